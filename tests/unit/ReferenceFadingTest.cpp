// A context that fades in the reference: the solution against the exponential integral, and pictures against the sum
// that its authors composite.

#include <cmath>

#include <gtest/gtest.h>

#include "rendering/reference/FadingIntegral.h"
#include "rendering/reference/Picture.h"
#include "rendering/scene/Fading.h"
#include "tests/support/Scenes.h"
#include "tests/unit/FadingContexts.h"

namespace fenestra::reference::referenceFadingTest {
namespace {

using namespace tests;

/// The depth τ after `length` mm of one material, with L = -p ln g:
///
///   τ' = κ exp(-L exp(-σ τ)),   w = exp(-σ τ):   w' = -σ κ w exp(-L w),   Ei(L) - Ei(L w) = σ κ t
///
/// Ei grows without end as w falls: bisection finds w.
double depthOf(double extinction, double strength, double sharpness, double length) {
  const double wanted = std::expint(strength) - sharpness * extinction * length;
  double low = 1e-300, high = 1.0;
  for (int i = 0; i < 2000 && low < high; ++i) {
    const double middle = std::sqrt(low * high);
    if (middle <= low || middle >= high) break;
    (std::expint(strength * middle) < wanted ? low : high) = middle;
  }
  return -std::log(high) / sharpness;
}

TEST(ReferenceFading, OfOneMaterialIsTheExponentialIntegral) {
  const glm::dvec3 colour(0.9, 0.5, 0.2);
  for (const double sharpness : {0.2, 0.5, 1.0, 2.0})
    for (const double slope : {0.9, 0.3, 0.05, 0.002})
      for (const double exponent : {0.3, 1.0, 2.5})
        for (const double extinction : {0.05, 1.0, 30.0}) {
          SCOPED_TRACE(testing::Message() << sharpness << ", " << slope << ", " << exponent << ", " << extinction);
          const double tau = depthOf(extinction, -exponent * std::log(slope), sharpness, 7.0);
          double before = std::numeric_limits<double>::infinity(), wrong = before;
          for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9, 1e-12}) {
            FadingState state;
            integrateFading(state, sharpness, 7.0, {tolerance, tolerance / 7.0, 1e-13}, [&](double) {
              return FadingPoint{extinction, slope, exponent, colour};
            });
            // Opacity cannot be finer than an ulp of 1, and a ray is not followed behind so little light.
            wrong = std::abs(std::exp(-state.depth) - std::exp(-tau));
            EXPECT_LE(wrong, state.error + 2e-13) << "the estimate covers the error";
            const glm::dvec3 off = glm::abs(state.colour + std::expm1(-tau) * colour);
            EXPECT_LE(std::max({off.r, off.g, off.b}), state.error + 2e-13);
            EXPECT_LE(state.error, before);
            before = state.error;
          }
          EXPECT_LE(wrong, 1e-9);
        }
}

TEST(ReferenceFading, NothingIsRaisedToNothing) {
  EXPECT_EQ(fadeOf({.slope = 0.0, .exponent = 0.0}, 1.0, 0.5), 1.0);
  EXPECT_EQ(fadeOf({.slope = 0.0, .exponent = 0.2}, 1.0, 0.5), 0.0);
  EXPECT_EQ(fadeOf({.slope = 1.0, .exponent = 9.0}, 0.0, 0.5), 1.0);
}

constexpr glm::ivec2 size{9, 7};

/// Values that grow along y, the steeper the farther; haze of one extinction, a ball in focus.
Scene hazyRamp(bool lit) {
  Scene scene;
  scene.volume = volumeOf<float>(gridOf({20, 30, 20}), [](glm::ivec3 i) { return i.y * i.y + 2.0 * i.x; });
  scene.labels = labelsOf(gridOf({20, 30, 20}), [](glm::ivec3 i) {
    return glm::distance(glm::dvec3(i), glm::dvec3(9.5, 20.0, 9.5)) < 4.2 ? 1 : 0;
  });
  const glm::dvec3 colour(0.9, 0.6, 0.3);
  scene.look.context.function = {{{-10.0, {colour, 0.2}}, {2000.0, {colour, 0.2}}}};
  scene.look.focusAppearance = {{0.2, 0.3, 0.9}, 0.4, {}};
  scene.look.shading.enabled = lit;
  scene.look.method = methods::ContextPreserving{.reach = 4.0, .sharpness = 0.7};
  return scene;
}

Camera from(const Scene& scene, Projection projection) {
  return Camera::fromAngles(20.0, 15.0, scene.volume->grid, projection);
}

/// The authors' sum along a ray, of `count` samples: opacity as of the step's length, times ‖∇f‖^(…).
glm::dvec4 composited(const Scene& scene, const Camera& camera, glm::ivec2 pixel, int count) {
  const Grid& grid = scene.volume->grid;
  const Ray ray = pixelRay(camera, size, pixel), inIndex = indexRay(ray, grid);
  const std::optional<Span> span = clip(ray, grid);
  glm::dvec4 sum(0.0);
  if (!span) return sum;
  const double step = (span->tOut - span->tIn) / count;
  const EyeRange range = eyeRangeOf(camera, grid);
  const Method& method = scene.look.method;
  const auto valueAt = [&](glm::ivec3 voxel) { return scene.volume->value(voxel); };
  for (int i = 0; i < count; ++i) {
    const double t = span->tIn + (i + 0.5) * step;
    const glm::dvec3 at = inIndex.origin + t * inIndex.direction;
    const double slope = std::min(glm::length(gradientAt(*scene.volume, at)) / steepestSlope(*scene.volume), 1.0);
    const double exponent =
        std::pow(method.of<methods::ContextPreserving>().reach * (1.0 - range.distance(t)) * (1.0 - sum.a),
                 method.of<methods::ContextPreserving>().sharpness);
    const OpticalProperties shown = scene.look.context.function.evaluate(interpolated(grid, at, valueAt));
    const double opacity = -std::expm1(-shown.extinction * step) * std::pow(slope, exponent);
    sum += (1.0 - sum.a) * opacity * glm::dvec4(shown.colour, 1.0);
  }
  return sum;
}

/// The sum's error is of first order in the step, so that two of them tell its limit.
TEST(ReferenceFading, IsTheLimitOfItsAuthorsSum) {
  const Scene scene = hazyRamp(false);
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    const Camera camera = from(scene, projection);
    const Picture here = picture(scene, camera, size);
    double greatest = 0.0;
    for (int j = 0; j < size.y; ++j)
      for (int i = 0; i < size.x; ++i) {
        const glm::dvec4 coarse = composited(scene, camera, {i, j}, 4000),
                         fine = composited(scene, camera, {i, j}, 8000);
        const glm::dvec4 found = here.final[static_cast<std::size_t>(j * size.x + i)];
        // The remaining error is of second order in steps of 0.01 mm; the reference has a tolerance of 1e-5.
        EXPECT_LT(glm::distance(found, 2.0 * fine - coarse), 3e-5) << i << ", " << j;
        greatest = std::max(greatest, found.a);
      }
    EXPECT_GT(greatest, 0.3);
    EXPECT_LT(greatest, 0.9);
  }
}

TEST(ReferenceFading, WithoutReachOrOffItIsPlainRendering) {
  for (const bool lit : {false, true}) {
    Scene scene = hazyRamp(lit);
    const Camera camera = from(scene, Projection::Perspective);
    const Picture faded = picture(scene, camera, size);
    scene.look.method.of<methods::ContextPreserving>().reach = 0.0;
    const Picture none = picture(scene, camera, size);
    scene.look.cutaway.enabled = false;
    const Picture plain = picture(scene, camera, size);
    double greatest = 0.0;
    for (std::size_t i = 0; i < plain.final.size(); ++i) {
      EXPECT_LT(glm::distance(none.final[i], plain.final[i]), 4e-5) << "two integrals of tolerance 1e-5, " << i;
      EXPECT_LE(faded.final[i].a, plain.final[i].a + 2e-5) << "what fades is never more opaque";
      greatest = std::max(greatest, plain.final[i].a - faded.final[i].a);
    }
    EXPECT_GT(greatest, 0.1) << "the test would notice";
  }
}

/// A context of one value has no gradient and fades altogether; the focus and its contents do not.
TEST(ReferenceFading, TheFocusKeepsItsOpacity) {
  Scene scene = hazyRamp(true);
  scene.volume = volumeOf<float>(gridOf({20, 30, 20}), [](glm::ivec3 i) { return i == glm::ivec3(0) ? 1.0 : 0.0; });
  scene.look.focus = LabelFocus{{1}};
  const Camera camera = from(scene, Projection::Perspective);
  expectTheFocusAlone(scene, camera, size, 0.8);
}

TEST(ReferenceFading, TheEstimatedErrorKeepsToTheTolerance) {
  const Scene scene = hazyRamp(true);
  const Camera camera = from(scene, Projection::Perspective);
  expectErrorsWithinTheTolerance(scene, camera, size);
}

}  // namespace
}  // namespace fenestra::reference::referenceFadingTest
