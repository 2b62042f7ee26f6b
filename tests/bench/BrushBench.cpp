// brush-bench: the cost of painting as a share of a full frame: a stroke of 50 points with a radius of 24 px at
// 700×650, on the torso phantom. Times until all passes have run, median and worst of the points against the median
// full frame, interleaved so that other load on the machine meets both.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "io/study/ReadStudy.h"
#include "rendering/Renderer.h"
#include "rendering/egl/EglContext.h"
#include "rendering/gpu/GpuScene.h"

namespace fenestra {
namespace {

constexpr int points = 50;
constexpr double radius = 24.0;  ///< px

/// Milliseconds until everything the picture needs has run.
double timed(Renderer& renderer, const Scene& scene, const View& view) {
  const auto start = std::chrono::steady_clock::now();
  renderer.render(scene, view);
  renderer.pick({0.0, 0.0});  // waits for the passes
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

void measure(BrushMode mode, const std::string& name) {
  io::StudyRequest options;
  options.phantom = "torso";
  options.makePlain();
  io::Study study = io::readStudy(options);
  Scene scene = study.drawn.scene();
  View view = *study.view;
  view.size = {700, 650};
  const auto gpu = std::make_shared<GpuScene>();
  Renderer painting(gpu), whole(gpu);
  painting.render(scene, view);
  whole.render(scene, view);
  std::vector<double> dabs, frames;
  BrushStroke stroke;
  stroke.mode = mode;
  scene.look.strokes = {stroke};
  View moved = view;
  for (int k = 0; k < points; ++k) {
    // Once around the heart, over the opening, its rim and the focus.
    const glm::dvec2 pixel(365.0 + 90.0 * std::cos(0.126 * k), 285.0 + 90.0 * std::sin(0.126 * k));
    const auto at = painting.pickBrush(pixel, mode);
    if (!at) continue;
    BrushStroke& painted = scene.look.strokes[0];
    if (painted.anchors.empty()) painted.radius = radius * at->pixelSize;
    if (!extend(painted, at->anchor)) continue;
    dabs.push_back(timed(painting, scene, view));
    moved.camera.eye.x = std::nextafter(moved.camera.eye.x, std::numeric_limits<double>::infinity());
    if (k % 5 == 0) frames.push_back(timed(whole, scene, moved));
  }
  const double full = median(frames);
  std::cout << name << ": " << dabs.size() << " points, median " << median(dabs) << " ms, worst "
            << *std::max_element(dabs.begin(), dabs.end()) << " ms; full frame " << full << " ms; median share "
            << 100.0 * median(dabs) / full << " %\n";
}

}  // namespace
}  // namespace fenestra

int main() {
  try {
    const fenestra::egl::EglContext context;
    std::cout << context.description() << '\n';
    fenestra::measure(fenestra::BrushMode::Restore, "restore");
    fenestra::measure(fenestra::BrushMode::Open, "open");
    fenestra::measure(fenestra::BrushMode::Fade, "fade");
  } catch (const std::exception& error) {
    std::cerr << "brush-bench: " << error.what() << '\n';
    return 1;
  }
}
