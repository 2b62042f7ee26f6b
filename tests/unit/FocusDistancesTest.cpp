// Distances from the focus on their lattice.

#include "rendering/scene/FocusDistances.h"

#include <gtest/gtest.h>

#include "rendering/scene/Fading.h"
#include "rendering/scene/Scene.h"
#include "tests/support/Scenes.h"

namespace fenestra::focusDistancesTest {
namespace {

using namespace tests;

/// Two voxels of one label, one of another, and values that grow along x.
Scene dots(const Grid& grid) {
  Scene scene;
  scene.volume = volumeOf<float>(grid, [](glm::ivec3 i) { return i.x; });
  scene.labels = labelsOf(grid, [](glm::ivec3 i) {
    return i == glm::ivec3(2, 3, 4) || i == glm::ivec3(9, 3, 4) ? 1 : i == glm::ivec3(5, 7, 1) ? 2 : 0;
  });
  scene.look.focus = LabelFocus{{1}};
  return scene;
}

TEST(FocusDistances, AreThoseToTheNearestVoxelInFocus) {
  const Grid grid = gridOf({12, 10, 8}, {0.5, 2.0, 3.0});
  const FocusDistances distances = focusDistances(dots(grid));
  EXPECT_EQ(distances.lattice.step, glm::ivec3(1));
  EXPECT_EQ(distances.lattice.points, grid.dims);
  EXPECT_EQ(distances.at({2, 3, 4}), 0.0f);
  EXPECT_EQ(distances.at({8, 3, 4}), 0.5f);
  EXPECT_EQ(distances.at({2, 5, 5}), 5.0f);
  EXPECT_FLOAT_EQ(distances.at({11, 0, 0}), static_cast<float>(glm::length(glm::dvec3(1.0, 6.0, 12.0))));
}

TEST(FocusDistances, OfValuesAreThoseToTheVoxelsInRange) {
  const Grid grid = gridOf({12, 10, 8}, {0.5, 2.0, 3.0});
  Scene scene = dots(grid);
  scene.look.focus = ValueFocus{{7.5, 9.0}, 0.0};
  const FocusDistances distances = focusDistances(scene);
  EXPECT_EQ(distances.at({8, 2, 3}), 0.0f);
  EXPECT_EQ(distances.at({7, 2, 3}), 0.5f);
  EXPECT_EQ(distances.at({11, 9, 0}), 1.0f);
}

TEST(FocusDistances, WithoutAFocusAreThoseToTheMiddle) {
  const Grid grid = gridOf({5, 7, 9}, {2.0, 1.0, 1.0});
  Scene scene = dots(grid);
  for (const Focus& focus : {Focus{}, Focus{LabelFocus{{77}}}}) {
    scene.look.focus = focus;
    const FocusDistances distances = focusDistances(scene);
    EXPECT_NEAR(distances.at({2, 3, 4}), 0.0, 1e-6);
    EXPECT_NEAR(distances.at({4, 0, 4}), 5.0, 1e-6);
  }
}

/// Every cell of voxels lies in one of the lattice, and no more points are made than asked for.
TEST(FocusDistances, OfManyVoxelsHaveACoarserLattice) {
  const Grid grid = gridOf({23, 20, 9}, {0.5, 0.6, 3.0});
  const Scene scene = dots(grid);
  const FocusDistances exact = focusDistances(scene);
  for (const std::size_t most : {4139u, 1000u, 200u, 8u, 1u}) {
    const FocusDistances coarse = focusDistances(scene, most);
    EXPECT_LE(coarse.lattice.count(), std::max<std::size_t>(most, 8));
    EXPECT_EQ(coarse.millimetres.size(), coarse.lattice.count());
    const glm::ivec3 last = coarse.lattice.step * (coarse.lattice.points - 1);
    EXPECT_TRUE(glm::all(glm::greaterThanEqual(last, grid.dims - 1)));
    for (int x = 0; x < coarse.lattice.points.x; ++x) {
      const glm::ivec3 point(x, 1, 1), voxel = point * coarse.lattice.step;
      if (!grid.contains(voxel)) continue;
      EXPECT_EQ(coarse.at(point), exact.at(voxel)) << most << ", " << x;
    }
  }
}

TEST(FocusDistances, AreMadeOnlyForARegionThatNeedsThem) {
  Scene scene = dots(gridOf({4, 4, 4}));
  scene.look.method = methods::FocalRegion{};
  EXPECT_FALSE(fadesByDistance(scene.look));
  scene.look.method.of<methods::FocalRegion>().shape = FocalShape::Distance;
  EXPECT_TRUE(fadesByDistance(scene.look));
  scene.look.cutaway.enabled = false;
  EXPECT_FALSE(fadesByDistance(scene.look));
  scene.look.cutaway.enabled = true;
  scene.look.method.kind = kindOf<methods::ContextPreserving>;
  EXPECT_FALSE(fadesByDistance(scene.look));
}

}  // namespace
}  // namespace fenestra::focusDistancesTest
