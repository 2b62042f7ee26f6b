#include "io/TransferFunctionFile.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <optional>
#include <string_view>
#include <system_error>

#include <nlohmann/json.hpp>

#include "fenestra/resources.h"
#include "rendering/segmentation/HounsfieldGuess.h"

namespace fenestra::io {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::string_view presetFolder = "transfer-functions/";
constexpr std::string_view presetEnding = ".json";

std::string presetPath(const std::string& id) { return std::string(presetFolder) + id + std::string(presetEnding); }

/// What the values of nodes are.
enum class Domain : std::uint8_t { Value, Hounsfield, Percentile, Uptake };

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
                                      {"uptake", Domain::Uptake}})
      if (domain != root_.end() && *domain == word) return meant;
    fail("\"domain\" is none of \"value\", \"hounsfield\", \"percentile\", \"uptake\"");
  }

  /// Nodes with values as written. `voxel`: the finest spacing, mm.
  TransferFunction function(double voxel) const {
    const auto nodes = root_.find("nodes");
    if (nodes == root_.end() || !nodes->is_array() || nodes->empty()) fail("\"nodes\" is not a list of nodes");
    const bool percentile = domain() == Domain::Percentile;
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
  /// Of the material that an opacity is that of, mm.
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

/// The value distribution of what is not background.
class TissueDistribution {
 public:
  explicit TissueDistribution(const Volume& volume) : values_(sampled(volume)) {
    if (!values_.empty()) values_.erase(values_.begin(), values_.begin() + backgroundCount());
  }

  double at(double percentile) const {
    if (values_.empty()) return 0.0;
    const double position = percentile / 100.0 * static_cast<double>(values_.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const auto above = std::min(below + 1, values_.size() - 1);
    return std::lerp(values_[below], values_[above], position - static_cast<double>(below));
  }

  double mean() const {
    double sum = 0.0;
    for (const double value : values_) sum += value;
    return values_.empty() ? 0.0 : sum / static_cast<double>(values_.size());
  }
  /// Share of the values that are greater, 0..1.
  double shareAbove(double value) const {
    if (values_.empty()) return 0.0;
    return static_cast<double>(values_.end() - std::upper_bound(values_.begin(), values_.end(), value)) /
           static_cast<double>(values_.size());
  }

 private:
  /// Finite real values of evenly spaced voxels, sorted. A quarter of a million give a percentile to a tenth of one.
  static std::vector<double> sampled(const Volume& volume) {
    constexpr std::size_t wanted = 1 << 18;
    std::vector<double> values;
    volume.voxels.visit([&](auto scalars) {
      // An odd stride does not fall into step with rows whose length is a power of two.
      const std::size_t stride = scalars.size() / wanted | 1;
      values.reserve(scalars.size() / stride + 1);
      for (std::size_t i = 0; i < scalars.size(); i += stride) {
        const double real = volume.slope * static_cast<double>(scalars[i]) + volume.intercept;
        if (std::isfinite(real)) values.push_back(real);
      }
    });
    std::sort(values.begin(), values.end());
    return values;
  }

  /// How many of the sorted values are background: air and its noise, below the threshold that separates the two
  /// classes best (Otsu, IEEE Trans. SMC 9(1), 1979: the greatest variance between classes).
  std::ptrdiff_t backgroundCount() const {
    // Outliers (metal, a spike) would be a class of their own.
    const std::size_t tail = values_.size() / 1000;
    const auto clipped = [&](std::size_t i) {
      return std::clamp(values_[i], values_[tail], values_[values_.size() - 1 - tail]);
    };
    double total = 0.0;
    for (std::size_t i = 0; i < values_.size(); ++i) total += clipped(i);
    const auto count = static_cast<double>(values_.size());
    double below = 0.0, greatest = 0.0;
    std::size_t split = 0;
    for (std::size_t i = 1; i < values_.size(); ++i) {
      below += clipped(i - 1);
      if (values_[i] == values_[i - 1]) continue;
      const double n = static_cast<double>(i);
      const double difference = below / n - (total - below) / (count - n);
      const double between = n * (count - n) * difference * difference;
      if (between > greatest) {
        greatest = between;
        split = i;
      }
    }
    return static_cast<std::ptrdiff_t>(split);
  }

  std::vector<double> values_;
};

/// MR may have the narrow peak of soft tissue by chance, but hardly any of it is nearly twice as bright as that, as
/// compact bone is in CT: in the heads of the test data, 10 % and more.
constexpr double compactBone = 776.0;       ///< HU
constexpr double leastCompactBone = 0.004;  ///< of the body's voxels

/// HU = factor · real value + offset.
struct HounsfieldScale {
  double factor, offset;
};

/// Whether a volume of no known kind has the values of CT plus 1024, as scanners store them and some converters leave
/// them. The scale is known then, so that less is asked of the values than of a guess, which foam around a head fails.
bool isStoredCt(const Volume& volume) {
  constexpr double airBelow = -900.0, bodyAbove = -500.0;              // HU
  constexpr double softLow = -20.0, softHigh = 90.0, softHalf = 60.0;  // HU: muscle, brain and organs
  constexpr int stored = 1024, most = 4096;
  if (volume.modality != Modality::Unknown && volume.modality != Modality::CT) return false;
  if (volume.range.low < 0.0 || volume.range.low > stored + airBelow || volume.range.high >= most) return false;
  std::vector<double> counts(most, 0.0);
  volume.voxels.visit([&](auto scalars) {
    const std::size_t stride = scalars.size() >> 20 | 1;
    for (std::size_t i = 0; i < scalars.size(); i += stride) {
      const double real = volume.slope * static_cast<double>(scalars[i]) + volume.intercept;
      if (real >= 0.0 && real < most) ++counts[static_cast<std::size_t>(real)];
    }
  });
  const auto between = [&](double low, double high) {
    const auto at = [&](double hounsfield) {
      return counts.begin() + static_cast<std::ptrdiff_t>(std::clamp(hounsfield + stored, 0.0, double(most)));
    };
    return std::accumulate(at(low), at(high), 0.0);
  };
  // The peak of a window that is as wide as scanners' noise.
  constexpr double step = 10.0, half = 15.0;
  double peak = bodyAbove, height = 0.0;
  for (double middle = bodyAbove; middle + half < most - stored; middle += step)
    if (const double here = between(middle - half, middle + half); here > height) {
      height = here;
      peak = middle;
    }
  const double body = between(bodyAbove, most);
  return peak >= softLow && peak <= softHigh && between(peak - softHalf, peak + softHalf) >= 0.25 * body &&
         between(compactBone, most) >= leastCompactBone * body &&
         between(-stored, airBelow) >= 0.02 * (body + between(-stored, bodyAbove));
}

/// The units of a CT that is in others than Hounsfield's; empty where it is in them or is no CT.
std::optional<HounsfieldScale> hounsfieldScaleOf(const Volume& volume) {
  if (volume.isInHounsfieldUnits()) return std::nullopt;
  if (isStoredCt(volume)) return HounsfieldScale{1.0, -1024.0};
  const auto guess = segmentation::hounsfieldGuess(volume);
  if (!guess) return std::nullopt;
  const HounsfieldScale scale{guess->factor, guess->offset};
  const bool isKnownCt = volume.modality == Modality::CT;
  const double compact = (compactBone - scale.offset) / scale.factor;
  if (!isKnownCt && TissueDistribution(volume).shareAbove(compact) < leastCompactBone) return std::nullopt;
  return scale;
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
    if (const auto scale = hounsfieldScaleOf(volume))
      for (TransferFunction::Node& node : context.function.nodes)
        node.value = (node.value - scale->offset) / scale->factor;
    return context;
  }
  // The mean of a body's standardised uptake value is 1, but for what has left it: that is its definition.
  const bool isStandardised = parser.domain() == Domain::Uptake && volume.unit == "GML";
  if (isStandardised) return context;
  const TissueDistribution tissue(volume);
  const double one = tissue.mean();
  for (TransferFunction::Node& node : context.function.nodes)
    node.value = parser.domain() == Domain::Uptake ? node.value * one : tissue.at(node.value);
  return context;
}

std::string defaultPreset(const Volume& volume) {
  if (volume.modality == Modality::PT) return "pet";
  if (volume.modality == Modality::US) return "ultrasound";
  if (volume.isInHounsfieldUnits() || hounsfieldScaleOf(volume)) return "ct-soft-tissue";
  // What is in no unit is shown by its own distribution. Fluid, which is what T2 shows bright, is a few per cent of a
  // body or head or more; vessels with flowing blood are less, and stand out farther.
  const TissueDistribution tissue(volume);
  const double median = tissue.at(50.0);
  if (!(median > 0.0)) return "mr-t1";
  if (tissue.shareAbove(3.0 * median) > 0.001 && tissue.shareAbove(2.0 * median) < 0.02) return "mr-angio";
  return tissue.shareAbove(2.0 * median) > 0.06 ? "mr-t2" : "mr-t1";
}

std::string plainPreset(const Volume& volume) { return volume.isInHounsfieldUnits() ? "ct-plain" : "mr"; }

}  // namespace fenestra::io
