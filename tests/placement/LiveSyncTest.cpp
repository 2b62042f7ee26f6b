// Viewing spheres of a picked point, against closed forms and a computation of their own.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rendering/viewpoints/LiveSync.h"
#include "rendering/viewpoints/Placement.h"
#include "rendering/viewpoints/Sphere.h"
#include "tests/support/Scenes.h"

namespace fenestra::tests::liveSyncTest {
namespace {

using namespace placement;

/// Coordinates are sums of at most a few thousand products of numbers below 1e3.
constexpr double rounding = 1e-9;
constexpr glm::dvec3 anterior{0, -1, 0}, posterior{0, 1, 0}, left{1, 0, 0}, right{-1, 0, 0}, superior{0, 0, 1},
    inferior{0, 0, -1};

template <class Inside>
Structure structureOf(const Grid& grid, const Inside& isInside) {
  return {labelsOf(grid, [&](glm::ivec3 index) { return isInside(index) ? 3 : 0; }), {3}};
}

/// Values 0 and 1: air, and a material that the context shows with an extinction.
template <class Shown>
Scene sceneOf(const Grid& grid, double extinction, const Shown& isShown) {
  Scene scene;
  scene.volume = volumeOf<float>(grid, [&](glm::ivec3 index) { return isShown(index) ? 1.0 : 0.0; });
  scene.look.context.function.nodes = {{0.0, {glm::dvec3(1.0), 0.0}}, {1.0, {glm::dvec3(1.0), extinction}}};
  return scene;
}

TEST(LiveSync, OrientationPrefersTheFrontThenTheSidesThenTheBack) {
  EXPECT_EQ(orientationScore(anterior), 1.0);
  EXPECT_EQ(orientationScore(left), orientationScore(right));
  EXPECT_GT(orientationScore(anterior), orientationScore(left));
  EXPECT_GT(orientationScore(left), orientationScore(posterior));
  EXPECT_GT(orientationScore(posterior), 0.0);
  EXPECT_EQ(orientationScore(superior), 0.0);
  EXPECT_EQ(orientationScore(inferior), 0.0);
  // Half way between two sides, it is their mean.
  EXPECT_NEAR(orientationScore((anterior + left) / std::numbers::sqrt2), 0.5 * (1.0 + 0.6), rounding);
}

TEST(LiveSync, HistoryFallsWithTheAngle) {
  EXPECT_EQ(historyScore(left, left), 1.0);
  EXPECT_EQ(historyScore(anterior, left), 0.5);
  EXPECT_EQ(historyScore(right, left), 0.0);
}

TEST(LiveSync, APlateIsSeenAlongItsNormal) {
  const Grid grid = gridOf(glm::ivec3(41));
  const LocalShape shape =
      localShape(structureOf(grid, [](glm::ivec3 i) { return i.x == 20; }), glm::dvec3(20.0), 15.0);
  EXPECT_NEAR(shape.score(left), 1.0, rounding);
  EXPECT_NEAR(shape.score(right), 1.0, rounding);
  EXPECT_NEAR(shape.score(anterior), 0.0, rounding);
  EXPECT_NEAR(shape.score(superior), 0.0, rounding);
  EXPECT_NEAR(shape.score((left + superior) / std::numbers::sqrt2), 0.5, rounding);
  // ∫ x² (1 - r²/R²)² dA / ∫ (1 - r²/R²)² dA = R²/8 over a disc of radius R. The sum over a lattice of 700 points
  // approaches the smooth integral within a thousandth.
  EXPECT_NEAR(shape.variances[0], 15.0 * 15.0 / 8.0, 15.0 * 15.0 / 8.0 * 1e-3);
  EXPECT_NEAR(shape.variances[1], shape.variances[0], 1e-6);  // the root of rounding, where eigenvalues are equal
  EXPECT_NEAR(shape.variances[2], 0.0, 1e-6);
}

TEST(LiveSync, ARodIsSeenAcrossAndABallFromEverywhere) {
  const Grid grid = gridOf(glm::ivec3(41));
  const LocalShape rod =
      localShape(structureOf(grid, [](glm::ivec3 i) { return i.x == 20 && i.y == 20; }), glm::dvec3(20.0), 15.0);
  EXPECT_NEAR(rod.score(superior), 0.0, rounding);
  for (const glm::dvec3 across : {left, anterior, (left + posterior) / std::numbers::sqrt2})
    EXPECT_NEAR(rod.score(across), 1.0, rounding);
  const LocalShape ball = localShape(
      structureOf(grid, [](glm::ivec3 i) { return glm::length(glm::dvec3(i) - 20.0) < 9.0; }), glm::dvec3(20.0), 15.0);
  for (const glm::dvec3 direction : ringDirections(2)) EXPECT_NEAR(ball.score(direction), 1.0, 1e-6);
}

TEST(LiveSync, ShapesFollowThePatientNotTheLattice) {
  // The plate has its place in the patient, but is stored with turned and flipped axes of other spacings.
  Grid grid = gridOf({61, 31, 41}, {0.5, 1.0, 0.75}, {-10.0, 20.0, 30.0});
  grid.direction = glm::dmat3(glm::dvec3(0, 0, -1), glm::dvec3(-1, 0, 0), glm::dvec3(0, -1, 0));
  const glm::dvec3 pick(grid.worldFromIndex() * glm::dvec4(30, 15, 20, 1));
  const LocalShape shape = localShape(structureOf(grid, [](glm::ivec3 i) { return i.y == 15; }), pick, 12.0);
  EXPECT_NEAR(shape.score(left), 1.0, rounding);  // the index axis y runs along R
  EXPECT_NEAR(shape.score(superior), 0.0, 0.05);  // two spacings sample the disc differently
  EXPECT_NEAR(shape.score(anterior), 0.0, 0.05);
}

TEST(LiveSync, AWallHidesWhatItsOpacitySays) {
  const Grid grid = gridOf(glm::ivec3(41), glm::dvec3(0.5));
  const auto inBall = [](glm::ivec3 i) { return glm::length(glm::dvec3(i) - 20.0) < 4.0; };
  // A wall of 5 voxels, 2.5 mm, on the left, of 0.4 / mm.
  const Scene scene = sceneOf(grid, 0.4, [](glm::ivec3 i) { return i.x >= 30 && i.x < 35; });
  const Structure ball = structureOf(grid, inBall);
  const std::vector<glm::dvec3> directions{left, right, anterior, superior};
  const std::vector<double> seen = visibilityScores(scene, ball, localShape(ball, glm::dvec3(10.0), 5.0), directions);
  EXPECT_NEAR(seen[0], std::exp(-1.0), 1e-6);  // extinctions are exact; values are stored as float
  for (std::size_t i = 1; i < 4; ++i) EXPECT_NEAR(seen[i], 1.0, rounding);
}

TEST(LiveSync, AStructureHidesItsOwnFarPart) {
  // Two plates of one structure: the pick is on the left one.
  const Grid grid = gridOf(glm::ivec3(41));
  const Structure plates = structureOf(grid, [](glm::ivec3 i) { return i.x == 10 || i.x == 30; });
  const Scene scene = sceneOf(grid, 0.0, [](glm::ivec3) { return false; });
  const LocalShape shape = localShape(plates, {30.0, 20.0, 20.0}, 8.0);
  const std::vector<glm::dvec3> directions{left, right};
  EXPECT_EQ(visibilityScores(scene, plates, shape, directions), (std::vector<double>{1.0, 0.0}));
}

TEST(LiveSync, ASmallGapIsNoEndOfTheStructure) {
  // A bar along L with a gap of one voxel, which holds something opaque: the camera sees the bar's end.
  const Grid grid = gridOf(glm::ivec3(41));
  const auto inBar = [](glm::ivec3 i) { return i.x != 24 && i.x >= 16 && i.x < 30; };
  const Structure bar = structureOf(grid, inBar);
  const Scene scene = sceneOf(grid, 10.0, [](glm::ivec3 i) { return i.x == 24; });
  const std::vector<glm::dvec3> directions{left};
  EXPECT_EQ(visibilityScores(scene, bar, localShape(bar, glm::dvec3(20.0), 4.0), directions)[0], 1.0);
}

TEST(LiveSync, WhatIsNearThePickCountsMore) {
  // A bar along L, whose end beyond 8 mm is hidden from the front.
  const Grid grid = gridOf(glm::ivec3(41));
  const Structure bar = structureOf(grid, [](glm::ivec3 i) { return i.y == 20 && i.z == 20; });
  const Scene scene = sceneOf(grid, 10.0, [](glm::ivec3 i) { return i.y < 10 && i.x >= 28; });
  double near = 0.0, all = 0.0;
  for (int x = -14; x <= 14; ++x) {
    const double weight = std::pow(1.0 - x * x / 225.0, 2);
    all += weight;
    if (x < 8) near += weight;
  }
  const std::vector<glm::dvec3> directions{anterior};
  // The score is the mean of 96 even samples of the weights; the one at the border may lie on either side of it.
  EXPECT_NEAR(visibilityScores(scene, bar, localShape(bar, glm::dvec3(20.0), 15.0), directions)[0], near / all,
              1.0 / 96.0);
}

TEST(LiveSync, ClippedMaterialHidesNothing) {
  const Grid grid = gridOf(glm::ivec3(41));
  const Structure ball = structureOf(grid, [](glm::ivec3 i) { return glm::length(glm::dvec3(i) - 20.0) < 4.0; });
  Scene scene = sceneOf(grid, 10.0, [](glm::ivec3 i) { return i.x >= 30; });
  const LocalShape shape = localShape(ball, glm::dvec3(20.0), 10.0);
  const std::vector<glm::dvec3> directions{left};
  EXPECT_LT(visibilityScores(scene, ball, shape, directions)[0], 1e-9);
  scene.look.clipping.planes = {{right, -28.0}};  // keeps x ≤ 28
  EXPECT_NEAR(visibilityScores(scene, ball, shape, directions)[0], 1.0, rounding);
}

TEST(LiveSync, AnotherStructureInFocusHides) {
  const Grid grid = gridOf(glm::ivec3(41));
  Scene scene = sceneOf(grid, 0.0, [](glm::ivec3) { return false; });
  scene.labels = labelsOf(grid, [](glm::ivec3 i) {
    return glm::length(glm::dvec3(i) - 20.0) < 4.0 ? 3 : i.y < 10 ? 5 : 0;
  });
  scene.look.focus = LabelFocus{{5}};
  const Structure ball{scene.labels, {3}};
  const std::vector<glm::dvec3> directions{anterior, left};
  const std::vector<double> seen = visibilityScores(scene, ball, localShape(ball, glm::dvec3(20.0), 10.0), directions);
  EXPECT_LT(seen[0], 1e-8);  // 10 mm of 2 / mm
  EXPECT_EQ(seen[1], 1.0);
}

TEST(LiveSync, RatingsAreTheWeightedMeansOfWhatIsComputedAnew) {
  const Grid grid = obliqueGrid({24, 20, 16});
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  const glm::dvec3 pick(worldFromIndex * glm::dvec4(8.3, 10.0, 7.4, 1.0));  // off the structure's middle
  const auto isInside = [](glm::ivec3 i) {
    const glm::dvec3 offset = (glm::dvec3(i) - glm::dvec3(11, 9, 8)) / glm::dvec3(8, 3, 2);
    return glm::dot(offset, offset) < 1.0;
  };
  const Scene scene = sceneOf(grid, 0.03, [&](glm::ivec3 i) { return !isInside(i) && i.x > 6; });
  const Structure structure = structureOf(grid, isInside);
  LiveSyncOptions options;
  options.weights = {0.7, 0.4, 1.3, 0.9};
  options.reach = 9.0;
  const glm::dvec3 last = glm::normalize(glm::dvec3(1.0, -2.0, 0.5));
  Options usual;
  usual.habits = noHabits;
  const RatedViews views = rateViews(scene, structure, pick, 2, options, usual, last);
  ASSERT_EQ(views.directions.size(), 48u + 6u);

  // Two passes over all voxels, and the eigenvalues as roots of the characteristic polynomial.
  double sum = 0.0;
  glm::dvec3 mean(0.0);
  glm::dmat3 covariance(0.0);
  const auto eachVoxel = [&](auto&& visit) {
    forEachVoxel(grid.dims, [&](glm::ivec3 i) {
      const glm::dvec3 position(worldFromIndex * glm::dvec4(i, 1.0));
      const double fraction = glm::distance(position, pick) / options.reach;
      if (fraction < 1.0 && isInside(i)) visit(position, std::pow(1.0 - fraction * fraction, 2));
    });
  };
  eachVoxel([&](glm::dvec3 position, double weight) { sum += weight, mean += weight * position; });
  mean /= sum;
  eachVoxel([&](glm::dvec3 position, double weight) {
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) covariance[a][b] += weight / sum * (position - mean)[a] * (position - mean)[b];
  });
  for (const double variance : views.shape.variances)
    EXPECT_NEAR(glm::determinant(covariance - glm::dmat3(variance)), 0.0, 1e-6);
  ASSERT_GE(views.shape.variances[0], views.shape.variances[1]);
  ASSERT_GE(views.shape.variances[1], views.shape.variances[2]);

  std::size_t best = 0;
  const std::vector<double> visible = visibilityScores(scene, structure, views.shape, views.directions);
  std::vector<double> expected;
  for (std::size_t i = 0; i < views.directions.size(); ++i) {
    const glm::dvec3 d = views.directions[i];
    const double orientation = d.x * d.x * 0.6 + d.y * d.y * (d.y < 0 ? 1.0 : 0.4);
    const double history = (1.0 + d.x * last.x + d.y * last.y + d.z * last.z) / 2.0;
    double along = 0.0;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) along += d[a] * covariance[a][b] * d[b];
    const double shape = 1.0 - (along - views.shape.variances[2]) / views.shape.variances[0];
    expected.push_back((0.7 * orientation + 0.4 * history + 1.3 * shape + 0.9 * visible[i]) / (0.7 + 0.4 + 1.3 + 0.9));
    EXPECT_NEAR(views.ratings[i], expected[i], rounding) << i;
    EXPECT_GE(views.ratings[i], 0.0);
    EXPECT_LE(views.ratings[i], 1.0);
    if (expected[i] > expected[best]) best = i;
  }
  EXPECT_EQ(views.c1, best);
  std::optional<std::size_t> second;
  for (std::size_t i = 0; i < expected.size(); ++i)
    if (inRegion(views.directions[best], views.directions[i], {}) && (!second || expected[i] > expected[*second]))
      second = i;
  EXPECT_EQ(views.c2, second);
}

/// Visibility by a walk through the voxels that a ray passes, with the exact length in each.
TEST(LiveSync, VisibilityIsThatOfAnExactWalk) {
  const Grid grid = gridOf(glm::ivec3(32));
  const auto inBall = [](glm::ivec3 i) { return glm::length(glm::dvec3(i) - 15.0) < 5.0; };
  const auto isHaze = [&](glm::ivec3 i) { return !inBall(i) && (i.x + i.y > 30 || i.z < 6); };
  const Scene scene = sceneOf(grid, 0.05, isHaze);
  const Structure ball = structureOf(grid, inBall);
  const LocalShape shape = localShape(ball, glm::dvec3(15.0), 8.0);
  const std::vector<glm::dvec3> directions = ringDirections(1);
  const std::vector<double> seen = visibilityScores(scene, ball, shape, directions);
  double sum = 0.0;
  for (const double weight : shape.weights) sum += weight;
  for (std::size_t d = 0; d < directions.size(); ++d) {
    double expected = 0.0;
    for (std::size_t v = 0; v < shape.voxels.size(); ++v) {
      double depth = 0.0;
      constexpr double fine = 0.02;  // mm: a ball is convex, so nothing but the haze counts
      for (double t = 0.5 * fine; t < 60.0; t += fine) {
        const glm::ivec3 voxel(glm::floor(glm::dvec3(shape.voxels[v]) + t * directions[d] + 0.5));
        if (grid.contains(voxel) && isHaze(voxel)) depth += fine * 0.05;
      }
      expected += shape.weights[v] / sum * std::exp(-depth);
    }
    // 96 of some 500 voxels, whose transmittances differ by 0.3 or less (standard deviation): 0.3 / √96. The steps of
    // a voxel change a transmittance by less than the opacity of one, 0.05.
    EXPECT_NEAR(seen[d], expected, 0.03) << d;
  }
}

TEST(LiveSync, ThePlateOfAFlippedVolumeIsSeenFromTheFront) {
  // A coronal plate, stored from the back to the front and from the feet up.
  Grid grid = gridOf(glm::ivec3(31), glm::dvec3(1.0), {30.0, 30.0, 0.0});
  grid.direction = glm::dmat3(glm::dvec3(-1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1));
  const Scene scene = sceneOf(grid, 0.0, [](glm::ivec3) { return false; });
  const Structure plate = structureOf(grid, [](glm::ivec3 i) { return i.y == 15; });
  const glm::dvec3 pick(15.0);
  const RatedViews views = rateViews(scene, plate, pick, 3, {}, {});
  ASSERT_TRUE(views.c1 && views.c2);
  EXPECT_GT(glm::dot(views.directions[*views.c1], anterior), 1.0 - rounding);
  EXPECT_TRUE(inRegion(anterior, views.directions[*views.c2], {}));
  // A last camera behind the plate keeps the view there when orientation does not count.
  LiveSyncOptions options;
  options.weights.orientation = 0.0;
  EXPECT_GT(glm::dot(views.directions[*rateViews(scene, plate, pick, 3, options, {}, posterior).c1], posterior),
            1.0 - rounding);
  // An obstacle before it turns the view around.
  const Scene hidden = sceneOf(grid, 1.0, [](glm::ivec3 i) { return i.y >= 20; });  // anterior: y falls with the index
  options = {};
  options.weights.visibility = 2.0;
  EXPECT_GT(views.directions[*rateViews(hidden, plate, pick, 3, options, {}).c1].y, 0.5);
}

TEST(LiveSync, HistoryDecidesBetweenEqualViews) {
  const Grid grid = gridOf(glm::ivec3(31));
  const Scene scene = sceneOf(grid, 0.0, [](glm::ivec3) { return false; });
  const Structure ball = structureOf(grid, [](glm::ivec3 i) { return glm::length(glm::dvec3(i) - 15.0) < 6.0; });
  LiveSyncOptions options;
  options.weights.orientation = 0.0;
  for (const glm::dvec3 last : ringDirections(3)) {
    const RatedViews views = rateViews(scene, ball, glm::dvec3(15.0), 3, options, {}, last);
    EXPECT_EQ(views.directions[*views.c1], last);
  }
  // Without one, ties go to the lowest index, so that results repeat.
  options.weights.shape = options.weights.visibility = 0.0;
  EXPECT_EQ(rateViews(scene, ball, glm::dvec3(15.0), 3, options, {}).c1, 0u);
}

TEST(LiveSync, HabitsKeepViewsOffCutEndsAndThinStacksInFront) {
  // A ball in a column that the volume cuts off below: from below, least lies in front of it.
  const Grid grid = gridOf(glm::ivec3(41));
  const auto inBall = [](glm::ivec3 i) { return glm::length(glm::dvec3(i) - glm::dvec3(20, 20, 8)) < 3.0; };
  const Scene column =
      sceneOf(grid, 0.02, [](glm::ivec3 i) { return glm::length(glm::dvec2(i.x - 20, i.y - 20)) < 14.0 && i.z < 36; });
  const glm::dvec3 pick(20.0, 20.0, 8.0);
  LiveSyncOptions options;
  options.weights = {.orientation = 0.0, .history = 0.0, .shape = 0.0, .visibility = 1.0};
  Options usual;
  const auto placed = [&](const Scene& scene, const Grid& on, const auto& isInside, glm::dvec3 at) {
    const RatedViews views = rateViews(scene, structureOf(on, isInside), at, 3, options, usual);
    return std::pair(views.directions[views.c1.value()], views.directions[views.c2.value()]);
  };
  const auto [up, across] = placed(column, grid, inBall, pick);
  EXPECT_GT(up.z, -0.71);
  EXPECT_GT(across.z, -0.71);
  usual.habits.avoidCutEnds = false;
  EXPECT_LT(placed(column, grid, inBall, pick).first.z, -0.71);
  // In three axial slices, a plate along them is seen from below, whatever shows more.
  const Grid flat = gridOf({41, 41, 3});
  const Scene slices = sceneOf(flat, 1.0, [](glm::ivec3 i) { return i.z != 1; });
  const auto inPlate = [](glm::ivec3 i) { return i.z == 1; };
  EXPECT_LT(placed(slices, flat, inPlate, {20.0, 20.0, 1.0}).first.z, -0.9);
  usual.habits.flatFromFront = false;
  EXPECT_GT(placed(slices, flat, inPlate, {20.0, 20.0, 1.0}).first.z, -0.9);
}

TEST(LiveSync, NoStructureWithinReachHasNoCamera) {
  const Grid grid = gridOf(glm::ivec3(31));
  const Scene scene = sceneOf(grid, 0.0, [](glm::ivec3) { return false; });
  const Structure far = structureOf(grid, [](glm::ivec3 i) { return i.x == 30; });
  const RatedViews views = rateViews(scene, far, {5.0, 5.0, 5.0}, 1, {.weights = {}, .reach = 10.0}, {});
  EXPECT_FALSE(views.c1);
  EXPECT_FALSE(views.c2);
}

TEST(LiveSync, TheCameraLooksAtThePick) {
  const Grid grid = gridOf(glm::ivec3(31));
  const glm::dvec3 pick(4.0, 20.0, 9.0);
  const glm::dvec3 direction = glm::normalize(glm::dvec3(1.0, -1.0, 0.3));
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    const Camera camera = cameraAt(pick, direction, grid, projection);
    EXPECT_EQ(camera.target, pick);
    EXPECT_NEAR(glm::dot(glm::normalize(camera.eye - pick), direction), 1.0, rounding);
    EXPECT_NEAR(glm::distance(camera.eye, pick),
                glm::distance(Camera::fromDirection(direction, grid, projection).eye, grid.centre()), rounding);
    EXPECT_GT(camera.axes().up.z, 0.5);
  }
}

}  // namespace
}  // namespace fenestra::tests::liveSyncTest
