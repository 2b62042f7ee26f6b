// Removed parts of a volume: coverages against the reference, and pictures against closed forms.

#include <gtest/gtest.h>

#include "rendering/reference/Picture.h"
#include "rendering/reference/Removals.h"
#include "rendering/scene/FocusCells.h"
#include "rendering/settings/SettingWords.h"
#include "tests/support/Scenes.h"

namespace fenestra::referenceRemovalTest {
namespace {

using namespace tests;

Removal ballAt(std::vector<glm::dvec3> points, double radius, double softness = 0.0) {
  Removal ball;
  ball.points = std::move(points);
  ball.size = radius;
  ball.softness = softness;
  return ball;
}

Removal boxAt(std::vector<glm::dvec3> points, glm::dvec3 sides) {
  Removal box;
  box.shape = RemovalShape::Box;
  box.points = std::move(points);
  box.sides = sides;
  return box;
}

Removal sawAlong(std::vector<glm::dvec3> points, double depth, double width) {
  Removal saw;
  saw.shape = RemovalShape::Saw;
  saw.points = std::move(points);
  saw.depth = depth;
  saw.size = width;
  return saw;
}

Removal planeThrough(std::vector<glm::dvec3> points, glm::dvec3 towards) {
  Removal plane;
  plane.shape = RemovalShape::Plane;
  plane.points = std::move(points);
  plane.direction = towards;
  return plane;
}

std::vector<glm::dvec3> randomPoints(std::mt19937& random, const Grid& grid, std::size_t count) {
  std::vector<glm::dvec3> points;
  while (points.size() < count) {
    const glm::dvec3 index = randomIn(random, glm::dvec3(-3.0), glm::dvec3(grid.dims + 2));
    points.emplace_back(grid.worldFromIndex() * glm::dvec4(index, 1.0));
  }
  return points;
}

/// Several of each shape, at random.
Removals randomRemovals(std::mt19937& random, const Grid& grid) {
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  Removals removals;
  removals.push_back(ballAt(randomPoints(random, grid, 1), in(0.5, 4.0)));
  removals.push_back(ballAt(randomPoints(random, grid, 4), in(0.5, 2.0), in(0.0, 6.0)));
  removals.push_back(boxAt(randomPoints(random, grid, 2), randomIn(random, glm::dvec3(0.3), glm::dvec3(6.0))));
  removals.back().direction = 3.0 * randomUnit(random);
  removals.back().up = 0.2 * randomUnit(random);
  for (const bool closed : {false, true}) {
    removals.push_back(sawAlong(randomPoints(random, grid, closed ? 5 : 3), in(0.0, 9.0), in(0.2, 3.0)));
    removals.back().direction = randomUnit(random);
    removals.back().softness = closed ? in(0.0, 3.0) : 0.0;
    if (closed) removals.back().points.push_back(removals.back().points.front());
  }
  for (const std::size_t bends : {0u, 3u}) {
    removals.push_back(planeThrough(randomPoints(random, grid, 6), randomUnit(random)));
    removals.back().depth = in(2.0, 6.0);
    removals.back().extent = in(2.0, 12.0);
    for (const glm::dvec3& point : randomPoints(random, grid, bends))
      removals.back().bends.push_back({point, in(-5.0, 5.0), in(3.0, 12.0)});
  }
  return removals;
}

/// The greatest difference of coverages, in 1/255, over a grid's voxels.
double worstOf(const Removals& removals, const Grid& grid) {
  const auto removed = removedVoxels(removals, grid);
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  double worst = 0.0;
  forEachVoxel(grid.dims, [&](glm::ivec3 voxel) {
    const glm::dvec3 world(worldFromIndex * glm::dvec4(glm::dvec3(voxel), 1.0));
    const double stored = removed ? removed->at(voxel) : 0;
    worst = std::max(worst, std::abs(stored - 255.0 * reference::coverage(removals, grid, world)));
  });
  return worst;
}

TEST(Removal, Thorough_CoveragesAreTheReferences) {
  // Half a step of rounding, and the error of a bent plane's gradient by differences of 1e-5 mm.
  constexpr double tolerance = 0.5 + 1e-3;
  std::mt19937 random(5);
  for (int round = 0; round < 3; ++round)
    for (const Grid& grid : {gridOf({15, 13, 14}, {0.9, 1.0, 1.1}), obliqueGrid({14, 11, 7})}) {
      const Removals removals = randomRemovals(random, grid);
      for (const Removal& each : removals)
        EXPECT_LE(worstOf({each}, grid), tolerance) << wordOf(each.shape).word << " in round " << round;
      EXPECT_LE(worstOf(removals, grid), tolerance) << "all of round " << round;
    }
}

TEST(Removal, AListThatGoesOnIsWhatItIsFromTheStart) {
  const Grid grid = obliqueGrid({24, 20, 12});
  std::mt19937 random(8);
  const Removals all = randomRemovals(random, grid);
  std::shared_ptr<const RemovedVoxels> before;
  Removals some;
  for (const Removal& each : all) {
    // A stroke that grows, point by point, then the next one.
    some.push_back(each);
    if (each.shape == RemovalShape::Ball)
      for (std::size_t count = 1; count <= each.points.size(); ++count) {
        some.back().points.assign(each.points.begin(), each.points.begin() + static_cast<std::ptrdiff_t>(count));
        before = removedVoxels(some, grid, before);
      }
    before = removedVoxels(some, grid, before);
    const auto fresh = removedVoxels(some, grid);
    ASSERT_EQ(before != nullptr, fresh != nullptr);
    if (!fresh) continue;
    forEachVoxel(grid.dims, [&](glm::ivec3 voxel) { ASSERT_EQ(before->at(voxel), fresh->at(voxel)); });
  }
}

TEST(Removal, WhatIsNotThereOrFarAwayRemovesNothing) {
  const Grid grid = gridOf({8, 8, 8});
  const glm::dvec3 middle = grid.centre();
  EXPECT_EQ(removedVoxels({}, grid), nullptr);
  EXPECT_EQ(removedVoxels({ballAt({{1e6, 0.0, 0.0}}, 5.0)}, grid), nullptr);
  EXPECT_EQ(removedVoxels({ballAt({}, 5.0)}, grid), nullptr);
  std::vector<Removal> wrong{ballAt({middle}, 0.0), ballAt({{nan, 0.0, 0.0}}, 3.0), ballAt({middle}, infinity),
                             ballAt({middle}, 3.0, -1.0), boxAt({middle}, {3.0, 0.0, 3.0})};
  wrong.push_back(boxAt({middle}, glm::dvec3(3.0)));
  wrong.back().up = 2.0 * wrong.back().direction;
  wrong.push_back(sawAlong({middle}, 3.0, 1.0));
  wrong.back().direction = glm::dvec3(0.0);
  wrong.push_back(planeThrough({middle}, {0.0, 0.0, 1.0}));
  wrong.back().bends = {{middle, 1.0, 0.0}};
  for (const Removal& each : wrong) {
    EXPECT_FALSE(removesAnything(each));
    EXPECT_EQ(removedVoxels({each}, grid), nullptr);
  }
}

/// A block of 200 in air, which is 0: opaque where less than half of it is removed.
Scene block(const Grid& grid) {
  Scene scene;
  scene.volume = volumeOf<std::uint8_t>(grid, [](glm::ivec3 v) { return v == glm::ivec3(0) ? 0 : 200; });
  scene.look.context.function = opaqueFrom(100.0);
  scene.look.shading.enabled = false;
  return scene;
}

/// From anterior, parallel rays along y.
Camera parallelTo(const Grid& grid, double height) {
  const glm::dvec3 centre = grid.centre();
  return lookAt(centre - glm::dvec3(0.0, 100.0, 0.0), centre, Projection::Orthographic, height);
}

Scene sculpted(const Scene& scene) { return Sculptor().of(scene); }

TEST(Removal, ABallOutOfABlockIsMetAtItsFarWall) {
  const Grid grid = gridOf({40, 40, 40});
  const double radius = 12.0;
  const glm::dvec3 centre(19.5, 2.0, 19.5);
  Scene scene = block(grid);
  scene.look.removals = {ballAt({centre}, radius)};
  const Camera camera = parallelTo(grid, 30.0);
  const glm::ivec2 size(45, 45);
  const auto hits = reference::hitPoints(sculpted(scene), camera, size);
  int inside = 0;
  for (std::size_t i = 0; i < hits.tContext.size(); ++i) {
    const auto ray = reference::pixelRay(camera, size, {static_cast<int>(i) % size.x, static_cast<int>(i) / size.x});
    const double aside = std::hypot(ray.origin.x - centre.x, ray.origin.z - centre.z);
    if (aside > 0.8 * radius) continue;
    ++inside;
    const double depth = std::sqrt(radius * radius - aside * aside), wall = centre.y + depth - ray.origin.y;
    // Interpolation between voxels of a distance whose second derivatives are 1/R along two axes errs by h²/8 · 2/R,
    // 0.02 mm; coverages and values are rounded to 1/510 and 1/400 of a rim of 2 mm, 0.009 mm; and where a cell's
    // corners lie more than the half rim of 1 mm from the wall, the ramp is cut off, which moves the level by less than
    // 0.04 mm. All across the wall: along the ray, by R / depth more.
    EXPECT_NEAR(hits.tContext[i], wall, 0.07 * radius / depth) << aside;
  }
  EXPECT_GT(inside, 500);
}

TEST(Removal, ASawThroughASlabLeavesWhatItsBladeSpares) {
  const Grid grid = gridOf({40, 20, 40});
  const double extinction = 0.05, width = 6.0, depth = 9.0;
  Scene scene = block(grid);
  // Extinction is linear from air to the block's value, so in a rim it is in proportion to what the coverage leaves.
  scene.look.context.function = {{{0.0, {glm::dvec3(1.0), 0.0}}, {200.0, {glm::dvec3(1.0), extinction}}}};
  // The points lie on the block's face, at y = -0.5.
  scene.look.removals = {sawAlong({{19.5, -0.5, 5.0}, {19.5, -0.5, 34.0}}, depth, width)};
  const Camera camera = parallelTo(grid, 30.0);
  const auto final = reference::picture(sculpted(scene), camera, {15, 15}).final;
  for (int i = 0; i < 15; ++i) {
    const auto ray = reference::pixelRay(camera, {15, 15}, {i, 7});
    const double aside = std::abs(ray.origin.x - 19.5);
    if (std::abs(aside - 0.5 * width) < 2.0) continue;  // the rim, and a voxel beside it
    // The rim at the end of the cut takes as much as it leaves: 1/510 of 2 mm of rounding each side, and the half cell
    // at the face.
    const double left = aside < 0.5 * width ? 20.0 - depth : 20.0;
    EXPECT_NEAR(final[static_cast<std::size_t>(7 * 15 + i)].a, -std::expm1(-extinction * left), 0.002) << aside;
  }
}

TEST(Removal, AClosedSawTakesOutWhatItEncloses) {
  const Grid grid = gridOf({30, 30, 30});
  const std::vector<glm::dvec3> square{{5, 0, 5}, {25, 0, 5}, {25, 0, 25}, {5, 0, 25}, {5, 0, 5}};
  const auto removed = removedVoxels({sawAlong(square, 10.0, 1.0)}, grid);
  ASSERT_TRUE(removed);
  for (int y = 0; y < 9; ++y) EXPECT_EQ(removed->at({15, y, 15}), 255);
  EXPECT_EQ(removed->at({15, 12, 15}), 0) << "deeper than it reaches";
  EXPECT_EQ(removed->at({2, 3, 15}), 0) << "beside";
  std::vector<glm::dvec3> open = square;
  open.pop_back();
  EXPECT_EQ(removedVoxels({sawAlong(open, 10.0, 1.0)}, grid)->at({15, 3, 15}), 0) << "an open stroke encloses nothing";
}

TEST(StrokePlane, IsThePlaneOfItsPoints) {
  std::mt19937 random(2);
  for (int round = 0; round < 20; ++round) {
    // A ring of points around a centre, of different radii along two axes: its principal axes are known.
    const glm::dvec3 normal = randomUnit(random), first = glm::normalize(glm::cross(normal, randomUnit(random)));
    const glm::dvec3 second = glm::cross(normal, first), centre = randomIn(random, glm::dvec3(-50.0), glm::dvec3(50.0));
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 12; ++i) {
      const double angle = i * glm::radians(30.0);
      points.push_back(centre + 9.0 * std::cos(angle) * first + 5.0 * std::sin(angle) * second +
                       (i % 2 == 0 ? 0.3 : -0.3) * normal);
    }
    const StrokePlane plane(points, normal);
    EXPECT_LT(glm::distance(plane.centre, centre), 1e-12 * 50.0);
    EXPECT_NEAR(glm::dot(plane.normal, normal), 1.0, 1e-9);
    EXPECT_NEAR(std::abs(glm::dot(plane.first, first)), 1.0, 1e-9);
    EXPECT_NEAR(glm::dot(StrokePlane(points, -normal).normal, normal), -1.0, 1e-9) << "towards the other side";
    const auto fitted = reference::planeThrough(points, normal);
    EXPECT_NEAR(glm::dot(fitted.normal, plane.normal), 1.0, 1e-9);
  }
}

TEST(StrokePlane, OfAStraightStrokeFacesWhereItShall) {
  const glm::dvec3 along = glm::normalize(glm::dvec3(1.0, 2.0, -1.0)), towards(0.3, 0.2, 0.9);
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 7; ++i) points.push_back(glm::dvec3(4.0, 5.0, 6.0) + 3.0 * i * along);
  const glm::dvec3 expected = glm::normalize(towards - glm::dot(towards, along) * along);
  EXPECT_LT(glm::distance(StrokePlane(points, towards).normal, expected), 1e-9);
  EXPECT_LT(glm::distance(reference::planeThrough(points, towards).normal, expected), 1e-9);
  const StrokePlane dab({{1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}}, towards);
  EXPECT_LT(glm::distance(dab.normal, glm::normalize(towards)), 1e-12);
  EXPECT_EQ(dab.centre, glm::dvec3(1.0, 2.0, 3.0));
  EXPECT_NEAR(glm::dot(StrokePlane(points, along).normal, along), 0.0, 1e-9) << "along the stroke says nothing";
}

TEST(BentPlane, MovesByTheDragAtItsPointAndNotBeyondTheSphere) {
  const StrokePlane plane({{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {10, 10, 0}}, {0.0, 0.0, 1.0});
  const BentPlane flat(plane, {});
  EXPECT_EQ(flat.at({3.0, -2.0}).value, 0.0);
  const glm::dvec3 at(7.0, 4.0, 3.0);  // counts by its foot on the plane
  const BentPlane bent(plane, {{at, -6.5, 8.0}});
  const auto heightAt = [&](const BentPlane& of, glm::dvec3 world) { return of.at(of.placeOf(world)).value; };
  EXPECT_EQ(heightAt(bent, at), -6.5);
  const glm::dvec3 aside = glm::normalize(glm::dvec3(0.6, -0.8, 0.0));
  EXPECT_EQ(heightAt(bent, at + 8.0 * aside), 0.0);
  EXPECT_EQ(heightAt(bent, at + 50.0 * aside), 0.0);
  EXPECT_NEAR(heightAt(bent, at + 4.0 * aside), -6.5 * 0.5625, 1e-12) << "(1 - 1/4)²";
  EXPECT_EQ(bent.at(bent.placeOf(at)).gradient, glm::dvec2(0.0));
  // A second drag at the same place goes on from the first; the sphere lies around the point there.
  const BentPlane twice(plane, {{at, -6.5, 8.0}, {at, 2.0, 5.0}});
  EXPECT_EQ(heightAt(twice, at), -4.5);
  EXPECT_NEAR(heightAt(twice, at + 4.0 * aside), heightAt(bent, at + 4.0 * aside), 0.05)
      << "4 mm beside and 2.8 mm above is beyond, or nearly, a sphere of 5 mm";
  // Gradients are the heights'.
  for (const glm::dvec2 place : {glm::dvec2(1.0, 0.5), glm::dvec2(3.0, -1.0), glm::dvec2(-2.0, 2.0)})
    for (int i = 0; i < 2; ++i) {
      glm::dvec2 step(0.0);
      step[i] = 1e-6;
      const double slope = (twice.at(place + step).value - twice.at(place - step).value) / 2e-6;
      EXPECT_NEAR(twice.at(place).gradient[i], slope, 1e-7);
    }
}

TEST(Removal, APlaneRemovesItsSideAndWhereItIsBentMore) {
  const Grid grid = gridOf({30, 30, 30});
  Removal plane = planeThrough({{5, 5, 15}, {25, 5, 15}, {5, 24, 15}, {25, 24, 15}}, {0.0, 0.0, 1.0});
  auto removed = removedVoxels({plane}, grid);
  EXPECT_EQ(removed->at({15, 15, 18}), 255);
  EXPECT_EQ(removed->at({15, 15, 12}), 0);
  EXPECT_EQ(removed->at({15, 15, 15}), 128) << "the plane itself";
  plane.bends = {{{15.0, 15.0, 15.0}, -8.0, 10.0}};
  removed = removedVoxels({plane}, grid);
  EXPECT_EQ(removed->at({15, 15, 9}), 255) << "bent away from what it removes, it removes more";
  EXPECT_EQ(removed->at({15, 15, 5}), 0);
  EXPECT_EQ(removed->at({2, 2, 12}), 0) << "beyond the sphere";
  plane.depth = 4.0;
  plane.extent = 6.0;
  removed = removedVoxels({plane}, grid);
  EXPECT_EQ(removed->at({15, 15, 25}), 0) << "deeper than it reaches";
  EXPECT_EQ(removed->at({25, 15, 17}), 0) << "beside its square";
}

TEST(Removal, TakesHitsAndVoxelsFromALabelFocus) {
  const Grid grid = gridOf({30, 30, 30});
  Scene scene = labelScene(grid, [](glm::ivec3 v) { return glm::length(glm::dvec3(v) - 14.5) < 8.0 ? 1 : 0; });
  const Camera camera = parallelTo(grid, 20.0);
  const auto focusHits = [&](const Scene& of) {
    const auto hits = reference::hitPoints(of, camera, {21, 21});
    return std::count_if(hits.tFocus.begin(), hits.tFocus.end(), [](double t) { return !std::isnan(t); });
  };
  const auto whole = focusHits(scene);
  ASSERT_GT(whole, 100);
  scene.look.removals = {boxAt({{14.5, 14.5, 22.0}}, {60.0, 15.0, 60.0})};  // the upper half
  const Scene half = sculpted(scene);
  EXPECT_NEAR(static_cast<double>(focusHits(half)), 0.5 * static_cast<double>(whole), 21.0) << "a row of pixels";
  EXPECT_EQ(scene.labels->value({14, 14, 18}), 1) << "the map as read stays";
  EXPECT_EQ(half.labels->value({14, 14, 18}), 0);
  EXPECT_EQ(half.labels->value({14, 14, 12}), 1);
  scene.look.removals = {ballAt({grid.centre()}, 12.0)};
  EXPECT_EQ(focusHits(sculpted(scene)), 0) << "all of it";
}

TEST(Removal, TakesCellsFromAFocusOfAir) {
  // Air belongs to the focus; the parts carved out of the tissue around it do not.
  const Grid grid = gridOf({20, 20, 20});
  Scene scene = valueScene(
      grid, [](glm::ivec3 v) { return glm::length(glm::dvec3(v) - 9.5) < 5.0 ? 0.0 : 100.0; }, -10.0, 10.0);
  const auto cellsOf = [](const Scene& of) {
    const FocusCells cells = focusCells(shownVolume(of), std::get<ValueFocus>(of.look.focus));
    return std::count(cells.kept.begin(), cells.kept.end(), 1);
  };
  const auto whole = cellsOf(scene);
  scene.look.removals = {ballAt({{2.0, 2.0, 2.0}}, 3.0)};
  EXPECT_EQ(cellsOf(sculpted(scene)), whole) << "tissue";
  scene.look.removals = {ballAt({grid.centre()}, 3.0)};
  EXPECT_LT(cellsOf(sculpted(scene)), whole) << "of the focus";
  scene.look.removals = {ballAt({grid.centre()}, 9.0)};
  EXPECT_EQ(cellsOf(sculpted(scene)), 0);
}

TEST(Removal, ASculptorKeepsWhatHasNotChangedAndGivesEverythingBack) {
  const Grid grid = gridOf({16, 16, 16});
  Scene scene = labelScene(grid, [](glm::ivec3 v) { return v.x < 8 ? 1 : 2; });
  Sculptor sculptor;
  EXPECT_EQ(sculptor.of(scene), scene);
  const Scene whole = scene;
  scene.look.removals = {ballAt({{4.0, 8.0, 8.0}}, 3.0)};
  const Scene carved = sculptor.of(scene);
  EXPECT_NE(carved.labels, scene.labels);
  scene.look.background = glm::dvec3(0.5);
  const Scene again = sculptor.of(scene);
  EXPECT_EQ(again.labels, carved.labels) << "another colour makes no other map";
  EXPECT_EQ(again.removed, carved.removed);
  EXPECT_EQ(sculptor.of(whole), whole) << "undone";
  EXPECT_EQ(shownVolume(sculptor.of(whole)), ShownVolume{whole.volume});
}

TEST(Removal, OfEverythingLeavesAnEmptyPicture) {
  for (const glm::ivec3 dims : {glm::ivec3(12, 9, 7), glm::ivec3(1, 1, 1)}) {
    const Grid grid = gridOf(dims);
    Scene scene = block(grid);
    if (dims.x == 1)  // whose only voxel is air, too
      scene.volume = volumeOf<std::int16_t>(grid, [](glm::ivec3) { return 40; });
    scene.labels = labelsOf(grid, [](glm::ivec3) { return 1; });
    scene.look.focus = LabelFocus{{1}};
    scene.look.removals = {ballAt({grid.centre()}, 50.0)};
    const Scene nothing = sculpted(scene);
    const auto hits = reference::hitPoints(nothing, parallelTo(grid, 12.0), {9, 9});
    for (const double t : hits.tFocus) EXPECT_TRUE(std::isnan(t));
    if (dims.x == 1) continue;
    for (const glm::dvec4& pixel : reference::picture(nothing, parallelTo(grid, 12.0), {9, 9}).final)
      EXPECT_EQ(pixel, glm::dvec4(0.0));
  }
}

}  // namespace
}  // namespace fenestra::referenceRemovalTest
