// The reference's integral against closed forms, and rules of known order against it.

#include <functional>
#include <numbers>

#include "tests/unit/ReferenceTesting.h"

namespace fenestra::reference::referenceIntegralTest {
namespace {

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

}  // namespace
}  // namespace fenestra::reference::referenceIntegralTest
