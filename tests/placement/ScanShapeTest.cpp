// Cut ends and thin stacks, found from made-up volumes.

#include <cmath>

#include <gtest/gtest.h>

#include "rendering/viewpoints/ScanShape.h"
#include "tests/support/Scenes.h"

namespace fenestra::tests::scanShapeTest {
namespace {

using namespace placement;

enum Face : std::size_t { L, P, S, R, A, I };

/// Tissue of 40 HU in air, and points of the focus as continuous indices.
template <class F>
ScanShape shapeOf(const Grid& grid, const F& isBody, const std::vector<glm::dvec3>& focus = {},
                  const std::vector<HalfSpace>& kept = {}) {
  const auto volume = volumeOf<float>(grid, [&](glm::ivec3 i) { return isBody(i) ? 40.0 : -1000.0; });
  volume->unit = "HU";
  return scanShape({volume}, kept, focus);
}

double fromAxis(glm::ivec3 i) { return glm::length(glm::dvec2(i.x, i.y) - 19.5); }

void expectCuts(const ScanShape& shape, const std::array<double, 6>& cuts) {
  for (std::size_t f = 0; f < 6; ++f) EXPECT_NEAR(shape.faces[f].cut, cuts[f], 1e-12) << f;
}

TEST(ScanShape, ACylinderThroughTheVolumeIsCutAtBothEnds) {
  const ScanShape shape = shapeOf(gridOf({40, 40, 40}), [](glm::ivec3 i) { return fromAxis(i) < 14.0; });
  expectCuts(shape, {0, 0, 1, 0, 0, 1});
  for (std::size_t f = 0; f < 6; ++f) EXPECT_EQ(shape.faces[f].contact, f == S || f == I ? 1.0 : 0.0);
  EXPECT_EQ(shape.throughCutEnd({0, 0, 1}), 1.0);
  EXPECT_EQ(shape.throughCutEnd({1, 0, 0}), 0.0);
  const double angle = 0.7;
  EXPECT_NEAR(shape.throughCutEnd({0, std::sin(angle), -std::cos(angle)}), std::pow(std::cos(angle), 2), 1e-12);
}

TEST(ScanShape, WhatEndsWithinTheVolumeOrTouchesItBarelyIsNotCut) {
  const Grid grid = gridOf({40, 40, 40});
  expectCuts(shapeOf(grid, [](glm::ivec3 i) { return fromAxis(i) < 14.0 && i.z > 2 && i.z < 37; }), {});
  // A ball that reaches all six faces.
  expectCuts(shapeOf(grid, [](glm::ivec3 i) { return glm::length(glm::dvec3(i) - 19.5) < 20.0; }, {glm::dvec3(19.5)}),
             {});
  expectCuts(shapeOf(grid, [](glm::ivec3) { return false; }), {});
}

TEST(ScanShape, ANeckIsACutEnd) {
  // Half of the head's greatest cross-section.
  const ScanShape shape = shapeOf(gridOf({40, 40, 40}), [](glm::ivec3 i) {
    return glm::length(glm::dvec3(i) - glm::dvec3(19.5, 19.5, 22.0)) < 15.0 || (i.z < 22 && fromAxis(i) < 10.5);
  });
  EXPECT_NEAR(shape.faces[I].contact, 0.5, 0.05);
  expectCuts(shape, {0, 0, 0, 0, 0, 1});
}

TEST(ScanShape, ASmallEndCountsWhereTheFocusIsBehindIt) {
  // A leg of an eighth of the foot's length above the heel.
  const auto isFoot = [](glm::ivec3 i) {
    return std::abs(i.x - 20) < 8 &&
           ((i.z > 2 && i.z < 12 && i.y > 2 && i.y < 37) || (i.z >= 12 && i.y > 30 && i.y < 37));
  };
  const Grid grid = gridOf({40, 40, 40});
  EXPECT_NEAR(shapeOf(grid, isFoot, {{20, 33, 6}}).faces[S].cut, 1.0, 1e-12);
  EXPECT_LT(shapeOf(grid, isFoot, {{20, 10, 6}}).faces[S].cut, 0.1);
  EXPECT_NEAR(shapeOf(grid, isFoot, {{20, 10, 6}, {20, 33, 6}}).faces[S].cut, 0.5, 1e-12);
}

TEST(ScanShape, APieceFromTheMiddleOfABodyHasNoCutEnd) {
  const Grid grid = gridOf({40, 40, 40});
  expectCuts(shapeOf(grid, [](glm::ivec3) { return true; }, {glm::dvec3(20.0)}), {});
  // With one free side, the others are cut.
  expectCuts(shapeOf(grid, [](glm::ivec3 i) { return i.y > 3; }), {1, 1, 1, 1, 0, 1});
}

TEST(ScanShape, WhatIsClippedOrHiddenIsNoBody) {
  const Grid grid = gridOf({40, 40, 40});
  const auto isBody = [](glm::ivec3 i) { return fromAxis(i) < 14.0; };
  expectCuts(shapeOf(grid, isBody, {}, {{{0, 0, 1}, 5.0}}), {0, 0, 1, 0, 0, 0});
  const auto volume = volumeOf<float>(grid, [&](glm::ivec3 i) { return isBody(i) ? 40.0 : -1000.0; });
  volume->unit = "HU";
  ShownVolume shown{volume};
  shown.table = tableWhere(grid, [](glm::ivec3 i) { return i.z > 35; });
  expectCuts(scanShape(shown, {}, {}), {0, 0, 0, 0, 0, 1});
}

TEST(ScanShape, ValuesThatAreNoHounsfieldUnitsHaveABodyToo) {
  // Noise around 20, tissue from 200 on, a bright spot.
  const Grid grid = obliqueGrid({40, 40, 40});
  const auto volume = volumeOf<std::uint16_t>(grid, [](glm::ivec3 i) {
    return i.x == 20 && i.y == 20 ? 900 : fromAxis(i) < 14.0 ? 200 + 10 * i.z : 10 + (7 * i.x + 3 * i.y) % 20;
  });
  const ScanShape shape = scanShape({volume}, {}, {});
  double through = 0.0;
  for (const ScanShape::Face& face : shape.faces) {
    const double along = std::abs(glm::dot(face.normal, grid.direction[2]));
    EXPECT_NEAR(face.cut, along > 0.5 ? 1.0 : 0.0, 1e-12);
    through += face.cut;
  }
  EXPECT_EQ(through, 2.0);
  EXPECT_NEAR(shape.throughCutEnd(grid.direction[2]), 1.0, 1e-12);
}

TEST(ScanShape, TheFocusLiesOnASideOfTheBody) {
  // A body of 20×10×30 voxels in the volume's lower corner, and a focus in front, to the left and in the middle.
  const auto isBody = [](glm::ivec3 i) { return i.x < 20 && i.y < 10 && i.z < 30; };
  const auto offset = [&](glm::dvec3 focus) { return shapeOf(gridOf({32, 32, 32}), isBody, {focus}).offset; };
  const ScanShape shape = shapeOf(gridOf({32, 32, 32}), isBody, {{9.5, 0.0, 14.5}});
  EXPECT_LT(glm::length(shape.offset - glm::dvec3(0, -1, 0)), 1e-12);
  EXPECT_NEAR(shape.farSide({0, 1, 0}), 1.0, 1e-12) << "from behind";
  EXPECT_NEAR(shape.farSide(glm::normalize(glm::dvec3(1, 1, 0))), std::sqrt(0.5), 1e-12);
  EXPECT_EQ(shape.farSide({0, -1, 0}), 0.0);
  EXPECT_EQ(shape.farSide({1, 0, 0}), 0.0);
  EXPECT_LT(glm::length(offset({19.0, 4.5, 14.5}) - glm::dvec3(1, 0, 0)), 1e-12);
  EXPECT_LT(glm::length(offset({9.5, 4.5, 14.5})), 1e-12);
  EXPECT_EQ(shapeOf(gridOf({32, 32, 32}), isBody).offset, glm::dvec3(0.0)) << "nothing in focus";
}

TEST(ScanShape, AThinStackIsFlatAndItsFrontIsWhereSlicesAreSeenFrom) {
  const auto isBody = [](glm::ivec3) { return true; };
  const glm::dvec3 fronts[] = {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 dims(40);
    dims[axis] = 3;
    const ScanShape shape = shapeOf(gridOf(dims, glm::dvec3(5.0)), isBody);
    EXPECT_EQ(shape.stack.flatness, 1.0);
    EXPECT_EQ(shape.stack.front, fronts[axis]);
    EXPECT_EQ(shape.edgeOn(shape.stack.front), 0.0);
    EXPECT_EQ(shape.edgeOn(-shape.stack.front), 1.0);
    EXPECT_EQ(shape.edgeOn(fronts[(axis + 1) % 3]), 1.0);
  }
  // Three slices far apart, and many close together.
  EXPECT_EQ(shapeOf(gridOf({40, 40, 3}, {1.0, 1.0, 8.0}), isBody).stack.flatness, 1.0);
  EXPECT_EQ(shapeOf(gridOf({40, 40, 20}, {1.0, 1.0, 0.2}), isBody).stack.flatness, 1.0);
  EXPECT_EQ(shapeOf(gridOf({40, 40, 20}), isBody).stack.flatness, 0.0);
  EXPECT_EQ(shapeOf(gridOf({8, 8, 3}), isBody).stack.flatness, 0.0);   // a small box, no stack
  EXPECT_EQ(shapeOf(gridOf({6, 6, 40}), isBody).stack.flatness, 0.0);  // a rod
  // In between, it grows smoothly.
  double before = 1.0;
  for (int slices = 5; slices < 14; ++slices) {
    const double flatness = shapeOf(gridOf({40, 40, slices}), isBody).stack.flatness;
    EXPECT_LE(flatness, before);
    EXPECT_LE(before - flatness, 0.5);
    before = flatness;
  }
  EXPECT_NEAR(before, std::pow(1.0 - (13.0 / 40.0 - 0.125) / (1.0 / 3.0 - 0.125), 2), 1e-12);
}

TEST(ScanShape, TheFrontOfAThinStackIsNoCutEnd) {
  const auto isBody = [](glm::ivec3 i) { return fromAxis(i) < 14.0; };
  EXPECT_EQ(shapeOf(gridOf({40, 40, 3}), isBody).throughCutEnd({0, 0, -1}), 0.0);
  EXPECT_EQ(shapeOf(gridOf({40, 40, 20}), isBody).throughCutEnd({0, 0, -1}), 1.0);
}

}  // namespace
}  // namespace fenestra::tests::scanShapeTest
