// Slices that stand as walls: which slice, where it stands for standard views, and the lines on it.

#include "rendering/scene/Walls.h"

#include <gtest/gtest.h>

#include "rendering/scene/Edges.h"
#include "tests/support/Scenes.h"

namespace fenestra::tests::wallsTest {
namespace {

constexpr MethodStages::Walls around{WallPlacement::Around, true, true, true, true};
constexpr MethodStages::Walls inside{WallPlacement::Inside, true, true, true, true};

const Grid grid = gridOf({20, 30, 40}, {1.0, 2.0, 0.5}, {-5.0, 7.0, 100.0});
/// Its box from the first corner to the last: half a voxel beyond the centres.
constexpr glm::dvec3 low(-5.5, 6.0, 99.75), high(14.5, 66.0, 119.75);
const double margin = wallMargin * 0.5 * glm::distance(low, high);

Wall wallOf(SlicePlane plane, const MethodStages::Walls& walls, const Camera& camera, const ShownSlices& slices = {}) {
  for (const Wall& wall : wallsAt(walls, grid, slices, camera))
    if (wall.plane == plane) return wall;
  ADD_FAILURE() << "no such wall";
  return {};
}

TEST(Walls, StandOnTheFarSidesOfTheVolume) {
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    // From the patient's left front, above: the walls stand on the right, behind and below.
    const Camera near = Camera::fromAngles(40.0, 30.0, grid, projection);
    EXPECT_NEAR(wallOf(SlicePlane::Sagittal, around, near).origin.x, low.x - margin, 1e-12);
    EXPECT_NEAR(wallOf(SlicePlane::Coronal, around, near).origin.y, high.y + margin, 1e-12);
    EXPECT_NEAR(wallOf(SlicePlane::Axial, around, near).origin.z, low.z - margin, 1e-12);
    // From the patient's right back, below: on the other three.
    const Camera far = Camera::fromAngles(220.0, -30.0, grid, projection);
    EXPECT_NEAR(wallOf(SlicePlane::Sagittal, around, far).origin.x, high.x + margin, 1e-12);
    EXPECT_NEAR(wallOf(SlicePlane::Coronal, around, far).origin.y, low.y - margin, 1e-12);
    EXPECT_NEAR(wallOf(SlicePlane::Axial, around, far).origin.z, high.z + margin, 1e-12);
    for (const auto& [view, plane, place] : {std::tuple(StandardView::Anterior, SlicePlane::Coronal, high.y + margin),
                                             std::tuple(StandardView::Posterior, SlicePlane::Coronal, low.y - margin),
                                             std::tuple(StandardView::Left, SlicePlane::Sagittal, low.x - margin),
                                             std::tuple(StandardView::Right, SlicePlane::Sagittal, high.x + margin),
                                             std::tuple(StandardView::Superior, SlicePlane::Axial, low.z - margin),
                                             std::tuple(StandardView::Inferior, SlicePlane::Axial, high.z + margin)}) {
      const Wall wall = wallOf(plane, around, Camera::standard(view, grid, projection));
      const int axis = plane == SlicePlane::Axial ? 2 : plane == SlicePlane::Sagittal ? 0 : 1;
      EXPECT_NEAR(wall.origin[axis], place, 1e-12);
    }
  }
}

TEST(Walls, ShowTheSliceNearestToTheCrosshair) {
  const Camera camera = Camera::fromAngles(40.0, 30.0, grid);
  const ShownSlices at{.crosshair = glm::dvec3(2.4, 30.9, 104.3)};  // index 7.4, 11.95, 8.6
  const Wall sagittal = wallOf(SlicePlane::Sagittal, inside, camera, at);
  EXPECT_EQ(sagittal.slice, 7);
  EXPECT_EQ(sagittal.size, glm::ivec2(30, 40));
  EXPECT_EQ(sagittal.origin, glm::dvec3(2.0, 7.0, 100.0)) << "where its voxels lie";
  EXPECT_EQ(sagittal.worldFromPlace({3.0, 4.0}), glm::dvec3(2.0, 13.0, 102.0));
  EXPECT_EQ(sagittal.indexFromPlace({3.0, 4.0}), glm::dvec3(7.0, 3.0, 4.0));
  EXPECT_EQ(wallOf(SlicePlane::Coronal, inside, camera, at).slice, 12);
  EXPECT_EQ(wallOf(SlicePlane::Axial, inside, camera, at).slice, 9);
  EXPECT_EQ(wallOf(SlicePlane::Axial, inside, camera).slice, 20) << "the volume's middle, between two slices";
  EXPECT_EQ(wallOf(SlicePlane::Axial, inside, camera, {.crosshair = glm::dvec3(0.0, 0.0, 1e6)}).slice, 39);
  EXPECT_EQ(wallOf(SlicePlane::Axial, around, camera, at).slice, 9);
}

TEST(Walls, AreTheOnesThatAreOn) {
  const Camera camera = Camera::fromAngles(40.0, 30.0, grid);
  MethodStages::Walls some = around;
  some.axial = some.coronal = false;
  const std::vector<Wall> walls = wallsAt(some, grid, {}, camera);
  ASSERT_EQ(walls.size(), 1u);
  EXPECT_EQ(walls[0].plane, SlicePlane::Sagittal);
}

/// On an oblique and sheared grid a wall keeps the parallelogram of its voxels and stands beyond all of the box.
TEST(Walls, OfAShearedGridStandParallelToTheirSlices) {
  Grid sheared = obliqueGrid({20, 30, 12});
  sheared.direction[2] = glm::normalize(sheared.direction[2] + 0.3 * sheared.direction[1]);
  const Camera camera = Camera::fromAngles(25.0, 15.0, sheared);
  for (const Wall& wall : wallsAt(around, sheared, {}, camera)) {
    const glm::dvec3 normal = glm::normalize(glm::cross(wall.right, wall.down));
    const double side = glm::dot(normal, camera.eye - wall.origin) < 0.0 ? -1.0 : 1.0;
    double nearest = infinity;
    for (const glm::dvec3& corner : sheared.corners())
      nearest = std::min(nearest, side * glm::dot(normal, corner - wall.origin));
    EXPECT_NEAR(nearest, wallMargin * sheared.boundingRadius(), 1e-9) << "on the eye's side, a margin away";
    const glm::dvec3 voxel(sheared.worldFromIndex() * glm::dvec4(wall.indexFromPlace({3.0, 5.0}), 1.0));
    EXPECT_NEAR(glm::distance(wall.worldFromPlace({3.0, 5.0}) - wall.shift, voxel), 0.0, 1e-9);
    EXPECT_NEAR(glm::length(glm::cross(wall.shift, normal)), 0.0, 1e-9);
    // Lengths and angles on the wall are those of the world.
    const glm::dmat2 mm = wall.mmFromPlace();
    for (const glm::dvec2 step : {glm::dvec2(1.0, 0.0), glm::dvec2(0.0, 1.0), glm::dvec2(2.0, -3.0)})
      EXPECT_NEAR(glm::length(mm * step), glm::length(step.x * wall.right + step.y * wall.down), 1e-12);
  }
}

TEST(Walls, CarryTheOutlinesOfVisibleLabelsInTheirColours) {
  Scene scene;
  scene.volume = volumeOf(grid, [](glm::ivec3) { return 0.0; });
  const auto labels = labelsOf(grid, [](glm::ivec3 i) {
    return i.x >= 5 && i.x < 15 && i.y >= 10 && i.y < 20 && i.z == 9 ? (i.x < 10 ? 3 : 4)
           : i.z == 9 && i.x > 17                                    ? 9
                                                                     : 0;
  });
  labels->labels = {{3, "three", {1.0, 0.0, 0.0}}, {4, "four", {0.0, 1.0, 0.0}}};
  scene.labels = labels;
  put(scene.look.labels, {.label = 4, .colour = glm::dvec3(0.0, 0.0, 1.0)});
  put(scene.look.labels, {.label = 9, .visible = false});
  const Camera camera = Camera::fromAngles(40.0, 30.0, grid);
  const ShownSlices at{.crosshair = glm::dvec3(2.4, 30.9, 104.3)};
  const auto on = [&](const MethodStages::Walls& walls) {
    return linesOn(wallOf(SlicePlane::Axial, walls, camera, at), walls, scene, at);
  };
  const std::vector<WallLine> lines = on(inside);
  ASSERT_EQ(lines.size(), 2u) << "the third label is invisible";
  EXPECT_EQ(lines[0].colour, glm::dvec3(1.0, 0.0, 0.0));
  EXPECT_EQ(lines[1].colour, glm::dvec3(0.0, 0.0, 1.0)) << "as slices have it";
  // Half way between voxels inside and outside; smoothing moves a point by half a voxel at most.
  glm::dvec2 first(infinity), last(-infinity);
  for (const WallLine::Piece& piece : lines[0].pieces) {
    first = glm::min(first, piece.from);
    last = glm::max(last, piece.to);
  }
  EXPECT_LT(glm::distance(first, glm::dvec2(4.5, 9.5)), 0.5);
  EXPECT_LT(glm::distance(last, glm::dvec2(9.5, 19.5)), 0.5);
  EXPECT_EQ(lines[0].pieces.front().from, lines[0].pieces.back().to) << "closed";

  const std::vector<WallLine> behind = on(around);
  ASSERT_EQ(behind.size(), 3u);
  ASSERT_EQ(behind[0].pieces.size(), 2u);
  EXPECT_EQ(behind[0].pieces[0].from, glm::dvec2(7.0, -0.5)) << "the sagittal slice";
  EXPECT_EQ(behind[0].pieces[0].to, glm::dvec2(7.0, 29.5));
  EXPECT_EQ(behind[0].pieces[1].to, glm::dvec2(19.5, 12.0)) << "the coronal one";
  MethodStages::Walls bare = around;
  bare.outlines = false;
  EXPECT_EQ(on(bare).size(), 1u);

  // A region in focus is outlined as well as the labels of the study.
  scene.structures = scene.labels;
  const auto region = labelsOf(grid, [](glm::ivec3 i) { return i.z == 9 && i.y > 25 ? 1 : 0; });
  region->labels = {{1, "region", {1.0, 1.0, 0.0}}};
  scene.labels = region;
  const std::vector<WallLine> both = on(inside);
  ASSERT_EQ(both.size(), 3u);
  EXPECT_EQ(both[2].colour, glm::dvec3(1.0, 1.0, 0.0));
}

TEST(Walls, HaveNoSmoothEdges) {
  Look look;
  look.edges = Edges::Smooth;
  EXPECT_TRUE(hasSmoothEdges(look, {}));
  look.method.kind = kindOf<methods::Walls>;
  EXPECT_FALSE(hasSmoothEdges(look, {}));
  look.cutaway.enabled = false;
  EXPECT_TRUE(hasSmoothEdges(look, {})) << "there are no walls";
  EXPECT_FALSE(wallsOf(look));
}

}  // namespace
}  // namespace fenestra::tests::wallsTest
