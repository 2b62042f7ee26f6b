// place --pick: cameras for the structure at a point, by LiveSync.

#include <chrono>

#include <nlohmann/json.hpp>

#include "app/cli/Commands.h"
#include "app/cli/Report.h"
#include "io/study/ReadStudy.h"
#include "rendering/segmentation/PickedStructure.h"
#include "rendering/viewpoints/LiveSync.h"
#include "rendering/viewpoints/Sphere.h"

namespace fenestra::cli {
namespace {

using Json = nlohmann::ordered_json;
using namespace placement;
using segmentation::PickedStructure;

Json viewJson(const RatedViews& views, std::size_t index) {
  const SphereScores& scores = views.scores[index];
  return {{"index", index},
          {"direction", listOf(views.directions[index])},
          {"rating", views.ratings[index]},
          {"spheres",
           {{"patient_orientation", scores.orientation},
            {"view_history", scores.history ? Json(*scores.history) : Json(nullptr)},
            {"local_shape", scores.shape},
            {"visibility", scores.visibility}}}};
}

Json structureJson(const PickedStructure& picked, const LocalShape& shape) {
  const auto* label = picked.label ? picked.labels->find(*picked.label) : nullptr;
  return {{"label", picked.label ? Json(*picked.label) : Json(nullptr)},
          {"name", label ? Json(label->name) : Json(nullptr)},
          {"grown", picked.isGrown},
          {"voxels_within_reach", shape.voxels.size()},
          {"variances_mm2", shape.variances}};
}

}  // namespace

void placeByPick(const PlaceOptions& options) {
  io::Study study = io::readStudy(options.study, progressOnTerminal());
  printWarnings(study.warnings);
  const Scene& scene = study.drawn.scene();
  const glm::dvec3 pick = *options.pick;
  const auto start = std::chrono::steady_clock::now();
  const PickedStructure picked = segmentation::pickedStructure(scene, pick);
  if (!picked.labels)
    throw io::Error(options.study.source(), "has nothing to look at for --pick: " + picked.problem,
                    "choose a --pick in a structure, in mm (L,P,S)");
  const RatedViews views = rateViews(scene, {picked.labels, picked.values}, pick, *sideOf(options.sampling.count),
                                     options.liveSync, options.placement);
  const double time = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();

  const Framing& framed = visibleOf(study);
  const auto cameraJson = [&](std::optional<std::size_t> index) -> Json {
    if (!index) return nullptr;
    Json json = viewJson(views, *index);
    const Camera camera = cameraAt(pick, views.directions[*index], framed, study.view->camera.projection);
    json["camera"] = {{"eye", listOf(camera.eye)}, {"target", listOf(camera.target)}, {"up", listOf(camera.axes().up)}};
    return json;
  };
  const LiveSyncWeights& weights = options.liveSync.weights;
  Json json = {
      {"by", "livesync"},
      {"pick", listOf(pick)},
      {"structure", structureJson(picked, views.shape)},
      {"c1", cameraJson(views.c1)},
      {"c2", cameraJson(views.c2)},
      {"weights",
       {{"patient_orientation", weights.orientation},
        {"local_shape", weights.shape},
        {"visibility", weights.visibility}}},
      {"reach_mm", options.liveSync.reach},
      {"candidates", views.spread()},
      {"region", options.placement.region == Region::Stream ? "stream" : "semi-sphere"},
      {"milliseconds", time},
  };
  if (options.everyCandidate) {
    json["all"] = Json::array();
    for (std::size_t i = 0; i < views.directions.size(); ++i) json["all"].push_back(viewJson(views, i));
  }
  printJson(json);
}

}  // namespace fenestra::cli
