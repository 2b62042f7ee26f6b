#pragma once
// Shared by every test of the renderer: one windowless context, an error check at the end, and the comparison with the
// double-precision reference.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "rendering/Renderer.h"
#include "rendering/egl/EglContext.h"
#include "rendering/gl/Context.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/reference/Reference.h"
#include "tests/support/Scenes.h"

namespace fenestra::tests {

/// Whether both hold the same bits.
template <class T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
  return std::ranges::equal(std::as_bytes(std::span(a)), std::as_bytes(std::span(b)));
}

class GlTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { context_ = std::make_unique<egl::EglContext>(); }
  static void TearDownTestSuite() { context_.reset(); }
  void TearDown() override { EXPECT_EQ(gl::takeError(), ""); }

 private:
  inline static std::unique_ptr<egl::EglContext> context_;
};

/// Errors of one stage against its reference, in the stage's unit.
struct StageErrors {
  std::size_t compared = 0, onlyHere = 0, onlyReference = 0;
  std::vector<double> errors;  ///< sorted

  double percentile(double p) const {
    return errors.empty() ? 0.0 : errors[static_cast<std::size_t>(p * static_cast<double>(errors.size() - 1))];
  }
  double max() const { return errors.empty() ? 0.0 : errors.back(); }
};

/// Compares two maps pixel by pixel, errors divided by `unit`. A pixel known in one map only is counted, not compared;
/// an infinite difference stays infinite.
inline StageErrors compareMaps(const std::vector<float>& here, const reference::Image& truth, double unit) {
  StageErrors result;
  if (here.size() != truth.size()) {
    ADD_FAILURE() << here.size() << " pixels against " << truth.size();
    return result;
  }
  for (std::size_t i = 0; i < here.size(); ++i) {
    const bool a = !std::isnan(here[i]), b = !std::isnan(truth[i]);
    if (a && b) {
      ++result.compared;
      const double error = here[i] == truth[i] ? 0.0 : std::abs(here[i] - truth[i]) / unit;
      result.errors.push_back(std::isnan(error) ? infinity : error);
    } else if (a) {
      ++result.onlyHere;
    } else if (b) {
      ++result.onlyReference;
    }
  }
  std::sort(result.errors.begin(), result.errors.end());
  return result;
}

inline reference::Image widened(const std::vector<float>& values) { return {values.begin(), values.end()}; }

/// The schedules under which whole pictures are compared with the reference: the driver's usual one, or both where
/// FENESTRA_BOTH_SCHEDULES is set, as the exhaustive tests do. Each pass is compared with the reference under both
/// (PassTest.h), and ProgramsTest compares the pictures of both with each other.
inline std::vector<Schedule> pictureSchedules() {
  if (std::getenv("FENESTRA_BOTH_SCHEDULES")) return {Schedule::Plain, Schedule::Llvmpipe};
  return {usualSchedule()};
}

struct Rendered {
  Layers layers;
  std::array<PassStats, passCount> stats;
};

inline Rendered renderOnce(const Scene& scene, const Camera& camera, glm::ivec2 size,
                           Quality quality = Quality::Draft) {
  Renderer renderer(std::make_shared<GpuScene>());
  renderer.render(scene, {camera, size, 1.0, quality});
  return {renderer.readLayers(), renderer.stats()};
}

inline double finestSpacing(const Grid& grid) { return std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z}); }

/// Holds stages 1 to 4 against the reference, whose hits are `truth`. Each stage is fed the renderer's own earlier
/// stages, so that an error shows where it arises.
inline void expectStagesMatch(const Layers& layers, const reference::HitPoints& truth, const Scene& scene,
                              const Camera& camera, glm::ivec2 size) {
  const std::size_t pixels = truth.tFocus.size();
  // A voxel's length, and what float32 makes of t itself, which the layers hold measured from the eye.
  double greatest = 0.0;
  for (const double t : truth.tContext)
    if (std::isfinite(t)) greatest = std::max(greatest, t);
  const double voxel = finestSpacing(scene.volume->grid) + greatest * 1.2e-7 * 1e3;

  const auto expectHits = [&](const std::vector<float>& here, const reference::Image& expected, const char* name) {
    const StageErrors e = compareMaps(here, expected, voxel);
    // 1e-3 voxel is what the method asks of refined hits. Where a ray grazes the surface, rounding moves the hit far
    // along the ray, or decides whether there is one: such pixels lie on the silhouette, and are held to one in a
    // thousand.
    EXPECT_LE(e.percentile(0.999), 1e-3) << name;
    const std::size_t grazing = std::max<std::size_t>(1, pixels / 1000);
    EXPECT_LE(e.onlyHere, grazing) << name << ": hits that the reference does not have";
    EXPECT_LE(e.onlyReference, grazing) << name << ": missed hits";
  };
  expectHits(layers.tFocus, truth.tFocus, "t_focus");
  expectHits(layers.tContext, truth.tContext, "t_context");

  const reference::Image filled = reference::fill(widened(layers.tFocus), size);
  const StageErrors fillErrors = compareMaps(layers.tFocusFilled, filled, voxel);
  // Means and sums of float32 over at most a dozen levels.
  EXPECT_LE(fillErrors.max(), 1e-3) << "t_focus_filled";
  EXPECT_EQ(fillErrors.onlyHere + fillErrors.onlyReference, 0u);
  for (std::size_t i = 0; i < pixels; ++i)
    if (!std::isnan(layers.tFocus[i])) {
      EXPECT_EQ(layers.tFocus[i], layers.tFocusFilled[i]) << "known pixel " << i;
    }

  const reference::Widths widths = reference::widthsInPixels(scene, camera, size, 1.0);
  const reference::Image distance = reference::distanceMap(widened(layers.tFocus), size, widths.open + widths.border);
  const StageErrors distanceErrors = compareMaps(layers.distance, distance, 1.0);
  // Squared distances are integers, so the only error is one rounding of a square root below 2^14.
  EXPECT_LE(distanceErrors.max(), 1e-3) << "distance";

  reference::HitPoints own = truth;
  own.tContext = widened(layers.tContext);
  own.tFocus = widened(layers.tFocus);
  const reference::Image start =
      reference::rayStart(own, widened(layers.tFocusFilled), widened(layers.distance), widths.open);
  const StageErrors startErrors = compareMaps(layers.tStart, start, voxel);
  EXPECT_LE(startErrors.max(), 2e-3) << "t_start";
  EXPECT_EQ(startErrors.onlyHere + startErrors.onlyReference, 0u);
}

inline void expectStagesMatch(const Scene& scene, const Camera& camera, glm::ivec2 size) {
  // Drafts meet a spline's samples, not the spline.
  const Layers layers = renderOnce(scene, camera, size, Quality::Normal).layers;
  expectStagesMatch(layers, reference::hitPoints(scene, camera, size), scene, camera, size);
}

}  // namespace fenestra::tests
