// Voxels hidden around the patient: a made body on a made table, and real CTs.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "io/LabelReader.h"
#include "io/VolumeReader.h"
#include "rendering/segmentation/Couch.h"
#include "tests/support/Scenes.h"
#include "tests/support/TestData.h"

namespace fenestra::segmentation::tableTest {
namespace {

using namespace tests;

constexpr double air = -1000.0;

/// The part of the made scan that a voxel belongs to.
enum class Part { Air, Trunk, Arm, Ear, Lung, Vessel, Table, Cushion, Wire };

/// A trunk with a lung and a vessel in it, an arm beside it, a thin ear on it; a curved table, a cushion on it, and a
/// wire above the body. `at` in mm from the middle, y to the back.
Part partAt(glm::dvec3 at) {
  const glm::dvec2 across(at.x, at.y);
  const auto disc = [&](glm::dvec2 centre, double radius) { return glm::length(across - centre) < radius; };
  if (disc({-40.0, -10.0}, 2.0)) return Part::Vessel;
  if (disc({-40.0, -10.0}, 25.0)) return Part::Lung;
  if (glm::length(across / glm::dvec2(90.0, 60.0)) < 1.0) return Part::Trunk;
  if (disc({120.0, 10.0}, 20.0)) return Part::Arm;
  if (std::abs(at.x + 97.0) < 14.0 && std::abs(at.y) < 2.0 && std::abs(at.z) < 15.0) return Part::Ear;
  const double curve = 90.0 - 0.001 * at.x * at.x;
  if (std::abs(at.y - curve) < 2.5) return Part::Table;
  if (std::abs(at.x) < 50.0 && at.y > 66.0 && at.y < curve - 2.5) return Part::Cushion;
  if (disc({0.0, -100.0}, 1.5)) return Part::Wire;
  return Part::Air;
}

double valueOf(Part part) {
  switch (part) {
    case Part::Air:
      return air;
    case Part::Trunk:
    case Part::Arm:
    case Part::Ear:
      return 40.0;
    case Part::Lung:
      return -850.0;
    case Part::Vessel:
      return 30.0;
    case Part::Table:
      return 100.0;
    case Part::Cushion:
      return -450.0;
    case Part::Wire:
      break;
  }
  return 300.0;
}

Part partOf(const Grid& grid, glm::ivec3 index) {
  return partAt(glm::dvec3(grid.worldFromIndex() * glm::dvec4(index, 1.0)) - grid.centre());
}

std::shared_ptr<const Volume> scan(const Grid& grid) {
  std::shared_ptr<Volume> volume = tests::volumeOf<std::int16_t>(
      grid, [&](glm::ivec3 index) { return static_cast<std::int16_t>(valueOf(partOf(grid, index))); });
  volume->modality = Modality::CT;
  return volume;
}

/// Reversed, sheared, anisotropic and fine grids of 320 × 240 × 60 mm.
std::vector<Grid> grids() {
  Grid reversed = gridOf({160, 120, 30}, {2.0, 2.0, 2.0}, {400.0, -3000.0, 7.0});
  reversed.direction[2] = -reversed.direction[2];
  return {gridOf({160, 120, 30}, {2.0, 2.0, 2.0}), reversed, gridOf({107, 80, 12}, {3.0, 3.0, 5.0}),
          gridOf({320, 240, 60}, {1.0, 1.0, 1.0})};
}

/// The volume that 3-D pictures show without its table.
ShownVolume withoutTable(const std::shared_ptr<const Volume>& volume) {
  Scene scene{volume, nullptr, {}};
  scene.table = tableOf(*volume);
  return shownVolume(scene);
}

TEST(Table, IsHiddenAndTheBodyIsNot) {
  for (const Grid& grid : grids()) {
    const std::shared_ptr<const Volume> volume = scan(grid);
    const ShownVolume shown = withoutTable(volume);
    ASSERT_NE(shown, ShownVolume{volume});
    const ShownVoxels cleared(shown);
    std::size_t wrong = 0, left = 0, table = 0;
    for (int z = 0; z < grid.dims.z; ++z)
      for (int y = 0; y < grid.dims.y; ++y)
        for (int x = 0; x < grid.dims.x; ++x) {
          const glm::ivec3 index(x, y, z);
          const Part part = partOf(grid, index);
          const bool isTable = part == Part::Table || part == Part::Cushion || part == Part::Wire;
          if (isTable) {
            ++table;
            left += cleared.value(index) != air;
          } else {
            wrong += cleared.value(index) != volume->value(index);
          }
        }
    EXPECT_EQ(wrong, 0u) << "of the body";
    EXPECT_GT(table, 1000u);
    EXPECT_EQ(left, 0u) << "of " << table << " voxels of the table";
  }
}

TEST(Table, IsLookedForInHounsfieldUnitsOnly) {
  const Grid grid = grids().front();
  auto volume = std::make_shared<Volume>();
  const std::shared_ptr<const Volume> ct = scan(grid);
  volume->grid = grid;
  volume->voxels = Voxels(ScalarType::Int16, grid.voxelCount());
  std::copy_n(ct->voxels.data(), ct->voxels.byteCount(), volume->voxels.data());
  volume->modality = Modality::MR;
  volume->computeRange();
  EXPECT_EQ(withoutTable(volume), ShownVolume{volume});
  EXPECT_EQ(findTable(*volume).count, 0u);
}

TEST(Table, NoneAndNoBodyLeaveTheVolumeAsItIs) {
  const Grid grid = gridOf({60, 50, 20}, {2.0, 2.0, 2.0});
  for (const double value : {air, 40.0}) {
    std::shared_ptr<Volume> volume = tests::volumeOf<std::int16_t>(grid, [&](glm::ivec3 i) {
      return static_cast<std::int16_t>(glm::length(glm::dvec2(i.x - 30, i.y - 25)) < 20.0 ? value : air);
    });
    volume->modality = Modality::CT;
    EXPECT_EQ(withoutTable(volume), ShownVolume{volume});
  }
  for (const glm::ivec3 dims : {glm::ivec3(1), glm::ivec3(1, 40, 50), glm::ivec3(40, 40, 1)}) {
    std::shared_ptr<Volume> volume = tests::volumeOf<float>(gridOf(dims), [](glm::ivec3 i) {
      return i.x % 3 == 0 ? std::nanf("") : i.x % 3 == 1 ? std::numeric_limits<float>::infinity() : -1000.0f;
    });
    volume->modality = Modality::CT;
    withoutTable(volume);
  }
}

TEST(Table, EqualCallsHideTheSame) {
  const std::shared_ptr<const Volume> volume = scan(grids().front());
  const CoarseMask first = findTable(*volume), second = findTable(*volume);
  EXPECT_EQ(first.cells, second.cells);
  EXPECT_EQ(first.count, second.count);
}

/// How many labelled voxels hiding changes, by their label's name.
std::map<std::string, std::size_t> hiddenLabels(const ShownVolume& shown, const LabelMap& labels) {
  const Volume& volume = *shown.volume;
  const ShownVoxels cleared(shown);
  std::map<std::string, std::size_t> hidden;
  forEachVoxel(volume.grid.dims, [&](glm::ivec3 index) {
    const std::uint16_t value = labels.value(index);
    if (value == 0 || cleared.value(index) == volume.value(index)) return;
    const Label* label = labels.find(value);
    ++hidden[label ? label->name : std::to_string(value)];
  });
  return hidden;
}

TEST(Table, NothingOfALabelledTorsoIsHidden) {
  struct Case {
    const char *image, *labels;
    bool hasTable;
  };
  for (const Case& each :
       {Case{"labelled/totalsegmentator-torso/example_ct.nii.gz",
             "labelled/totalsegmentator-torso/example_seg_fast_force_split.nii.gz", true},
        Case{"labelled/totalsegmentator-dicom/example_ct_dicom",
             "labelled/totalsegmentator-dicom/example_seg_dicom.nii.gz", true},
        Case{"labelled/slicer-ctchest/CTChest4.nrrd", "labelled/slicer-ctchest/Segmentation.seg.nrrd", true}}) {
    const std::filesystem::path image = findTestData(each.image), labels = findTestData(each.labels);
    if (image.empty() || labels.empty()) GTEST_SKIP() << "needs " << each.image;
    const std::shared_ptr<const Volume> volume = io::openVolume(image).volume;
    const ShownVolume cleared = withoutTable(volume);
    const auto map = io::openLabels(labels, volume->grid).labels;
    EXPECT_EQ(hiddenLabels(cleared, *map), (std::map<std::string, std::size_t>{})) << each.image;
    EXPECT_EQ(cleared != ShownVolume{volume}, each.hasTable) << each.image;
  }
}

}  // namespace
}  // namespace fenestra::segmentation::tableTest
