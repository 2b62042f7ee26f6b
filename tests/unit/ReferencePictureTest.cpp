// The reference's integral, lighting and composite against closed forms, and rules of known order against it.

#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "rendering/reference/Picture.h"
#include "rendering/scene/Lighting.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference {
namespace {

using namespace tests;

const glm::dvec3 red(0.9, 0.2, 0.1), blue(0.1, 0.3, 0.8);

/// Unlit values along x without a focus.
template <class F>
Scene profile(int count, F&& valueAt, TransferFunction transfer, double spacing = 1.0) {
  Scene scene;
  scene.volume = volumeOf(gridOf({count, 3, 3}, glm::dvec3(spacing)), [&](glm::ivec3 i) { return valueAt(i.x); });
  scene.look.context.function = std::move(transfer);
  scene.look.shading.enabled = false;
  return scene;
}

/// One ray along x through the middle of the grid.
Camera alongX(const Grid& grid) {
  const glm::dvec3 centre = grid.centre();
  return lookAt(centre - glm::dvec3(100.0, 0.0, 0.0), centre, Projection::Orthographic, 1.0);
}

glm::dvec4 onePixel(const Scene& scene, double tolerance) {
  PictureOptions options;
  options.tolerance = tolerance;
  const Picture result = picture(scene, alongX(scene.volume->grid), {1, 1}, options);
  EXPECT_LE(result.error[0], tolerance);
  return result.focusLayer[0];
}

void expectNear(glm::dvec4 found, glm::dvec4 expected, double tolerance) {
  for (int channel = 0; channel < 4; ++channel) EXPECT_NEAR(found[channel], expected[channel], tolerance) << channel;
}

// ---- The integral against closed forms ------------------------------------------------------------------------------
// Tolerances: the integral is asked for 1e-12; what remains is rounding over at most some hundred parts.

TEST(ReferenceIntegral, homogeneousSlabFollowsBeerAndLambert) {
  for (const double extinction : {1e-12, 1e-6, 0.02, 1.0, 30.0, 1e6}) {
    const Scene scene = profile(20, [](int) { return 7.0; }, {{{0.0, {red, extinction}}}});
    const double opacity = -std::expm1(-extinction * 20.0);
    const glm::dvec4 found = onePixel(scene, 1e-12);
    // Relative, so that faint haze is tested as well.
    EXPECT_NEAR(found.a / opacity, 1.0, 1e-12) << extinction;
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(found[channel] / (red[channel] * opacity), 1.0, 1e-11) << extinction;
  }
}

TEST(ReferenceIntegral, extinctionAndColourLinearAlongTheRay) {
  // The value is the depth x behind the first voxel's centre, κ = a·x, c = red + x/L·(blue - red), from 0 to L; beyond,
  // in the outer half voxel, both keep their last value.
  const double a = 0.013, length = 19.0;
  const Scene scene = profile(20, [](int x) { return x; }, {{{0.0, {red, 0.0}}, {length, {blue, a * length}}}});
  // ∫ a x exp(-a x²/2) dx and, by parts, ∫ x/L a x exp(-a x²/2) dx.
  const double through = std::exp(-0.5 * a * length * length), opacity = 1.0 - through;
  const double blueShare =
      std::sqrt(std::numbers::pi / (2.0 * a)) * std::erf(length * std::sqrt(0.5 * a)) / length - through;
  const double last = through * -std::expm1(-a * length * 0.5);
  const glm::dvec3 colour = red * (opacity - blueShare) + blue * (blueShare + last);
  expectNear(onePixel(scene, 1e-12), {colour, opacity + last}, 1e-12);
}

TEST(ReferenceIntegral, twoMaterialsMeetWhereTheValueCrossesTheStep) {
  // From 0 to 100 between voxels 9 and 10, the step at 30: they meet at index 9.3.
  const Scene scene = profile(20, [](int x) { return x < 10 ? 0.0 : 100.0; },
                              {{{0.0, {red, 0.05}}, {30.0, {red, 0.05}}, {30.0, {blue, 0.4}}, {100.0, {blue, 0.4}}}});
  const double front = -std::expm1(-0.05 * 9.8), back = -std::expm1(-0.4 * 10.2);
  expectNear(onePixel(scene, 1e-12), {red * front + blue * back * (1.0 - front), front + back * (1.0 - front)}, 1e-12);
}

TEST(ReferenceIntegral, spikesNarrowerThanAVoxelsValues) {
  // Two thousand units a voxel and a triangle one unit wide: its optical depth is its area over the slope, wherever
  // in a cell it lies and however steep.
  for (const double at : {5000.5, 6000.0, 7999.9})
    for (const double height : {0.5, 4000.0, 1e7}) {
      const OpticalProperties clear{red, 0.0}, spike{red, height};
      const Scene scene =
          profile(8, [](int x) { return 2000.0 * x; }, {{{at - 0.5, clear}, {at, spike}, {at + 0.5, clear}}});
      const double opacity = -std::expm1(-0.5 * height / 2000.0);
      // The spike is 5e-4 mm wide and lies 100 mm from the eye: rounding of t is 1e-14/5e-4 of it.
      EXPECT_NEAR(onePixel(scene, 1e-12).a / opacity, 1.0, 1e-9) << at << ", " << height;
    }
}

TEST(ReferenceIntegral, obliqueRaysThroughObliqueGrids) {
  const Grid grid = obliqueGrid({9, 12, 7});
  Scene scene;
  scene.volume = volumeOf(grid, [](glm::ivec3) { return 1.0; });
  scene.look.context.function = {{{0.0, {red, 0.03}}}};
  scene.look.shading.enabled = false;
  const Camera camera = Camera::fromAngles(33.0, 24.0, grid);
  const glm::ivec2 size(23, 19);
  PictureOptions options;
  options.tolerance = 1e-11;
  const Picture result = picture(scene, camera, size, options);
  int met = 0;
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i) {
      const std::optional<Span> span = clip(pixelRay(camera, size, {i, j}), grid);
      const double opacity = span ? -std::expm1(-0.03 * (span->tOut - span->tIn)) : 0.0;
      expectNear(result.final[static_cast<std::size_t>(j * size.x + i)], {red * opacity, opacity}, 1e-11);
      met += opacity > 0.01;
    }
  EXPECT_GT(met, 100);
  EXPECT_TRUE(result.contextLayer.empty());
}

TEST(ReferenceIntegral, ballConvergesWithTheSquareOfTheVoxel) {
  // A homogeneous ball as a level set of the distance to its centre: interpolation shifts the surface by O(h²).
  const double radius = 8.0, extinction = 0.1;
  std::vector<double> errors;
  for (const int voxels : {10, 20, 40}) {
    const double spacing = 20.0 / voxels;
    const Grid grid = gridOf(glm::ivec3(voxels), glm::dvec3(spacing));
    Scene scene;
    scene.volume =
        volumeOf(grid, [&](glm::ivec3 i) { return -glm::length((glm::dvec3(i) - 0.5 * (voxels - 1)) * spacing); });
    scene.look.context.function = {{{-radius, {red, 0.0}}, {-radius, {red, extinction}}}};
    scene.look.shading.enabled = false;
    const glm::dvec3 centre = grid.centre();
    const glm::dvec3 eye = centre + glm::dvec3(-60.0, -35.0, 22.0);
    const glm::ivec2 size(21, 21);
    const Camera camera = lookAt(eye, centre, Projection::Orthographic, 10.0);
    const Picture result = picture(scene, camera, size);
    double worst = 0.0;
    for (int j = 0; j < size.y; ++j)
      for (int i = 0; i < size.x; ++i) {
        const Ray ray = pixelRay(camera, size, {i, j});
        const glm::dvec3 off = centre - ray.origin;
        const double miss2 = glm::dot(off, off) - std::pow(glm::dot(off, ray.direction), 2);
        const double expected = -std::expm1(-2.0 * extinction * std::sqrt(radius * radius - miss2));
        const double found = result.focusLayer[static_cast<std::size_t>(j * size.x + i)].a;
        worst = std::max(worst, std::abs(found - expected));
      }
    errors.push_back(worst);
  }
  // Halving the voxel quarters the worst error, up to how the rays happen to fall on one grid.
  for (std::size_t k = 0; k + 1 < errors.size(); ++k) EXPECT_NEAR(std::log2(errors[k] / errors[k + 1]), 2.0, 0.5);
}

// ---- Its estimate of its own error ----------------------------------------------------------------------------------

/// Noise with gradients, a curved transfer function and a focus: every feature of an integrand.
Scene roughScene() {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> value(0.0, 1.0);
  const Grid grid = obliqueGrid({14, 12, 10});
  Scene scene;
  scene.volume = volumeOf<float>(grid, [&](glm::ivec3) { return value(random); });
  scene.labels = labelsOf(grid, [](glm::ivec3 i) { return i.x > 8 && i.y > 3 ? (i.z < 5 ? 1 : 2) : 0; });
  scene.look.focus = LabelFocus{{1, 2}};
  scene.look.focusAppearance.extinction = 0.4;
  scene.look.context.function = {{{0.2, {red, 0.0}}, {0.5, {blue, 0.3}}, {0.5, {red, 0.05}}, {0.9, {red, 2.0}}}};
  scene.look.cutaway.openWidth = 8.0;
  return scene;
}

double greatestDifference(const std::vector<glm::dvec4>& a, const std::vector<glm::dvec4>& b) {
  double greatest = a.size() == b.size() ? 0.0 : infinity;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
    for (int channel = 0; channel < 4; ++channel) {
      const double difference = std::abs(a[i][channel] - b[i][channel]);
      greatest = std::isnan(difference) ? infinity : std::max(greatest, difference);
    }
  return greatest;
}

TEST(ReferenceIntegral, staysWithinItsTolerance) {
  const Scene scene = roughScene();
  const Camera camera = Camera::fromAngles(25.0, 10.0, scene.volume->grid);
  const glm::ivec2 size(40, 36);
  const auto within = [&](double tolerance) {
    PictureOptions options;
    options.tolerance = tolerance;
    return picture(scene, camera, size, options);
  };
  const Picture truth = within(1e-11);
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    const Picture found = within(tolerance);
    for (std::size_t i = 0; i < found.error.size(); ++i) {
      EXPECT_LE(found.error[i], tolerance);
      // Two rules can agree by chance where lighting changes sharply, so the estimate may be too small by half.
      const double allowed = std::min(tolerance, 2.0 * found.error[i] + 1e-11);
      EXPECT_LE(greatestDifference({found.focusLayer[i]}, {truth.focusLayer[i]}), allowed);
      EXPECT_LE(greatestDifference({found.final[i]}, {truth.final[i]}), allowed);
    }
  }
}

// ---- Rules of known order converge to it ----------------------------------------------------------------------------
// Etiene et al., "Verifying Volume Rendering Using Discretization Error Analysis", TVCG 2014: a Riemann sum of the
// emission-absorption integral is of order 1, the midpoint rule and pre-integration are of order 2.

using Sampler = std::function<double(double)>;  ///< value at a depth

glm::dvec4 riemann(const TransferFunction& transfer, const Sampler& valueAt, double length, int steps, double offset) {
  const double h = length / steps;
  glm::dvec3 colour(0.0);
  double through = 1.0;
  for (int k = 0; k < steps; ++k) {
    const OpticalProperties p = transfer.evaluate(valueAt((k + offset) * h));
    const double opacity = -std::expm1(-p.extinction * h);
    colour += through * opacity * p.colour;
    through *= 1.0 - opacity;
  }
  return {colour, 1.0 - through};
}

/// Pre-integration: the value is linear between samples, and the transfer function is integrated over it as finely as a
/// table would hold it.
glm::dvec4 preIntegrated(const TransferFunction& transfer, const Sampler& valueAt, double length, int steps) {
  const double h = length / steps;
  constexpr int finer = 60;
  glm::dvec3 colour(0.0);
  double through = 1.0;
  for (int k = 0; k < steps; ++k) {
    const double front = valueAt(k * h), back = valueAt((k + 1) * h);
    std::vector<double> places{0.0, h};
    for (const TransferFunction::Node& node : transfer.nodes)
      if (const double at = h * (node.value - front) / (back - front); at > 0.0 && at < h) places.push_back(at);
    std::sort(places.begin(), places.end());
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      const auto between = [&](double depth) { return glm::mix(front, back, (places[i] + depth) / h); };
      const glm::dvec4 part = riemann(transfer, between, places[i + 1] - places[i], finer, 0.5);
      colour += through * glm::dvec3(part);
      through *= 1.0 - part.a;
    }
  }
  return {colour, 1.0 - through};
}

/// Slope of log error over log step by least squares.
double orderOf(const std::function<double(int steps)>& errorOf) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  int count = 0;
  for (int steps = 16; steps <= 256; steps *= 2) {
    const double x = -std::log(steps), y = std::log(errorOf(steps));
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
    ++count;
  }
  return (count * sxy - sx * sy) / (count * sxx - sx * sx);
}

/// A stretch of a ray inside one cell, 20 mm wide: the value along it is a smooth cubic.
class SmoothRay {
 public:
  SmoothRay() {
    const double corners[] = {0.0, 5.0, 3.0, 9.0, 2.0, 8.0, 11.0, 20.0};
    scene_.volume =
        volumeOf(gridOf({2, 2, 2}, glm::dvec3(20.0)), [&](glm::ivec3 i) { return corners[i.x + 2 * i.y + 4 * i.z]; });
    scene_.look.shading.enabled = false;
  }

  double length() const { return glm::distance(begin_, end_); }
  double valueAt(double depth) const { return scene_.volume->sample(glm::mix(begin_, end_, depth / length()) / 20.0); }

  /// The reference's integral over the stretch: that of the whole ray minus that of a second ray from the end on.
  glm::dvec4 integral(const TransferFunction& transfer) {
    scene_.look.context.function = transfer;
    const glm::dvec4 whole = from(begin_), rest = from(end_);
    const double through = (1.0 - whole.a) / (1.0 - rest.a);
    return {glm::dvec3(whole) - through * glm::dvec3(rest), 1.0 - through};
  }

 private:
  glm::dvec4 from(glm::dvec3 eye) const {
    PictureOptions options;
    options.tolerance = 1e-12;
    const Camera camera = lookAt(eye, eye + end_ - begin_, Projection::Orthographic, 1.0);
    return picture(scene_, camera, {1, 1}, options).focusLayer[0];
  }

  glm::dvec3 begin_{1.0, 2.0, 3.0}, end_{19.0, 17.0, 18.5};
  Scene scene_;
};

TEST(ReferenceIntegral, isWhatRulesOfOrderOneAndTwoConvergeTo) {
  SmoothRay ray;
  const Sampler valueAt = [&](double depth) { return ray.valueAt(depth); };
  const TransferFunction smooth{{{0.0, {red, 0.01}}, {20.0, {blue, 0.2}}}};
  const glm::dvec4 truth = ray.integral(smooth);
  const auto orderOfSum = [&](double offset) {
    return orderOf([&](int steps) {
      return greatestDifference({riemann(smooth, valueAt, ray.length(), steps, offset)}, {truth});
    });
  };
  EXPECT_NEAR(orderOfSum(0.0), 1.0, 0.05);
  EXPECT_NEAR(orderOfSum(0.5), 2.0, 0.05);
  EXPECT_NEAR(orderOf([&](int steps) {
                return greatestDifference({preIntegrated(smooth, valueAt, ray.length(), steps)}, {truth});
              }),
              2.0, 0.05);

  // A step of the transfer function lowers the midpoint rule to order 1. Its error depends on where the step falls
  // between samples, so the mean of many is taken. Pre-integration has the step in its table and stays at order 2.
  std::vector<std::pair<TransferFunction, glm::dvec4>> steps;
  for (double at = 4.0; at < 9.0; at += 0.31) {
    const TransferFunction transfer{{{0.0, {red, 0.01}}, {at, {red, 0.01}}, {at, {blue, 0.2}}, {20.0, {blue, 0.2}}}};
    steps.emplace_back(transfer, ray.integral(transfer));
  }
  const auto meanOrder = [&](const auto& rule) {
    return orderOf([&](int count) {
      double sum = 0.0;
      for (const auto& [transfer, integral] : steps) sum += greatestDifference({rule(transfer, count)}, {integral});
      return sum;
    });
  };
  EXPECT_NEAR(meanOrder([&](const TransferFunction& transfer, int count) {
                return riemann(transfer, valueAt, ray.length(), count, 0.5);
              }),
              1.0, 0.2);
  EXPECT_NEAR(meanOrder([&](const TransferFunction& transfer, int count) {
                return preIntegrated(transfer, valueAt, ray.length(), count);
              }),
              2.0, 0.2);
}

// ---- Focus, lighting, cut faces -------------------------------------------------------------------------------------

TEST(ReferenceFocusLayer, labelsShowTheirColoursFromTheLevelOn) {
  // Context to index 6.5, label 1 to the middle between 9 and 10, label 2 to the box's face.
  Scene scene = profile(14, [](int) { return 1.0; }, {{{0.0, {blue, 0.02}}}});
  auto labels = labelsOf(scene.volume->grid, [](glm::ivec3 i) { return i.x < 7 ? 0 : i.x < 10 ? 1 : 2; });
  labels->labels = {{1, "one", red}, {2, "two", {0.2, 0.9, 0.4}}};
  scene.labels = labels;
  scene.look.focus = LabelFocus{{1, 2}};
  scene.look.focusAppearance.extinction = 0.3;
  scene.look.cutaway.enabled = false;
  const double front = std::exp(-0.02 * 7.0), first = std::exp(-0.3 * 3.0), second = std::exp(-0.3 * 4.0);
  const glm::dvec3 colour =
      blue * (1.0 - front) + front * (red * (1.0 - first) + first * glm::dvec3(0.2, 0.9, 0.4) * (1.0 - second));
  expectNear(onePixel(scene, 1e-12), {colour, 1.0 - front * first * second}, 1e-12);
  // With the cutaway the ray starts on the focus.
  scene.look.cutaway.enabled = true;
  scene.look.contextLayer.strength = 0.0;
  expectNear(onePixel(scene, 1e-12),
             {red * (1.0 - first) + first * glm::dvec3(0.2, 0.9, 0.4) * (1.0 - second), 1.0 - first * second}, 1e-12);
}

TEST(ReferenceFocusLayer, valuesShowTheFocusesColourInsideTheirRange) {
  // The value is the index: focus between 4 and 8, context before and after.
  Scene scene = profile(12, [](int x) { return x; }, {{{0.0, {blue, 0.05}}}});
  scene.look.focus = ValueFocus{{4.0, 8.0}, 0.0};
  scene.look.focusAppearance = {red, 0.2, {}};
  scene.look.cutaway.enabled = false;
  const double front = std::exp(-0.05 * 4.5), focus = std::exp(-0.2 * 4.0), back = std::exp(-0.05 * 3.5);
  const glm::dvec3 colour = blue * (1.0 - front) + front * (red * (1.0 - focus) + focus * blue * (1.0 - back));
  expectNear(onePixel(scene, 1e-12), {colour, 1.0 - front * focus * back}, 1e-12);
}

TEST(ReferenceFocusLayer, labelsShowTheirFunctionsOfTheValue) {
  // The value is the index. Label 1 from 3.5 to 7.5 by a function that steps at 5, label 2 to the face of one material.
  const glm::dvec3 green(0.2, 0.9, 0.4);
  Scene scene = profile(12, [](int x) { return x; }, {{{0.0, {blue, 0.05}}}});
  auto labels = labelsOf(scene.volume->grid, [](glm::ivec3 i) { return i.x < 4 ? 0 : i.x < 8 ? 1 : 2; });
  labels->labels = {{1, "one", {1.0, 1.0, 1.0}}, {2, "two", green}};
  scene.labels = labels;
  scene.look.focus = LabelFocus{{1, 2}};
  scene.look.focusAppearance = {{}, 0.3, {}};
  scene.look.cutaway.enabled = false;
  const TransferFunction step{{{5.0, {red, 0.1}}, {5.0, {blue, 0.2}}}};
  put(scene.look.labels, {.label = 1, .function = step});
  const auto expected = [&](double below, double above) {
    const double t0 = std::exp(-0.05 * 4.0), t1 = t0 * std::exp(-below * 1.5), t2 = t1 * std::exp(-above * 2.5),
                 t3 = t2 * std::exp(-0.3 * 4.0);
    return glm::dvec4(blue * (1.0 - t0) + red * (t0 - t1) + blue * (t1 - t2) + green * (t2 - t3), 1.0 - t3);
  };
  expectNear(onePixel(scene, 1e-12), expected(0.1, 0.2), 1e-12);
  // A label's opacity is that of 10 mm of it, at each node.
  put(scene.look.labels, {.label = 1, .opacity = 0.5, .function = step});
  const auto halved = [](double extinction) {
    return -std::log(1.0 - 0.5 * (1.0 - std::exp(-10.0 * extinction))) / 10.0;
  };
  expectNear(onePixel(scene, 1e-12), expected(halved(0.1), halved(0.2)), 1e-12);
  put(scene.look.labels, {.label = 1, .visible = false, .function = step});
  expectNear(onePixel(scene, 1e-12), expected(0.0, 0.0), 1e-12);
  // A label that is not in focus shows as context, whatever its function.
  put(scene.look.labels, {.label = 1, .function = step});
  scene.look.focus = LabelFocus{{2}};
  EXPECT_FALSE(hasFocusFunction(scene));
  const double front = std::exp(-0.05 * 8.0), back = std::exp(-0.3 * 4.0);
  expectNear(onePixel(scene, 1e-12), {blue * (1.0 - front) + front * green * (1.0 - back), 1.0 - front * back}, 1e-12);
}

TEST(ReferenceFocusLayer, valuesShowTheFocusesFunction) {
  // The value is the index: focus between 4 and 8, whose extinction rises from 0 to 0.4 there; ∫ is 0.8.
  Scene scene = profile(12, [](int x) { return x; }, {{{0.0, {blue, 0.05}}}});
  scene.look.focus = ValueFocus{{4.0, 8.0}, 0.0};
  scene.look.focusAppearance.function = {{{4.0, {red, 0.0}}, {8.0, {red, 0.4}}}};
  scene.look.cutaway.enabled = false;
  const double front = std::exp(-0.05 * 4.5), focus = std::exp(-0.8), back = std::exp(-0.05 * 3.5);
  const glm::dvec3 colour = blue * (1.0 - front) + front * (red * (1.0 - focus) + focus * blue * (1.0 - back));
  expectNear(onePixel(scene, 1e-12), {colour, 1.0 - front * focus * back}, 1e-10);
  // The focus, and so the ray starts, stay the same where the function shows nothing.
  scene.look.focusAppearance.function->nodes.front().properties.extinction = 0.4;
  const auto hits = [&] { return reference::hitPoints(scene, alongX(scene.volume->grid), {1, 1}); };
  const reference::HitPoints dense = hits();
  scene.look.focusAppearance.function = TransferFunction{};
  EXPECT_EQ(hits().tFocus, dense.tFocus);
  EXPECT_EQ(hits().tContext, dense.tContext);
  const double clear = std::exp(-0.05 * 8.0);
  expectNear(onePixel(scene, 1e-12), {blue * (1.0 - clear), 1.0 - clear}, 1e-12);
}

/// Blinn-Phong with the light from the upper left behind the viewer, written out a second time.
glm::dvec3 phong(glm::dvec3 colour, glm::dvec3 normal, const Camera& camera, const Shading& shading) {
  const Camera::Axes axes = camera.axes();
  const glm::dvec3 light = glm::normalize(-axes.forward + 0.45 * axes.up - 0.35 * axes.right);
  const glm::dvec3 half = glm::normalize(light - axes.forward);
  return colour * (shading.ambient + shading.diffuse * std::abs(glm::dot(normal, light))) +
         glm::dvec3(shading.specular * std::pow(std::abs(glm::dot(normal, half)), shading.shininess));
}

TEST(ReferenceLighting, followsTheGradientAsFarAsItIsCertain) {
  // Values rise along (1, 2, 0.5) in world space on an oblique grid, 100 in all; rays parallel.
  const Grid grid = obliqueGrid({24, 24, 24});
  const glm::dvec3 slope(1.0, 2.0, 0.5);
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  const double finest = 0.7;  // mm
  const auto lit = [&](double share) {
    // |gradient| · finest spacing / range = share: set by an outlier that stretches the range and lies off the ray.
    const double range = glm::length(slope) * finest / share;
    Scene scene;
    scene.volume = volumeOf(grid, [&](glm::ivec3 i) {
      if (i == glm::ivec3(0)) return -0.5 * range;
      if (i == glm::ivec3(23)) return 0.5 * range;
      return glm::dot(slope, glm::dvec3(worldFromIndex * glm::dvec4(i, 1.0)));
    });
    scene.look.context.function = {{{0.0, {red, 0.5}}}};
    const glm::dvec3 centre = grid.centre();
    // Along the index z axis: the ray keeps to the middle of the other two.
    const Camera camera = lookAt(centre - 80.0 * grid.direction[2], centre, Projection::Orthographic, 1.0);
    PictureOptions options;
    options.tolerance = 1e-11;
    const glm::dvec4 found = picture(scene, camera, {1, 1}, options).focusLayer[0];
    const glm::dvec3 flat = red * (scene.look.shading.ambient + 0.7 * scene.look.shading.diffuse);
    const glm::dvec3 full = phong(red, glm::normalize(slope), camera, scene.look.shading);
    return std::array<glm::dvec3, 3>{glm::dvec3(found) / found.a, flat, full};
  };
  const auto expectMix = [](const std::array<glm::dvec3, 3>& colours, double certainty) {
    const glm::dvec3 expected = glm::mix(colours[1], colours[2], certainty);
    // The volume's outer half voxels and border differ from the inside by rounding alone.
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(colours[0][channel], expected[channel], 1e-9);
  };
  expectMix(lit(0.5 * lighting::gradientGateLow), 0.0);
  expectMix(lit(2.0 * lighting::gradientGateHigh), 1.0);
  // A quarter of the way through the gate: g = ¼²·(3 - ½), and g over ½ in the same way.
  const double g = 0.0625 * 2.5, over = g / lighting::certainLength;
  expectMix(lit(0.75 * lighting::gradientGateLow + 0.25 * lighting::gradientGateHigh),
            over * over * (3.0 - 2.0 * over));
}

TEST(ReferenceLighting, cutFacesFadeIntoTheirStrata) {
  // A block without gradients whose rays start on a given slanted plane: lit by the plane, fading over two voxels.
  const Grid grid = gridOf({20, 20, 20});
  Scene scene = labelScene(grid, [](glm::ivec3 i) { return i == glm::ivec3(0); });
  const double extinction = 0.3;
  scene.look.context.function = {{{-1.0, {red, extinction}}}};
  scene.look.contextLayer.strength = 0.0;
  scene.look.cutaway.borderWidth = 0.0;
  const Camera camera = lookAt({-50.0, 9.5, 9.5}, {9.5, 9.5, 9.5}, Projection::Orthographic, 3.0);
  const Camera::Axes axes = camera.axes();
  Stages stages;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      // Pixels are a mm apart.
      stages.tStart.push_back(56.0 + 0.5 * (i - 1) + 0.25 * (j - 1));
      stages.hits.tContext.push_back(49.5);
      stages.hits.tFocus.push_back(nan);
    }
  PictureOptions options;
  options.tolerance = 1e-12;
  options.pixels = {{1, 1}};
  const glm::dvec4 found = picture(scene, camera, {3, 3}, stages, options).focusLayer[0];

  const glm::dvec3 normal = glm::normalize(-axes.forward + 0.5 * axes.right - 0.25 * axes.up);
  const glm::dvec3 wall = phong(red, normal, camera, scene.look.shading);
  const glm::dvec3 strata = red * (scene.look.shading.ambient + 0.7 * scene.look.shading.diffuse);
  const double length = 19.5 + 50.0 - 56.0, faster = extinction + 1.0 / 2.0;
  const double opacity = -std::expm1(-extinction * length);
  const double wallPart = 0.75 * extinction / faster * -std::expm1(-faster * length);
  expectNear(found, {strata * opacity + (wall - strata) * wallPart, opacity}, 1e-11);

  // On the context's own surface, and beside a ray that meets nothing, there is no cut face.
  for (const bool bare : {true, false}) {
    Stages other = stages;
    if (bare)
      other.hits.tContext[4] = 55.5;
    else
      other.tStart[5] = nan;
    expectNear(picture(scene, camera, {3, 3}, other, options).focusLayer[0], {strata * opacity, opacity}, 1e-11);
  }
}

TEST(ReferenceLighting, labelsTakeTheirNormalsFromTheSmoothedIndicator) {
  // A half space of labels cut by an oblique plane, in a volume without gradients: the smoothed indicator's level sets
  // are that plane's, to the smoothing's own staircase.
  const Grid grid = gridOf({30, 30, 30}, {1.0, 1.0, 2.0});
  const glm::dvec3 n = glm::normalize(glm::dvec3(1.0, 0.4, 0.3));
  Scene scene =
      labelScene(grid, [&](glm::ivec3 i) { return glm::dot(n, (glm::dvec3(i) - 14.3) * grid.spacing) > 0.0; });
  scene.look.focusAppearance.extinction = 50.0;
  scene.look.contextLayer.strength = 0.0;
  const glm::dvec3 centre = grid.centre();
  const Camera camera = lookAt(centre - glm::dvec3(90.0, 0.0, 0.0), centre, Projection::Orthographic, 8.0);
  const Picture result = picture(scene, camera, {16, 16});
  const glm::dvec3 expected = phong(defaultLabelColour(1), n, camera, scene.look.shading);
  for (const glm::dvec4& pixel : result.final) {
    EXPECT_NEAR(pixel.a, 1.0, 1e-6);
    // The slope of light over normal is below 5 (specular, shininess 24), normals within a degree.
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(pixel[channel], expected[channel], 0.08);
  }
}

// ---- Composite and the picture as a whole ---------------------------------------------------------------------------

TEST(ReferenceComposite, borderCoversItsShareOfAPixel) {
  const Grid grid = gridOf({16, 16, 16});
  Scene scene = labelScene(grid, [](glm::ivec3 i) { return i == glm::ivec3(8); });
  scene.look.context.function = {{{-1.0, {red, 0.5}}}};
  scene.look.contextLayer.strength = 0.0;
  scene.look.cutaway.openWidth = 3.25;
  scene.look.cutaway.borderWidth = 2.5;
  const Camera camera = lookAt({8.0, -50.0, 8.0}, {8.0, 8.0, 8.0}, Projection::Orthographic, 16.0);
  const glm::ivec2 size(17, 17);
  const Stages stages = geometricStages(scene, camera, size);
  const Picture result = picture(scene, camera, size, stages);
  // Focus in the middle pixel alone; along the row distances are whole numbers.
  const std::size_t middle = 8 * 17 + 8;
  ASSERT_EQ(stages.distance[middle], 0.0);
  ASSERT_EQ(stages.distance[middle + 1], 1.0);
  const double expected[] = {0.0, 0.0, 0.0, 0.25, 1.0, 1.0, 0.25, 0.0};
  for (std::size_t d = 0; d < 8; ++d) {
    const glm::dvec4 own = result.focusLayer[middle + d], border(scene.look.cutaway.borderColour, 1.0);
    expectNear(result.final[middle + d], glm::mix(own, border, expected[d]), 1e-12);
  }
}

TEST(ReferenceComposite, contextLayerLiesOverTheFocus) {
  // A ball of values around a small ball of labels: κ = 1/r and the silhouette term are known.
  const Grid grid = gridOf({48, 48, 48});
  const auto radiusAt = [](glm::ivec3 i) { return glm::length(glm::dvec3(i) - 23.5); };
  Scene scene;
  scene.volume = volumeOf<float>(grid, [&](glm::ivec3 i) { return -radiusAt(i); });
  scene.labels = labelsOf(grid, [&](glm::ivec3 i) { return radiusAt(i) < 12.0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = opaqueFrom(-16.0);
  scene.look.cutaway.openWidth = 0.0;
  scene.look.cutaway.borderWidth = 0.0;
  const Camera camera = lookAt({23.5, -60.0, 23.5}, glm::dvec3(23.5), Projection::Orthographic, 48.0);
  const glm::ivec2 size(48, 48);
  const Stages stages = geometricStages(scene, camera, size);
  const Picture result = picture(scene, camera, size, stages);
  const auto step = [](double low, double high, double x) {
    const double s = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return s * s * (3.0 - 2.0 * s);
  };
  int seen = 0;
  for (std::size_t i = 0; i < result.final.size(); ++i) {
    EXPECT_EQ(std::isnan(result.contextLayer[i].x), std::isnan(stages.hits.tFocus[i]));
    if (std::isnan(stages.hits.tFocus[i])) {
      expectNear(result.final[i], result.focusLayer[i], 0.0);
      continue;
    }
    const glm::dvec4 layer = result.contextLayer[i];
    const double rim = result.silhouette[i],
                 bend = std::hypot(layer.x, layer.y) / std::sqrt(2.0) * 2.0;  // 2 mm thinned
    // The ball's own, from where the ray meets it.
    const double across = std::sqrt(256.0 - std::pow(stages.hits.tContext[i] - 83.5, 2));
    EXPECT_NEAR(rim, 1.0 - std::sqrt(1.0 - across * across / 256.0), 0.01);
    EXPECT_NEAR(layer.w, -16.0, 1e-9);
    const double opacity =
        scene.look.contextLayer.strength * std::clamp(step(0.10, 0.40, bend) + step(0.30, 0.85, rim), 0.0, 1.0);
    const glm::dvec4 front(scene.look.contextLayer.colour * layer.z, 1.0);
    expectNear(result.final[i], front * opacity + result.focusLayer[i] * (1.0 - opacity), 1e-12);
    ++seen;
  }
  EXPECT_GT(seen, 300);
}

TEST(ReferencePicture, somePixelsAreThoseOfTheWhole) {
  const Scene scene = roughScene();
  const Camera camera = Camera::fromAngles(25.0, 10.0, scene.volume->grid);
  const glm::ivec2 size(40, 36);
  const Picture whole = picture(scene, camera, size), again = picture(scene, camera, size);
  EXPECT_EQ(whole.final, again.final);
  PictureOptions options;
  options.pixels = {{20, 18}, {0, 0}, {39, 35}, {20, 18}, {7, 30}};
  const Picture some = picture(scene, camera, size, options);
  ASSERT_EQ(some.final.size(), options.pixels.size());
  for (std::size_t i = 0; i < options.pixels.size(); ++i) {
    const auto at = static_cast<std::size_t>(options.pixels[i].y * size.x + options.pixels[i].x);
    EXPECT_EQ(some.final[i], whole.final[at]);
    EXPECT_EQ(some.focusLayer[i], whole.focusLayer[at]);
    EXPECT_EQ(some.error[i], whole.error[at]);
  }
}

}  // namespace
}  // namespace fenestra::reference
