#include "rendering/segmentation/RandomWalk.h"

#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "rendering/segmentation/RegionGrowing.h"
#include "tests/support/Scenes.h"
#include "tests/support/TestData.h"

namespace fenestra::segmentation::randomWalkTest {
namespace {

using tests::gridOf;
using tests::volumeOf;

constexpr double white = 110.0, grey = 100.0, noiseDeviation = 4.0;
const glm::dvec3 middle(44.0, 44.0, 44.0);  // mm
constexpr double radius = 10.0;

bool inNucleus(glm::dvec3 mm) { return glm::distance(mm, middle) <= radius; }
/// A bridge leads from the nucleus to a cortex of its own value, which is far larger.
bool isGrey(glm::dvec3 mm) {
  return inNucleus(mm) || mm.x < 16.0 || (mm.x < 44.0 && std::hypot(mm.y - 44.0, mm.z - 44.0) <= 3.0);
}

template <class IsGrey>
std::shared_ptr<Volume> mrOf(glm::ivec3 dims, glm::dvec3 spacing, IsGrey isGreyAt) {
  std::mt19937 random(9);
  std::normal_distribution<double> noise(0.0, noiseDeviation);
  return volumeOf<float>(gridOf(dims, spacing), [&](glm::ivec3 at) {
    return (isGreyAt(glm::dvec3(at) * spacing) ? grey : white) + noise(random);
  });
}

glm::ivec3 voxelOf(const Volume& volume, glm::dvec3 mm) { return glm::ivec3(glm::round(mm / volume.grid.spacing)); }

double diceOf(const Volume& volume, const WalkRegion& region) {
  double both = 0.0, sum = 0.0;
  tests::forEachVoxel(volume.grid.dims, [&](glm::ivec3 at) {
    const bool joined = region.box.contains(at) && region.joins[region.box.offset(at)] < region.step;
    const bool inside = inNucleus(glm::dvec3(at) * volume.grid.spacing);
    both += joined && inside ? 2.0 : 0.0;
    sum += (joined ? 1.0 : 0.0) + (inside ? 1.0 : 0.0);
  });
  return both / sum;
}

std::optional<WalkRegion> walkFrom(const Volume& volume, glm::dvec3 mm, std::span<const glm::ivec3> outside = {}) {
  const glm::ivec3 seed = voxelOf(volume, mm);
  return walkRegion(volume, noiseOf(volume), std::span(&seed, 1), outside);
}

TEST(RandomWalk, FindsANucleusThatABridgeJoinsToItsCortex) {
  const auto volume = mrOf({88, 88, 88}, {1.0, 1.0, 1.0}, isGrey);
  // Voxels of 1 mm: half a voxel of the surface is a seventh of the volume.
  for (const glm::dvec3 away : {glm::dvec3(0.0), glm::dvec3(0.0, 6.0, 0.0), glm::dvec3(4.0, 0.0, -4.0)}) {
    const auto region = walkFrom(*volume, middle + away);
    ASSERT_TRUE(region);
    EXPECT_GT(diceOf(*volume, *region), 0.85);
    EXPECT_GT(region->support, 0.85);
  }
}

TEST(RandomWalk, TakesFineVoxelsTogether) {
  const auto volume = mrOf({176, 176, 44}, {0.5, 0.5, 2.0}, isGrey);
  const auto region = walkFrom(*volume, middle);
  ASSERT_TRUE(region);
  EXPECT_GT(diceOf(*volume, *region), 0.80);
}

TEST(RandomWalk, SeesNoSurfaceInEvenTissue) {
  const auto volume = mrOf({88, 88, 88}, {1.0, 1.0, 1.0}, [](glm::dvec3) { return false; });
  const auto region = walkFrom(*volume, middle);
  EXPECT_TRUE(!region || region->support < 0.5);
}

TEST(RandomWalk, LeavesOutWhatASeedOutsideMeans) {
  const auto volume = mrOf({88, 88, 88}, {1.0, 1.0, 1.0}, isGrey);
  const std::array outside{voxelOf(*volume, middle + glm::dvec3(0.0, -6.0, 0.0))};
  const auto region = walkFrom(*volume, middle + glm::dvec3(0.0, 5.0, 0.0), outside);
  ASSERT_TRUE(region);
  EXPECT_EQ(region->joins[region->box.offset(outside.front())], never);
  EXPECT_LT(region->joins[region->box.offset(voxelOf(*volume, middle + glm::dvec3(0.0, 5.0, 0.0)))], region->step);
}

TEST(RandomWalk, Thorough_IsWhatAClickInAThalamusOpens) {
  FENESTRA_TEST_DATA_OR_SKIP(brain, "labelled/brain-colin27/ch2.nii.gz");
  const auto volume = io::openVolume(brain).volume;
  const RegionFocus click{{{11.0, 18.0, 8.0}}, {}, {}, {}, RegionRule::Tissues};
  const GrowthMemory memory;
  const auto growth = growRegion(*volume, click, wholeOf(volume->grid.dims), {}, memory);
  ASSERT_TRUE(growth);
  EXPECT_TRUE(memory.first()->isWalk);
  const double ml = growth->curve.volume[static_cast<std::size_t>(growth->curve.automatic)] / 1000.0;
  EXPECT_GT(ml, 6.0) << "the atlas has 8.7";
  EXPECT_LT(ml, 13.0);
}

/// The click above, in voxels that are said to be of a CT.
TEST(RandomWalk, DoesNotCompeteInHounsfieldUnits) {
  FENESTRA_TEST_DATA_OR_SKIP(brain, "labelled/brain-colin27/ch2.nii.gz");
  const auto mr = io::openVolume(brain).volume;
  // Some values of a CT lie below zero.
  const auto ct = volumeOf<float>(mr->grid, [&](glm::ivec3 at) { return mr->value(at) - 1.0; });
  ct->modality = Modality::CT;
  ct->unit = "HU";
  ASSERT_TRUE(ct->isInHounsfieldUnits());
  const RegionFocus click{{{11.0, 18.0, 8.0}}, {}, {}, {}, RegionRule::Tissues};
  const GrowthMemory memory;
  ASSERT_TRUE(growRegion(*ct, click, wholeOf(ct->grid.dims), {}, memory));
  EXPECT_FALSE(memory.first()->isWalk);
  EXPECT_FALSE(memory.first()->isBone || memory.first()->isTube) << "beside these there is none in any unit";
}

}  // namespace
}  // namespace fenestra::segmentation::randomWalkTest
