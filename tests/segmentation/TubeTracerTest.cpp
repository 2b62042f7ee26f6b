#include "rendering/segmentation/TubeTracer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "io/LabelReader.h"
#include "io/VolumeReader.h"
#include "rendering/segmentation/Mask.h"
#include "rendering/segmentation/RegionGrowing.h"
#include "tests/support/Scenes.h"
#include "tests/support/TestData.h"

namespace fenestra::segmentation::tubeTracerTest {
namespace {

using tests::gridOf;
using tests::volumeOf;

constexpr double fat = -90.0, blood = 45.0;

/// In Hounsfield units, with a scanner's noise.
template <class InsideAt>
std::shared_ptr<Volume> ctOf(const Grid& grid, InsideAt insideAt) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 15.0);
  const std::shared_ptr<Volume> volume =
      volumeOf<float>(grid, [&](glm::ivec3 at) { return (insideAt(at) ? blood : fat) + noise(random); });
  volume->unit = "HU";
  return volume;
}

glm::dvec3 worldOf(const Grid& grid, glm::dvec3 index) {
  return glm::dvec3(grid.worldFromIndex() * glm::dvec4(index, 1.0));
}

/// A vessel of 5 mm round a corner, which lies on a block of its own density for most of its way.
const Grid bendGrid = gridOf({84, 84, 60}, {1.0, 1.0, 1.0});
bool inBend(glm::ivec3 at) {
  const double away = std::hypot(at.x - 4.0, at.y - 4.0) - 60.0;
  return std::hypot(away, at.z - 34.0) <= 5.0;
}
bool inBlock(glm::ivec3 at) { return at.x >= 20 && at.y >= 20 && at.z < 31; }
bool inEither(glm::ivec3 at) { return inBend(at) || inBlock(at); }
/// In the middle of the vessel, at an angle from the x axis in radians.
glm::dvec3 inBendAt(double angle) { return {4.0 + 60.0 * std::cos(angle), 4.0 + 60.0 * std::sin(angle), 34.0}; }

/// A vessel of 5 mm along x that opens into a ball of 18 mm.
const Grid bulbGrid = gridOf({96, 50, 50}, {1.0, 1.0, 1.0});
bool inBall(glm::ivec3 at) { return glm::distance(glm::dvec3(at), glm::dvec3(72.0, 25.0, 25.0)) <= 18.0; }
bool inStalk(glm::ivec3 at) { return at.x < 60 && std::hypot(at.y - 25.0, at.z - 25.0) <= 5.0 && !inBall(at); }

RegionFocus clickAt(const Grid& grid, glm::dvec3 index) {
  return {{worldOf(grid, index)}, {}, {}, {}, RegionRule::Tissues};
}

Mask regionOf(const Volume& volume, const RegionFocus& click, std::optional<int> step = {}) {
  const auto growth = growRegion(volume, click, wholeOf(volume.grid.dims));
  return maskAt(*growth, step.value_or(growth->curve.automatic));
}

template <class InsideAt>
double diceOf(const Mask& mask, InsideAt insideAt) {
  double both = 0.0, sum = 0.0;
  tests::forEachVoxel(mask.grid.dims, [&](glm::ivec3 at) {
    const bool holds = mask.voxels[mask.grid.offset(at)] != 0, inside = insideAt(at);
    both += holds && inside ? 2.0 : 0.0;
    sum += (holds ? 1.0 : 0.0) + (inside ? 1.0 : 0.0);
  });
  return both / sum;
}

TEST(TubeSection, AspectIsOfTheAxesWhereverTheMiddleIs) {
  const auto aspectOf = [](double wide, double thick, double offset) {
    TubeSection section;
    for (std::size_t ray = 0; ray < TubeSection::rays; ++ray) {
      // From a point beside the middle of an ellipse, to its wall.
      const double turn = 2.0 * std::numbers::pi * static_cast<double>(ray) / TubeSection::rays;
      const double x = std::cos(turn) / wide, y = std::sin(turn) / thick, from = offset / wide;
      const double square = x * x + y * y, product = x * from;
      section.wall[ray] = (std::sqrt(product * product - square * (from * from - 1.0)) - product) / square;
    }
    return section.aspect();
  };
  EXPECT_NEAR(aspectOf(5.0, 5.0, 0.0), 1.0, 0.01);
  EXPECT_NEAR(aspectOf(5.0, 5.0, 2.0), 1.0, 0.05);
  EXPECT_NEAR(aspectOf(8.0, 4.0, 0.0), 2.0, 0.05);
  EXPECT_NEAR(aspectOf(4.0, 8.0, 1.0), 2.0, 0.05);
}

TEST(SectionFinder, GoesStraightOnWhereTheTubeTouchesItsOwnDensity) {
  const std::shared_ptr<Volume> volume = ctOf(bendGrid, inEither);
  const glm::dvec3 seed = inBendAt(0.78);
  SectionFinder finder(*volume, noiseOf(*volume), glm::ivec3(glm::round(seed)));
  TubeSection plane;
  plane.centre = worldOf(bendGrid, seed + glm::dvec3(0.0, 0.0, 1.0));
  plane.normal = glm::normalize(glm::dvec3(-std::sin(0.78), std::cos(0.78), 0.0));
  plane.right = {0.0, 0.0, 1.0};
  plane.up = glm::cross(plane.normal, plane.right);
  const TubeSection section = finder.centred(plane, nullptr, 2);
  EXPECT_NEAR(section.radius(), 5.0, 1.0);
  EXPECT_GT(section.support, 0.6);
  EXPECT_LT(glm::distance(section.centre, worldOf(bendGrid, seed)), 1.0);
}

TEST(TubeTracer, FollowsABendBesideABlockOfItsDensity) {
  const std::shared_ptr<Volume> volume = ctOf(bendGrid, inEither);
  for (const double angle : {0.3, 0.8, 1.2}) {
    const auto tube = traceTube(*volume, noiseOf(*volume), glm::ivec3(glm::round(inBendAt(angle))));
    ASSERT_TRUE(tube) << angle;
    EXPECT_NEAR(tube->radius, 5.0, 0.7) << angle;
    EXPECT_GT(tube->length, 75.0) << angle << ": the bend is 91 mm long";
  }
}

TEST(TubeTracer, EndsWhereTheTubeOpens) {
  const std::shared_ptr<Volume> volume = ctOf(bulbGrid, [](glm::ivec3 at) { return inBall(at) || inStalk(at); });
  const auto tube = traceTube(*volume, noiseOf(*volume), {20, 25, 25});
  ASSERT_TRUE(tube);
  const TubeRegion region = tubeRegion(*volume, *tube);
  double stalk = 0.0, held = 0.0, ball = 0.0, inside = 0.0;
  tests::forEachVoxel(bulbGrid.dims, [&](glm::ivec3 at) {
    const bool holds = region.box.contains(at) && region.joins[region.box.offset(at)] <= tubeLevel;
    stalk += inStalk(at) ? 1.0 : 0.0;
    held += holds && inStalk(at) ? 1.0 : 0.0;
    ball += inBall(at) ? 1.0 : 0.0;
    inside += holds && inBall(at) ? 1.0 : 0.0;
  });
  EXPECT_GT(held, 0.85 * stalk);
  EXPECT_LT(inside, 0.05 * ball);
}

TEST(TubeTracer, IsTheSameEachTime) {
  const std::shared_ptr<Volume> volume = ctOf(bendGrid, inEither);
  const auto levels = [&] {
    return tubeRegion(*volume, *traceTube(*volume, noiseOf(*volume), glm::ivec3(inBendAt(0.8)))).joins;
  };
  EXPECT_EQ(levels(), levels());
}

TEST(TubeTracer, NeedsNoDepth) {
  const std::shared_ptr<Volume> slice =
      ctOf(gridOf({60, 60, 1}, {1.0, 1.0, 1.0}), [](glm::ivec3 at) { return std::abs(at.y - 30) < 5; });
  traceTube(*slice, noiseOf(*slice), {30, 30, 0});  // whatever it finds
}

TEST(RegionByTube, Thorough_AClickInAVesselTakesItAlone) {
  const std::shared_ptr<Volume> volume = ctOf(bendGrid, inEither);
  for (const double angle : {0.3, 0.8, 1.2})
    EXPECT_GT(diceOf(regionOf(*volume, clickAt(bendGrid, inBendAt(angle))), inBend), 0.85) << angle;
}

TEST(RegionByTube, AClickInAnOrganTakesNoTube) {
  const std::shared_ptr<Volume> volume = ctOf(bulbGrid, [](glm::ivec3 at) { return inBall(at) || inStalk(at); });
  for (const glm::dvec3 index : {glm::dvec3(72.0, 25.0, 25.0), glm::dvec3(80.0, 30.0, 25.0)})
    EXPECT_GT(diceOf(regionOf(*volume, clickAt(bulbGrid, index)), inBall), 0.9);
}

TEST(RegionByTube, TheToleranceMakesItThinnerAndThicker) {
  const std::shared_ptr<Volume> volume = ctOf(bendGrid, inEither);
  const RegionFocus click = clickAt(bendGrid, inBendAt(0.8));
  const auto growth = growRegion(*volume, click, wholeOf(bendGrid.dims));
  const std::vector<double>& sizes = growth->curve.volume;
  const auto own = static_cast<std::size_t>(growth->curve.automatic);
  ASSERT_EQ(own, std::size_t{tubeLevel} + 1);
  EXPECT_NEAR(sizes[own / 2] / sizes[own], 0.25, 0.1) << "half the radius";
  EXPECT_GT(sizes[own + own / 3], 1.3 * sizes[own]);
  EXPECT_LT(sizes.back(), 3.0 * sizes[own]);
}

TEST(RegionByTube, SaysHowFlatItIsInCt) {
  // Two vessels beside each other, which no wall parts.
  const auto inPair = [](glm::ivec3 at) {
    const double away = std::hypot(at.x - 4.0, at.y - 4.0) - 60.0;
    return std::hypot(away / 8.0, (at.z - 34.0) / 4.0) <= 1.0;
  };
  const std::shared_ptr<Volume> pair = ctOf(bendGrid, [&](glm::ivec3 at) { return inPair(at) || inBlock(at); });
  const GrowthMemory memory;
  const auto growth = growRegion(*pair, clickAt(bendGrid, inBendAt(0.8)), wholeOf(bendGrid.dims), {}, memory);
  ASSERT_TRUE(memory.first()->isTube);
  EXPECT_GT(growth->curve.flatness, 1.5);
  const std::shared_ptr<Volume> one = ctOf(bendGrid, inEither);
  EXPECT_LT(traceTube(*one, noiseOf(*one), glm::ivec3(inBendAt(0.8)))->aspect, 1.25);
}

TEST(RegionByTube, CorrectionsCutItAndGoOn) {
  const std::shared_ptr<Volume> volume = ctOf(bendGrid, inEither);
  RegionFocus click = clickAt(bendGrid, inBendAt(0.4));
  const Mask whole = regionOf(*volume, click);
  click.outside = {worldOf(bendGrid, inBendAt(1.3))};
  const Mask cut = regionOf(*volume, click);
  const auto holds = [](const Mask& mask, glm::dvec3 index) {
    return mask.voxels[mask.grid.offset(glm::ivec3(glm::round(index)))] != 0;
  };
  EXPECT_TRUE(holds(whole, inBendAt(1.3)));
  EXPECT_FALSE(holds(cut, inBendAt(1.3)));
  EXPECT_TRUE(holds(cut, inBendAt(0.4)));
  EXPECT_GT(volumeOf(cut), 0.4 * volumeOf(whole));

  // A plug, beyond which the vessel goes on.
  const auto plugged = [](glm::ivec3 at) {
    const double angle = std::atan2(at.y - 4.0, at.x - 4.0);
    return inEither(at) && !(inBend(at) && angle > 0.75 && angle < 1.0);
  };
  const std::shared_ptr<Volume> stopped = ctOf(bendGrid, plugged);
  RegionFocus both = clickAt(bendGrid, inBendAt(0.2));
  both.inside.push_back(worldOf(bendGrid, inBendAt(1.3)));
  const Mask added = regionOf(*stopped, both);
  EXPECT_TRUE(holds(added, inBendAt(0.2)));
  EXPECT_TRUE(holds(added, inBendAt(1.3)));
  EXPECT_LT(volumeOf(added), 1.3 * volumeOf(whole)) << "nothing of the block";
}

TEST(RegionByTube, Thorough_FollowsVesselsWithoutContrastAgent) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "labelled/totalsegmentator-torso");
  const auto volume = io::openVolume(folder / "example_ct.nii.gz").volume;
  const auto labels = io::openLabels(folder / "example_seg_fast_force_split.nii.gz", volume->grid).labels;
  struct Case {
    std::uint16_t label;
    glm::dvec3 seed;
    double least;
    bool isTube;
  };
  const GrowthMemory memory;
  for (const Case& each : {Case{52, {54, 47, 98}, 0.75, true},     // aorta; values and tissues reach 0.36
                           Case{52, {57, 46, 108}, 0.75, true},    // near the scan's end: a tube that is followed anew
                           Case{63, {65, 52, 103}, 0.65, true},    // … ends before the seed, and 1.3 l of liver win
                           Case{63, {63, 56, 91}, 0.65, true},     // inferior vena cava: 0.31
                           Case{79, {57, 36, 74}, 0.65, true},     // spinal cord: 0.64
                           Case{5, {87, 49, 106}, 0.85, false},    // liver
                           Case{29, {56, 43, 74}, 0.7, false}}) {  // vertebra L3
    const Mask truth = maskOf(*labels, each.label);
    const auto growth = growRegion(*volume, clickAt(volume->grid, each.seed), wholeOf(volume->grid.dims), {}, memory);
    const Mask mask = maskAt(*growth, growth->curve.automatic);
    const double dice = diceOf(mask, [&](glm::ivec3 at) { return truth.voxels[truth.grid.offset(at)] != 0; });
    EXPECT_GT(dice, each.least) << each.label;
    EXPECT_EQ(memory.first()->isTube, each.isTube) << each.label;
  }
}

}  // namespace
}  // namespace fenestra::segmentation::tubeTracerTest
