// grow: a region from seeds, as a label map.

#include <cmath>

#include <nlohmann/json.hpp>

#include "app/RegionOptions.h"
#include "app/cli/Commands.h"
#include "app/cli/Report.h"
#include "io/LabelWriter.h"
#include "io/study/GrowRegion.h"
#include "io/study/ReadStudy.h"
#include "rendering/segmentation/Mask.h"
#include "rendering/segmentation/RegionFacts.h"

namespace fenestra::cli {
namespace {

using Json = nlohmann::ordered_json;
using namespace segmentation;

Json listsOf(const std::vector<glm::dvec3>& positions) {
  Json list = Json::array();
  for (const glm::dvec3 p : positions) list.push_back(listOf(p));
  return list;
}

Json describe(const Growth& growth, const Plateau& plateau) {
  return {{"tolerance", growth.toleranceOf(plateau.best)},
          {"from", growth.toleranceOf(plateau.first)},
          {"to", growth.toleranceOf(plateau.last)},
          {"volume_ml", plateau.volume / mm3PerMl},
          {"contrast", plateau.contrast * growth.noise}};
}

Json curveOf(const Growth& growth) {
  Json tolerances = Json::array(), volumes = Json::array();
  for (int step = 1; step <= stepCount; ++step) {
    tolerances.push_back(growth.toleranceOf(step));
    volumes.push_back(growth.curve.volume[static_cast<std::size_t>(step)] / mm3PerMl);
  }
  return {{"tolerance", std::move(tolerances)}, {"volume_ml", std::move(volumes)}};
}

void warnOfShare(const std::optional<double>& share) {
  if (!share || *share <= largeShareOfBody) return;
  printWarnings(
      {{io::Warning::Kind::Other,
        "the region is " + std::to_string(std::lround(100.0 * *share)) +
            " % of the body, hardly one structure: lower --tolerance, bound it by --ball, or add an --outside",
        {}}});
}

}  // namespace

void grow(const GrowOptions& options) {
  const io::Study study = io::openData(options.data, progressOnTerminal());
  printWarnings(study.warnings);
  const Volume& volume = *study.scene.volume;
  const auto grown = io::growWholeRegion(volume, options.region, options.data.source(), progressOnTerminal());
  const Growth& growth = *grown;
  const int step = growth.stepOf(options.region);
  const Mask mask = maskAt(growth, step);
  io::writeLabels(*labelMapOf(mask, {1, "region", regionColour}), options.output, {.series = study.series.files},
                  progressOnTerminal());
  const std::optional<double> share = shareOfBody(growth, step);
  warnOfShare(share);
  Json plateaus = Json::array();
  for (const Plateau& plateau : growth.curve.plateaus) plateaus.push_back(describe(growth, plateau));
  Json json{
      {"source", options.data.source()},
      {"seeds", listsOf(options.region.inside)},
      {"outside", listsOf(options.region.outside)},
      {"by", app::wordOfRule(options.region.rule)},
      {"tolerance", options.region.tolerance.value_or(growth.toleranceOf(step))},
      {"automatic", !options.region.tolerance},
      {"unit", volume.unit},
      {"noise", growth.noise},
      {"volume_ml", volumeOf(mask) / mm3PerMl},
      {"voxels", std::lround(volumeOf(mask) / volume.grid.voxelVolume())},
      {"plateaus", std::move(plateaus)},
      {"share_of_body", share ? Json(*share) : Json(nullptr)},
  };
  if (options.curve) json["curve"] = curveOf(growth);
  printJson(json);
}

}  // namespace fenestra::cli
