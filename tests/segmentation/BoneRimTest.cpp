#include "rendering/segmentation/BoneRim.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "io/PhantomFile.h"
#include "rendering/segmentation/BoneVoxels.h"
#include "rendering/segmentation/RegionGrowing.h"
#include "tests/support/Scenes.h"

namespace fenestra::segmentation::boneRimTest {
namespace {

using tests::gridOf;
using tests::volumeOf;

constexpr double fat = -60.0, bone = 850.0;
const Grid grid = gridOf({40, 40, 40});
const glm::dvec3 middle(20.0, 20.0, 20.0);

/// A ball whose surface voxels hold bone and fat by the share of each, as those of a scanner do.
double shareOfBone(glm::ivec3 at, double radius) {
  double held = 0.0;
  for (int i = 0; i < 64; ++i) {
    const glm::dvec3 part = glm::dvec3(i % 4, i / 4 % 4, i / 16) / 4.0 - 0.375;
    held += glm::distance(glm::dvec3(at) + part, middle) <= radius ? 1.0 / 64.0 : 0.0;
  }
  return held;
}
std::shared_ptr<Volume> ballOf(double radius) {
  const auto volume =
      volumeOf<float>(grid, [&](glm::ivec3 at) { return fat + (bone - fat) * shareOfBone(at, radius); });
  volume->unit = "HU";
  return volume;
}

TEST(BoneRim, IsWhatHoldsLessThanHalfOfBone) {
  constexpr double radius = 9.0;
  const auto volume = ballOf(radius);
  std::vector<Level> joins(grid.voxelCount(), never);
  tests::forEachVoxel(grid.dims, [&](glm::ivec3 at) {
    if (volume->value(at) >= boneFrom) joins[grid.offset(at)] = 0;
  });
  const std::vector<RimVoxel> rim = softRim(*volume, noiseOf(*volume), joins, 1);
  const auto isSoft = [&](glm::ivec3 at) {
    return std::ranges::any_of(rim, [&](const RimVoxel& each) { return each.offset == grid.offset(at); });
  };
  int soft = 0, hard = 0;
  tests::forEachVoxel(grid.dims, [&](glm::ivec3 at) {
    const double share = shareOfBone(at, radius);
    if (volume->value(at) < boneFrom || (share > 0.4 && share < 0.6)) return;  // means are of blurred voxels, too
    EXPECT_EQ(isSoft(at), share < 0.5) << share;
    ++(share < 0.5 ? soft : hard);
  });
  EXPECT_GT(soft, 100);
  EXPECT_GT(hard, 1000);
  // What lies beyond is fat.
  for (const RimVoxel& each : rim) EXPECT_EQ(each.cost, levelOf((boneFrom - fat) / noiseOf(*volume).unit));
}

TEST(BoneRim, LeavesAThinPlateWhole) {
  const auto volume = volumeOf<float>(grid, [](glm::ivec3 at) {
    return at.z == 20 ? 800.0 : at.z == 21 ? 200.0 : fat;
  });
  volume->unit = "HU";
  std::vector<Level> joins(grid.voxelCount(), never);
  tests::forEachVoxel(grid.dims, [&](glm::ivec3 at) {
    if (at.z == 20 || at.z == 21) joins[grid.offset(at)] = 0;
  });
  EXPECT_TRUE(softRim(*volume, noiseOf(*volume), joins, 1).empty());
}

TEST(BoneRim, IsNoPartOfAJawThatAClickOpens) {
  const io::OpenedPhantom phantom = io::openPhantom("head", 180);
  const Volume& volume = *phantom.volume.volume;
  const RegionFocus click{{{40.0, -24.0, -72.0}}, {}, {}, {}, RegionRule::Tissues};
  const Growth growth = *growRegion(volume, click, wholeOf(volume.grid.dims));
  const double ml = growth.curve.volume[static_cast<std::size_t>(growth.curve.automatic)] / 1000.0;
  // The jaw has 27.6 ml, and 40 with its rim. Voxels of 1.6 mm: half a voxel of the surface is a fifth of it.
  EXPECT_NEAR(ml, 27.6, 0.2 * 27.6);
}

}  // namespace
}  // namespace fenestra::segmentation::boneRimTest
