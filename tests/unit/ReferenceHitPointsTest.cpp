// Hit points of the reference against closed forms and fine marching.

#include <gtest/gtest.h>

#include "rendering/reference/Reference.h"
#include "rendering/scene/FocusCells.h"
#include "rendering/volume/Phantom.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference::referenceHitPointsTest {
namespace {

using namespace tests;

/// Calls f(pixel's linear index, ray).
template <class F>
void forEachRay(const Camera& camera, glm::ivec2 size, F&& f) {
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i) f(static_cast<std::size_t>(j * size.x + i), pixelRay(camera, size, {i, j}));
}

glm::dvec3 worldAt(const Grid& grid, glm::dvec3 index) {
  return glm::dvec3(grid.worldFromIndex() * glm::dvec4(index, 1.0));
}

glm::dvec3 indexAt(const Ray& ray, const Grid& grid, double t) {
  const Ray local = indexRay(ray, grid);
  return local.origin + t * local.direction;
}

TEST(ReferenceRays, projectBackIntoTheirPixels) {
  const Grid grid = obliqueGrid({40, 30, 20});
  const glm::ivec2 size(70, 65);
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    const Camera camera = Camera::fromAngles(33.0, -21.0, grid, projection);
    const glm::dmat4 clipFromWorld = camera.clipFromWorld(70.0 / 65.0, grid);
    forEachRay(camera, size, [&](std::size_t pixel, const Ray& ray) {
      EXPECT_NEAR(glm::length(ray.direction), 1.0, 1e-14);
      const double distance = glm::distance(camera.eye, camera.target);
      const glm::dvec4 clip = clipFromWorld * glm::dvec4(ray.origin + distance * ray.direction, 1.0);
      const auto i = static_cast<double>(pixel % 70), j = static_cast<double>(pixel / 70);
      EXPECT_NEAR(clip.x / clip.w, 2.0 * (i + 0.5) / 70.0 - 1.0, 1e-12);
      EXPECT_NEAR(clip.y / clip.w, 1.0 - 2.0 * (j + 0.5) / 65.0, 1e-12);
      // The origin is the eye, or on the near plane.
      if (projection == Projection::Perspective)
        EXPECT_EQ(ray.origin, camera.eye);
      else
        EXPECT_NEAR((clipFromWorld * glm::dvec4(ray.origin, 1.0)).z, -1.0, 1e-12);
    });
  }
}

TEST(ReferenceRays, clipToTheVoxelsExtents) {
  const Grid grid = gridOf({4, 6, 8}, {1.0, 2.0, 3.0});
  const auto span = clip({{-10.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, grid);
  ASSERT_TRUE(span);
  EXPECT_DOUBLE_EQ(span->tIn, 9.5);
  EXPECT_DOUBLE_EQ(span->tOut, 13.5);
  const auto inside = clip({{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, grid);
  ASSERT_TRUE(inside);
  EXPECT_DOUBLE_EQ(inside->tIn, 0.0);
  EXPECT_DOUBLE_EQ(inside->tOut, 11.0);
  EXPECT_FALSE(clip({{10.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, grid));    // behind
  EXPECT_FALSE(clip({{-10.0, 50.0, 0.0}, {1.0, 0.0, 0.0}}, grid));  // beside
}

TEST(ReferenceRays, clipKeepsRaysThatRunInAFace) {
  const Grid grid = gridOf({4, 4, 4});
  for (const double face : {-0.5, 3.5}) {
    const auto span = clip({{face, 1.0, -10.0}, {0.0, 0.0, 1.0}}, grid);
    ASSERT_TRUE(span);
    EXPECT_DOUBLE_EQ(span->tIn, 9.5);
    EXPECT_DOUBLE_EQ(span->tOut, 13.5);
  }
  EXPECT_FALSE(clip({{std::nextafter(3.5, 4.0), 1.0, -10.0}, {0.0, 0.0, 1.0}}, grid));
}

TEST(ReferenceHitPoints, labelSurfaceOfAHalfSpaceIsMidwayBetweenCentres) {
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    const Grid grid = obliqueGrid({12, 14, 10});
    const Scene scene = labelScene(grid, [](glm::ivec3 i) { return i.x >= 5; });
    const Camera camera = lookAt(worldAt(grid, {-20.0, 3.0, 7.0}), worldAt(grid, {6.0, 6.0, 4.0}), projection, 12.0);
    const glm::ivec2 size(23, 17);
    const HitPoints hits = hitPoints(scene, camera, size);
    int count = 0;
    forEachRay(camera, size, [&](std::size_t pixel, const Ray& ray) {
      const auto span = clip(ray, grid);
      ASSERT_EQ(std::isnan(hits.tOut[pixel]), !span.has_value());
      if (!span) return;
      // The plane index x = 4.5 in closed form.
      const Ray local = indexRay(ray, grid);
      const double t = (4.5 - local.origin.x) / local.direction.x;
      if (indexAt(ray, grid, span->tIn).x >= 4.5) {
        EXPECT_DOUBLE_EQ(hits.tFocus[pixel], span->tIn);
      } else if (t <= span->tOut) {
        EXPECT_NEAR(hits.tFocus[pixel], t, 1e-10);
        ++count;
      } else {
        EXPECT_TRUE(std::isnan(hits.tFocus[pixel]));
      }
      // The scene holds the focus alone, so tContext is its hit, too.
      EXPECT_TRUE(hits.tContext[pixel] == hits.tFocus[pixel] ||
                  (std::isnan(hits.tContext[pixel]) && std::isnan(hits.tFocus[pixel])));
    });
    EXPECT_GT(count, 100);
  }
}

TEST(ReferenceHitPoints, levelPlanesOfARampAreExact) {
  const Grid grid = obliqueGrid({20, 20, 20});
  const glm::dvec3 slope(1.0, 0.6, -0.4);
  // Far enough from the border that no ray meets the plane where values are clamped.
  const auto ramp = [&](glm::ivec3 i) { return glm::dot(slope, glm::dvec3(i)); };
  const double low = ramp(glm::ivec3(10)), high = low + 1.5;
  Scene scene = valueScene(grid, ramp, low, high);
  scene.look.context.function = opaqueFrom(low - 2.0);
  const Camera camera = lookAt(worldAt(grid, {-60.0, -20.0, 30.0}), worldAt(grid, glm::dvec3(9.0)));
  const glm::ivec2 size(31, 29);
  const HitPoints hits = hitPoints(scene, camera, size);
  int count = 0;
  forEachRay(camera, size, [&](std::size_t pixel, const Ray& ray) {
    const Ray local = indexRay(ray, grid);
    const auto tOf = [&](double level) {
      return (level - glm::dot(slope, local.origin)) / glm::dot(slope, local.direction);
    };
    const glm::dvec3 at = local.origin + tOf(low) * local.direction,
                     before = local.origin + tOf(low - 2.0) * local.direction;
    for (const glm::dvec3& p : {at, before})
      if (glm::any(glm::lessThan(p, glm::dvec3(0.0))) || glm::any(glm::greaterThan(p, glm::dvec3(19.0)))) return;
    EXPECT_NEAR(hits.tFocus[pixel], tOf(low), 1e-9);
    EXPECT_NEAR(hits.tContext[pixel], tOf(low - 2.0), 1e-9);
    ++count;
  });
  EXPECT_GT(count, 100);
}

/// First t, marched in small steps, at which the interpolated value leaves `outside`; its step's beginning and end.
struct Marched {
  double before = nan, at = nan;
};
Marched march(const Volume& volume, const Ray& ray, Span span, double step, const auto& isIn) {
  double before = span.tIn;
  for (double t = span.tIn;; t = std::min(t + step, span.tOut)) {
    if (isIn(volume.sample(indexAt(ray, volume.grid, t)))) return {before, t};
    if (t >= span.tOut) return {};
    before = t;
  }
}

TEST(ReferenceHitPoints, firstCrossingsInNoiseAgreeWithFineMarching) {
  // In a random volume every cell holds another cubic: the worst case.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(0.0, 1.0);
  const Grid grid = obliqueGrid({7, 6, 5});
  int hitCount = 0, slivers = 0;
  for (int trial = 0; trial < 4; ++trial) {
    const auto noise = [&](glm::ivec3) { return value(random); };
    const double low = 0.72, high = 0.75;
    Scene scene = valueScene(grid, noise, low, high);
    scene.look.context.function = opaqueFrom(0.85);
    const Camera camera = Camera::fromAngles(40.0 * trial, 15.0, grid);
    const glm::ivec2 size(35, 33);
    const HitPoints hits = hitPoints(scene, camera, size);
    const double step = 2e-3;
    forEachRay(camera, size, [&](std::size_t pixel, const Ray& ray) {
      const auto span = clip(ray, grid);
      if (!span) return;
      const auto check = [&](double t, const Marched& marched, const auto& isIn, double level) {
        if (std::isnan(t)) {
          EXPECT_TRUE(std::isnan(marched.at)) << "missed at pixel " << pixel;
          return;
        }
        // Marching may step over a sliver; the reference may not come later than it.
        EXPECT_FALSE(t > marched.at + 1e-9);
        if (std::isnan(marched.at) || t < marched.before - 1e-9) ++slivers;
        const double found = scene.volume->sample(indexAt(ray, grid, t));
        EXPECT_TRUE(std::abs(found - level) < 1e-9 || (t == span->tIn && isIn(found))) << found;
        ++hitCount;
      };
      const auto inFocus = [&](double v) { return v >= low && v <= high; };
      const Marched focus = march(*scene.volume, ray, *span, step, inFocus);
      // Coming from below or from above.
      const double start = scene.volume->sample(indexAt(ray, grid, span->tIn));
      check(hits.tFocus[pixel], focus, inFocus, start < low ? low : high);
      const auto inContext = [&](double v) { return v >= 0.85; };
      const Marched context = march(*scene.volume, ray, *span, step, inContext);
      const double tContext = std::fmin(context.at, focus.at);
      EXPECT_EQ(std::isnan(hits.tContext[pixel]), std::isnan(hits.tFocus[pixel]) && std::isnan(context.at));
      EXPECT_FALSE(hits.tContext[pixel] > tContext + 1e-9);
      if (hits.tContext[pixel] > span->tIn && hits.tContext[pixel] != hits.tFocus[pixel]) {
        EXPECT_NEAR(scene.volume->sample(indexAt(ray, grid, hits.tContext[pixel])), 0.85, 1e-9);
      }
    });
  }
  EXPECT_GT(hitCount, 500);
  EXPECT_LT(slivers, hitCount / 50);  // else the comparison would be void
}

TEST(ReferenceHitPoints, contextInsideAGapLeavesByEitherEnd) {
  // A profile along x that a ray follows: opaque outside 10 … 20.
  const double profile[] = {15, 12, 18, 25, 15, 5};
  Scene scene;
  scene.volume = volumeOf(gridOf({6, 3, 3}), [&](glm::ivec3 i) { return profile[i.x]; });
  scene.look.context.function.nodes = {{10.0, {glm::dvec3(1.0), 5.0}},
                                       {10.0, {glm::dvec3(1.0), 0.0}},
                                       {20.0, {glm::dvec3(1.0), 0.0}},
                                       {20.0, {glm::dvec3(1.0), 5.0}}};
  Camera camera = lookAt({-10.0, 1.0, 1.0}, {0.0, 1.0, 1.0}, Projection::Orthographic, 1.0);
  EXPECT_NEAR(hitPoints(scene, camera, {1, 1}).tContext[0], 10.0 + 2.0 + 2.0 / 7.0, 1e-12);
  camera = lookAt({20.0, 1.0, 1.0}, {0.0, 1.0, 1.0}, Projection::Orthographic, 1.0);
  EXPECT_DOUBLE_EQ(hitPoints(scene, camera, {1, 1}).tContext[0], 20.0 - 5.5);  // opaque where it enters
}

TEST(ReferenceHitPoints, labelsOfABallConvergeToTheBall) {
  // The 0.5 level of a sampled indicator lies within a voxel of the surface, whatever the resolution.
  Phantom phantom;
  phantom.extent = glm::dvec3(40.0);
  phantom.bodies = {{1, "ball", {}, 100.0, {Ellipsoid{{0.37, -0.21, 0.13}, glm::dvec3(14.0)}}}};
  const glm::ivec2 size(61, 61);
  double meanBefore = infinity;
  for (const int voxels : {20, 40, 80}) {
    const Phantom::Rasterised raster = phantom.rasterise(voxels);
    Scene scene;
    scene.volume = raster.volume;
    scene.labels = raster.labels;
    scene.look.focus = LabelFocus{{1}};
    const Camera camera = Camera::fromAngles(25.0, 35.0, raster.volume->grid);
    const HitPoints hits = hitPoints(scene, camera, size);
    const double voxel = raster.volume->grid.spacing.x;
    double sum = 0.0;
    int count = 0;
    forEachRay(camera, size, [&](std::size_t pixel, const Ray& ray) {
      const auto exact = phantom.firstHit(ray.origin, ray.direction, {1});
      // Rays that graze the ball turn a small shift of the surface into a large one of t.
      if (!exact || std::isnan(hits.tFocus[pixel])) return;
      const glm::dvec3 normal = glm::normalize(ray.origin + *exact * ray.direction - glm::dvec3(0.37, -0.21, 0.13));
      const double across = std::abs(hits.tFocus[pixel] - *exact) * std::abs(glm::dot(normal, ray.direction));
      if (glm::dot(normal, ray.direction) > -0.3) return;
      EXPECT_LT(across, voxel);
      sum += across;
      ++count;
    });
    ASSERT_GT(count, 300);
    EXPECT_LT(sum / count, 0.3 * voxel);
    EXPECT_LT(sum / count,
              0.7 * meanBefore);  // halving the voxel, with a margin for how the surface lies on the lattice
    meanBefore = sum / count;
  }
}

TEST(ReferenceHitPoints, levelHalfwayBetweenMaterialsIsTheBallsSurface) {
  Phantom phantom;
  phantom.extent = glm::dvec3(40.0);
  phantom.background = 0.0;
  phantom.bodies = {{1, "ball", {}, 1000.0, {Ellipsoid{{0.0, 0.0, 0.0}, glm::dvec3(14.0)}}}};
  const Phantom::Rasterised raster = phantom.rasterise(64);
  Scene scene;
  scene.volume = raster.volume;
  scene.look.focus = ValueFocus{{500.0, infinity}, 0.0};
  const glm::ivec2 size(31, 31);
  const Camera camera = Camera::fromAngles(10.0, 20.0, raster.volume->grid);
  const HitPoints hits = hitPoints(scene, camera, size);
  forEachRay(camera, size, [&](std::size_t pixel, const Ray& ray) {
    const auto exact = phantom.firstHit(ray.origin, ray.direction, {1});
    if (!exact) return;
    const double cosine = -glm::dot(glm::normalize(ray.origin + *exact * ray.direction), ray.direction);
    // Coverage is far smoother than 0/1 labels; interpolation and the spread over neighbours shift a curved surface by
    // less than this.
    EXPECT_LT(std::abs(hits.tFocus[pixel] - *exact) * cosine, 0.2 * raster.volume->grid.spacing.x);
  });
}

TEST(ReferenceFocusCells, smallComponentsAreDropped) {
  // Two cubes of value 1: 3³ voxels touch 4³ cells, a single voxel 2³.
  const Grid grid = gridOf({20, 20, 20}, {0.5, 1.0, 2.0});
  const auto cubes = [](glm::ivec3 i) {
    const bool large = glm::all(glm::greaterThanEqual(i, glm::ivec3(4))) && glm::all(glm::lessThan(i, glm::ivec3(7)));
    return large || i == glm::ivec3(15) ? 1.0 : 0.0;
  };
  const auto volume = volumeOf(grid, cubes);
  const auto kept = [&](double minimum) {
    const FocusCells cells = focusCells({volume}, {{0.5, 2.0}, minimum});
    return std::count(cells.kept.begin(), cells.kept.end(), 1);
  };
  EXPECT_EQ(kept(0.0), 64 + 8);
  EXPECT_EQ(kept(8.0), 64 + 8);  // the voxel's volume is 1 mm³; as large as the limit stays
  EXPECT_EQ(kept(8.001), 64);
  EXPECT_EQ(kept(64.0), 64);
  EXPECT_EQ(kept(64.001), 0);
}

TEST(ReferenceFocusCells, cellsThatShareACornerAreConnected) {
  // Cells of voxel (5,5,5) reach corner 6; those of voxel (7,7,7) begin there.
  const auto volume =
      volumeOf(gridOf({12, 12, 12}), [](glm::ivec3 i) { return i == glm::ivec3(5) || i == glm::ivec3(7) ? 1.0 : 0.0; });
  const FocusCells together = focusCells({volume}, {{0.5, 2.0}, 16.0});
  EXPECT_EQ(std::count(together.kept.begin(), together.kept.end(), 1), 16);
  const auto apart =
      volumeOf(gridOf({12, 12, 12}), [](glm::ivec3 i) { return i == glm::ivec3(5) || i == glm::ivec3(8) ? 1.0 : 0.0; });
  const FocusCells none = focusCells({apart}, {{0.5, 2.0}, 16.0});
  EXPECT_EQ(std::count(none.kept.begin(), none.kept.end(), 1), 0);
}

TEST(ReferenceHitPoints, droppedComponentsAreNotHit) {
  const Grid grid = gridOf({30, 9, 9});
  const auto twoBlobs = [](glm::ivec3 i) {
    return i == glm::ivec3(5, 4, 4) || (i.x >= 15 && i.x < 20 && i.y > 1 && i.y < 7 && i.z > 1 && i.z < 7) ? 1.0 : 0.0;
  };
  Scene scene = valueScene(grid, twoBlobs, 0.5);
  const Camera camera = lookAt({-10.0, 4.0, 4.0}, {0.0, 4.0, 4.0}, Projection::Orthographic, 1.0);
  EXPECT_DOUBLE_EQ(hitPoints(scene, camera, {1, 1}).tFocus[0], 14.5);
  std::get<ValueFocus>(scene.look.focus).minimumComponent = 20.0;
  EXPECT_DOUBLE_EQ(hitPoints(scene, camera, {1, 1}).tFocus[0], 24.5);
}

TEST(ReferenceHitPoints, withoutAFocusThereIsContextOnly) {
  Scene scene;
  scene.volume = volumeOf(gridOf({5, 5, 5}), [](glm::ivec3 i) { return i.x; });
  scene.look.context.function = opaqueFrom(1.75);
  const Camera camera = lookAt({-10.0, 2.0, 2.0}, {0.0, 2.0, 2.0}, Projection::Orthographic, 1.0);
  const HitPoints hits = hitPoints(scene, camera, {1, 1});
  EXPECT_DOUBLE_EQ(hits.tContext[0], 11.75);
  EXPECT_TRUE(std::isnan(hits.tFocus[0]));
  EXPECT_DOUBLE_EQ(hits.tOut[0], 14.5);
}

}  // namespace
}  // namespace fenestra::reference::referenceHitPointsTest
