// The voxels that strokes of a ball brush select: balls and lines by their geometry, soft rims by their values, and
// strokes over a region that grows.

#include "rendering/segmentation/Painting.h"

#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "rendering/segmentation/Mask.h"
#include "rendering/segmentation/RegionGrowing.h"
#include "tests/support/Scenes.h"

namespace fenestra::segmentation::paintingTest {
namespace {

using namespace tests;

glm::dvec3 worldOf(const Grid& grid, glm::dvec3 index) {
  return glm::dvec3(grid.worldFromIndex() * glm::dvec4(index, 1.0));
}

/// A turned grid of other spacings along each axis.
std::shared_ptr<const Volume> rampVolume() {
  return tests::volumeOf<float>(obliqueGrid({30, 26, 22}), [](glm::ivec3 i) { return 10.0 * i.x; });
}

std::vector<std::uint8_t> maskOf(const SelectionStroke& stroke, const Volume& volume, double noise = 1.0) {
  std::vector<std::uint8_t> mask(volume.grid.voxelCount(), 0);
  for (const std::size_t voxel : voxelsOf(stroke, volume, noise)) mask[voxel] = 1;
  return mask;
}

/// Every voxel as `belongs(its centre in the world, its index)` says.
template <class Belongs>
void expectVoxels(const SelectionStroke& stroke, const Volume& volume, double noise, const Belongs& belongs) {
  const std::vector<std::uint8_t> mask = maskOf(stroke, volume, noise);
  std::size_t held = 0;
  for (int z = 0; z < volume.grid.dims.z; ++z)
    for (int y = 0; y < volume.grid.dims.y; ++y)
      for (int x = 0; x < volume.grid.dims.x; ++x) {
        const glm::ivec3 voxel(x, y, z);
        const bool is = mask[volume.grid.offset(voxel)] != 0;
        held += is;
        EXPECT_EQ(is, belongs(worldOf(volume.grid, glm::dvec3(voxel)), voxel)) << x << ", " << y << ", " << z;
      }
  EXPECT_GT(held, 20u);
  EXPECT_LT(held, volume.grid.voxelCount() / 2) << "the test would notice";
}

TEST(Painting, ADabIsABallInTheWorld) {
  const auto volume = rampVolume();
  const glm::dvec3 centre = worldOf(volume->grid, {14.3, 12.1, 10.7});
  expectVoxels({{centre}, 5.2}, *volume, 1.0,
               [&](glm::dvec3 at, glm::ivec3) { return glm::distance(at, centre) <= 5.2; });
}

TEST(Painting, AStrokeIsTheBallAlongItsLine) {
  const auto volume = rampVolume();
  const glm::dvec3 a = worldOf(volume->grid, {4.0, 5.0, 6.0}), b = worldOf(volume->grid, {25.0, 18.0, 15.0});
  // Points of the line, close enough that the greatest error of a distance, (b - a)² / (8 · 20000² · 3), is none.
  expectVoxels({{a, b}, 3.1}, *volume, 1.0, [&](glm::dvec3 at, glm::ivec3) {
    double least = 1e9;
    for (int i = 0; i <= 20000; i += 20) least = std::min(least, glm::distance(at, glm::mix(a, b, i / 20000.0)));
    return least <= 3.1;
  });
}

/// The world's edge cuts a ball off; beyond it there is nothing, however far.
TEST(Painting, KeepsToTheVolume) {
  const auto volume = rampVolume();
  const Grid& grid = volume->grid;
  const glm::dvec3 corner = worldOf(grid, glm::dvec3(0.0));
  const std::size_t whole = voxelsOf({{worldOf(grid, {15.0, 13.0, 11.0})}, 4.0}, *volume, 1.0).size();
  const std::size_t cut = voxelsOf({{corner}, 4.0}, *volume, 1.0).size();
  EXPECT_GT(cut, whole / 12);
  EXPECT_LT(cut, whole / 4);
  for (const double away : {-1e3, 1e3, 1e18}) {
    EXPECT_TRUE(boxOf({{corner + away}, 4.0}, grid).empty()) << away;
    EXPECT_TRUE(voxelsOf({{corner + away}, 4.0}, *volume, 1.0).empty()) << away;
  }
  EXPECT_EQ(voxelsOf({{corner}, 1e6}, *volume, 1.0).size(), grid.voxelCount());
  EXPECT_TRUE(voxelsOf({{}, 4.0}, *volume, 1.0).empty());
}

/// On a ramp, values differ from the ball's mean, that of its centre, by 10 a voxel along x.
TEST(Painting, ASoftRimFollowsTheValues) {
  const auto volume = rampVolume();
  const glm::ivec3 middle(15, 13, 11);
  const glm::dvec3 centre = worldOf(volume->grid, glm::dvec3(middle));
  const double radius = 6.0, softness = 0.6, core = (1.0 - softness) * radius, noise = 4.0;
  int kept = 0, left = 0;
  expectVoxels({{centre}, radius, softness}, *volume, noise, [&](glm::dvec3 at, glm::ivec3 voxel) {
    const double d = glm::distance(at, centre);
    if (d <= core) return true;
    const bool is = d <= radius && 10.0 * std::abs(voxel.x - middle.x) * (d - core) <= alike * noise * (radius - d);
    if (d <= radius) ++(is ? kept : left);
    return is;
  });
  EXPECT_GT(kept, 20);
  EXPECT_GT(left, 20);
  EXPECT_EQ(voxelsOf({{centre}, radius, softness}, *volume, 1e9).size(),
            voxelsOf({{centre}, radius, 0.0}, *volume, 1.0).size())
      << "in much noise all values are alike";
}

TEST(Painting, ValuesThatAreNoNumbersAreLikeNone) {
  const auto volume = tests::volumeOf<float>(
      gridOf({20, 20, 20}), [](glm::ivec3 i) { return i.x >= 12 ? std::numeric_limits<double>::quiet_NaN() : 5.0; });
  const glm::dvec3 centre = worldOf(volume->grid, {10.0, 10.0, 10.0});
  for (const std::size_t voxel : voxelsOf({{centre}, 6.0, 1.0}, *volume, 1.0))
    EXPECT_LT(static_cast<int>(voxel % 20), 12);
}

TEST(Painting, StrokesFollowOneAnotherAndAreCounted) {
  const auto volume = rampVolume();
  const glm::dvec3 a = worldOf(volume->grid, {10.0, 13.0, 11.0}), b = worldOf(volume->grid, {14.0, 13.0, 11.0});
  const SelectionStroke adds{{a}, 5.0}, takes{{b}, 5.0, 0.0, false};
  const std::vector<std::uint8_t> first = maskOf(adds, *volume), second = maskOf(takes, *volume);
  for (const bool taken : {true, false}) {
    // A region that holds every third voxel from step 5 on.
    std::vector<std::uint8_t> steps(volume->grid.voxelCount(), 0);
    for (std::size_t i = 0; i < steps.size(); i += 3) steps[i] = 5;
    std::vector<double> counts(8, 0.0);
    for (std::size_t step = 5; step < counts.size(); ++step)
      counts[step] = static_cast<double>(std::count(steps.begin(), steps.end(), 5));
    const std::vector<SelectionStroke> strokes = taken ? std::vector{adds, takes} : std::vector{takes, adds};
    paint(steps, counts, *volume, 1.0, strokes);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      int expected = i % 3 == 0 ? 5 : 0;
      if (taken ? first[i] && !second[i] : first[i] != 0) expected = 1;
      if (second[i] && (taken || !first[i])) expected = 0;
      EXPECT_EQ(steps[i], expected) << i;
    }
    for (std::size_t step = 0; step < counts.size(); ++step)
      EXPECT_EQ(counts[step],
                std::count_if(steps.begin(), steps.end(), [&](std::uint8_t each) { return each > 0 && each <= step; }))
          << step;
  }
}

TEST(Painting, ARegionMayBePaintedAloneOrOverWhatGrows) {
  const Grid grid = gridOf({40, 40, 40});
  const auto volume = tests::volumeOf<std::int16_t>(
      grid, [](glm::ivec3 i) { return glm::distance(glm::dvec3(i), glm::dvec3(14.0, 20.0, 20.0)) < 8.0 ? 200 : 0; });
  const VoxelBox whole = wholeOf(grid.dims);
  const SelectionStroke ball{{worldOf(grid, {30.0, 20.0, 20.0})}, 6.0},
      bite{{worldOf(grid, {14.0, 20.0, 20.0})}, 3.0, 0.0, false};
  const RegionFocus alone{{}, {}, {}, {ball}};
  EXPECT_TRUE(canGrow(*volume, alone));
  EXPECT_FALSE(canGrow(*volume, {{}, {}, {}, {bite}})) << "nothing to take from";
  const auto painted = growRegion(*volume, alone, whole);
  ASSERT_TRUE(painted);
  const Mask mask = segmentation::maskAt(*painted, painted->stepOf(alone));
  EXPECT_EQ(mask.voxels, maskOf(ball, *volume));
  EXPECT_DOUBLE_EQ(volumeOf(mask), painted->curve.volume[static_cast<std::size_t>(painted->stepOf(alone))]);

  const RegionFocus seeded{{worldOf(grid, {14.0, 26.0, 20.0})}, {}, {}};
  RegionFocus both = seeded;
  both.painted = {ball, bite};
  EXPECT_FALSE(haveSameSeeds(seeded, both));
  const auto grown = growRegion(*volume, seeded, whole), over = growRegion(*volume, both, whole);
  ASSERT_TRUE(grown && over);
  EXPECT_EQ(over->stepOf(both), grown->stepOf(seeded));
  Mask expected = segmentation::maskAt(*grown, grown->stepOf(seeded));
  EXPECT_GT(volumeOf(expected), 1000.0);
  for (const std::size_t voxel : voxelsOf(ball, *volume, 1.0)) expected.voxels[voxel] = 1;
  for (const std::size_t voxel : voxelsOf(bite, *volume, 1.0)) expected.voxels[voxel] = 0;
  const Mask found = segmentation::maskAt(*over, over->stepOf(both));
  EXPECT_EQ(found.voxels, expected.voxels);
  // Painting stroke by stroke gives the same region.
  RegionFocus first = seeded;
  first.painted = {ball};
  const auto begun = paintedOn(*grown, seeded, first, *volume);
  ASSERT_TRUE(begun);
  const auto ended = paintedOn(*begun, first, both, *volume);
  ASSERT_TRUE(ended);
  EXPECT_EQ(segmentation::maskAt(*ended, ended->stepOf(both)).voxels, expected.voxels);
  EXPECT_EQ(ended->curve.volume, over->curve.volume);
  EXPECT_EQ(ended->box, over->box);
  EXPECT_FALSE(paintedOn(*over, both, first, *volume)) << "a stroke is not unpainted";
  EXPECT_FALSE(paintedOn(*painted, alone, first, *volume)) << "other seeds";
  EXPECT_NEAR(over->curve.volume[static_cast<std::size_t>(over->stepOf(both))], volumeOf(found),
              1e-9 * volumeOf(found));
}

}  // namespace
}  // namespace fenestra::segmentation::paintingTest
