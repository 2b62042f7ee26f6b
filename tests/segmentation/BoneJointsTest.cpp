#include "rendering/segmentation/BoneJoints.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "rendering/segmentation/BoneTree.h"
#include "tests/support/Scenes.h"

namespace fenestra::segmentation::boneJointsTest {
namespace {

using tests::gridOf;
using tests::volumeOf;

constexpr double fat = -90.0, cartilage = 170.0, spongiosa = 300.0, cortex = 700.0;

/// A bone of two balls with a neck, and one that touches its first ball across a disc of cartilage, which is dense
/// enough for bone. The disc is wider than the neck.
const Grid jointGrid = gridOf({56, 56, 36}, {1.0, 1.0, 1.0});
constexpr double ball = 10.0, neck = 7.0, shell = 2.0;
constexpr int gapFrom = 24, gapTo = 25;  ///< x
double within(glm::ivec3 at, glm::dvec3 centre) { return ball - glm::distance(glm::dvec3(at), centre); }
double inNeck(glm::ivec3 at) {
  return at.y >= 16 && at.y <= 38 ? neck - glm::distance(glm::dvec2(at.x, at.z), glm::dvec2(18.0, 18.0)) : -1.0;
}
/// Depths below the surface; negative outside.
double inFirst(glm::ivec3 at) {
  const double inBalls = std::max(within(at, {18.0, 16.0, 18.0}), within(at, {18.0, 38.0, 18.0}));
  return std::min(std::max(inBalls, inNeck(at)), static_cast<double>(gapFrom - 1 - at.x));
}
double inSecond(glm::ivec3 at) {
  return std::min(within(at, {31.0, 16.0, 18.0}), static_cast<double>(at.x - gapTo - 1));
}
double jointValue(glm::ivec3 at) {
  const double depth = std::max(inFirst(at), inSecond(at));
  if (depth >= 0.0) return depth < shell ? cortex : spongiosa;
  const bool inDisc = at.x >= gapFrom && at.x <= gapTo && glm::distance(glm::dvec2(at.y, at.z), {16.0, 18.0}) < 8.0;
  return inDisc ? cartilage : fat;
}

TEST(BoneJoints, AGapPartsBonesThatTouchMoreWidelyThanTheyAreThick) {
  const std::shared_ptr<Volume> volume = volumeOf<float>(jointGrid, jointValue);
  volume->unit = "HU";
  const std::shared_ptr<const BoneTree> bones = BoneTree::build(*volume, std::nullopt);
  const std::vector<Level> joins = *bones->joinsOf({18, 38, 18});  // in the other ball: the neck must hold
  double both = 0.0, first = 0.0, second = 0.0, joined = 0.0;
  tests::forEachVoxel(jointGrid.dims, [&](glm::ivec3 at) {
    const bool joinsAt = joins[jointGrid.offset(at)] < BoneTree::lastStep();
    joined += joinsAt ? 1.0 : 0.0;
    first += inFirst(at) >= 0.0 ? 1.0 : 0.0;
    both += joinsAt && inFirst(at) >= 0.0 ? 1.0 : 0.0;
    second += joinsAt && inSecond(at) >= 0.0 ? 1.0 : 0.0;
  });
  EXPECT_GT(2.0 * both / (joined + first), 0.95);
  EXPECT_EQ(second, 0.0);
}

/// Two blocks of `cortex` in a row of voxels of 1 mm, with `gap` voxels between them.
BoneMeetings meetingsAcross(int gap, double deviation = 0.0, const std::function<bool()>& goOn = {}) {
  const Grid grid = gridOf({20, 5, 5}, {1.0, 1.0, 1.0});
  const auto partAt = [gap](glm::ivec3 at) { return at.x < 6 ? 1 : at.x >= 6 + gap && at.x < 12 + gap ? 2 : 0; };
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 1.0);
  const std::shared_ptr<Volume> volume =
      volumeOf<float>(grid, [&](glm::ivec3 at) { return (partAt(at) ? cortex : fat) + deviation * noise(random); });
  volume->unit = "HU";
  std::vector<std::uint8_t> mask(grid.voxelCount());
  tests::forEachVoxel(grid.dims, [&](glm::ivec3 at) { mask[grid.offset(at)] = partAt(at) ? 1 : 0; });
  const VoxelSet voxels(mask);
  std::vector<std::uint32_t> parts;
  for (const std::uint32_t offset : voxels.offsets())
    parts.push_back(static_cast<std::uint32_t>(partAt(wholeOf(grid.dims).at(offset)) - 1));
  BoneMeetings meetings(2);
  EXPECT_EQ(addGaps(*volume, noiseOf(*volume).deviation, voxels, parts, meetings, goOn), !goOn);
  return meetings;
}

TEST(BoneJoints, PartsThatFaceEachOtherMeetAcrossANarrowGapAlone) {
  const BoneMeetings narrow = meetingsAcross(3);
  ASSERT_TRUE(narrow[0].contains(1) && narrow[1].contains(0));
  EXPECT_NEAR(narrow[0].at(1).gap(), (cortex - fat) / cortex, 1e-9);
  EXPECT_NEAR(narrow[1].at(0).side, 25.0 * cortex, 1e-6) << "25 faces of 1 mm²";
  EXPECT_EQ(narrow[0].at(1).depth, 0.0) << "they do not touch";
  EXPECT_FALSE(meetingsAcross(4)[0].contains(1));
}

TEST(BoneJoints, ABorderInEvenBoneIsNoGap) {
  const BoneMeetings meetings = meetingsAcross(0);
  ASSERT_TRUE(meetings[0].contains(1));
  EXPECT_EQ(meetings[0].at(1).gap(), 0.0);
}

TEST(BoneJoints, AreNotFoundWhenThatIsNoLongerWanted) {
  EXPECT_TRUE(meetingsAcross(0, 0.0, [] { return false; })[0].empty());
}

TEST(BoneJoints, LoudNoiseIsNoGap) {
  constexpr double deviation = 60.0;
  // The greatest of four values twice, and the least of two: some two deviations apart.
  EXPECT_LT(meetingsAcross(0, deviation)[0].at(1).gap(), deviation / cortex);
}

}  // namespace
}  // namespace fenestra::segmentation::boneJointsTest
