// The cases that break ray casters: degenerate grids, far cameras, values that are no numbers, extreme foci.

#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include "rendering/reference/Reference.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference::referenceHardCasesTest {
namespace {

using namespace tests;

glm::dvec3 worldAt(const Grid& grid, glm::dvec3 index) {
  return glm::dvec3(grid.worldFromIndex() * glm::dvec4(index, 1.0));
}

int knownCount(const Image& image) {
  return static_cast<int>(std::count_if(image.begin(), image.end(), [](double t) { return !std::isnan(t); }));
}

/// Invariants of every picture.
void expectSound(const Stages& stages) {
  const HitPoints& hits = stages.hits;
  for (std::size_t i = 0; i < hits.tContext.size(); ++i) {
    if (!std::isnan(hits.tFocus[i])) {
      EXPECT_LE(hits.tContext[i], hits.tFocus[i]);
      EXPECT_EQ(stages.tStart[i], hits.tFocus[i]);
      EXPECT_EQ(stages.distance[i], 0.0);
    }
    EXPECT_EQ(std::isnan(stages.tStart[i]), std::isnan(hits.tContext[i]));
    if (std::isnan(hits.tContext[i])) continue;
    EXPECT_GE(hits.tContext[i], 0.0);
    EXPECT_LE(hits.tContext[i], hits.tOut[i]);
    EXPECT_GE(stages.tStart[i], hits.tContext[i]);
    EXPECT_LE(stages.tStart[i], hits.tOut[i]);
  }
}

TEST(ReferenceHardCases, axisParallelRaysInCellFacesAndBoxFaces) {
  // Rays at every half index: in the box's faces, in the planes of voxel centres and between them.
  const Grid grid = gridOf({6, 6, 6});
  const Scene scene = labelScene(grid, [](glm::ivec3 i) { return i.y >= 3; });
  for (double x = -0.5; x <= 5.5; x += 0.5)
    for (double z = -0.5; z <= 5.5; z += 0.5) {
      const Camera camera = lookAt({x, -7.0, z}, {x, 0.0, z}, Projection::Orthographic, 1.0);
      const HitPoints hits = hitPoints(scene, camera, {1, 1});
      EXPECT_DOUBLE_EQ(hits.tFocus[0], 9.5) << x << ", " << z;
      EXPECT_DOUBLE_EQ(hits.tOut[0], 12.5) << x << ", " << z;
    }
}

TEST(ReferenceHardCases, rayStartsOnAPlaneOfTheGrid) {
  const Scene scene = labelScene(gridOf({6, 6, 6}), [](glm::ivec3 i) { return i.y >= 4; });
  for (const double y : {-0.5, 0.0, 1.0, 3.0, 3.5, 5.5}) {
    const Camera camera = lookAt({2.0, y, 2.0}, {2.0, 10.0, 2.0}, Projection::Orthographic, 1.0);
    EXPECT_DOUBLE_EQ(hitPoints(scene, camera, {1, 1}).tFocus[0], std::max(0.0, 3.5 - y)) << y;
  }
}

TEST(ReferenceHardCases, raysAlongTheLevelItself) {
  // Where the indicator is 0.5 all along the ray, the closed set counts as hit where the ray enters the box.
  const Scene scene = labelScene(gridOf({6, 6, 6}), [](glm::ivec3 i) { return i.x >= 3; });
  const Camera camera = lookAt({2.5, -7.0, 2.0}, {2.5, 0.0, 2.0}, Projection::Orthographic, 1.0);
  EXPECT_DOUBLE_EQ(hitPoints(scene, camera, {1, 1}).tFocus[0], 6.5);
}

TEST(ReferenceHardCases, cameraInsideTheVolumeAndInsideTheFocus) {
  const Grid grid = obliqueGrid({20, 20, 20});
  Scene scene = labelScene(grid, [](glm::ivec3 i) { return glm::distance(glm::dvec3(i), glm::dvec3(10.0)) < 5.0; });
  scene.look.context.function = opaqueFrom(-1.0);
  const Camera inside = lookAt(worldAt(grid, {2.0, 10.0, 10.0}), worldAt(grid, glm::dvec3(10.0)));
  const Stages stages = geometricStages(scene, inside, {33, 31});
  expectSound(stages);
  EXPECT_EQ(stages.hits.tContext[0], 0.0);
  EXPECT_GT(knownCount(stages.hits.tFocus), 100);
  const Camera within = lookAt(worldAt(grid, {9.0, 10.0, 10.0}), worldAt(grid, glm::dvec3(10.0)));
  const Stages all = geometricStages(scene, within, {33, 31});
  expectSound(all);
  for (const double t : all.hits.tFocus) EXPECT_EQ(t, 0.0);
}

TEST(ReferenceHardCases, cameraAKilometreAwaySeesTheSame) {
  const Grid grid = obliqueGrid({16, 16, 16});
  const Scene scene =
      labelScene(grid, [](glm::ivec3 i) { return glm::distance(glm::dvec3(i), glm::dvec3(8.0)) < 5.0; });
  const glm::dvec3 centre = grid.centre(), towards = glm::normalize(glm::dvec3(1.0, -2.0, 0.5));
  const auto from = [&](double distance) {
    return hitPoints(scene, lookAt(centre + distance * towards, centre, Projection::Orthographic, 20.0), {41, 37});
  };
  const HitPoints near = from(100.0), distant = from(1e6);
  EXPECT_GT(knownCount(near.tFocus), 100);
  for (std::size_t i = 0; i < near.tFocus.size(); ++i) {
    if (std::isnan(near.tFocus[i]) && std::isnan(distant.tFocus[i])) continue;
    // Doubles at 1e6 mm are 1e-10 mm apart; on grazing rays that grows.
    EXPECT_NEAR(distant.tFocus[i] - 1e6, near.tFocus[i] - 100.0, 1e-6);
  }
}

TEST(ReferenceHardCases, thinVoxelsFarFromTheOrigin) {
  const auto picture = [](glm::dvec3 origin) {
    const Grid grid = gridOf({64, 64, 5}, {0.05, 0.05, 10.0}, origin);
    Scene scene = labelScene(
        grid, [](glm::ivec3 i) { return glm::distance(glm::dvec2(i), glm::dvec2(31.5)) < 20.0 && i.z == 2; });
    scene.look.context.function = opaqueFrom(-1.0);
    return geometricStages(scene, Camera::fromAngles(20.0, 85.0, grid), {90, 90});
  };
  const Stages near = picture(glm::dvec3(0.0)), distant = picture({1e6, -1e6, 1e6});
  expectSound(near);
  expectSound(distant);
  EXPECT_GT(knownCount(near.hits.tFocus), 20);
  for (std::size_t i = 0; i < near.tStart.size(); ++i) {
    ASSERT_EQ(std::isnan(near.hits.tFocus[i]), std::isnan(distant.hits.tFocus[i]));
    ASSERT_EQ(std::isnan(near.tStart[i]), std::isnan(distant.tStart[i]));
    if (std::isnan(near.tStart[i])) continue;
    EXPECT_NEAR(near.tStart[i], distant.tStart[i], 1e-6);  // 1e6 mm in doubles, over a slope of 0.05 : 10
  }
}

TEST(ReferenceHardCases, volumesOfOneVoxelOrOneSlice) {
  for (const glm::ivec3 dims : {glm::ivec3(1), glm::ivec3(1, 5, 7), glm::ivec3(5, 1, 7), glm::ivec3(5, 7, 1)}) {
    const Grid grid = gridOf(dims);
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
      Scene scene = labelScene(grid, [](glm::ivec3) { return 1; });
      const Camera camera = Camera::fromAngles(30.0, 20.0, grid, projection);
      const Stages labels = geometricStages(scene, camera, {25, 25});
      expectSound(labels);
      EXPECT_GT(knownCount(labels.hits.tFocus), 50);
      // Every voxel is focus, and so the whole box to its outer faces.
      for (std::size_t i = 0; i < labels.hits.tFocus.size(); ++i)
        EXPECT_EQ(std::isnan(labels.hits.tFocus[i]), std::isnan(labels.hits.tOut[i]));
      scene.look.focus = ValueFocus{{-1.0, 1.0}, 0.0};
      const Stages values = geometricStages(scene, camera, {25, 25});
      expectSound(values);
      EXPECT_EQ(knownCount(values.hits.tFocus), knownCount(labels.hits.tFocus));
    }
  }
}

TEST(ReferenceHardCases, valuesThatAreNoNumbersMakeNoSurface) {
  // A ramp with holes of NaN: they count as the least value, 0, and infinite ones as the greatest, 9.
  const Grid grid = gridOf({10, 5, 5});
  const auto ramp = [](glm::ivec3 i) { return static_cast<double>(i.x); };
  Scene scene;
  scene.volume = volumeOf<float>(grid, [&](glm::ivec3 i) {
    if (i.y == 0) return nan;
    if (i.y == 4) return i.x < 5 ? -infinity : infinity;
    return ramp(i);
  });
  scene.look.context.function = opaqueFrom(5.5);
  scene.look.focus = ValueFocus{{7.5, infinity}, 0.0};
  const auto at = [&](double y) {
    return hitPoints(scene, lookAt({-10.0, y, 2.0}, {0.0, y, 2.0}, Projection::Orthographic, 1.0), {1, 1});
  };
  EXPECT_DOUBLE_EQ(at(2.0).tContext[0], 15.5);
  EXPECT_DOUBLE_EQ(at(2.0).tFocus[0], 17.5);
  EXPECT_TRUE(std::isnan(at(0.0).tContext[0]));
  EXPECT_TRUE(std::isnan(at(0.0).tFocus[0]));
  EXPECT_NEAR(at(4.0).tContext[0], 14.0 + 5.5 / 9.0, 1e-12);
}

TEST(ReferenceHardCases, hugeValuesKeepTheirSurfaces) {
  Scene scene = valueScene(
      gridOf({6, 3, 3}), [](glm::ivec3 i) { return i.x >= 3 ? 1e30 : -1e30; }, 0.0);
  const Camera camera = lookAt({-10.0, 1.0, 1.0}, {0.0, 1.0, 1.0}, Projection::Orthographic, 1.0);
  EXPECT_NEAR(hitPoints(scene, camera, {1, 1}).tFocus[0], 12.5, 1e-12);
}

TEST(ReferenceHardCases, full16BitRanges) {
  Scene scene;
  scene.look.focus = ValueFocus{{0.0, infinity}, 0.0};
  const Camera camera = lookAt({-10.0, 1.0, 1.0}, {0.0, 1.0, 1.0}, Projection::Orthographic, 1.0);
  scene.volume = volumeOf<std::int16_t>(gridOf({6, 3, 3}), [](glm::ivec3 i) { return i.x >= 3 ? 32767 : -32768; });
  EXPECT_NEAR(hitPoints(scene, camera, {1, 1}).tFocus[0], 12.0 + 32768.0 / 65535.0, 1e-12);
  scene.volume = volumeOf<std::uint16_t>(gridOf({6, 3, 3}), [](glm::ivec3 i) { return i.x >= 3 ? 65535 : 0; });
  scene.look.focus = ValueFocus{{32768.0, 65535.0}, 0.0};
  EXPECT_NEAR(hitPoints(scene, camera, {1, 1}).tFocus[0], 12.0 + 32768.0 / 65535.0, 1e-12);
}

TEST(ReferenceHardCases, constantVolumes) {
  const Grid grid = gridOf({8, 8, 8});
  const Camera camera = Camera::standard(StandardView::Anterior, grid);
  Scene scene = valueScene(
      grid, [](glm::ivec3) { return 5.0; }, 5.0, 5.0);
  const Stages all = geometricStages(scene, camera, {21, 21});
  expectSound(all);
  EXPECT_EQ(knownCount(all.hits.tFocus), knownCount(all.hits.tOut));
  scene.look.focus = ValueFocus{{5.1, 6.0}, 0.0};
  EXPECT_EQ(knownCount(geometricStages(scene, camera, {21, 21}).hits.tContext), 0);
}

TEST(ReferenceHardCases, focusOfOneVoxel) {
  // Its 0.5 level is the octahedron-like body |1-|x|||1-|y||(1-|z|) = 0.5: half a voxel out along the axes.
  const Grid grid = gridOf({9, 9, 9});
  for (const glm::ivec3 voxel : {glm::ivec3(4), glm::ivec3(0, 4, 8)}) {
    const Scene scene = labelScene(grid, [&](glm::ivec3 i) { return i == voxel; });
    const glm::dvec3 p(voxel);
    const Camera camera = lookAt(p - glm::dvec3(0.0, 30.0, 0.0), p, Projection::Orthographic, 2.0);
    const Stages stages = geometricStages(scene, camera, {41, 41});
    expectSound(stages);
    EXPECT_NEAR(stages.hits.tFocus[20 * 41 + 20], 29.5, 1e-12);
    EXPECT_GT(knownCount(stages.hits.tFocus), 100);
  }
}

TEST(ReferenceHardCases, emptyFocusAndFocusOutOfView) {
  const Grid grid = gridOf({9, 9, 9});
  Scene scene = labelScene(grid, [](glm::ivec3) { return 0; });
  scene.look.context.function = opaqueFrom(-1.0);
  const Camera camera = Camera::standard(StandardView::Left, grid);
  const Stages empty = geometricStages(scene, camera, {20, 20});
  expectSound(empty);
  EXPECT_EQ(knownCount(empty.hits.tFocus), 0);
  EXPECT_EQ(knownCount(empty.tFocusFilled), 0);
  for (std::size_t i = 0; i < empty.tStart.size(); ++i) {
    EXPECT_EQ(empty.distance[i], infinity);
    EXPECT_TRUE(std::isnan(empty.tStart[i]) || empty.tStart[i] == empty.hits.tContext[i]);
  }
  Camera away = camera;
  away.target = away.eye + (away.eye - camera.target);
  const Stages none = geometricStages(scene, away, {20, 20});
  expectSound(none);
  EXPECT_EQ(knownCount(none.hits.tOut), 0);
}

TEST(ReferenceHardCases, sheetsThinnerThanAnyStepAreHit) {
  // One slice of labels, and a value range met within a thousandth of a voxel.
  const Grid grid = gridOf({40, 40, 40});
  const Camera camera = Camera::fromAngles(40.0, 25.0, grid);
  const glm::ivec2 size(40, 40);
  const Scene sheet = labelScene(grid, [](glm::ivec3 i) { return i.y == 20; });
  const Scene thin = valueScene(
      grid, [](glm::ivec3 i) { return static_cast<double>(i.y); }, 20.0, 20.001);
  const auto expectPlane = [&](const Scene& scene, double y) {
    const HitPoints hits = hitPoints(scene, camera, size);
    int count = 0;
    for (int j = 0; j < size.y; ++j)
      for (int i = 0; i < size.x; ++i) {
        const Ray ray = pixelRay(camera, size, {i, j});
        const auto span = clip(ray, grid);
        const double t = (y - ray.origin.y) / ray.direction.y;
        if (!span || t <= span->tIn || t >= span->tOut) continue;
        EXPECT_NEAR(hits.tFocus[static_cast<std::size_t>(j * size.x + i)], t, 1e-9);
        ++count;
      }
    EXPECT_GT(count, 300);
  };
  expectPlane(sheet, 19.5);
  expectPlane(thin, 20.0);
}

TEST(ReferenceHardCases, opacitySpikesNarrowerThanAVoxelsValues) {
  // Two thousand units from one voxel to the next, and a spike of one unit in which alone there is context.
  Scene scene;
  scene.volume = volumeOf(gridOf({6, 3, 3}), [](glm::ivec3 i) { return 2000.0 * i.x; });
  const OpticalProperties clear{glm::dvec3(1.0), 0.0}, opaque{glm::dvec3(1.0), 1e6};
  scene.look.context.function.nodes = {{5000.0, clear}, {5000.5, opaque}, {5001.0, clear}};
  const Camera camera = lookAt({-10.0, 1.0, 1.0}, {0.0, 1.0, 1.0}, Projection::Orthographic, 1.0);
  EXPECT_NEAR(hitPoints(scene, camera, {1, 1}).tContext[0], 12.5, 1e-9);
}

TEST(ReferenceHardCases, valuesAtTheBorderReachTheFacesOfTheBox) {
  // The outer half voxel belongs to the nearest cell, and is kept or dropped with it.
  const Camera camera = lookAt({-10.0, 1.0, 1.0}, {0.0, 1.0, 1.0}, Projection::Orthographic, 1.0);
  Scene scene = valueScene(
      gridOf({6, 3, 3}), [](glm::ivec3 i) { return i.x == 0 ? 1.0 : 0.0; }, 0.5);
  EXPECT_DOUBLE_EQ(hitPoints(scene, camera, {1, 1}).tFocus[0], 9.5);
  std::get<ValueFocus>(scene.look.focus).minimumComponent = 1e6;
  EXPECT_TRUE(std::isnan(hitPoints(scene, camera, {1, 1}).tFocus[0]));
}

TEST(ReferenceHardCases, everyViewportSize) {
  const Grid grid = gridOf({12, 12, 12});
  Scene scene = labelScene(grid, [](glm::ivec3 i) { return i.x == 6; });
  scene.look.context.function = opaqueFrom(-1.0);
  const Camera camera = Camera::fromAngles(70.0, 10.0, grid);
  for (const glm::ivec2 size : {glm::ivec2(1), glm::ivec2(1, 64), glm::ivec2(64, 1), glm::ivec2(701, 649)}) {
    const Stages stages = geometricStages(scene, camera, size);
    EXPECT_EQ(stages.tStart.size(), static_cast<std::size_t>(size.x * size.y));
    expectSound(stages);
  }
}

TEST(ReferenceHardCases, widthsBeyondThePictureAndZero) {
  const Grid grid = gridOf({12, 12, 12});
  Scene scene = labelScene(grid, [](glm::ivec3 i) { return i == glm::ivec3(6); });
  scene.look.context.function = opaqueFrom(-1.0);
  const Camera camera = Camera::fromAngles(70.0, 10.0, grid);
  for (const double width : {0.0, 1e6}) {
    scene.look.cutaway.openWidth = scene.look.cutaway.borderWidth = width;
    expectSound(geometricStages(scene, camera, {50, 40}));
  }
}

TEST(ReferenceHardCases, upAlongTheView) {
  const Grid grid = gridOf({12, 12, 12});
  const Scene scene = labelScene(grid, [](glm::ivec3 i) { return i.z == 6; });
  Camera camera = Camera::standard(StandardView::Superior, grid);
  camera.up = {0.0, 0.0, 1.0};
  const Stages stages = geometricStages(scene, camera, {30, 30});
  expectSound(stages);
  EXPECT_GT(knownCount(stages.hits.tFocus), 100);
}

TEST(ReferenceHardCases, theSamePictureTwice) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> value(0.0, 1.0);
  const Grid grid = obliqueGrid({15, 15, 15});
  Scene scene = valueScene(
      grid, [&](glm::ivec3) { return value(random); }, 0.9);
  scene.look.context.function = opaqueFrom(0.7);
  const Camera camera = Camera::fromAngles(10.0, 10.0, grid);
  const Stages a = geometricStages(scene, camera, {60, 50}), b = geometricStages(scene, camera, {60, 50});
  for (std::size_t i = 0; i < a.tStart.size(); ++i)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(a.tStart[i]), std::bit_cast<std::uint64_t>(b.tStart[i]));
}

}  // namespace
}  // namespace fenestra::reference::referenceHardCasesTest
