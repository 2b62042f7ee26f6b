#include "rendering/volume/Phantom.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::phantomTest {
namespace {

using namespace tests;

glm::dmat3 randomRotation(std::mt19937& random) {
  return glm::dmat3(
      glm::rotate(glm::dmat4(1.0), std::uniform_real_distribution<double>(0.0, 6.28)(random), randomUnit(random)));
}

Shape randomShape(std::mt19937& random, int kind) {
  const glm::dvec3 centre = randomIn(random, glm::dvec3(-20.0), glm::dvec3(20.0));
  const glm::dvec3 semiAxes = randomIn(random, glm::dvec3(2.0), glm::dvec3(15.0));
  switch (kind) {
    case 0:
      return Ellipsoid{centre, semiAxes, randomRotation(random)};
    case 1:
      return Cylinder{centre, semiAxes, randomRotation(random)};
    case 2:
      return Capsule{centre, randomIn(random, glm::dvec3(-20.0), glm::dvec3(20.0)), semiAxes.x};
    default:
      return Box{centre, semiAxes, randomRotation(random)};
  }
}

Phantom randomPhantom(std::mt19937& random, int bodies) {
  Phantom phantom;
  phantom.extent = {70.0, 60.0, 50.0};
  for (int i = 0; i < bodies; ++i) {
    PhantomBody body;
    body.label = static_cast<std::uint16_t>(i % 4);  // every fourth is drawn into the values only
    body.name = std::to_string(i);
    body.value = 100.0 * i - 300.0;
    body.shapes = {randomShape(random, i % 4), randomShape(random, (i + 1) % 4)};
    phantom.bodies.push_back(body);
  }
  return phantom;
}

TEST(Phantom, sphereOnAxis) {
  const auto hit = intersect(Ellipsoid{{0, 0, 10}, glm::dvec3(4.0)}, {0, 0, 0}, {0, 0, 1});
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->tIn, 6.0);
  EXPECT_DOUBLE_EQ(hit->tOut, 14.0);
  EXPECT_FALSE(intersect(Ellipsoid{{0, 0, 10}, glm::dvec3(4.0)}, {4.0001, 0, 0}, {0, 0, 1}));
}

TEST(Phantom, sphereFromAKilometreAway) {
  const auto hit = intersect(Ellipsoid{{0, 0, 0}, glm::dvec3(4.0)}, {3.0, 0, -1e6}, {0, 0, 1});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->tIn, 1e6 - std::sqrt(7.0), 1e-9);  // doubles at 1e6 are 1e-10 apart
}

TEST(Phantom, cylinderSideAndEnds) {
  const Cylinder cylinder{{0, 0, 0}, {3, 5, 10}};
  EXPECT_DOUBLE_EQ(intersect(cylinder, {-20, 0, 0}, {1, 0, 0})->tIn, 17.0);
  EXPECT_DOUBLE_EQ(intersect(cylinder, {0, -20, 0}, {0, 1, 0})->tOut, 25.0);
  EXPECT_DOUBLE_EQ(intersect(cylinder, {1, 1, -20}, {0, 0, 1})->tIn, 10.0);
  EXPECT_FALSE(intersect(cylinder, {2.9, 4.9, -20}, {0, 0, 1}));
  EXPECT_FALSE(intersect(cylinder, {-20, 0, 10.001}, {1, 0, 0}));
}

TEST(Phantom, capsuleSideEndsAndPoint) {
  const Capsule capsule{{-5, 0, 0}, {5, 0, 0}, 2.0};
  EXPECT_DOUBLE_EQ(intersect(capsule, {0, -10, 0}, {0, 1, 0})->tIn, 8.0);
  EXPECT_DOUBLE_EQ(intersect(capsule, {-20, 0, 0}, {1, 0, 0})->tIn, 13.0);
  EXPECT_DOUBLE_EQ(intersect(capsule, {-20, 0, 0}, {1, 0, 0})->tOut, 27.0);
  EXPECT_FALSE(intersect(capsule, {-20, 2.001, 0}, {1, 0, 0}));
  EXPECT_DOUBLE_EQ(intersect(Capsule{{1, 1, 1}, {1, 1, 1}, 2.0}, {1, 1, -9}, {0, 0, 1})->tIn, 8.0);
}

TEST(Phantom, boxFacesAndRaysAlongThem) {
  const Box box{{0, 0, 0}, {1, 2, 3}};
  EXPECT_DOUBLE_EQ(intersect(box, {0, 0, -10}, {0, 0, 1})->tIn, 7.0);
  const auto along = intersect(box, {1, 2, -10}, {0, 0, 1});  // on an edge, which belongs to the box
  ASSERT_TRUE(along);
  EXPECT_DOUBLE_EQ(along->tIn, 7.0);
  EXPECT_FALSE(intersect(box, {1.0001, 0, -10}, {0, 0, 1}));
}

TEST(Phantom, intersectionsAgreeWithMarching) {
  std::mt19937 random(11);
  int hits = 0, misses = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Shape shape = randomShape(random, trial % 4);
    const glm::dvec3 origin = randomIn(random, glm::dvec3(-40.0), glm::dvec3(40.0));
    const glm::dvec3 direction = glm::normalize(randomIn(random, glm::dvec3(-15.0), glm::dvec3(15.0)) - origin);
    const auto interval = intersect(shape, origin, direction);
    interval ? ++hits : ++misses;
    constexpr double step = 0.05;
    // Closer to the surface than this, rounding may decide either way.
    constexpr double margin = 1e-9;
    for (double t = -80.0; t < 80.0; t += step) {
      const bool inside = interval && t > interval->tIn + margin && t < interval->tOut - margin;
      const bool outside = !interval || t < interval->tIn - margin || t > interval->tOut + margin;
      if (!inside && !outside) continue;
      EXPECT_EQ(contains(shape, origin + t * direction), inside) << "trial " << trial << " t " << t;
    }
  }
  EXPECT_GT(hits, 50);
  EXPECT_GT(misses, 50);
}

TEST(Phantom, laterBodyWins) {
  Phantom phantom;
  phantom.bodies = {{1, "outer", {}, 50.0, {Ellipsoid{{0, 0, 0}, glm::dvec3(10.0)}}},
                    {2, "inner", {}, 300.0, {Ellipsoid{{0, 0, 0}, glm::dvec3(5.0)}}},
                    {0, "marrow", {}, 200.0, {Ellipsoid{{0, 0, 0}, glm::dvec3(2.0)}}}};
  EXPECT_EQ(phantom.value({0, 0, 0}), 200.0);
  EXPECT_EQ(phantom.label({0, 0, 0}), 2);  // unlabelled bodies leave labels alone
  EXPECT_EQ(phantom.label({7, 0, 0}), 1);
  EXPECT_EQ(phantom.label({11, 0, 0}), 0);
  EXPECT_EQ(phantom.value({11, 0, 0}), -1000.0);
  const glm::dvec3 eye(-20, 0, 0), right(1, 0, 0);
  EXPECT_DOUBLE_EQ(*phantom.firstHit(eye, right, {1}), 10.0);
  EXPECT_DOUBLE_EQ(*phantom.firstHit(eye, right, {2}), 15.0);
  EXPECT_DOUBLE_EQ(*phantom.firstHit({0, 0, 0}, right, {1}), 5.0);  // from inside: behind the inner ball
  EXPECT_DOUBLE_EQ(*phantom.firstHit({7, 0, 0}, right, {1}), 0.0);
  EXPECT_FALSE(phantom.firstHit({11, 0, 0}, right, {1}));  // behind the eye
  EXPECT_FALSE(phantom.firstHit(eye, right, {3}));
  EXPECT_FALSE(phantom.firstHit(eye, right, {}));
  ASSERT_EQ(phantom.segments(eye, right).size(), 5u);
  EXPECT_DOUBLE_EQ(phantom.segments(eye, right)[2].tIn, 18.0);
  EXPECT_EQ(phantom.segments(eye, right)[2].body, 2u);
}

TEST(Phantom, firstHitsAndSegmentsAgreeWithMarching) {
  std::mt19937 random(17);
  int hits = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const Phantom phantom = randomPhantom(random, 8);
    const glm::dvec3 origin = randomIn(random, glm::dvec3(-40.0), glm::dvec3(40.0));
    const glm::dvec3 direction = glm::normalize(randomIn(random, glm::dvec3(-15.0), glm::dvec3(15.0)) - origin);
    const std::vector<std::uint16_t> labels = {static_cast<std::uint16_t>(1 + trial % 3)};
    const auto hit = phantom.firstHit(origin, direction, labels);
    const auto isFocus = [&](double t) { return phantom.label(origin + t * direction) == labels[0]; };
    // The march starts behind the origin's own rounding and may step over a sliver, but never finds an earlier hit.
    for (double t = 1e-9; t < (hit ? *hit - 1e-9 : 100.0); t += 0.03) EXPECT_FALSE(isFocus(t)) << "trial " << trial;
    if (hit) {
      ++hits;
      EXPECT_TRUE(isFocus(*hit + 1e-9)) << "trial " << trial;
    }
    double tBefore = -infinity;
    for (const Phantom::Segment& segment : phantom.segments(origin, direction)) {
      EXPECT_GE(segment.tIn, tBefore);
      EXPECT_LT(segment.tIn, segment.tOut);
      EXPECT_EQ(phantom.value(origin + 0.5 * (segment.tIn + segment.tOut) * direction),
                phantom.bodies[segment.body].value);
      tBefore = segment.tOut;
    }
  }
  EXPECT_GT(hits, 30);
}

TEST(Phantom, rasterisedGridCoversTheExtentWithCubes) {
  Phantom phantom;
  phantom.extent = {100.0, 30.0, 200.0};
  const Grid grid = phantom.rasterise(64).volume->grid;
  EXPECT_EQ(grid.dims, glm::ivec3(32, 10, 64));
  EXPECT_EQ(grid.spacing, glm::dvec3(200.0 / 64.0));
  EXPECT_NEAR(glm::length(grid.centre()), 0.0, 1e-12);
  EXPECT_EQ(phantom.rasterise(1).volume->grid.dims, glm::ivec3(1));
}

TEST(Phantom, rasterisedLabelsAreThoseOfTheVoxelCentres) {
  std::mt19937 random(23);
  for (int trial = 0; trial < 4; ++trial) {
    const Phantom phantom = randomPhantom(random, 10);
    const Phantom::Rasterised raster = phantom.rasterise(40);
    const Grid& grid = raster.volume->grid;
    ASSERT_EQ(raster.labels->grid, grid);
    forEachVoxel(grid.dims, [&](glm::ivec3 i) {
      const glm::dvec3 centre(grid.worldFromIndex() * glm::dvec4(glm::dvec3(i), 1.0));
      EXPECT_EQ(raster.labels->value(i), phantom.label(centre));
    });
  }
}

TEST(Phantom, rasterisedValuesAreMeansSpreadOverTheNeighbours) {
  std::mt19937 random(29);
  const Phantom phantom = randomPhantom(random, 10);
  const Phantom::Rasterised raster = phantom.rasterise(32);
  const Grid& grid = raster.volume->grid;
  // Each voxel's mean by brute force.
  std::vector<double> means(grid.voxelCount());
  forEachVoxel(grid.dims, [&](glm::ivec3 i) {
    const glm::dvec3 centre(grid.worldFromIndex() * glm::dvec4(glm::dvec3(i), 1.0));
    constexpr int n = 8;
    for (int k = 0; k < n * n * n; ++k) {
      const glm::dvec3 offset = (glm::dvec3(k % n, k / n % n, k / (n * n)) + 0.5) / double(n) - 0.5;
      means[grid.offset(i)] += phantom.value(centre + grid.spacing * offset) / (n * n * n);
    }
  });
  double sum = 0.0, greatest = 0.0;
  forEachVoxel(grid.dims, [&](glm::ivec3 i) {
    double expected = 0.0;
    forEachVoxel(glm::ivec3(3), [&](glm::ivec3 d) {
      const glm::ivec3 neighbour = glm::clamp(i + d - 1, glm::ivec3(0), grid.dims - 1), weight = 2 - glm::abs(d - 1);
      expected += means[grid.offset(neighbour)] * weight.x * weight.y * weight.z / 64.0;
    });
    const double error = std::abs(raster.volume->value(i) - expected);
    greatest = std::max(greatest, error);
    sum += error;
  });
  // Bodies differ by up to 1600. The brute force steps by an eighth of a voxel, which some surface may follow; over all
  // voxels such steps cancel.
  EXPECT_LT(greatest, 0.125 * 1600.0);
  EXPECT_LT(sum / static_cast<double>(grid.voxelCount()), 2.0);
}

TEST(Phantom, rasterisedSphereKeepsItsVolume) {
  Phantom phantom;
  phantom.extent = glm::dvec3(40.0);
  phantom.background = 0.0;
  phantom.bodies = {{1, "ball", {}, 1000.0, {Ellipsoid{{0.3, -0.2, 0.1}, glm::dvec3(15.0)}}}};
  const Phantom::Rasterised raster = phantom.rasterise(40);
  double sum = 0.0;
  forEachVoxel(raster.volume->grid.dims, [&](glm::ivec3 i) { sum += raster.volume->value(i); });
  const double volume = 4.0 / 3.0 * 3.14159265358979 * 15.0 * 15.0 * 15.0;
  EXPECT_NEAR(sum / 1000.0, volume, 1e-3 * volume);  // quarter-voxel rows through a ball 30 voxels wide
  EXPECT_EQ(raster.volume->value({20, 20, 20}), 1000.0);
  EXPECT_EQ(raster.volume->value({0, 0, 0}), 0.0);
  EXPECT_EQ(raster.volume->range, (ValueRange{0.0, 1000.0}));
  ASSERT_EQ(raster.labels->labels.size(), 1u);
  EXPECT_EQ(raster.labels->labels[0].name, "ball");
}

TEST(Phantom, valuesBeyondInt16AreClamped) {
  Phantom phantom;
  phantom.extent = glm::dvec3(4.0);
  phantom.background = -1e9;
  phantom.bodies = {{1, "dense", {}, 1e9, {Box{{1, 0, 0}, {1, 2, 2}}}}};
  const Phantom::Rasterised raster = phantom.rasterise(4);
  EXPECT_EQ(raster.volume->range, (ValueRange{-32768.0, 32767.0}));
}

}  // namespace
}  // namespace fenestra::phantomTest
