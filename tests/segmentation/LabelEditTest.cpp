// Label maps before and after an edit, to the voxel.

#include "rendering/segmentation/LabelEdit.h"

#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::segmentation::labelEditTest {
namespace {

using tests::gridOf;

const Grid grid = gridOf({9, 7, 5});

Mask randomMask(unsigned seed) {
  std::mt19937 random(seed);
  Mask mask{grid, std::vector<std::uint8_t>(grid.voxelCount())};
  for (std::uint8_t& voxel : mask.voxels) voxel = random() % 3 == 0;
  return mask;
}

std::shared_ptr<LabelMap> randomLabels(unsigned seed, std::vector<std::uint16_t> values) {
  std::mt19937 random(seed);
  auto map = std::make_shared<LabelMap>();
  map->grid = grid;
  const bool wide = values.back() > 255;
  map->voxels = Voxels(wide ? ScalarType::UInt16 : ScalarType::UInt8, grid.voxelCount());
  for (std::size_t i = 0; i < grid.voxelCount(); ++i) {
    const std::size_t at = random() % (values.size() + 1);
    const std::uint16_t value = at == 0 ? std::uint16_t{0} : values[at - 1];
    if (wide)
      map->voxels.as<std::uint16_t>()[i] = value;
    else
      map->voxels.as<std::uint8_t>()[i] = static_cast<std::uint8_t>(value);
  }
  for (const std::uint16_t value : values) map->labels.push_back({value, "label", defaultLabelColour(value)});
  return map;
}

void expectSame(const LabelMap* a, const LabelMap* b) {
  ASSERT_EQ(a == nullptr, b == nullptr);
  if (!a) return;
  EXPECT_EQ(a->grid, b->grid);
  EXPECT_EQ(a->labels, b->labels);
  ASSERT_EQ(a->voxels.type(), b->voxels.type());
  EXPECT_EQ(std::memcmp(a->voxels.data(), b->voxels.data(), a->voxels.byteCount()), 0);
}

TEST(LabelEdit, TheFirstLabelComesAndGoes) {
  const Mask mask = randomMask(1);
  const Label label{1, "kept", {0.1, 0.2, 0.3}};
  const LabelEdit edit = relabel(nullptr, mask, label, Overlap::Take);
  const auto after = edit.applied(nullptr);
  ASSERT_TRUE(after);
  EXPECT_EQ(after->labels, std::vector<Label>{label});
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) ASSERT_EQ(after->voxels.as<std::uint8_t>()[i], mask.voxels[i]);
  EXPECT_EQ(edit.reverted(after.get()), nullptr);
}

TEST(LabelEdit, OverlapsAreTakenOrLeft) {
  const auto before = randomLabels(2, {1, 4});
  const Mask mask = randomMask(3);
  for (const Overlap overlap : {Overlap::Take, Overlap::Leave}) {
    const LabelEdit edit = relabel(before.get(), mask, {4, "grown", {}}, overlap);
    const auto after = edit.applied(before.get());
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
      const std::uint8_t was = before->voxels.as<std::uint8_t>()[i], is = after->voxels.as<std::uint8_t>()[i];
      const bool others = was == 1;
      if (mask.voxels[i])
        ASSERT_EQ(is, others && overlap == Overlap::Leave ? 1 : 4);
      else
        ASSERT_EQ(is, others ? 1 : 0);
    }
    EXPECT_EQ(after->find(4)->name, "grown");
    expectSame(edit.reverted(after.get()).get(), before.get());
  }
}

TEST(LabelEdit, ComesBackToTheBitWhereTheVoxelsTypeChanges) {
  const auto before = randomLabels(4, {2, 255});
  const LabelEdit edit = relabel(before.get(), randomMask(5), {256, "wide", {}}, Overlap::Take);
  const auto after = edit.applied(before.get());
  EXPECT_EQ(after->voxels.type(), ScalarType::UInt16);
  expectSame(edit.reverted(after.get()).get(), before.get());
  expectSame(edit.applied(edit.reverted(after.get()).get()).get(), after.get());
}

TEST(LabelEdit, HoldsRunsInsteadOfVoxels) {
  const Grid large = gridOf({100, 100, 10});
  Mask mask{large, std::vector<std::uint8_t>(large.voxelCount(), 1)};
  const LabelEdit edit = relabel(nullptr, mask, {1, "all", {}}, Overlap::Take);
  EXPECT_EQ(edit.runs.size(), 1u);
  EXPECT_LT(edit.bytes(), 1000u);
}

TEST(LabelEdit, FindsAFreeLabel) {
  EXPECT_EQ(freeLabel(nullptr), 1);
  EXPECT_EQ(freeLabel(randomLabels(6, {1, 2, 5}).get()), 3);
}

}  // namespace
}  // namespace fenestra::segmentation::labelEditTest
