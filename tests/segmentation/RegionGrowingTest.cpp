#include "rendering/segmentation/RegionGrowing.h"

#include <random>

#include <gtest/gtest.h>

#include "io/PhantomFile.h"
#include "rendering/segmentation/Mask.h"
#include "tests/support/Scenes.h"

namespace fenestra::segmentation::regionGrowingTest {
namespace {

using tests::gridOf;
using tests::volumeOf;

glm::dvec3 worldOf(const Grid& grid, glm::ivec3 index) {
  return glm::dvec3(grid.worldFromIndex() * glm::dvec4(glm::dvec3(index), 1.0));
}

RegionFocus seededAt(const Volume& volume, glm::ivec3 index) { return {{worldOf(volume.grid, index)}, {}, {}}; }

Growth grow(const Volume& volume, const RegionFocus& settings) {
  return *growRegion(volume, settings, wholeOf(volume.grid.dims));
}

template <class InsideAt>
double dice(const Mask& mask, InsideAt insideAt) {
  double both = 0.0, either = 0.0;
  tests::forEachVoxel(mask.grid.dims, [&](glm::ivec3 at) {
    const bool a = mask.voxels[mask.grid.offset(at)], b = insideAt(at);
    both += a && b ? 1.0 : 0.0;
    either += (a ? 1.0 : 0.0) + (b ? 1.0 : 0.0);
  });
  return 2.0 * both / either;
}

/// A body of 50 with normal noise on a ground of 0.
template <class InsideAt>
std::shared_ptr<Volume> noisyBody(const Grid& grid, double noise, InsideAt insideAt) {
  std::mt19937 random(11);
  std::normal_distribution<double> deviation(0.0, noise);
  return volumeOf<float>(grid, [&](glm::ivec3 at) { return deviation(random) + (insideAt(at) ? 50.0 : 0.0); });
}

bool inBall(glm::ivec3 at, glm::dvec3 centre, double radius) { return glm::distance(glm::dvec3(at), centre) <= radius; }

TEST(RegionGrowing, FindsANoisyBallByItself) {
  const auto ball = [](glm::ivec3 at) { return inBall(at, glm::dvec3(24.0), 13.0); };
  const auto volume = noisyBody(gridOf(glm::ivec3(49)), 12.0, ball);
  const Growth growth = grow(*volume, seededAt(*volume, {20, 27, 22}));
  EXPECT_GT(dice(maskAt(growth, growth.curve.automatic), ball), 0.95);
  EXPECT_NEAR(growth.noise, 12.0, 1.0);
}

TEST(RegionGrowing, AToleranceIsAThreshold) {
  const auto ball = [](glm::ivec3 at) { return inBall(at, glm::dvec3(15.0), 8.0); };
  const auto volume = noisyBody(gridOf(glm::ivec3(31)), 10.0, ball);
  const Growth growth = grow(*volume, seededAt(*volume, glm::ivec3(15)));
  double before = 0.0;
  for (int step = 0; step <= stepCount; ++step) {
    EXPECT_DOUBLE_EQ(volumeOf(maskAt(growth, step)), growth.curve.volume[static_cast<std::size_t>(step)]);
    EXPECT_GE(growth.curve.volume[static_cast<std::size_t>(step)], before);
    before = growth.curve.volume[static_cast<std::size_t>(step)];
    if (step > 0) {
      EXPECT_EQ(growth.stepOf(growth.toleranceOf(step)), step);
    }
  }
  // As a focus: the labels up to the step.
  const int step = growth.curve.automatic;
  Mask mask = maskAt(growth, stepCount);
  setMask(mask, growth, step);
  EXPECT_EQ(mask.voxels, maskAt(growth, step).voxels);
  tests::forEachVoxel(volume->grid.dims, [&](glm::ivec3 at) {
    const int label = growth.steps->value(at);
    EXPECT_EQ(label >= 1 && label <= step, mask.voxels[mask.grid.offset(at)] == 1);
  });
}

TEST(RegionGrowing, TheRegionOfAToleranceHangsTogether) {
  std::mt19937 random(2);
  const auto volume = volumeOf<float>(gridOf(glm::ivec3(24)), [&](glm::ivec3) { return random() % 100; });
  const Growth growth = grow(*volume, seededAt(*volume, glm::ivec3(12)));
  for (int step = 1; step <= stepCount; step += 9) {
    const Mask mask = maskAt(growth, step);
    EXPECT_EQ(largestPart(mask).voxels, mask.voxels) << step;
  }
}

TEST(RegionGrowing, ClosesANarrowLeak) {
  const glm::dvec3 left(16.0), right(44.0, 16.0, 16.0);
  const auto first = [&](glm::ivec3 at) { return inBall(at, left, 10.0); };
  const auto volume = noisyBody(gridOf({61, 33, 33}), 8.0, [&](glm::ivec3 at) {
    return first(at) || inBall(at, right, 10.0) || (at.y == 16 && at.z == 16 && at.x > 16 && at.x < 44);
  });
  const Growth growth = grow(*volume, seededAt(*volume, glm::ivec3(16)));
  EXPECT_GT(dice(maskAt(growth, growth.curve.automatic), first), 0.95);
}

TEST(RegionGrowing, AnOutsideSeedPartsWhatTouchesWidely) {
  const glm::dvec3 left(16.0), right(34.0, 16.0, 16.0);
  const auto first = [&](glm::ivec3 at) { return inBall(at, left, 10.0) && at.x <= 25; };
  const auto volume =
      noisyBody(gridOf({51, 33, 33}), 8.0, [&](glm::ivec3 at) { return first(at) || inBall(at, right, 10.0); });
  RegionFocus settings = seededAt(*volume, glm::ivec3(16));
  const Growth one = grow(*volume, settings);
  EXPECT_LT(dice(maskAt(one, one.curve.automatic), first), 0.8);
  settings.outside.push_back(right);
  const Growth parted = grow(*volume, settings);
  // The parting surface follows what noise is left where the bodies touch.
  EXPECT_GT(dice(maskAt(parted, parted.curve.automatic), first), 0.95);
  // No tolerance reaches the other side.
  EXPECT_EQ(parted.steps->value({34, 16, 16}), 0);
}

TEST(RegionGrowing, AnInsideSeedAddsATissue) {
  // A ball of 50 with a core of 150 on 0.
  const glm::dvec3 centre(20.0);
  const auto ball = [&](glm::ivec3 at) { return inBall(at, centre, 14.0); };
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0.0, 5.0);
  const auto volume = volumeOf<float>(gridOf(glm::ivec3(41)), [&](glm::ivec3 at) {
    return noise(random) + (inBall(at, centre, 8.0) ? 150.0 : ball(at) ? 50.0 : 0.0);
  });
  RegionFocus settings = seededAt(*volume, {20, 20, 31});
  settings.inside.push_back(centre);
  const Growth both = grow(*volume, settings);
  EXPECT_GT(dice(maskAt(both, both.curve.automatic), ball), 0.95);
}

TEST(RegionGrowing, AnInsideSeedInTheRimAddsNoNeighbour) {
  // A ball of 150 with a rim of 110, which is nearer to a neighbour of 90 than to the ball.
  const glm::dvec3 centre(20.0);
  const auto ball = [&](glm::ivec3 at) { return inBall(at, centre, 10.0); };
  const auto rim = [&](glm::ivec3 at) { return !ball(at) && inBall(at, centre, 11.0); };
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0.0, 2.0);
  const auto volume = volumeOf<float>(gridOf(glm::ivec3(41)), [&](glm::ivec3 at) {
    return noise(random) + (ball(at) ? 150.0 : rim(at) ? 110.0 : at.z > 20 ? 90.0 : 0.0);
  });
  volume->modality = Modality::MR;  // else its three values pass for a CT's, and the ball for a bone with its rim
  RegionFocus settings = seededAt(*volume, glm::ivec3(20));
  settings.rule = RegionRule::Tissues;
  const Growth one = grow(*volume, settings);
  const Mask before = maskAt(one, one.curve.automatic);
  const glm::ivec3 seed(20, 20, 31);
  ASSERT_TRUE(rim(seed));
  ASSERT_FALSE(before.voxels[volume->grid.offset(seed)]);
  settings.inside.push_back(worldOf(volume->grid, seed));
  const Growth both = grow(*volume, settings);
  const Mask after = maskAt(both, both.curve.automatic);
  EXPECT_TRUE(after.voxels[volume->grid.offset(seed)]);
  double added = 0.0, wrong = 0.0;
  tests::forEachVoxel(volume->grid.dims, [&](glm::ivec3 at) {
    const std::size_t i = volume->grid.offset(at);
    EXPECT_GE(after.voxels[i], before.voxels[i]);
    added += after.voxels[i] && !before.voxels[i] ? 1.0 : 0.0;
    wrong += after.voxels[i] && !before.voxels[i] && !ball(at) && !rim(at) ? 1.0 : 0.0;
  });
  EXPECT_GT(added, 10.0);
  EXPECT_EQ(wrong, 0.0);
}

TEST(RegionGrowing, GrowsAThinTube) {
  // Two voxels thick, thinner than the ball that closes leaks.
  const auto tube = [](glm::ivec3 at) { return (at.y == 10 || at.y == 11) && (at.z == 10 || at.z == 11); };
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0.0, 5.0);
  const auto volume =
      volumeOf<float>(gridOf({40, 22, 22}), [&](glm::ivec3 at) { return noise(random) + (tube(at) ? 200.0 : 0.0); });
  const Growth growth = grow(*volume, seededAt(*volume, {20, 10, 11}));
  double best = 0.0;
  for (int step = 1; step <= stepCount; ++step) best = std::max(best, dice(maskAt(growth, step), tube));
  EXPECT_GT(best, 0.9);
}

TEST(RegionGrowing, PutsTheSurfaceWhereAVoxelHoldsHalfOfEach) {
  // A ball whose surface voxels hold both tissues by their share, and darker ground around a brighter body.
  const glm::dvec3 centre(20.3, 19.8, 20.1);
  const double radius = 11.4;
  for (const double body : {300.0, -300.0}) {
    std::mt19937 random(6);
    std::normal_distribution<double> noise(0.0, 6.0);
    const auto volume = volumeOf<float>(gridOf(glm::ivec3(41)), [&](glm::ivec3 at) {
      const double share = std::clamp(radius - glm::distance(glm::dvec3(at), centre) + 0.5, 0.0, 1.0);
      return noise(random) + share * body;
    });
    const Growth growth = grow(*volume, seededAt(*volume, {24, 17, 21}));
    // Voxels as full as half differ by the noise alone: 2 % of the surface's, which are a quarter of the ball's.
    EXPECT_GT(dice(maskAt(growth, growth.curve.automatic), [&](glm::ivec3 at) { return inBall(at, centre, radius); }),
              0.99)
        << body;
  }
}

TEST(RegionGrowing, ThePreviewIsThePartOfTheWhole) {
  const auto ball = [](glm::ivec3 at) { return inBall(at, {90.0, 20.0, 20.0}, 14.0); };
  const auto volume = noisyBody(gridOf({180, 41, 41}), 8.0, ball);
  const RegionFocus settings = seededAt(*volume, {90, 20, 20});
  const VoxelBox near = previewBox(*volume, settings);
  ASSERT_LT(near.count(), volume->grid.voxelCount());
  const Growth preview = *growRegion(*volume, settings, near), whole = grow(*volume, settings);
  EXPECT_EQ(preview.box, near);
  const int step = whole.curve.automatic;
  EXPECT_EQ(maskAt(preview, step).voxels, maskAt(whole, step).voxels);
}

TEST(RegionGrowing, KnowsTheVoxelOfAPosition) {
  const Grid grid = tests::obliqueGrid({5, 6, 7});
  EXPECT_EQ(voxelAt(grid, worldOf(grid, {4, 0, 6})), glm::ivec3(4, 0, 6));
  EXPECT_FALSE(voxelAt(grid, worldOf(grid, {5, 0, 6})));
  EXPECT_FALSE(voxelAt(grid, glm::dvec3(1e30)));
  EXPECT_FALSE(voxelAt(grid, glm::dvec3(tests::nan)));
}

TEST(RegionGrowing, StopsWhenAskedTo) {
  const auto volume = noisyBody(gridOf(glm::ivec3(20)), 5.0, [](glm::ivec3) { return true; });
  const RegionFocus settings = seededAt(*volume, glm::ivec3(10));
  int all = 0;
  double last = -1.0;
  ASSERT_TRUE(growRegion(*volume, settings, wholeOf(volume->grid.dims), [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return ++all > 0;
  }));
  EXPECT_EQ(last, 1.0);
  // Whenever it is asked to, but for the last time, when the result is there.
  for (int stop = 1; stop < all; stop += 17) {
    int asked = 0;
    EXPECT_FALSE(growRegion(*volume, settings, wholeOf(volume->grid.dims), [&](double) { return ++asked < stop; }));
    EXPECT_EQ(asked, stop);
  }
}

TEST(RegionGrowing, TakesVolumesOfAnyKind) {
  const auto single = volumeOf<std::uint8_t>(gridOf(glm::ivec3(1)), [](glm::ivec3) { return 3; });
  EXPECT_EQ(volumeOf(maskAt(grow(*single, seededAt(*single, glm::ivec3(0))), stepCount)), 1.0);
  const auto flat = volumeOf<std::int16_t>(gridOf({30, 20, 1}), [](glm::ivec3) { return -5; });
  EXPECT_EQ(volumeOf(maskAt(grow(*flat, seededAt(*flat, {3, 4, 0})), stepCount)), 600.0);
  const auto holes = volumeOf<float>(gridOf(glm::ivec3(12)), [](glm::ivec3 at) {
    return at.x == 6 ? tests::nan : at.y == 6 ? tests::infinity : at.z == 6 ? -tests::infinity : 1.0 + at.x;
  });
  for (const glm::ivec3 seed : {glm::ivec3(6), glm::ivec3(1), glm::ivec3(1, 6, 1)})
    EXPECT_GT(volumeOf(maskAt(grow(*holes, seededAt(*holes, seed)), stepCount)), 0.0);
}

TEST(RegionGrowing, SeedsAndSettingsCompare) {
  RegionFocus a{{glm::dvec3(1.0)}, {}, 20.0}, b = a;
  EXPECT_EQ(a, b);
  b.outside.push_back(glm::dvec3(2.0));
  EXPECT_NE(a, b);
  b = a;
  b.tolerance.reset();
  EXPECT_NE(a, b);
}

/// A built-in phantom's structure and a point in it, mm.
struct PhantomCase {
  const char* phantom;
  std::uint16_t label;
  glm::dvec3 seed;
};
void PrintTo(const PhantomCase& each, std::ostream* out) { *out << each.phantom << ' ' << each.label; }

class PhantomGrowing : public ::testing::TestWithParam<PhantomCase> {};

TEST_P(PhantomGrowing, Thorough_FindsTheStructure) {
  const PhantomCase& each = GetParam();
  const io::OpenedPhantom phantom = io::openPhantom(each.phantom, 200);
  const Growth growth = grow(*phantom.volume.volume, {{each.seed}, {}, {}});
  const auto inside = [&](glm::ivec3 at) { return phantom.labels->value(at) == each.label; };
  ASSERT_TRUE(inside(*voxelAt(phantom.labels->grid, each.seed)));
  EXPECT_GT(dice(maskAt(growth, growth.curve.automatic), inside), 0.95);
}

INSTANTIATE_TEST_SUITE_P(Bodies, PhantomGrowing,
                         ::testing::Values(PhantomCase{"torso", 17, {88.0, 40.0, -40.0}},  // spleen
                                           PhantomCase{"torso", 20, {78.0, 44.0, -98.0}},  // left kidney
                                           PhantomCase{"head", 25, {27.0, 24.0, 46.0}}));  // tumour

}  // namespace
}  // namespace fenestra::segmentation::regionGrowingTest
