#pragma once
// Measures candidates on the GPU, and in double precision on the CPU.

#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "rendering/placement/Placer.h"
#include "rendering/viewpoints/Sphere.h"
#include "tests/gl/GlTest.h"

namespace fenestra::placement {

using namespace tests;

constexpr int side = 96;
constexpr double pi = std::numbers::pi;

class CandidateTest : public GlTest {
 protected:
  std::vector<Candidate> measure(const Scene& scene, const std::vector<glm::dvec3>& directions, int pixels = side,
                                 int surfacePoints = 0, bool endFaces = false) {
    gpu_.update(scene);
    surface_ = surfacePoints > 0 ? sampleSurface(scene, gpu_.focus(), surfacePoints) : FocusSurface{};
    return images_.measure(gpu_, directions, surface_, pixels, endFaces);
  }
  const FocusSurface& surface() const { return surface_; }
  GpuScene& gpu() { return gpu_; }

 private:
  GpuScene gpu_;
  CandidateImages images_;
  FocusSurface surface_;
};

inline std::vector<glm::dvec3> someDirections() {
  std::vector<glm::dvec3> directions;
  std::mt19937 random(11);
  for (int i = 0; i < 3; ++i) {
    directions.push_back(randomUnit(random));
    directions.push_back(-directions.back());  // shares its image
  }
  for (const glm::dvec3 axis : {glm::dvec3(0, -1, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1)})
    directions.push_back(axis);
  return directions;
}

/// The measurement of CandidateImages.h in double precision, with the reference's rays through a parallel camera.
class CpuImage {
 public:
  CpuImage(const Scene& scene, glm::dvec3 direction, int pixels)
      : scene_(scene), direction_(direction), pixels_(pixels), radius_(scene.volume->grid.boundingRadius()) {
    const glm::dvec3 centre = scene.volume->grid.centre();
    Camera camera = lookAt(centre + direction * (2.0 * radius_), centre, Projection::Orthographic, 2.0 * radius_);
    camera.up = uprightFrom(direction);
    reference::HitPoints hits = reference::hitPoints(scene, camera, {pixels, pixels});
    hits_ = std::move(hits.tFocus);
    for (std::size_t i = 0; i < hits_.size(); ++i) {
      const glm::ivec2 pixel(static_cast<int>(i) % pixels, static_cast<int>(i) / pixels);
      const auto span = reference::clip(reference::pixelRay(camera, {pixels, pixels}, pixel), scene.volume->grid);
      throughEnd_.push_back(span && hits.tContext[i] <= span->tIn + 1e-5 * radius_ ? 1.0 : 0.0);
    }
  }

  ImageSums sums() const {
    ImageSums sums;
    sums.box = {pixels_, pixels_, -1, -1};
    for (int y = -1; y < pixels_; ++y)
      for (int x = -1; x < pixels_; ++x) addCell(sums, {x, y});
    if (sums.count == 0.0) sums.box = ImageSums{}.box;
    return sums;
  }

 private:
  /// -1…1 across the image, from a position in pixels.
  glm::dvec2 imagePosition(glm::dvec2 pixel) const {
    return glm::dvec2(2.0 * (pixel.x + 0.5) / pixels_ - 1.0, 1.0 - 2.0 * (pixel.y + 0.5) / pixels_);
  }
  double hit(glm::ivec2 pixel) const {
    const bool inside = pixel.x >= 0 && pixel.y >= 0 && pixel.x < pixels_ && pixel.y < pixels_;
    return inside ? hits_[static_cast<std::size_t>(pixel.y * pixels_ + pixel.x)] : std::nan("");
  }
  bool sees(glm::dvec2 pixel) const {
    const Camera::Axes axes = axesAt(direction_);
    const glm::dvec2 position = imagePosition(pixel) * radius_;
    const glm::dvec3 target = scene_.volume->grid.centre() + position.x * axes.right + position.y * axes.up;
    const Camera camera = lookAt(target + direction_ * (2.0 * radius_), target, Projection::Orthographic, radius_);
    return !std::isnan(reference::hitPoints(scene_, camera, {1, 1}).tFocus.front());
  }
  /// The outline between the pixels a, which sees the focus, and b, which does not: the middle of the sixteenth of the
  /// way that holds it.
  glm::dvec2 outline(glm::dvec2 a, glm::dvec2 b) const {
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 4; ++i) {
      const double middle = 0.5 * (low + high);
      (sees(glm::mix(a, b, middle)) ? low : high) = middle;
    }
    return glm::mix(a, b, 0.5 * (low + high));
  }
  void addCell(ImageSums& sums, glm::ivec2 cell) const {
    const glm::ivec2 corners[] = {cell, cell + glm::ivec2(1, 0), cell + 1, cell + glm::ivec2(0, 1)};
    std::vector<glm::dvec2> polygon;
    double depth = 0.0, throughEnd = 0.0;
    int seeing = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const glm::ivec2 from = corners[i], to = corners[(i + 1) % 4];
      const bool here = !std::isnan(hit(from)), there = !std::isnan(hit(to));
      if (here) {
        polygon.emplace_back(from);
        depth += (hit(from) - radius_) / (2.0 * radius_);
        throughEnd += throughEnd_[static_cast<std::size_t>(from.y * pixels_ + from.x)];
        ++seeing;
      }
      if (here != there) polygon.push_back(here ? outline(from, to) : outline(to, from));
    }
    if (seeing == 0) return;
    if (!std::isnan(hit(cell)))
      sums.box = {std::min(sums.box.x, cell.x), std::min(sums.box.y, cell.y), std::max(sums.box.z, cell.x),
                  std::max(sums.box.w, cell.y)};
    double area = 0.0;
    glm::dvec2 moment(0.0);
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {  // a fan of triangles
      const glm::dvec2 u = polygon[i] - polygon[0], v = polygon[i + 1] - polygon[0];
      const double part = 0.5 * (u.x * v.y - u.y * v.x);
      area += part;
      moment += part * (polygon[0] + polygon[i] + polygon[i + 1]) / 3.0;
    }
    sums.count += area;
    sums.depth += area * depth / seeing;
    sums.ends += area * throughEnd / seeing;
    if (area > 0.0) sums.position += area * imagePosition(moment / area);
  }

  const Scene& scene_;
  glm::dvec3 direction_;
  int pixels_;
  double radius_;
  reference::Image hits_, throughEnd_;
};

/// float32 against double: 1e-4 of every descriptor. A ray that grazes the surface may move one crossing of the outline
/// by a thirty-second of a pixel; an image has some hundreds of crossings.
inline void expectSameAsOnCpu(const Scene& scene, const std::vector<Candidate>& candidates) {
  for (const Candidate& candidate : candidates) {
    const ImageSums truth = CpuImage(scene, candidate.direction, side).sums();
    const ImageSums& sums = candidate.sums;
    constexpr double tolerance = 1e-4;
    ASSERT_GT(truth.count, 0.0);
    EXPECT_NEAR(sums.count, truth.count, tolerance * truth.count);
    EXPECT_NEAR(sums.depth, truth.depth, tolerance * truth.count);
    EXPECT_NEAR(sums.position.x, truth.position.x, tolerance * truth.count);
    EXPECT_NEAR(sums.position.y, truth.position.y, tolerance * truth.count);
    EXPECT_EQ(sums.box, truth.box);
    const Descriptors d = candidate.descriptors, expected = describe(truth, side, candidate.direction);
    EXPECT_NEAR(d.visibility, expected.visibility, tolerance);
    EXPECT_NEAR(d.coverage, expected.coverage, tolerance * expected.coverage);
    EXPECT_NEAR(d.location, expected.location, tolerance);
  }
}

/// Two lobes and a bar away from the grid's centre: concave, and different from every side.
inline int lobes(const Grid& grid, glm::ivec3 index) {
  const glm::dvec3 u = glm::dvec3(index) / glm::dvec3(grid.dims);
  const bool inside = glm::length(u - glm::dvec3(0.31, 0.42, 0.37)) < 0.2 ||
                      glm::length(u - glm::dvec3(0.66, 0.55, 0.61)) < 0.14 ||
                      (std::abs(u.x - 0.5) < 0.3 && std::abs(u.y - 0.71) < 0.06 && std::abs(u.z - 0.44) < 0.07);
  return inside ? 1 : 0;
}

inline Grid shearedGrid(glm::ivec3 dims) {
  Grid grid = obliqueGrid(dims);
  grid.direction[2] = glm::normalize(grid.direction[2] + 0.35 * grid.direction[1]);
  return grid;
}

}  // namespace fenestra::placement
