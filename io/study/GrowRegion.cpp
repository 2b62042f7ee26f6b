#include "io/study/GrowRegion.h"

#include <optional>
#include <sstream>
#include <utility>

#include "io/base/Error.h"
#include "rendering/segmentation/Painting.h"

namespace fenestra::io {
namespace {

std::string textOf(glm::dvec3 position) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << position.x << ',' << position.y << ',' << position.z;
  return text.str();
}

void checkSeeds(const Grid& grid, const std::vector<glm::dvec3>& seeds, const std::string& what,
                const std::string& source) {
  for (const glm::dvec3 seed : seeds) {
    if (segmentation::voxelAt(grid, seed)) continue;
    throw Error(source, "does not reach to " + what + " " + textOf(seed),
                "the volume's centre is " + textOf(grid.centre()) + " (mm, LPS)");
  }
}

void checkReach(const Grid& grid, const RegionFocus& region, const std::string& source) {
  checkSeeds(grid, region.inside, "the seed", source);
  checkSeeds(grid, region.outside, "the point outside,", source);
  for (const SelectionStroke& ball : region.painted)
    if (segmentation::boxOf(ball, grid).empty())
      throw Error(source, "has no voxel within the ball at " + textOf(ball.anchors.front()),
                  "enlarge the ball, or move it; the volume's centre is " + textOf(grid.centre()) + " (mm, LPS)");
}

}  // namespace

std::shared_ptr<const segmentation::Growth> growRegion(const Volume& volume, const RegionFocus& region,
                                                       const Progress& progress,
                                                       const segmentation::GrowthMemory& memory) {
  segmentation::Progress onward;
  if (progress) onward = [&](double fraction) { return progress(fraction, "growing the region"); };
  std::optional<segmentation::Growth> growth =
      segmentation::growRegion(volume, region, segmentation::wholeOf(volume.grid.dims), onward, memory);
  if (!growth) throw Cancelled();
  return std::make_shared<const segmentation::Growth>(std::move(*growth));
}

std::shared_ptr<const segmentation::Growth> growWholeRegion(const Volume& volume, const RegionFocus& region,
                                                            const std::string& source, const Progress& progress) {
  checkReach(volume.grid, region, source);
  auto growth = growRegion(volume, region, progress);
  if (growth->curve.volume[static_cast<std::size_t>(growth->stepOf(region))] > 0.0) return growth;
  if (!region.painted.empty()) throw Error(source, "has no voxel in what the balls select", WayOut::ChangeSelection);
  throw Error(source, "has no region of this tolerance around the seed",
              region.tolerance ? WayOut::RaiseTolerance : WayOut::ChooseSeed);
}

}  // namespace fenestra::io
