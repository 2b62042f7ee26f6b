#include "rendering/segmentation/HounsfieldGuess.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "rendering/segmentation/BoneTree.h"
#include "rendering/segmentation/Mask.h"
#include "rendering/segmentation/RegionGrowing.h"
#include "tests/support/Scenes.h"
#include "tests/support/TestData.h"

namespace fenestra::segmentation::hounsfieldGuessTest {
namespace {

using tests::gridOf;
using tests::volumeOf;

constexpr double fat = -100.0, muscle = 55.0, cortex = 900.0, marrow = 30.0;

/// A body in air with two bones of cortex and marrow, in Hounsfield units without noise; `fatShare` of its depth is
/// fat.
const Grid grid = gridOf({64, 48, 48}, {1.0, 1.0, 1.0});
const glm::dvec3 left(18.0, 24.0, 24.0), right(46.0, 24.0, 24.0);
constexpr double radius = 11.0, marrowRadius = 7.5;
bool inBone(glm::ivec3 at, glm::dvec3 centre) { return glm::distance(glm::dvec3(at), centre) <= radius; }
double bodyValue(glm::ivec3 at, double fatShare) {
  const double depth = std::min({at.y, 47 - at.y, at.z, 47 - at.z});
  if (depth < 4.0) return airValue;
  if (const double away = std::min(glm::distance(glm::dvec3(at), left), glm::distance(glm::dvec3(at), right));
      away <= radius)
    return away <= marrowRadius ? marrow : cortex;
  return depth < 4.0 + 20.0 * fatShare ? fat : muscle;
}

/// The body with a scanner's noise, in units of which each is `factor` HU and 0 is `offset` HU.
template <class Stored>
std::shared_ptr<Volume> ctIn(double factor, double offset, double fatShare = 0.2) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 15.0);
  const auto volume = volumeOf<Stored>(grid, [&](glm::ivec3 at) {
    const double value = (std::max(airValue, bodyValue(at, fatShare) + noise(random)) - offset) / factor;
    return std::is_integral_v<Stored> ? std::round(value) : value;
  });
  volume->modality = Modality::Unknown;
  return volume;
}

void expectHounsfieldUnits(const Volume& volume, double factor, double offset) {
  ASSERT_FALSE(volume.isInHounsfieldUnits());
  const std::optional<HounsfieldGuess> guess = hounsfieldGuess(volume);
  ASSERT_TRUE(guess);
  // Muscle is taken for the peak's 45 HU, and a bin is some 10 HU wide.
  for (const double hounsfield : {-900.0, 0.0, 125.0, 900.0})
    EXPECT_NEAR(guess->factor * (hounsfield - offset) / factor + guess->offset, hounsfield, 35.0);
}

TEST(HounsfieldGuess, FindsTheUnitsOfARescaledCt) {
  expectHounsfieldUnits(*ctIn<float>(2500.0, -1000.0), 2500.0, -1000.0);
}

TEST(HounsfieldGuess, FindsTheUnitsOfTwelveBitsWithoutRescale) {
  expectHounsfieldUnits(*ctIn<std::uint16_t>(1.0, -1024.0), 1.0, -1024.0);
}

TEST(HounsfieldGuess, FindsTheUnitsOfBytes) {
  expectHounsfieldUnits(*ctIn<std::uint8_t>(12.0, -1000.0), 12.0, -1000.0);
}

TEST(HounsfieldGuess, TellsFatFromMuscleWhereMostIsFat) {
  expectHounsfieldUnits(*ctIn<float>(2500.0, -1000.0, 0.4), 2500.0, -1000.0);
}

TEST(HounsfieldGuess, LeavesHounsfieldUnitsAndOtherModalitiesAlone) {
  const auto scaled = ctIn<float>(2500.0, -1000.0);
  scaled->modality = Modality::MR;
  EXPECT_FALSE(hounsfieldGuess(*scaled));
  scaled->modality = Modality::CT;
  EXPECT_TRUE(hounsfieldGuess(*scaled));
  EXPECT_FALSE(hounsfieldGuess(*ctIn<float>(1.0, 0.0)));  // it is in Hounsfield units
}

TEST(HounsfieldGuess, T1IsNoCt) {
  // Fluid, grey and white matter, and fat, with the spread that a coil's sensitivity and partial volumes leave.
  std::mt19937 random(9);
  std::normal_distribution<double> spread(0.0, 0.1);
  const auto head = volumeOf<float>(grid, [&](glm::ivec3 at) {
    const double depth = std::min({at.y, 47 - at.y, at.z, 47 - at.z, at.x, 63 - at.x});
    const double mean = depth < 5.0 ? 5.0 : depth < 8.0 ? 160.0 : depth < 10.0 ? 20.0 : depth < 16.0 ? 85.0 : 115.0;
    return std::abs(mean * (1.0 + spread(random)));
  });
  EXPECT_FALSE(hounsfieldGuess(*head));
}

TEST(HounsfieldGuess, VolumesOfAnyKindHaveNone) {
  for (const auto& volume : {volumeOf<float>(gridOf({3, 2, 1}), [](glm::ivec3) { return tests::nan; }),
                             volumeOf<float>(grid, [](glm::ivec3) { return 7.0; }),
                             volumeOf<float>(grid, [](glm::ivec3) { return tests::nan; }),
                             volumeOf<float>(grid, [](glm::ivec3 at) { return static_cast<double>(at.x); }),
                             volumeOf<float>(grid, [](glm::ivec3 at) { return at.x > 30 ? 1.0 : 0.0; })})
    EXPECT_FALSE(hounsfieldGuess(*volume));
}

TEST(HounsfieldGuess, AClickInMarrowTakesItsBoneWhateverTheUnits) {
  const auto volume = ctIn<float>(2500.0, -1000.0);
  const glm::dvec3 seed(grid.worldFromIndex() * glm::dvec4(left, 1.0));
  const RegionFocus click{{seed}, {}, {}, {}, RegionRule::Tissues};
  const GrowthMemory memory;
  const auto growth = growRegion(*volume, click, wholeOf(grid.dims), {}, memory);
  ASSERT_TRUE(growth);
  ASSERT_TRUE(memory.bones());
  EXPECT_TRUE(memory.first()->isBone);
  const Mask mask = maskAt(*growth, growth->curve.automatic);
  double both = 0.0, sum = 0.0;
  tests::forEachVoxel(grid.dims, [&](glm::ivec3 at) {
    const bool joined = mask.voxels[grid.offset(at)] != 0, inside = inBone(at, left);
    both += joined && inside ? 2.0 : 0.0;
    sum += (joined ? 1.0 : 0.0) + (inside ? 1.0 : 0.0);
  });
  EXPECT_GT(both / sum, 0.95);
}

TEST(HounsfieldGuess, TellsARealHeadInCtFromOneInMr) {
  const auto ct = tests::findTestData("ct-head/ct.nii.gz"),
             mr = tests::findTestData("labelled/brain-colin27/ch2.nii.gz");
  if (ct.empty() || mr.empty()) GTEST_SKIP() << "needs ct-head/ct.nii.gz and labelled/brain-colin27/ch2.nii.gz";
  const std::optional<HounsfieldGuess> guess = hounsfieldGuess(*io::openVolume(ct).volume);
  ASSERT_TRUE(guess);
  EXPECT_NEAR(guess->factor * 0.35 + guess->offset, 45.0, 15.0);  // the brain's value in the file
  EXPECT_GT(guess->soft, 0.5);
  EXPECT_FALSE(hounsfieldGuess(*io::openVolume(mr).volume));
}

}  // namespace
}  // namespace fenestra::segmentation::hounsfieldGuessTest
