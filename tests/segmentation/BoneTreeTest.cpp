#include "rendering/segmentation/BoneTree.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "rendering/segmentation/BoneVoxels.h"
#include "rendering/segmentation/Mask.h"
#include "rendering/segmentation/Morphology.h"
#include "rendering/segmentation/RegionGrowing.h"
#include "rendering/volume/DistanceTransform.h"
#include "tests/support/Scenes.h"

namespace fenestra::segmentation::boneTreeTest {
namespace {

using tests::gridOf;
using tests::volumeOf;

constexpr double muscle = 55.0, marrow = 30.0, spongiosa = 220.0, cortex = 700.0, blood = 300.0;

/// In Hounsfield units, with a scanner's noise.
template <class ValueAt>
std::shared_ptr<Volume> ctOf(const Grid& grid, ValueAt valueAt) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 15.0);
  const std::shared_ptr<Volume> volume =
      volumeOf<float>(grid, [&](glm::ivec3 at) { return valueAt(at) + noise(random); });
  volume->unit = "HU";
  return volume;
}

double distance(glm::ivec3 at, glm::dvec3 centre) { return glm::distance(glm::dvec3(at), centre); }

/// Two bones with marrow that touch in a joint.
const Grid jointGrid = gridOf({64, 40, 40}, {1.0, 1.0, 1.0});
const glm::dvec3 left(18.0, 20.0, 20.0), right(45.0, 20.0, 20.0);
constexpr double radius = 14.0, spongyRadius = 12.0, marrowRadius = 7.5;
bool inLeft(glm::ivec3 at) { return distance(at, left) <= radius && at.x <= 31; }
bool inRight(glm::ivec3 at) { return distance(at, right) <= radius && at.x > 31; }
double jointValue(glm::ivec3 at) {
  const double depth = std::min(distance(at, left), distance(at, right));
  if (depth <= marrowRadius) return marrow;
  if (depth <= spongyRadius) return spongiosa;
  return inLeft(at) || inRight(at) ? cortex : muscle;
}

template <class InsideAt>
double diceAt(const std::vector<Level>& joins, int step, const Grid& grid, InsideAt insideAt) {
  double both = 0.0, sum = 0.0;
  tests::forEachVoxel(grid.dims, [&](glm::ivec3 at) {
    const bool joined = joins[grid.offset(at)] < step, inside = insideAt(at);
    both += joined && inside ? 2.0 : 0.0;
    sum += (joined ? 1.0 : 0.0) + (inside ? 1.0 : 0.0);
  });
  return both / sum;
}

TEST(BoneTree, PartsTwoBonesAtTheirJointAndHoldsTheirMarrow) {
  const std::shared_ptr<Volume> volume = ctOf(jointGrid, jointValue);
  const std::shared_ptr<const BoneTree> bones = BoneTree::build(*volume, hounsfieldGuess(*volume));
  for (const glm::ivec3 seed : {glm::ivec3(left), glm::ivec3(left) + glm::ivec3(0, 12, 0)})
    EXPECT_GT(diceAt(*bones->joinsOf(seed), BoneTree::lastStep(), jointGrid, inLeft), 0.95);
  EXPECT_GT(diceAt(*bones->joinsOf(glm::ivec3(right)), BoneTree::lastStep(), jointGrid, inRight), 0.95);
}

TEST(BoneTree, LargerTolerancesCrossTheJoint) {
  const std::shared_ptr<Volume> volume = ctOf(jointGrid, jointValue);
  const std::vector<Level> joins = *BoneTree::build(*volume, hounsfieldGuess(*volume))->joinsOf(glm::ivec3(left));
  EXPECT_GT(diceAt(joins, stepCount, jointGrid, [](glm::ivec3 at) { return inLeft(at) || inRight(at); }), 0.95);
}

TEST(BoneTree, HoldsNoSeedFarFromBone) {
  const std::shared_ptr<Volume> volume = ctOf(jointGrid, jointValue);
  EXPECT_FALSE(BoneTree::build(*volume, hounsfieldGuess(*volume))->joinsOf({2, 2, 2}));
}

TEST(BoneVoxels, WhetherOneIsNearIsKnownWithoutAllOfThem) {
  const std::shared_ptr<Volume> volume = ctOf(jointGrid, jointValue);
  const VoxelSet all = boneVoxels(*volume, noiseOf(*volume));
  const VoxelBox whole = wholeOf(jointGrid.dims);
  const std::vector<glm::ivec3> ball = ballOffsets(jointGrid, 4.0);
  int near = 0;
  for (std::size_t i = 0; i < whole.count(); i += 331) {
    const glm::ivec3 voxel = whole.at(i);
    const bool expected = std::any_of(ball.begin(), ball.end(), [&](glm::ivec3 offset) {
      return whole.contains(voxel + offset) && all.holds(whole.offset(voxel + offset));
    });
    near += expected ? 1 : 0;
    EXPECT_EQ(isNearBone(*volume, voxel, ball), expected) << i;
  }
  EXPECT_GT(near, 50);
  EXPECT_TRUE(BoneTree::isNear(*volume, hounsfieldGuess(*volume), glm::ivec3(left))) << "deep in marrow";
  EXPECT_FALSE(BoneTree::isNear(*volume, hounsfieldGuess(*volume), {2, 2, 2}));
}

TEST(BoneTree, AClickFarFromBoneFindsNone) {
  const std::shared_ptr<Volume> volume = ctOf(jointGrid, jointValue);
  const auto bonesAfterClickAt = [&](glm::dvec3 index) {
    const GrowthMemory memory;
    const RegionFocus click{
        {glm::dvec3(jointGrid.worldFromIndex() * glm::dvec4(index, 1.0))}, {}, {}, {}, RegionRule::Tissues};
    EXPECT_TRUE(growRegion(*volume, click, wholeOf(jointGrid.dims), {}, memory));
    return memory.bones();
  };
  EXPECT_FALSE(bonesAfterClickAt({2.0, 2.0, 2.0}));
  EXPECT_TRUE(bonesAfterClickAt(left));
}

TEST(BoneTree, BloodWithContrastAgentIsTooEvenForBone) {
  const Grid grid = gridOf({40, 40, 40}, {1.0, 1.0, 1.0});
  const auto inVessel = [](glm::ivec3 at) { return std::hypot(at.x - 20.0, at.y - 20.0) <= 9.0; };
  const std::shared_ptr<Volume> vessel = ctOf(grid, [&](glm::ivec3 at) { return inVessel(at) ? blood : muscle; });
  const std::shared_ptr<const BoneTree> dense = BoneTree::build(*vessel, hounsfieldGuess(*vessel));
  const std::vector<Level> joins = *dense->joinsOf({20, 20, 20});
  ASSERT_GT(diceAt(joins, BoneTree::lastStep(), grid, inVessel), 0.9);
  EXPECT_FALSE(dense->isBone(*vessel, joins, BoneTree::lastStep()));

  const std::shared_ptr<Volume> joint = ctOf(jointGrid, jointValue);
  const std::shared_ptr<const BoneTree> bones = BoneTree::build(*joint, hounsfieldGuess(*joint));
  EXPECT_TRUE(bones->isBone(*joint, *bones->joinsOf(glm::ivec3(left)), BoneTree::lastStep()));
}

TEST(BoneTree, AClickComparesABoneWithItsNeighbours) {
  const auto leadIn = [](auto valueAt) {
    const glm::dvec3 seed(jointGrid.worldFromIndex() * glm::dvec4(left, 1.0));
    const RegionFocus click{{seed}, {}, {}, {}, RegionRule::Tissues};
    const std::shared_ptr<Volume> volume = ctOf(jointGrid, valueAt);
    return growRegion(*volume, click, wholeOf(jointGrid.dims))->curve.boneLead;
  };
  EXPECT_TRUE(std::isfinite(leadIn(jointValue)));
  EXPECT_FALSE(std::isfinite(leadIn([](glm::ivec3 at) { return at.x <= 31 ? jointValue(at) : muscle; })));
}

TEST(BoneTree, AClickInMarrowTakesItsBoneAlone) {
  const std::shared_ptr<Volume> volume = ctOf(jointGrid, jointValue);
  const glm::dvec3 seed(jointGrid.worldFromIndex() * glm::dvec4(left, 1.0));
  const RegionFocus click{{seed}, {}, {}, {}, RegionRule::Tissues};
  const auto growth = growRegion(*volume, click, wholeOf(jointGrid.dims));
  ASSERT_TRUE(growth);
  const Mask mask = maskAt(*growth, growth->curve.automatic);
  double both = 0.0, sum = 0.0;
  tests::forEachVoxel(jointGrid.dims, [&](glm::ivec3 at) {
    const bool joined = mask.voxels[jointGrid.offset(at)] != 0;
    both += joined && inLeft(at) ? 2.0 : 0.0;
    sum += (joined ? 1.0 : 0.0) + (inLeft(at) ? 1.0 : 0.0);
  });
  EXPECT_GT(both / sum, 0.95);
}

TEST(BoneTree, ABuildThatIsStoppedReturnsNothing) {
  EXPECT_EQ(BoneTree::build(*ctOf(jointGrid, jointValue), std::nullopt, [] { return false; }), nullptr);
}

TEST(BoneVoxels, FillsMarrowButNoWideHole) {
  const Grid grid = gridOf({64, 64, 12}, {1.0, 1.0, 1.0});
  // Rings of two voxels around a canal of 8 mm and around a basin of 40 mm: 50 and 1257 mm².
  const auto inRing = [](glm::ivec3 at, glm::dvec2 centre, double inner) {
    const double away = glm::distance(glm::dvec2(at.x, at.y), centre);
    return away > inner && away <= inner + 2.0;
  };
  const glm::dvec2 canal(8.0, 8.0), basin(38.0, 38.0);
  const std::shared_ptr<Volume> volume =
      ctOf(grid, [&](glm::ivec3 at) { return inRing(at, canal, 4.0) || inRing(at, basin, 20.0) ? cortex : muscle; });
  const VoxelSet voxels = boneVoxels(*volume, noiseOf(*volume));
  EXPECT_TRUE(voxels.holds(grid.offset({8, 8, 6})));
  EXPECT_FALSE(voxels.holds(grid.offset({38, 38, 6})));
  EXPECT_FALSE(voxels.holds(grid.offset({60, 4, 6})));
}

TEST(BoneVoxels, DepthsAreDistancesToWhatIsOutside) {
  const Grid grid = gridOf({40, 36, 30}, {0.8, 1.0, 1.7});
  std::vector<std::uint8_t> mask(grid.voxelCount(), 0), outside(grid.voxelCount(), 1);
  tests::forEachVoxel(grid.dims, [&](glm::ivec3 at) {
    // A ball that the volume's first plane cuts, and a plate.
    const bool inside = distance(at, {4.0, 18.0, 14.0}) < 13.0 || (at.x > 24 && at.x < 30 && at.y > 3);
    mask[grid.offset(at)] = inside ? 1 : 0;
    outside[grid.offset(at)] = inside ? 0 : 1;
  });
  const VoxelSet voxels(mask);
  const std::vector<float> depths = depthsOf(voxels, grid);
  SampledLattice all;
  all.points = grid.dims;
  const std::vector<float> exact = distancesTo(outside, grid, all);
  double most = 0.0;
  for (std::size_t number = 0; number < voxels.size(); ++number) {
    const float expected = exact[voxels.offsets()[number]];
    ASSERT_GE(depths[number], expected * (1.0f - 1e-6f)) << number;  // float32's rounding
    most = std::max(most, static_cast<double>(depths[number] - expected));
  }
  EXPECT_LT(most, 0.1);  // mm: of the ways passed on within the set, some are longer by a small part of a voxel
}

TEST(VoxelSet, NumbersItsMembersInOrder) {
  std::mt19937 random(7);
  std::vector<std::uint8_t> mask(1000);
  for (std::uint8_t& each : mask) each = random() % 3 == 0 ? 1 : 0;
  const VoxelSet set(mask);
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    EXPECT_EQ(set.holds(i), mask[i] != 0);
    if (mask[i] == 0) continue;
    EXPECT_EQ(set.numberOf(i), number);
    EXPECT_EQ(set.offsets()[number++], i);
  }
  EXPECT_EQ(set.size(), number);
}

}  // namespace
}  // namespace fenestra::segmentation::boneTreeTest
