#include "io/TransferFunctionFile.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <optional>
#include <string_view>
#include <system_error>

#include <nlohmann/json.hpp>

#include "fenestra/resources.h"
#include "rendering/segmentation/HounsfieldScale.h"
#include "rendering/segmentation/TissueDistribution.h"

namespace fenestra::io {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using segmentation::HounsfieldScale;

constexpr std::string_view presetFolder = "transfer-functions/";
constexpr std::string_view presetEnding = ".json";

std::string presetPath(const std::string& id) { return std::string(presetFolder) + id + std::string(presetEnding); }

/// What the values of nodes are.
enum class Domain : std::uint8_t { Value, Hounsfield, Percentile, Tissue, Uptake };

/// Reads one description; every mistake is an Error that names `source` and says which entry it is.
class Parser {
 public:
  Parser(fs::path source, std::string_view text) : source_(std::move(source)) {
    try {
      root_ = Json::parse(text);
    } catch (const Json::parse_error& error) {
      fail("not valid JSON near byte " + std::to_string(error.byte));
    } catch (const Json::out_of_range&) {
      fail("holds a number too large for double precision");
    }
    if (!root_.is_object()) fail("the top level is not an object");
  }

  std::string name() const {
    const auto name = root_.find("name");
    if (name == root_.end() || !name->is_string()) fail("\"name\" is not a text");
    return name->get<std::string>();
  }

  Domain domain() const {
    const auto domain = root_.find("domain");
    for (const auto& [word, meant] : {std::pair("value", Domain::Value),
                                      {"hounsfield", Domain::Hounsfield},
                                      {"percentile", Domain::Percentile},
                                      {"tissue", Domain::Tissue},
                                      {"uptake", Domain::Uptake}})
      if (domain != root_.end() && *domain == word) return meant;
    fail("\"domain\" is none of \"value\", \"hounsfield\", \"percentile\", \"tissue\", \"uptake\"");
  }

  /// Nodes with values as written. `voxel`: the finest spacing, mm.
  TransferFunction function(double voxel) const {
    const auto nodes = root_.find("nodes");
    if (nodes == root_.end() || !nodes->is_array() || nodes->empty()) fail("\"nodes\" is not a list of nodes");
    const bool percentile = domain() == Domain::Percentile || domain() == Domain::Tissue;
    TransferFunction result;
    for (const Json& entry : *nodes) {
      const std::string where = "node " + std::to_string(result.nodes.size() + 1) + ": ";
      if (!entry.is_object()) fail(where + "not an object");
      TransferFunction::Node node;
      node.value = number(entry, "value", where);
      if (percentile && (node.value < 0.0 || node.value > 100.0)) fail(where + "a percentile outside 0 to 100");
      if (!result.nodes.empty() && node.value < result.nodes.back().value)
        fail(where + "its value is less than the node's before it");
      node.properties.extinction = extinctionFromOpacity(fraction(number(entry, "opacity", where), "opacity", where)) /
                                   thicknessOf(entry, voxel, where);
      const auto colour = entry.find("colour");
      if (colour == entry.end() || !colour->is_array() || colour->size() != 3)
        fail(where + "\"colour\" is not a list of three numbers");
      for (int channel = 0; channel < 3; ++channel) {
        const Json& component = (*colour)[static_cast<std::size_t>(channel)];
        if (!component.is_number()) fail(where + "\"colour\" is not a list of three numbers");
        node.properties.colour[channel] = fraction(component.get<double>(), "colour", where);
      }
      result.nodes.push_back(node);
    }
    return result;
  }

 private:
  /// Thickness of the material that an opacity belongs to, mm.
  double thicknessOf(const Json& entry, double voxel, const std::string& where) const {
    const auto per = entry.find("per");
    if (per == entry.end() || *per == "mm") return 1.0;
    if (*per == "voxel") return voxel;
    fail(where + "\"per\" is neither \"mm\" nor \"voxel\"");
  }
  [[noreturn]] void fail(const std::string& cause) const {
    throw Error(source_, "not a transfer function: " + cause,
                "see the presets in resources/transfer-functions for the form");
  }
  double number(const Json& entry, const char* key, const std::string& where) const {
    const auto at = entry.find(key);
    if (at == entry.end() || !at->is_number() || !std::isfinite(at->get<double>()))
      fail(where + "\"" + key + "\" is not a number");
    return at->get<double>();
  }
  double fraction(double value, const char* key, const std::string& where) const {
    if (!(value >= 0.0 && value <= 1.0)) fail(where + "\"" + key + "\" lies outside 0 to 1");
    return value;
  }

  fs::path source_;
  Json root_;
};

std::string readFile(const fs::path& path) {
  // Hand-written files are a few hundred bytes; anything beyond this is another kind of file.
  constexpr std::uintmax_t largest = 1 << 20;
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    std::string names;
    for (const TransferFunctionPreset& preset : transferFunctionPresets())
      names += (names.empty() ? "" : ", ") + preset.id;
    throw Error(path, "neither a preset nor a file", "the presets are " + names);
  }
  if (fs::file_size(path, error) > largest || error)
    throw Error(path, "not a transfer function: too large", "give a JSON file of nodes");
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file.good() && !file.eof()) throw Error(path, "cannot be read", "check its permissions");
  return text;
}

/// A preset or file, see loadContextFunction(). `scale` is the volume's, asked for where nodes are in HU.
ContextFunction madeFor(const Volume& volume, const std::string& presetOrPath,
                        const std::function<std::optional<HounsfieldScale>()>& scale) {
  const std::string_view embedded = resources::find(presetPath(presetOrPath));
  const Parser parser(presetOrPath, embedded.empty() ? readFile(presetOrPath) : std::string(embedded));
  ContextFunction context;
  if (embedded.empty())
    context.file = std::filesystem::absolute(presetOrPath);
  else
    context.preset = presetOrPath;
  const glm::dvec3 spacing = volume.grid.spacing;
  context.function = parser.function(std::min({spacing.x, spacing.y, spacing.z}));
  if (parser.domain() == Domain::Value) return context;
  if (parser.domain() == Domain::Hounsfield) {
    if (const auto units = scale())
      for (TransferFunction::Node& node : context.function.nodes) node.value = units->realAt(node.value);
    return context;
  }
  // The mean of a body's standardised uptake value is 1, but for what has left it: that is its definition.
  const bool isStandardised = parser.domain() == Domain::Uptake && volume.unit == "GML";
  if (isStandardised) return context;
  using segmentation::TissueDistribution;
  const TissueDistribution tissue(volume, parser.domain() == Domain::Tissue
                                              ? TissueDistribution::Background::Air
                                              : TissueDistribution::Background::DarkerClass);
  const double one = tissue.mean();
  for (TransferFunction::Node& node : context.function.nodes)
    node.value = parser.domain() == Domain::Uptake ? node.value * one : tissue.at(node.value);
  return context;
}

/// See defaultPreset().
std::string presetFor(const Volume& volume, const std::optional<HounsfieldScale>& scale) {
  if (volume.modality == Modality::PT) return "pet";
  if (volume.modality == Modality::US) return "ultrasound";
  if (volume.isInHounsfieldUnits() || scale) return "ct-soft-tissue";
  // What is in no unit is shown by its own distribution. Fluid, which is what T2 shows bright, is a few per cent of a
  // body or head or more; vessels with flowing blood are less, and stand out farther.
  const segmentation::TissueDistribution tissue(volume);
  const double median = tissue.at(50.0);
  if (!(median > 0.0)) return "mr-t1";
  if (tissue.shareAbove(3.0 * median) > 0.001 && tissue.shareAbove(2.0 * median) < 0.02) return "mr-angio";
  return tissue.shareAbove(2.0 * median) > 0.06 ? "mr-t2" : "mr-t1";
}

}  // namespace

std::vector<TransferFunctionPreset> transferFunctionPresets() {
  std::vector<TransferFunctionPreset> presets;
  for (const std::string_view path : resources::paths()) {
    if (!path.starts_with(presetFolder) || !path.ends_with(presetEnding)) continue;
    std::string id(path.substr(presetFolder.size(), path.size() - presetFolder.size() - presetEnding.size()));
    presets.push_back({std::move(id), Parser(path, resources::find(path)).name()});
  }
  // "mr" comes before "mr-bright", and its file's path does not.
  std::sort(presets.begin(), presets.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return presets;
}

ContextFunction loadContextFunction(const std::string& presetOrPath, const Volume& volume) {
  return madeFor(volume, presetOrPath, [&volume] { return segmentation::hounsfieldScaleOf(volume); });
}

std::string defaultPreset(const Volume& volume) { return presetFor(volume, segmentation::hounsfieldScaleOf(volume)); }

ContextFunction startingContext(const Volume& volume) {
  const std::optional<HounsfieldScale> scale = segmentation::hounsfieldScaleOf(volume);
  return madeFor(volume, presetFor(volume, scale), [&scale] { return scale; });
}

std::string plainPreset(const Volume& volume) { return volume.isInHounsfieldUnits() ? "ct-plain" : "mr"; }

}  // namespace fenestra::io
