// Faces are found by the shape of the head, on a made head and on real ones, and nowhere else.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "rendering/segmentation/Face.h"
#include "tests/support/MadeHead.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::face {
namespace {

using segmentation::FaceRegion;
using segmentation::FaceSearch;
using segmentation::findFace;

/// How much of the voxels that `counts` lies in the region.
template <class Counts>
double shareIn(const FaceRegion& region, const Volume& volume, const Counts& counts) {
  const glm::dmat4 worldFromIndex = volume.grid.worldFromIndex();
  double in = 0.0, all = 0.0;
  for (int z = 0; z < volume.grid.dims.z; ++z)
    for (int y = 0; y < volume.grid.dims.y; ++y)
      for (int x = 0; x < volume.grid.dims.x; ++x) {
        const glm::dvec3 p(worldFromIndex * glm::dvec4(x, y, z, 1.0));
        if (!counts(p)) continue;
        all += 1.0;
        in += region.contains(p) ? 1.0 : 0.0;
      }
  EXPECT_GT(all, 0.0);
  return in / all;
}

/// The skin of eyes, nose, mouth and chin lies in the region, and no brain does.
void expectFace(const FaceSearch& found, const Volume& volume) {
  ASSERT_TRUE(found.isFound) << found.reason;
  EXPECT_EQ(shareIn(found.region, volume, [](const glm::dvec3& p) { return madeHeadAt(p) == MadeTissue::Brain; }), 0.0);
  const double noseAndChin = shareIn(
      found.region, volume, [](const glm::dvec3& p) { return madeHeadAt(p) == MadeTissue::Face && p.y < -75.0; });
  EXPECT_EQ(noseAndChin, 1.0);
  for (const double x : {-30.0, 30.0}) EXPECT_TRUE(found.region.contains({x, -82.0, -40.0})) << "an eye at " << x;
}

TEST(Face, IsFoundInCtAndMr) {
  for (const Modality modality : {Modality::CT, Modality::MR}) {
    SCOPED_TRACE(static_cast<int>(modality));
    const auto volume = madeHead(modality);
    expectFace(findFace(*volume), *volume);
  }
}

TEST(Face, IsFoundWhateverTheOrderOfTheVoxels) {
  const auto volume = madeHead(Modality::MR);
  const FaceSearch straight = findFace(*volume);
  ASSERT_TRUE(straight.isFound) << straight.reason;
  // Each axis runs backwards, so that the lattice begins at its other end.
  Grid& grid = volume->grid;
  const auto voxels = volume->voxels.as<std::int16_t>();
  std::reverse(voxels.begin(), voxels.end());
  grid.origin = glm::dvec3(grid.worldFromIndex() * glm::dvec4(glm::dvec3(grid.dims - 1), 1.0));
  grid.direction = -grid.direction;
  const FaceSearch backwards = findFace(*volume);
  ASSERT_TRUE(backwards.isFound) << backwards.reason;
  // Cells see the voxels that they saw, but where one lies half way between two.
  EXPECT_NEAR(backwards.region.offset, straight.region.offset, 1.0);
  EXPECT_NEAR(backwards.region.lowest, straight.region.lowest, 6.0);  // two cells
}

TEST(Face, KeepsWhatIsBelowTheNeck) {
  const auto volume = madeHead(Modality::CT);
  const FaceSearch found = findFace(*volume);
  ASSERT_TRUE(found.isFound) << found.reason;
  EXPECT_FALSE(found.region.contains({0.0, -150.0, found.region.lowest - 1.0}));
  EXPECT_LT(found.region.lowest, -160.0) << "the chin reaches to -154 mm";
}

TEST(Face, IsNotFoundInWhatIsNoHead) {
  EXPECT_EQ(findFace(*madeHead(Modality::CT, 4.0, 30.0)).reason, "its top is cut off");
  const auto small = madeHead(Modality::CT), large = madeHead(Modality::CT);
  small->grid.spacing *= 0.6;
  large->grid.spacing *= 1.4;
  for (const auto& each : {small, large})
    EXPECT_EQ(findFace(*each).reason, "what it shows has not the size of a head") << each->grid.spacing.x;
  const auto air = madeHead(Modality::CT);
  for (std::int16_t& value : air->voxels.as<std::int16_t>()) value = -1000;
  air->computeRange();
  EXPECT_FALSE(findFace(*air).isFound);
}

TEST(Face, IsNotFoundInABlockOfTheSizeOfAHead) {
  const auto block = madeHead(Modality::CT);
  const Grid& grid = block->grid;
  const auto voxels = block->voxels.as<std::int16_t>();
  for (int z = 0; z < grid.dims.z; ++z)
    for (int y = 0; y < grid.dims.y; ++y)
      for (int x = 0; x < grid.dims.x; ++x) {
        const glm::dvec3 p = grid.origin + grid.spacing * glm::dvec3(x, y, z);
        const bool isBlock = std::abs(p.x) < 75.0 && std::abs(p.y) < 90.0 && p.z < 40.0;
        const bool isKnob = glm::length(glm::dvec2(p.x, p.y)) < 25.0 && p.z < 74.0;
        voxels[grid.offset({x, y, z})] = isBlock || isKnob ? 40 : -1000;
      }
  block->computeRange();
  EXPECT_EQ(findFace(*block).reason, "what it shows has not the shape of a head");
}

/// Points of a real head by its pictures: tip of the nose and chin must go, the frontal lobe's front and base stay.
void expectPoints(const std::filesystem::path& file, const std::vector<glm::dvec3>& face,
                  const std::vector<glm::dvec3>& brain) {
  const FaceSearch found = findFace(*io::openVolume(file).volume);
  ASSERT_TRUE(found.isFound) << found.reason;
  for (const glm::dvec3& p : face) EXPECT_TRUE(found.region.contains(p)) << p.x << ' ' << p.y << ' ' << p.z;
  for (const glm::dvec3& p : brain) EXPECT_FALSE(found.region.contains(p)) << p.x << ' ' << p.y << ' ' << p.z;
}

TEST(Face, IsFoundInARealCt) {
  FENESTRA_TEST_DATA_OR_SKIP(head, "ct-head/ct.nii.gz");  // values from 0 to 1, not HU
  expectPoints(head, {{0, -117, -8}, {0, -82, -70}, {25, -88, 10}}, {{0, -54, 54}, {0, -63, 27}});
}

TEST(Face, IsFoundInARealMr) {
  FENESTRA_TEST_DATA_OR_SKIP(head, "visible-human/vm_head_mri.mha");
  expectPoints(head, {{0, -151, -40}, {35, -122, -20}}, {{0, -102, 9}, {30, -100, 20}});
}

TEST(Face, Exhaustive_IsFoundInAHeadWithShoulders) {
  const std::filesystem::path head = unpackTestData("visible-human/VHMCT1mm_Head.tar.xz", "VHMCT1mm_Head");
  if (head.empty()) GTEST_SKIP() << "needs the test-data file visible-human/VHMCT1mm_Head.tar.xz";
  expectPoints(head, {{256, 143, 1141}, {256, 160, 1045}}, {{256, 181, 1196}, {256, 184, 1164}});
}

TEST(Face, IsNotFoundInARealChest) {
  FENESTRA_TEST_DATA_OR_SKIP(chest, "formats/metaimage/3DCT_lung_baseline_small.mha");
  EXPECT_EQ(findFace(*io::openVolume(chest).volume).reason, "its top is cut off");
}

}  // namespace
}  // namespace fenestra::tests::face
