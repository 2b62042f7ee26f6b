#include "app/cli/DescriptorReport.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <system_error>

#include <nlohmann/json.hpp>

#include "io/ImageWriter.h"
#include "io/base/Error.h"
#include "io/base/Text.h"
#include "rendering/Renderer.h"
#include "rendering/viewpoints/RepresentativeViews.h"

namespace fenestra::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using namespace placement;

constexpr const char *everything = "all", *representative = "representative-views";

double degreesBetween(glm::dvec3 a, glm::dvec3 b) {
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

/// What the descriptors are correlated with, of the spread candidates: the paper's three, and the share of the surface.
std::vector<std::pair<const char*, std::vector<double>>> comparedWith(const DescribedPlacement& placed) {
  std::vector<std::pair<const char*, std::vector<double>>> lists{
      {"visibility", {}}, {"coverage", {}}, {"location", {}}, {"share", placed.views.shares()}};
  for (std::size_t i = 0; i < placed.measured.spread; ++i) {
    const Candidate& candidate = placed.measured.candidates[i];
    const bool isSeen = candidate.sums.count > 0.0;
    lists[0].second.push_back(isSeen ? candidate.descriptors.visibility : std::nan(""));
    lists[1].second.push_back(isSeen ? candidate.descriptors.coverage : std::nan(""));
    lists[2].second.push_back(isSeen ? candidate.descriptors.location : std::nan(""));
  }
  return lists;
}

/// The names that the chosen cameras have as pictures.
std::vector<std::pair<std::string, std::size_t>> chosenCameras(const DescriptorOptions& options,
                                                               const DescribedPlacement& placed) {
  std::vector<std::pair<std::string, std::size_t>> cameras{{"c1", placed.c1}};
  for (const ViewDescriptor each : options.wanted)
    if (const auto choice = choiceBy(each, placed.views.values(each)))
      cameras.emplace_back(entryOf(each).name, *choice);
  if (!options.representativeViews) return cameras;
  const std::vector<std::size_t> views = representativeViews(placed.views.channel()).views;
  for (std::size_t i = 0; i < views.size(); ++i)
    cameras.emplace_back("representative-view-" + std::to_string(i + 1), views[i]);
  return cameras;
}

Json representativeJson(const DescribedPlacement& placed) {
  const RepresentativeViews chosen = representativeViews(placed.views.channel());
  Json json = {{"views", Json::array()}};
  std::vector<glm::dvec3> directions;
  for (std::size_t i = 0; i < chosen.views.size(); ++i) {
    Json view = placed.cameraJson(chosen.views[i]);
    view["share_together"] = chosen.shares[i];
    json["views"].push_back(std::move(view));
    directions.push_back(placed.measured.candidates[chosen.views[i]].direction);
  }
  const Tour tour = shortestTour(directions);
  json["tour"] = Json::array();
  for (const std::size_t stop : tour.order) json["tour"].push_back(chosen.views[stop]);
  json["tour_degrees"] = glm::degrees(tour.length);
  return json;
}

}  // namespace

bool DescriptorOptions::needsImages() const {
  return std::any_of(wanted.begin(), wanted.end(), [](ViewDescriptor each) { return entryOf(each).needsImages; });
}

std::vector<std::string> descriptorNames() {
  std::vector<std::string> names{everything};
  for (const ViewDescriptorEntry& entry : viewDescriptors()) names.emplace_back(entry.name);
  names.emplace_back(representative);
  return names;
}

bool selectDescriptors(const std::string& names, DescriptorOptions& options) {
  std::set<ViewDescriptor> wanted;
  bool representativeViews = false;
  for (const std::string& name : io::split(names, ',')) {
    const auto entries = viewDescriptors();
    const auto entry =
        std::find_if(entries.begin(), entries.end(), [&](const auto& each) { return each.name == name; });
    if (entry != entries.end())
      wanted.insert(entry->descriptor);
    else if (name != everything && name != representative)
      return false;
    if (name == everything)
      for (const ViewDescriptorEntry& each : entries) wanted.insert(each.descriptor);
    representativeViews = representativeViews || name == everything || name == representative;
  }
  options.wanted.assign(wanted.begin(), wanted.end());
  options.representativeViews = representativeViews;
  return true;
}

void addDescriptors(Json& json, const DescriptorOptions& options, const DescribedPlacement& placed) {
  const auto lists = comparedWith(placed);
  const std::vector<Candidate>& candidates = placed.measured.candidates;
  json["directions"] = Json::array();
  for (std::size_t i = 0; i < placed.measured.spread; ++i)
    json["directions"].push_back({candidates[i].direction.x, candidates[i].direction.y, candidates[i].direction.z});
  json["descriptors"] = Json::object();
  for (const ViewDescriptor each : options.wanted) {
    const ViewDescriptorEntry& entry = entryOf(each);
    const std::vector<double> values = placed.views.values(each);
    Json choice = nullptr;
    if (const auto index = choiceBy(each, values)) {
      choice = placed.cameraJson(*index);
      choice["value"] = values[*index];
      choice["degrees_from_c1"] = degreesBetween(candidates[*index].direction, candidates[placed.c1].direction);
    }
    Json correlations = Json::object();
    for (const auto& [name, list] : lists) correlations[name] = preferenceCorrelation(each, values, list);
    json["descriptors"][std::string(entry.name)] = {{"unit", std::string(entry.unit)},
                                                    {"best", entry.isHighBest ? "high" : "low"},
                                                    {"choice", std::move(choice)},
                                                    {"rank_correlation", std::move(correlations)},
                                                    {"values", values}};
  }
  if (options.representativeViews) json["representative_views"] = representativeJson(placed);
}

void writeDescriptorPictures(const DescriptorOptions& options, const DescribedPlacement& placed,
                             const std::shared_ptr<GpuScene>& gpu, const Scene& scene, const View& view,
                             const std::function<Camera(std::size_t)>& cameraOf) {
  std::error_code error;
  fs::create_directories(options.pictures, error);
  if (error)
    throw io::Error(options.pictures, "cannot be made: " + error.message(), "choose a folder you may write to");
  Renderer renderer(gpu);
  for (const auto& [name, candidate] : chosenCameras(options, placed)) {
    View from = view;
    from.camera = cameraOf(candidate);
    from.frozen.reset();
    renderer.render(scene, from);
    std::vector<std::uint8_t> colours;
    const std::vector<std::uint8_t> picture = renderer.readPicture();
    for (std::size_t i = 0; i < picture.size(); ++i)
      if (i % 4 != 3) colours.push_back(picture[i]);
    io::writePng(options.pictures / (name + ".png"), from.size, 3, colours);
  }
}

}  // namespace fenestra::cli
