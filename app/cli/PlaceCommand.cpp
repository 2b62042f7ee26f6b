#include <chrono>
#include <memory>
#include <optional>

#include <nlohmann/json.hpp>

#include "app/ScheduleChoice.h"
#include "app/cli/Commands.h"
#include "app/cli/QualityMap.h"
#include "app/cli/ReadBesideContext.h"
#include "app/cli/Report.h"
#include "rendering/gpu/GpuScene.h"

namespace fenestra::cli {
namespace {

using Json = nlohmann::ordered_json;
using namespace placement;

Json candidateJson(const Measured& measured, std::size_t index, const Options& by) {
  const Candidate& candidate = measured.candidates[index];
  const Descriptors& d = candidate.descriptors;
  return {{"index", index},
          {"direction", listOf(candidate.direction)},
          {"quality", quality(d, by.weights)},
          {"worth", worth(d, by)},
          {"descriptors",
           {{"visibility", d.visibility},
            {"coverage", d.coverage},
            {"location", d.location},
            {"entropy", d.entropy},
            {"mutual_information", d.mutualInformation},
            {"stability", d.stability},
            {"orientation", d.orientation},
            {"end_face", d.endFace}}},
          {"awkward",
           {{"through_cut_end", d.awkwardness.throughCutEnd},
            {"lying", d.awkwardness.lying},
            {"edge_on", d.awkwardness.edgeOn}}},
          {"pixels", candidate.sums.count},
          {"box", {candidate.sums.box.x, candidate.sums.box.y, candidate.sums.box.z, candidate.sums.box.w}},
          {"share", seenShare(candidate, candidate, measured.surfacePoints)}};
}

/// The cut ends by the side of the patient that they are nearest to.
Json scanJson(const ScanShape& scan) {
  Json ends = Json::object();
  for (std::size_t f = 0; f < scan.faces.size(); ++f)
    ends[std::string(1, "LPSRAI"[f])] = {
        {"cut", scan.faces[f].cut}, {"contact", scan.faces[f].contact}, {"behind", scan.faces[f].behind}};
  return {{"ends", ends}, {"flatness", scan.stack.flatness}, {"front", listOf(scan.stack.front)}, {"offset", listOf(scan.offset)}};
}

Json cameraJson(const Measured& measured, std::optional<std::size_t> index, const Options& by, const Framing& framed,
                Projection projection) {
  if (!index) return nullptr;
  Json json = candidateJson(measured, *index, by);
  const Camera camera = Camera::fromDirection(measured.candidates[*index].direction, framed, projection);
  json["camera"] = {{"eye", listOf(camera.eye)}, {"target", listOf(camera.target)}, {"up", listOf(camera.axes().up)}};
  return json;
}

/// Pictures of the chosen cameras, unless --size asks for another size.
constexpr glm::ivec2 thumbnail{320, 240};

void describe(const PlaceOptions& options, const io::Study& study, const std::shared_ptr<GpuScene>& gpu,
              const Measured& measured, std::size_t c1, const Framing& framed, Json& json) {
  const Projection projection = study.view->camera.projection;
  const DescribedViews views =
      describeViews(*gpu, study.drawn.scene(), measured, options.sampling, options.descriptors.needsImages());
  const DescribedPlacement placed{measured, views, c1, [&](std::size_t index) {
                                    return cameraJson(measured, index, options.placement, framed, projection);
                                  }};
  addDescriptors(json, options.descriptors, placed);
  if (options.descriptors.pictures.empty()) return;
  View view = *study.view;
  view.size = options.study.size.value_or(thumbnail);
  view.pixelScale *= static_cast<double>(view.size.x) / study.view->size.x;  // openings as wide as in a whole picture
  writeDescriptorPictures(options.descriptors, placed, gpu, study.drawn.scene(), view, [&](std::size_t index) {
    return Camera::fromDirection(measured.candidates[index].direction, framed, projection);
  });
}

}  // namespace

void place(const PlaceOptions& options) {
  if (options.pick) return placeByPick(options);
  std::optional<egl::EglContext> context;
  io::Study study = readBesideContext(options.study, context);
  printWarnings(study.warnings);
  const Scene& scene = study.drawn.scene();
  const auto gpu = std::make_shared<GpuScene>();
  if (const auto known = app::knownSchedule(options.schedule, *scene.volume)) gpu->setSchedule(*known);
  const auto uploading = std::chrono::steady_clock::now();
  gpu->update(scene, GpuScene::Use::FirstHits);
  const double uploadTime = millisecondsSince(uploading);
  printReduction(*gpu);

  Placer placer;
  const Measured* measured = nullptr;
  std::vector<double> times;
  for (int i = 0; i < options.repeat; ++i) {
    placer.forget();
    const auto start = std::chrono::steady_clock::now();
    measured = &placer.measure(*gpu, scene, options.sampling, options.placement);
    times.push_back(millisecondsSince(start));
  }
  const auto choosing = std::chrono::steady_clock::now();
  const Placement placement = choose(*measured, options.placement, options.joint);
  const double chooseTime = millisecondsSince(choosing);
  if (!placement.c1) throw io::Error(options.study.source(), placement.note, placementHint);

  if (!options.map.empty()) writeQualityMap(options.map, *measured, options.placement, placement);
  const Options& by = options.placement;
  const Framing& framed = visibleOf(study);
  const Projection projection = study.view->camera.projection;
  const auto standard = bestStandardPair(measured->candidates, measured->surfacePoints);
  Json json = {
      {"c1", cameraJson(*measured, placement.c1, by, framed, projection)},
      {"c2", cameraJson(*measured, placement.c2, by, framed, projection)},
      {"share", placement.share},
      {"standard_pair_share", standard ? Json(standard->share) : Json(nullptr)},
      {"note", placement.note},
      {"candidates", measured->spread},
      {"refined", options.sampling.refined},
      {"joint", options.joint},
      {"region", options.placement.region == Region::Stream ? "stream" : "semi-sphere"},
      {"habits",
       {{"avoid_cut_ends", by.habits.avoidCutEnds},
        {"upright_first", by.habits.uprightFirst},
        {"flat_from_front", by.habits.flatFromFront},
        {"near_side_first", by.habits.nearSideFirst}}},
      {"scan", scanJson(measured->scan)},
      {"surface", {{"mm2", measured->surfaceArea}, {"points", measured->surfacePoints}}},
      {"milliseconds", {{"upload", uploadTime}, {"measure", times}, {"choose", chooseTime}}},
      {"gl", context->description()},
  };
  if (options.everyCandidate) {
    json["all"] = Json::array();
    for (std::size_t i = 0; i < measured->candidates.size(); ++i)
      json["all"].push_back(candidateJson(*measured, i, by));
  }
  if (!options.descriptors.isEmpty()) describe(options, study, gpu, *measured, *placement.c1, framed, json);
  printJson(json);
}

}  // namespace fenestra::cli
