// The reference with a spline between the voxels, against closed forms and against fine steps through the spline
// itself.

#include <cmath>

#include <gtest/gtest.h>

#include "rendering/reference/Picture.h"
#include "rendering/scene/FocusCells.h"
#include "rendering/scene/Lighting.h"
#include "rendering/scene/SplineVolume.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference::referenceReconstructionTest {
namespace {

using namespace tests;

/// Noise in an oblique grid.
Scene noise(Reconstruction reconstruction, TransferFunction transfer) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0.0, 100.0);
  Scene scene;
  scene.volume = volumeOf(obliqueGrid({7, 6, 5}), [&](glm::ivec3) { return any(random); });
  scene.look.context.function = std::move(transfer);
  scene.look.shading.enabled = false;
  scene.look.reconstruction = reconstruction;
  return scene;
}

Camera around(const Scene& scene) {
  const glm::dvec3 centre = scene.volume->grid.centre();
  return lookAt(centre + glm::dvec3(30.0, -50.0, 20.0), centre, Projection::Orthographic, 8.0);
}

constexpr glm::ivec2 size(9, 8);

TEST(ReferenceReconstruction, HitsOfASplineAgreeWithFineMarching) {
  // The more it is smoothed, the less the noise of 0 to 100 rises above its mean.
  struct Case {
    Reconstruction kind;
    double context, focus;  ///< levels
    int hits;               ///< at least
  };
  for (const Case& each : {Case{Reconstruction::Cubic, 62.0, 70.0, 60}, Case{Reconstruction::Smooth, 62.0, 70.0, 10},
                           Case{Reconstruction::Smoother, 53.0, 55.0, 10}}) {
    Scene scene = noise(each.kind, opaqueFrom(each.context));
    scene.look.focus = ValueFocus{.values = {each.focus, 1e9}, .minimumComponent = 0.0};
    const Camera camera = around(scene);
    const Grid& grid = scene.volume->grid;
    const SplineVolume spline(shownVolume(scene));
    const HitPoints hits = hitPoints(scene, camera, size);
    int found = 0;
    for (int i = 0; i < size.x * size.y; ++i) {
      const Ray ray = pixelRay(camera, size, {i % size.x, i / size.x});
      const auto span = clip(ray, grid);
      if (!span) continue;
      const Ray local = indexRay(ray, grid);
      const double step = 1e-4;
      const auto firstFrom = [&](double level) {
        for (double t = span->tIn; t <= span->tOut; t += step)
          if (spline.value(local.origin + t * local.direction) >= level) return t;
        return nan;
      };
      const auto at = static_cast<std::size_t>(i);
      const double context = firstFrom(each.context), focus = firstFrom(each.focus);
      // Marching stops up to a step behind the surface.
      const auto expectSame = [&](double hit, double marched, double level) {
        ASSERT_EQ(std::isnan(hit), std::isnan(marched)) << i;
        if (std::isnan(hit)) return;
        ++found;
        EXPECT_NEAR(hit, marched, 2.0 * step) << i;
        // The cubics' error (see Field.h): in noise over 100 the fourth derivative along a line reaches some 10^4.
        if (hit > span->tIn) {
          EXPECT_NEAR(spline.value(local.origin + hit * local.direction), level, 2e-3);
        }
      };
      expectSame(hits.tContext[at], context, each.context);
      expectSame(hits.tFocus[at], focus, each.focus);
    }
    EXPECT_GT(found, each.hits);
  }
}

TEST(ReferenceReconstruction, HitsOfAPolynomialAreItsRoots) {
  // z³ along z, looked at along z: the cubic meets 8 at z = 2, where trilinear values meet it at 1 + 7/7 = 2 as well,
  // and 5 at ∛5, where those meet it at 1 + 4/7.
  Scene scene;
  scene.volume = volumeOf(gridOf({4, 4, 6}), [](glm::ivec3 i) { return std::pow(i.z, 3.0); });
  scene.look.context.function = opaqueFrom(5.0);
  const glm::dvec3 centre = scene.volume->grid.centre();
  const Camera camera = lookAt(centre - glm::dvec3(0.0, 0.0, 50.0), centre, Projection::Orthographic, 1.0);
  const double first = centre.z - 50.0;
  EXPECT_NEAR(hitPoints(scene, camera, {1, 1}).tContext[0] + first, 1.0 + 4.0 / 7.0, 1e-9);
  scene.look.reconstruction = Reconstruction::Cubic;
  EXPECT_NEAR(hitPoints(scene, camera, {1, 1}).tContext[0] + first, std::cbrt(5.0), 1e-9);
}

/// The integral of a scene without a focus by the midpoint rule: of second order, and converged to 1e-7 here.
glm::dvec4 byMidpoints(const Scene& scene, const Camera& camera, glm::ivec2 pixel) {
  const Grid& grid = scene.volume->grid;
  const SplineVolume spline(shownVolume(scene));
  const Ray ray = pixelRay(camera, size, pixel);
  const Span span = clip(ray, grid).value_or(Span{});
  const Ray local = indexRay(ray, grid);
  constexpr int count = 200000;
  const double step = (span.tOut - span.tIn) / count;
  glm::dvec3 colour(0.0);
  double depth = 0.0;
  for (int i = 0; i < count; ++i) {
    const double value = spline.value(local.origin + (span.tIn + (i + 0.5) * step) * local.direction);
    const OpticalProperties p = scene.look.context.function.evaluate(value);
    colour += std::exp(-depth - 0.5 * p.extinction * step) * p.extinction * step * p.colour;
    depth += p.extinction * step;
  }
  return {colour, -std::expm1(-depth)};
}

TEST(ReferenceReconstruction, IntegralOfASplineAgreesWithFineSteps) {
  const TransferFunction transfer{{{20.0, {{1.0, 0.2, 0.1}, 0.0}},
                                   {50.0, {{0.2, 1.0, 0.3}, 0.2}},
                                   {55.0, {{0.1, 0.3, 1.0}, 0.01}},
                                   {110.0, {{1.0, 1.0, 0.5}, 0.3}}}};
  for (const Reconstruction kind : {Reconstruction::Cubic, Reconstruction::Smooth, Reconstruction::Smoother}) {
    const Scene scene = noise(kind, transfer);
    const Camera camera = around(scene);
    PictureOptions options;
    options.tolerance = 1e-9;
    options.pixels = {{4, 4}, {3, 5}, {5, 3}};
    const Picture made = picture(scene, camera, size, options);
    for (std::size_t i = 0; i < options.pixels.size(); ++i) {
      const glm::dvec4 expected = byMidpoints(scene, camera, options.pixels[i]);
      ASSERT_GT(expected.a, 0.3);
      // The cubics' error (see Field.h) and the midpoint rule's.
      for (int channel = 0; channel < 4; ++channel)
        EXPECT_NEAR(made.focusLayer[i][channel], expected[channel], 1e-6) << channel;
    }
  }
}

TEST(ReferenceReconstruction, LightFollowsTheSplinesOwnGradient) {
  // A parabola's gradient is exact in a cubic spline everywhere, and the light of a dense medium is that of its
  // surface.
  Scene scene;
  const glm::dvec3 middle(6.2, 5.7, 6.4);
  scene.volume = volumeOf(gridOf({13, 13, 13}), [&](glm::ivec3 i) {
    const glm::dvec3 p = glm::dvec3(i) - middle;
    return -glm::dot(p, p);
  });
  const glm::dvec3 colour(0.8, 0.6, 0.4);
  scene.look.context.function = {{{-16.0, {colour, 0.0}}, {-16.0, {colour, 1e7}}}};
  scene.look.reconstruction = Reconstruction::Cubic;
  const Camera camera = lookAt(middle + glm::dvec3(3.0, 40.0, -10.0), middle, Projection::Orthographic, 10.0);
  const Picture made = picture(scene, camera, size);
  const HitPoints hits = hitPoints(scene, camera, size);
  const Shading& shading = scene.look.shading;
  const glm::dvec3 light = lightDirection(camera.axes(), shading);
  int met = 0;
  for (int i = 0; i < size.x * size.y; ++i) {
    const double t = hits.tContext[static_cast<std::size_t>(i)];
    if (std::isnan(t)) continue;
    ++met;
    const Ray ray = pixelRay(camera, size, {i % size.x, i / size.x});
    // The cubic B-spline of the unit normals at the voxels, all of whose gradients are above the gate here.
    const glm::dvec3 at = ray.origin + t * ray.direction;
    glm::dvec3 normal(0.0);
    forEachVoxel({13, 13, 13}, [&](glm::ivec3 voxel) {
      double weight = 1.0;
      for (int axis = 0; axis < 3; ++axis) {
        const double d = std::abs(at[axis] - voxel[axis]), rest = std::max(2.0 - d, 0.0);
        weight *= d < 1.0 ? 2.0 / 3.0 - d * d * (1.0 - 0.5 * d) : rest * rest * rest / 6.0;
      }
      if (weight > 0.0) normal += weight * glm::normalize(glm::dvec3(voxel) - middle);
    });
    normal = glm::normalize(normal);
    EXPECT_NEAR(glm::distance(ray.origin + t * ray.direction, middle), 4.0, 1e-9);
    const glm::dvec3 expected =
        colour * (shading.ambient + shading.diffuse * std::abs(glm::dot(normal, light))) +
        shading.specular *
            std::pow(std::abs(glm::dot(normal, glm::normalize(light - ray.direction))), shading.shininess);
    // All light comes from the first 1e-6 mm.
    EXPECT_LT(glm::distance(glm::dvec3(made.focusLayer[static_cast<std::size_t>(i)]), expected), 1e-5);
  }
  EXPECT_GT(met, 25);
}

TEST(ReferenceFocusCells, CellsAroundKeptOnesAreKeptOfASplineButNotDroppedOnes) {
  // A large and a small island.
  const auto volume = volumeOf(gridOf({14, 5, 5}), [](glm::ivec3 i) {
    return i.y == 2 && i.z == 2 && ((i.x >= 2 && i.x <= 7) || i.x == 11) ? 1.0 : 0.0;
  });
  const ValueFocus focus{.values = {0.5, 2.0}, .minimumComponent = 20.0};
  const FocusCells linear = focusCells({volume}, focus);
  ShownVolume shown{volume};
  shown.reconstruction = Reconstruction::Cubic;
  const FocusCells cubic = focusCells(shown, focus);
  EXPECT_FALSE(linear.contains({0, 1, 1}));
  EXPECT_TRUE(linear.contains({1, 1, 1}));
  EXPECT_TRUE(cubic.contains({0, 1, 1}));
  EXPECT_TRUE(cubic.contains({8, 0, 0}));
  EXPECT_FALSE(cubic.contains({9, 1, 1}));
  EXPECT_FALSE(cubic.contains({10, 1, 1}));  // of the small island
}

}  // namespace
}  // namespace fenestra::reference::referenceReconstructionTest
