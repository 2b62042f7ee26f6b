// The sparse index of the focus against an evaluation of every cell, and the box and centre that come with it.

#include "rendering/gpu/FocusIndexing.h"

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "rendering/gpu/LabelIndex.h"
#include "tests/support/Scenes.h"

namespace fenestra::tests::focusIndexTest {
namespace {

FocusIndex indexOf(const Scene& scene) { return buildFocusIndex(scene, brickRanges(shownVolume(scene))); }

/// Around the bricks' side, and volumes with an axis of one voxel.
const std::vector<glm::ivec3> awkwardSizes{{1, 1, 1}, {1, 7, 5}, {6, 1, 9}, {3, 3, 3},
                                           {4, 4, 4}, {5, 4, 3}, {13, 8, 7}};

/// The index's entry for a cell in the cell frame: the bits of its corners (labels), 255 or 0 (values).
unsigned bitsAt(const FocusIndex& index, glm::ivec3 cell) {
  const std::uint32_t slot = index.slots.at(brickOffset(index.bricks, cell / brickSide));
  if (slot < 2) return slot * 255;
  const std::size_t at = (slot - 2) * cellsPerBrick + cellInBrick(cell);
  if (index.kind == FocusIndex::Kind::Labels) return index.cells.at(at / 4) >> (8 * (at % 4)) & 255;
  return index.cells.at(at / 32) >> (at % 32) & 1 ? 255 : 0;
}

struct Expected {
  std::vector<unsigned> bits;  ///< of the cells in the cell frame, x fastest
  std::optional<IndexBox> box;
};

void expectIndex(const FocusIndex& index, glm::ivec3 dims, const Expected& expected) {
  ASSERT_EQ(index.bricks, brickCount(dims));
  std::size_t at = 0;
  std::vector<std::set<unsigned>> met(index.slots.size());
  forEachVoxel(dims + 1, [&](glm::ivec3 cell) {
    EXPECT_EQ(bitsAt(index, cell), expected.bits.at(at))
        << "cell " << cell.x << ' ' << cell.y << ' ' << cell.z << " of " << dims.x << ' ' << dims.y << ' ' << dims.z;
    met[brickOffset(index.bricks, cell / brickSide)].insert(expected.bits[at++]);
  });
  std::set<std::uint32_t> mixed;
  for (std::size_t brick = 0; brick < met.size(); ++brick) {
    const bool isUniform = met[brick] == std::set<unsigned>{0} || met[brick] == std::set<unsigned>{255};
    EXPECT_EQ(index.slots[brick] < 2, isUniform) << "brick " << brick;
    if (index.slots[brick] >= 2) mixed.insert(index.slots[brick]);
  }
  const std::size_t wordsPerBrick = cellsPerBrick / (index.kind == FocusIndex::Kind::Labels ? 4 : 32);
  EXPECT_EQ(index.cells.size(), mixed.size() * wordsPerBrick) << "a slot for each brick that is cut, and no other";
  ASSERT_EQ(index.box.has_value(), expected.box.has_value());
  if (!expected.box) return;
  EXPECT_EQ(index.box->low, expected.box->low);
  EXPECT_EQ(index.box->high, expected.box->high);
}

/// The voxel at corner i of a cell in the cell frame; the volume's edge repeats outwards.
glm::ivec3 cornerOf(glm::ivec3 cell, int corner, glm::ivec3 dims) {
  const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
  return glm::clamp(cell - 1 + step, glm::ivec3(0), dims - 1);
}

Expected labelsByHand(const LabelMap& labels, const std::vector<std::uint16_t>& focus) {
  const auto isIn = [&](glm::ivec3 voxel) {
    return std::find(focus.begin(), focus.end(), labels.value(voxel)) != focus.end();
  };
  Expected expected;
  forEachVoxel(labels.grid.dims + 1, [&](glm::ivec3 cell) {
    unsigned bits = 0;
    for (int corner = 0; corner < 8; ++corner)
      if (isIn(cornerOf(cell, corner, labels.grid.dims))) bits |= 1u << corner;
    expected.bits.push_back(bits);
  });
  forEachVoxel(labels.grid.dims, [&](glm::ivec3 voxel) {
    if (isIn(voxel)) grow(expected.box, voxel, voxel);
  });
  return expected;
}

/// Cells whose corner values overlap the range, flooded over 26 neighbours, without components that are too small.
Expected valuesByHand(const Volume& volume, const ValueFocus& focus) {
  const glm::ivec3 dims = volume.grid.dims;
  Grid cells;  // the interior ones; the border's half cells repeat the nearest
  cells.dims = glm::max(dims - 1, 1);
  enum class State { Out, New, Kept };
  std::vector<State> states;
  forEachVoxel(cells.dims, [&](glm::ivec3 cell) {
    double least = infinity, greatest = -infinity;
    for (int corner = 0; corner < 8; ++corner) {
      double value = volume.value(cornerOf(cell + 1, corner, dims));
      value = std::isnan(value) ? volume.range.low : std::clamp(value, volume.range.low, volume.range.high);
      least = std::min(least, value);
      greatest = std::max(greatest, value);
    }
    states.push_back(least <= focus.values.high && greatest >= focus.values.low ? State::New : State::Out);
  });
  Expected expected;
  forEachVoxel(cells.dims, [&](glm::ivec3 seed) {
    std::vector<glm::ivec3> component;
    const auto flood = [&](glm::ivec3 cell) {
      if (!cells.contains(cell) || states[cells.offset(cell)] != State::New) return;
      states[cells.offset(cell)] = State::Kept;
      component.push_back(cell);
    };
    flood(seed);
    for (std::size_t i = 0; i < component.size(); ++i)
      forEachVoxel(glm::ivec3(3), [&, from = component[i] - 1](glm::ivec3 step) { flood(from + step); });
    const bool isKept = static_cast<double>(component.size()) * volume.grid.voxelVolume() >= focus.minimumComponent;
    for (const glm::ivec3 cell : component) {
      if (isKept) grow(expected.box, cell, glm::min(cell + 1, dims - 1));
      if (!isKept) states[cells.offset(cell)] = State::Out;
    }
  });
  forEachVoxel(dims + 1, [&](glm::ivec3 cell) {
    const glm::ivec3 nearest = glm::clamp(cell - 1, glm::ivec3(0), cells.dims - 1);
    expected.bits.push_back(states[cells.offset(nearest)] == State::Kept ? 255 : 0);
  });
  return expected;
}

TEST(FocusIndex, LabelsAreThoseOfEveryCellsCorners) {
  std::mt19937 random(3);
  for (const glm::ivec3 dims : awkwardSizes)
    for (const double share : {0.0, 0.03, 0.5, 0.97, 1.0}) {
      Scene scene = labelScene(obliqueGrid(dims), [&](glm::ivec3) {
        return std::bernoulli_distribution(share)(random) ? (random() % 2 ? 1 : 300) : 2;
      });
      scene.look.focus = LabelFocus{{1, 300}};
      expectIndex(indexOf(scene), dims, labelsByHand(*scene.labels, {1, 300}));
    }
}

TEST(FocusIndex, LabelsOfOneByteAreReadToo) {
  const glm::ivec3 dims(9, 6, 5);
  Scene scene = labelScene(gridOf(dims), [](glm::ivec3) { return 0; });
  auto labels = std::make_shared<LabelMap>();
  labels->grid = scene.volume->grid;
  labels->voxels = Voxels(ScalarType::UInt8, labels->grid.voxelCount());
  for (std::size_t i = 0; i < labels->voxels.count(); i += 7) labels->voxels.as<std::uint8_t>()[i] = 255;
  scene.labels = labels;
  scene.look.focus = LabelFocus{{255}};
  expectIndex(indexOf(scene), dims, labelsByHand(*labels, {255}));
}

TEST(FocusIndex, FollowsLabelsThatJoinAndLeaveAsIfMadeFromScratch) {
  std::mt19937 random(5);
  std::vector<glm::ivec3> sizes = awkwardSizes;
  sizes.push_back({23, 19, 17});
  for (const glm::ivec3 dims : sizes)
    for (const bool oneByte : {false, true}) {
      // Steps of a region grown from the middle, with noise, and voxels that no step reaches.
      const Grid grid = gridOf(dims);
      Scene scene;
      scene.volume = volumeOf<std::uint8_t>(grid, [](glm::ivec3) { return 0; });
      const auto steps = labelsOf(grid, [&](glm::ivec3 v) {
        const double step = 8.0 * glm::distance(glm::dvec3(v), glm::dvec3(dims - 1) * 0.5) + random() % 20;
        return random() % 9 == 0 ? 0.0 : std::min(1.0 + step, 255.0);
      });
      scene.labels = steps;
      if (oneByte) {
        const auto narrow = std::make_shared<LabelMap>();
        narrow->grid = grid;
        narrow->voxels = Voxels(ScalarType::UInt8, grid.voxelCount());
        const auto from = steps->voxels.as<std::uint16_t>();
        std::copy(from.begin(), from.end(), narrow->voxels.as<std::uint8_t>().begin());
        scene.labels = narrow;
      }
      LabelIndexer indexer(scene.labels);
      FocusIndex index;
      std::vector<unsigned> bits;
      for (int change = 0; change < 30; ++change) {
        // Up, down, by one step and by many; now and then single labels.
        std::vector<std::uint16_t> labels;
        const unsigned last = change % 3 == 0 ? random() % 256 : static_cast<unsigned>(40 + change);
        for (unsigned label = 1; label <= last; ++label)
          if (change % 7 != 0 || random() % 2) labels.push_back(static_cast<std::uint16_t>(label));
        const FocusIndex old = index;
        const LabelIndexer::Change changed = indexer.update(index, labels);
        scene.look.focus = LabelFocus{labels};
        const Expected expected = labelsByHand(*scene.labels, labels);
        expectIndex(index, dims, expected);
        const FocusIndex scratch = indexOf(scene);
        EXPECT_EQ(index.cells.size(), scratch.cells.size());
        EXPECT_EQ(index.occupied(), scratch.occupied());

        // Exactly the reported parts have changed.
        std::set<std::size_t> cells, flipped, layers;
        std::size_t at = 0;
        forEachVoxel(dims + 1, [&](glm::ivec3 cell) {
          const unsigned before = bits.empty() ? 0 : bits[at];
          if (before != expected.bits[at++]) cells.insert(brickOffset(index.bricks, cell / brickSide));
        });
        bits = expected.bits;
        for (std::size_t brick = 0; brick < index.slots.size(); ++brick) {
          const std::uint32_t before = old.slots.empty() ? 0 : old.slots[brick];
          if ((before != 0) != (index.slots[brick] != 0)) flipped.insert(brick);
          if (before != index.slots[brick]) layers.insert(brick / brickOffset(index.bricks, {0, 0, 1}));
        }
        EXPECT_EQ(std::set<std::size_t>(changed.bricks.begin(), changed.bricks.end()), cells);
        std::set<std::size_t> told(changed.filled.begin(), changed.filled.end());
        told.insert(changed.emptied.begin(), changed.emptied.end());
        EXPECT_EQ(told, flipped);
        for (const std::size_t layer : layers) {
          EXPECT_GE(static_cast<int>(layer), changed.firstLayer);
          EXPECT_LE(static_cast<int>(layer), changed.lastLayer);
        }
      }
    }
}

TEST(FocusIndex, AVoxelAtABricksBoundaryReachesBothBricks) {
  // Voxel brickSide - 1 is a corner of the last cell of one brick and of the first cell of the next.
  const glm::ivec3 dims(2 * brickSide, 3, 3), voxel(brickSide - 1, 1, 1);
  const Scene scene = labelScene(gridOf(dims), [&](glm::ivec3 index) { return index == voxel; });
  const FocusIndex index = indexOf(scene);
  EXPECT_GE(index.slots.at(0), 2u);
  EXPECT_GE(index.slots.at(1), 2u);
  EXPECT_EQ(bitsAt(index, {brickSide - 1, 1, 1}), 128u);
  EXPECT_EQ(bitsAt(index, {brickSide, 1, 1}), 64u);
  expectIndex(index, dims, labelsByHand(*scene.labels, {1}));
}

TEST(FocusIndex, ValuesAreCellsThatMeetTheRangeInComponentsThatAreLargeEnough) {
  std::mt19937 random(4);
  for (const glm::ivec3 dims : awkwardSizes)
    for (const double share : {0.0, 0.02, 0.2, 1.0})
      for (const double cells : {0.0, 8.0, 9.0, 30.0}) {
        const Grid grid = obliqueGrid(dims);
        auto volume = volumeOf<std::int16_t>(
            grid, [&](glm::ivec3) { return std::bernoulli_distribution(share)(random) ? 50 : 10 * (random() % 3); });
        volume->slope = -2.0;
        volume->intercept = 7.0;
        volume->computeRange();
        Scene scene;
        scene.volume = volume;
        const ValueFocus focus{{-100.0, -60.0}, cells * grid.voxelVolume()};
        scene.look.focus = focus;
        expectIndex(indexOf(scene), dims, valuesByHand(*volume, focus));
      }
}

TEST(FocusIndex, ComponentsAreConnectedOver26Neighbours) {
  const glm::ivec3 dims(9), middle(4);
  forEachVoxel(glm::ivec3(7), [&](glm::ivec3 step) {
    // Each of two voxels lies in 2×2×2 cells; those of voxels two apart touch at a face, an edge or a corner.
    const glm::ivec3 offset = step - 3;
    if (offset == glm::ivec3(0)) return;
    Scene scene = valueScene(
        gridOf(dims), [&](glm::ivec3 v) { return v == middle || v == middle + offset ? 1.0 : 0.0; }, 0.5);
    ValueFocus& focus = std::get<ValueFocus>(scene.look.focus);
    focus.minimumComponent = 9.0;
    const glm::ivec3 apart = glm::abs(offset);
    EXPECT_EQ(indexOf(scene).box.has_value(), std::max({apart.x, apart.y, apart.z}) <= 2)
        << offset.x << ' ' << offset.y << ' ' << offset.z;
    expectIndex(indexOf(scene), dims, valuesByHand(*scene.volume, focus));
  });
}

TEST(FocusIndex, ACellWhoseCornersLieOnBothSidesOfTheRangeIsKept) {
  const glm::ivec3 dims(6, 5, 4);
  const Scene scene = valueScene(
      gridOf(dims), [](glm::ivec3 index) { return index.x < 3 ? 0.0 : 10.0; }, 4.0, 5.0);
  const FocusIndex index = indexOf(scene);
  EXPECT_EQ(bitsAt(index, {3, 2, 2}), 255u);
  EXPECT_EQ(bitsAt(index, {2, 2, 2}), 0u);
  expectIndex(index, dims, valuesByHand(*scene.volume, std::get<ValueFocus>(scene.look.focus)));
}

TEST(FocusIndex, NonFiniteValuesCountAsTheEndsOfTheRange) {
  const glm::ivec3 dims(7, 6, 5);
  std::mt19937 random(6);
  for (const ValueRange range : {ValueRange{-1.0, 0.5}, ValueRange{19.5, 20.0}, ValueRange{5.0, 6.0}}) {
    const Scene scene = valueScene(
        gridOf(dims),
        [&](glm::ivec3 index) {
          if (index == glm::ivec3(0)) return 0.0;
          if (index == glm::ivec3(6, 5, 4)) return 20.0;
          // Cells with all eight corners at one of them, and mixed ones.
          if (index.x >= 4) return index.y < 2 ? nan : index.y < 4 ? -infinity : infinity;
          const unsigned kind = random() % 20;
          return kind == 0 ? nan : kind == 1 ? -infinity : kind == 2 ? infinity : 10.0;
        },
        range.low, range.high);
    ASSERT_EQ(scene.volume->range.low, 0.0);
    ASSERT_EQ(scene.volume->range.high, 20.0);
    expectIndex(indexOf(scene), dims, valuesByHand(*scene.volume, std::get<ValueFocus>(scene.look.focus)));
  }
}

TEST(FocusIndex, ARangeWithItsEndsSwappedHoldsNothing) {
  const Scene scene = valueScene(
      gridOf({4, 4, 4}), [](glm::ivec3 index) { return index.x; }, 2.5, 1.5);
  EXPECT_FALSE(indexOf(scene).box);
  EXPECT_FALSE(focusCentre(scene));
}

TEST(FocusIndex, CentreIsThatOfTheBoxWithoutDroppedIslands) {
  // A block of voxels 2…5, 2…4, 2…3, and a lone voxel far from it.
  const Grid grid = obliqueGrid({24, 9, 8});
  const auto isBlock = [](glm::ivec3 v) {
    return v.x >= 2 && v.x <= 5 && v.y >= 2 && v.y <= 4 && v.z >= 2 && v.z <= 3;
  };
  Scene scene = valueScene(
      grid, [&](glm::ivec3 v) { return isBlock(v) || v == glm::ivec3(20, 7, 6) ? 100.0 : 0.0; }, 50.0);
  const auto worldOf = [&](glm::dvec3 index) { return glm::dvec3(grid.worldFromIndex() * glm::dvec4(index, 1.0)); };
  const auto expectCentre = [&](glm::dvec3 index) {
    ASSERT_TRUE(focusCentre(scene));
    EXPECT_LT(glm::distance(*focusCentre(scene), worldOf(index)), 1e-9);
    EXPECT_EQ(indexOf(scene).centre(grid), focusCentre(scene));
  };
  // Cells reach a voxel beyond the block. The lone voxel lies in eight cells.
  expectCentre({0.5 * (1 + 21), 0.5 * (1 + 8), 0.5 * (1 + 7)});
  std::get<ValueFocus>(scene.look.focus).minimumComponent = 9.0 * grid.voxelVolume();
  expectCentre({3.5, 3.0, 2.5});
  std::get<ValueFocus>(scene.look.focus).minimumComponent = 1e6;
  EXPECT_FALSE(focusCentre(scene));

  scene.labels = labelsOf(grid, isBlock);
  scene.look.focus = LabelFocus{{1}};
  expectCentre({3.5, 3.0, 2.5});
  scene.look.focus = LabelFocus{{2}};
  EXPECT_FALSE(focusCentre(scene));
  scene.look.focus = std::monostate{};
  EXPECT_FALSE(focusCentre(scene));
}

}  // namespace
}  // namespace fenestra::tests::focusIndexTest
