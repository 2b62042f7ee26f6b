// grow: a region from seeds, as a label map.

#include <cmath>

#include <nlohmann/json.hpp>

#include "app/cli/Commands.h"
#include "app/cli/Growing.h"
#include "app/cli/Report.h"
#include "io/VolumeWriter.h"

namespace fenestra::cli {
namespace {

using Json = nlohmann::ordered_json;
using namespace segmentation;

constexpr double mm3PerMl = 1000.0;

Json listOf(const std::vector<glm::dvec3>& positions) {
  Json list = Json::array();
  for (const glm::dvec3 p : positions) list.push_back({p.x, p.y, p.z});
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

/// 0 and 1 on the mask's grid.
Volume volumeOfLabels(const Mask& mask) {
  Volume volume;
  volume.grid = mask.grid;
  volume.voxels = Voxels(ScalarType::UInt8, mask.voxels.size());
  std::copy(mask.voxels.begin(), mask.voxels.end(), volume.voxels.as<std::uint8_t>().begin());
  volume.range = {0.0, 1.0};
  return volume;
}

}  // namespace

void grow(const GrowOptions& options) {
  const app::OpenedData data = app::openData(options.volume, progressOnTerminal());
  printWarnings(data.volume.warnings);
  const Volume& volume = *data.volume.volume;
  const GrownRegion region = growFromSeeds(volume, options.settings, options.volume.source());
  io::writeVolume(volumeOfLabels(region.mask), options.output);
  const Growth& growth = region.growth;
  Json plateaus = Json::array();
  for (const Plateau& plateau : growth.curve.plateaus) plateaus.push_back(describe(growth, plateau));
  Json json{
      {"source", options.volume.source()},
      {"seeds", listOf(options.settings.inside)},
      {"outside", listOf(options.settings.outside)},
      {"tolerance", options.settings.tolerance.value_or(growth.toleranceOf(region.step))},
      {"automatic", !options.settings.tolerance},
      {"unit", volume.unit},
      {"noise", growth.noise},
      {"volume_ml", volumeOf(region.mask) / mm3PerMl},
      {"voxels", std::lround(volumeOf(region.mask) / volume.grid.voxelVolume())},
      {"plateaus", std::move(plateaus)},
  };
  if (options.curve) json["curve"] = curveOf(growth);
  printJson(json);
}

}  // namespace fenestra::cli
