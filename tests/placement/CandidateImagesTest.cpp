// Candidates as the GPU measures them, against closed forms and against a double-precision computation on the CPU.

#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "rendering/placement/Placer.h"
#include "rendering/viewpoints/Sphere.h"
#include "tests/gl/GlTest.h"

namespace fenestra::placement {
namespace {

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

std::vector<glm::dvec3> someDirections() {
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
void expectSameAsOnCpu(const Scene& scene, const std::vector<Candidate>& candidates) {
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
int lobes(const Grid& grid, glm::ivec3 index) {
  const glm::dvec3 u = glm::dvec3(index) / glm::dvec3(grid.dims);
  const bool inside = glm::length(u - glm::dvec3(0.31, 0.42, 0.37)) < 0.2 ||
                      glm::length(u - glm::dvec3(0.66, 0.55, 0.61)) < 0.14 ||
                      (std::abs(u.x - 0.5) < 0.3 && std::abs(u.y - 0.71) < 0.06 && std::abs(u.z - 0.44) < 0.07);
  return inside ? 1 : 0;
}

Grid shearedGrid(glm::ivec3 dims) {
  Grid grid = obliqueGrid(dims);
  grid.direction[2] = glm::normalize(grid.direction[2] + 0.35 * grid.direction[1]);
  return grid;
}

TEST_F(CandidateTest, LabelsAgreeWithTheCpuOnEveryKindOfGrid) {
  for (const Grid& grid : {gridOf({37, 31, 29}), gridOf({33, 29, 14}, {0.8, 1.1, 2.9}, {400.0, -3000.0, 7.0}),
                           obliqueGrid({31, 25, 17}), shearedGrid({31, 25, 17})}) {
    const Scene scene = labelScene(grid, [&](glm::ivec3 index) { return lobes(grid, index); });
    expectSameAsOnCpu(scene, measure(scene, someDirections()));
  }
}

/// A body around the lobes that the scan cuts off below, and on one side; air has other values than tissue, in two
/// gaps.
Scene cutBody(const Grid& grid, Focus focus) {
  const auto inBody = [&](glm::ivec3 i) {
    const glm::dvec3 u = glm::dvec3(i) / glm::dvec3(grid.dims);
    return glm::length((u - glm::dvec3(0.5, 0.45, 0.3)) * glm::dvec3(1.0, 0.8, 0.6)) < 0.42;
  };
  Scene scene = labelScene(grid, [&](glm::ivec3 index) { return lobes(grid, index); });
  const Scene values = valueScene(
      grid, [&](glm::ivec3 i) { return lobes(grid, i) ? 90.0
                                       : inBody(i)    ? 40.0 + (i.x + i.y) % 3
                                                      : -800.0; }, 0.0);
  scene.volume = values.volume;
  scene.look = values.look;
  scene.look.focus = std::move(focus);
  // From -200 on and not around 41: there are values that the context leaves out among its own.
  scene.look.context.function.nodes = {{-200.0, {{1, 1, 1}, 0.0}}, {-100.0, {{1, 1, 1}, 0.4}}};
  return scene;
}

TEST_F(CandidateTest, EndFacesAgreeWithTheCpu) {
  std::vector<glm::dvec3> few = someDirections();
  few.resize(2);
  few.emplace_back(0.0, 0.0, -1.0);
  few.emplace_back(0.0, 0.0, 1.0);
  const std::pair<Grid, Focus> cases[] = {{gridOf({37, 31, 29}), LabelFocus{{1}}},
                                          {shearedGrid({31, 25, 17}), LabelFocus{{1}}},
                                          {obliqueGrid({15, 13, 10}), ValueFocus{{60.0, 1000.0}, 0.0}}};
  for (const auto& [grid, focus] : cases) {
    const Scene scene = cutBody(grid, focus);
    const std::vector<Candidate> candidates = measure(scene, few, side, 0, true);
    const std::vector<Candidate> without = measure(scene, few);
    double least = 1.0, greatest = 0.0;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const ImageSums truth = CpuImage(scene, candidates[i].direction, side).sums();
      const double endFace = candidates[i].descriptors.endFace;
      // A ray whose entry point has the value of the body's surface may fall to either side in float32: one pixel.
      EXPECT_NEAR(endFace, truth.ends / truth.count, 1e-4 + 1.0 / truth.count) << i;
      least = std::min(least, endFace);
      greatest = std::max(greatest, endFace);
      EXPECT_EQ(without[i].descriptors.endFace, 0.0);
      EXPECT_EQ(without[i].sums.count, candidates[i].sums.count) << "the rest is measured as before";
      EXPECT_EQ(without[i].sums.depth, candidates[i].sums.depth);
    }
    EXPECT_GT(greatest, least + 0.1) << "the views differ";
  }
}

TEST_F(CandidateTest, EndFacesOfACutCylinderInClosedForm) {
  // A body that fills the volume from bottom to top but not to the sides, its focus a small ball on the axis: views
  // from above and below come in through the ends, those from the sides do not.
  const Grid grid = gridOf({40, 40, 30});
  const auto fromAxis = [](glm::ivec3 i) { return glm::length(glm::dvec2(i.x, i.y) - 19.5); };
  Scene scene = valueScene(
      grid,
      [&](glm::ivec3 i) {
        return glm::length(glm::dvec3(i) - glm::dvec3(19.5, 19.5, 14.5)) < 3.0
                   ? 300.0
                   : 100.0 * std::clamp(14.0 - fromAxis(i), -1.0, 1.0);
      },
      250.0);
  scene.look.context.function.nodes = {{-1.0, {{1, 1, 1}, 0.0}}, {0.0, {{1, 1, 1}, 1.0}}, {1.0, {{1, 1, 1}, 1.0}}};
  for (const Candidate& candidate : measure(scene, ringDirections(4), side, 0, true)) {
    const double z = std::abs(candidate.direction.z), across = std::sqrt(1.0 - z * z);
    // A ray to the ball's centre passes the end at this distance from the axis; the ball has a radius of 3.
    const double distance = z > 0.0 ? 15.0 * across / z : 1e9;
    if (distance + 3.5 / z < 14.0) {
      EXPECT_NEAR(candidate.descriptors.endFace, 1.0, 1e-5);  // float32 sums
    } else if (distance - 3.5 / z > 14.0) {
      EXPECT_EQ(candidate.descriptors.endFace, 0.0);
    }
  }
}

TEST_F(CandidateTest, EndFacesAreMeasuredAgainOnlyWhenTheyChange) {
  const Grid grid = gridOf({37, 31, 29});
  Scene scene = cutBody(grid, LabelFocus{{1}});
  Placer placer;
  Options options, without;
  without.weights.endFace = 0.0;
  const auto measured = [&](const Options& with) { return placer.measure(gpu(), scene, {48}, with).candidates.data(); };
  const Candidate* kept = measured(options);
  EXPECT_EQ(measured(without), kept);
  scene.look.context.function.nodes[1].properties.colour = {1, 0, 0};
  EXPECT_EQ(measured(options), kept) << "a colour opens no end";
  const double before = placer.measured().candidates[0].descriptors.endFace;
  EXPECT_GT(before, 0.0);
  scene.look.context.function.nodes = {{2000.0, {{1, 1, 1}, 0.0}}, {2001.0, {{1, 1, 1}, 0.4}}};
  EXPECT_EQ(placer.measure(gpu(), scene, {48}, without).candidates[0].descriptors.endFace, before);
  EXPECT_LT(placer.measure(gpu(), scene, {48}, options).candidates[0].descriptors.endFace, before);
  placer.forget();
  placer.measure(gpu(), scene, {48}, without);
  scene.look.context.function.nodes[1].value = 2002.0;
  const Candidate* plain = measured(without);
  scene.look.context.function.nodes[1].value = 2003.0;
  EXPECT_EQ(measured(without), plain);
}

TEST_F(CandidateTest, RefinementWithEndFacesFindsWhatAnExhaustiveSearchFinds) {
  const Grid grid = gridOf({37, 31, 29});
  const Scene scene = cutBody(grid, LabelFocus{{1}});
  const Options options;
  constexpr int finest = 16;
  measure(scene, {});
  const int pixels = CandidateImages::sideFor(gpu());
  const auto measured = [&](const std::vector<glm::dvec3>& directions) {
    return measure(scene, directions, pixels, 0, true);
  };
  Refinement refinement(options, 0, 2, finest);
  while (!refinement.wanted().empty()) refinement.add(measured(refinement.wanted()));
  const std::vector<Candidate> all = refinement.candidates();
  const std::vector<Candidate> found(all.begin() + static_cast<std::ptrdiff_t>(refinement.coarser()), all.end());
  std::vector<glm::dvec3> directions;
  for (int pixel = 0; pixel < 12 * finest * finest; ++pixel) directions.push_back(nestedDirection(finest, pixel));
  const std::vector<Candidate> brute = measured(directions);
  const Candidate& c1 = brute[bestView(brute, options).value()];
  EXPECT_EQ(found[bestView(found, options).value()].direction, c1.direction);
  EXPECT_EQ(found[dualView(found, c1.direction, options).value()].direction,
            brute[dualView(brute, c1.direction, options).value()].direction);
}

TEST_F(CandidateTest, ValuesAgreeWithTheCpu) {
  const Grid grid = obliqueGrid({20, 17, 12});
  std::mt19937 random(2);
  std::uniform_real_distribution<double> noise(0.0, 0.2);
  const Scene scene = valueScene(
      grid, [&](glm::ivec3 index) { return lobes(grid, index) + noise(random); }, 0.55);
  const std::vector<glm::dvec3> all = someDirections();
  expectSameAsOnCpu(scene, measure(scene, {all[0], all[1], all.back()}));
}

TEST_F(CandidateTest, AFocusThatFillsTheVolumeAgreesWithTheCpu) {
  const Scene scene = labelScene(obliqueGrid({20, 17, 9}), [](glm::ivec3) { return 1; });
  const std::vector<Candidate> candidates = measure(scene, someDirections(), side, 500);
  expectSameAsOnCpu(scene, candidates);
  EXPECT_TRUE(surface().points.empty());
  Placer placer;
  const Placement placement = choose(placer.measure(gpu(), scene, {48}, {}), {}, true);
  EXPECT_TRUE(placement.c1 && placement.c2);
  EXPECT_EQ(placement.share, 0.0);
  EXPECT_NE(placement.note, "");
}

TEST_F(CandidateTest, AFocusAtTheBorderAgreesWithTheCpu) {
  const Scene scene =
      labelScene(gridOf({24, 20, 18}, {1.0, 1.2, 1.5}), [](glm::ivec3 i) { return i.x < 6 && i.y > 11 ? 1 : 0; });
  expectSameAsOnCpu(scene, measure(scene, someDirections()));
}

TEST_F(CandidateTest, AnEmptyFocusSeesNothingAndSaysSo) {
  const Scene scene = labelScene(gridOf({12, 12, 12}), [](glm::ivec3) { return 2; });
  for (const Candidate& candidate : measure(scene, someDirections(), side, 100)) {
    EXPECT_EQ(candidate.sums.count, 0.0);
    EXPECT_LT(candidate.sums.box.z, candidate.sums.box.x);
  }
  Placer placer;
  const Placement placement = choose(placer.measure(gpu(), scene, {}, {}), {}, false);
  EXPECT_FALSE(placement.c1 || placement.c2);
  EXPECT_NE(placement.note, "");
}

/// Largest error of an area, the sum of three: chords cut 2π/12 of a square pixel off a convex outline (∮κ ds = 2π, a
/// chord's segment is κ/12 of its length cubed); each crossing has an independent error of up to 1/32 of a pixel, taken
/// at three standard deviations; and trilinear interpolation moves a curved surface inwards.
double areaError(double outlinePixels, double fieldError) {
  return 0.53 + 3.0 / 32.0 / std::sqrt(3.0) * std::sqrt(outlinePixels) + fieldError * outlinePixels;
}

TEST_F(CandidateTest, ABallInClosedForm) {
  const Grid grid = gridOf({64, 60, 56});
  const glm::dvec3 centre(28.3, 33.1, 26.4);
  const double r = 13.0, radius = grid.boundingRadius();
  const Scene scene = valueScene(
      grid, [&](glm::ivec3 i) { return r - glm::length(glm::dvec3(i) - centre); }, 0.0);
  const glm::dvec3 offset = centre - grid.centre();
  const double perPixel = 2.0 * radius / 128.0;
  for (const Candidate& candidate : measure(scene, ringDirections(3), 128)) {
    const double expected = pi * r * r / (perPixel * perPixel);
    // Trilinear interpolation of a distance errs by (1/8)·(2/r) of a squared voxel.
    EXPECT_NEAR(candidate.sums.count, expected, areaError(2.0 * pi * r / perPixel, 0.25 / r / perPixel));
    // The mean height of a half sphere over its disc is 2/3 of its radius. Half a pixel of outline, seen edge on.
    const double depth = 0.5 + (-glm::dot(offset, candidate.direction) - 2.0 / 3.0 * r) / (2.0 * radius);
    EXPECT_NEAR(candidate.descriptors.visibility, depth, 0.05 * perPixel / (2.0 * radius));
    const Camera::Axes axes = axesAt(candidate.direction);
    const glm::dvec2 position = glm::dvec2(glm::dot(offset, axes.right), glm::dot(offset, axes.up)) / radius;
    EXPECT_NEAR(candidate.descriptors.location, 1.0 - glm::length(position) / std::sqrt(2.0), 0.03 * perPixel / radius);
  }
}

TEST_F(CandidateTest, AnEllipsoidInClosedForm) {
  const Grid grid = gridOf({60, 60, 60});
  const glm::dvec3 centre(30.2, 28.7, 31.1), axes(22.0, 14.0, 9.0);
  const Scene scene = valueScene(
      grid, [&](glm::ivec3 i) { return 1.0 - glm::length((glm::dvec3(i) - centre) / axes); }, 0.0);
  const double perPixel = 2.0 * grid.boundingRadius() / 128.0;
  for (const Candidate& candidate : measure(scene, ringDirections(3), 128)) {
    const glm::dvec3 shadow = candidate.direction * glm::dvec3(axes.y * axes.z, axes.x * axes.z, axes.x * axes.y);
    const double area = pi * glm::length(shadow);
    // The outline is shorter than that of the enclosing circle; the surface is most curved at the ends of the long
    // axis.
    EXPECT_NEAR(candidate.sums.count, area / (perPixel * perPixel),
                areaError(2.0 * pi * axes.x / perPixel, 0.05 / perPixel));
  }
}

TEST_F(CandidateTest, ASlabInClosedForm) {
  const Grid grid = gridOf({60, 60, 60});
  const glm::ivec3 low(10, 22, 31), size(36, 20, 8);
  const Scene scene = labelScene(grid, [&](glm::ivec3 i) {
    return glm::all(glm::greaterThanEqual(i, low)) && glm::all(glm::lessThan(i, low + size)) ? 1 : 0;
  });
  const double perPixel = 2.0 * grid.boundingRadius() / 128.0;
  for (const Candidate& candidate : measure(scene, ringDirections(3), 128)) {
    const glm::dvec3 d = glm::abs(candidate.direction), s(size);
    const double area = d.x * s.y * s.z + d.y * s.x * s.z + d.z * s.x * s.y;
    const double outline = 2.0 * (s.x + s.y + s.z);
    // The 0.5 level lies half way between voxels; it takes √2·(√½ - ½) = 0.29 of a voxel off the edges.
    EXPECT_NEAR(candidate.sums.count, area / (perPixel * perPixel), areaError(outline / perPixel, 0.29 / perPixel));
  }
}

TEST_F(CandidateTest, TwoBallsHideOneAnotherAlongTheirAxis) {
  const Grid grid = gridOf({70, 40, 40});
  const double r = 8.0;
  const glm::dvec3 a(18.5, 19.5, 19.5), b(50.5, 19.5, 19.5);
  const Scene scene = valueScene(
      grid, [&](glm::ivec3 i) { return r - std::min(glm::length(glm::dvec3(i) - a), glm::length(glm::dvec3(i) - b)); },
      0.0);
  const double perPixel = 2.0 * grid.boundingRadius() / 128.0, disc = pi * r * r / (perPixel * perPixel);
  const std::vector<Candidate> candidates = measure(scene, {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}, 128, 2000);
  const double tolerance = areaError(4.0 * pi * r / perPixel, 0.25 / r / perPixel);
  EXPECT_NEAR(candidates[0].sums.count, disc, tolerance);
  EXPECT_NEAR(candidates[1].sums.count, 2.0 * disc, tolerance);
  EXPECT_NEAR(candidates[2].sums.count, 2.0 * disc, tolerance);
  // A quarter of the surface is seen along the axis, half of it from the side. The hidden ball has the front ball's
  // outline: points within 15 degrees of edge-on there (a quarter of the quarter) may count as seen or not.
  EXPECT_NEAR(seenShare(candidates[0], candidates[0], surface().points.size()), 0.25, 0.06);
  EXPECT_NEAR(seenShare(candidates[1], candidates[1], surface().points.size()), 0.5, 0.02);
}

TEST_F(CandidateTest, ASmallBallBehindALargerOneIsHidden) {
  const Grid grid = gridOf({70, 40, 40});
  const glm::dvec3 large(18.5, 19.5, 19.5), small(50.5, 19.5, 19.5);
  const auto inside = [&](glm::ivec3 i) {
    return glm::length(glm::dvec3(i) - large) < 10.0 || glm::length(glm::dvec3(i) - small) < 6.0;
  };
  const std::vector<Candidate> candidates =
      measure(labelScene(grid, [&](glm::ivec3 i) { return inside(i) ? 1 : 0; }), {{-1, 0, 0}, {1, 0, 0}}, side, 2000);
  const double all = 10.0 * 10.0 + 6.0 * 6.0;
  // From the large ball's side half of that is seen; from the other side half of the small one and the ring of the
  // large one around it.
  const auto share = [&](std::size_t i) { return seenShare(candidates[i], candidates[i], surface().points.size()); };
  // Normals err by up to two degrees, which puts at most 2π/90 of a half's 2π on the wrong side of the outline.
  EXPECT_NEAR(share(0), 0.5 * 10.0 * 10.0 / all, 0.015);
  const double ring = 10.0 * 10.0 * (1.0 - (1.0 - std::sqrt(1.0 - 0.36)));
  EXPECT_NEAR(share(1), 0.5 * (6.0 * 6.0 + ring) / all, 0.015);
}

TEST_F(CandidateTest, ABallsSurfaceAndWhatIsSeenOfIt) {
  for (const Grid& grid : {gridOf({48, 48, 48}), gridOf({60, 50, 24}, {0.7, 0.9, 1.8}), shearedGrid({60, 40, 28})}) {
    const double r = 14.0;
    const glm::dmat4 world = grid.worldFromIndex();
    const glm::dvec3 centre = grid.centre();
    const Scene scene = labelScene(
        grid, [&](glm::ivec3 i) { return glm::length(glm::dvec3(world * glm::dvec4(i, 1.0)) - centre) < r ? 1 : 0; });
    std::vector<glm::dvec3> directions;
    for (const glm::dvec3 direction : ringDirections(1)) {
      directions.push_back(direction);
      directions.push_back(-direction);
    }
    const std::vector<Candidate> candidates = measure(scene, directions, side, 4096);
    // Errors of the normals enter in second order: 5 degrees are 0.4 %.
    EXPECT_NEAR(surface().area / (4.0 * pi * r * r), 1.0, 0.01);
    ASSERT_NEAR(static_cast<double>(surface().points.size()), 4096.0, 1.0);
    for (std::size_t i = 0; i < candidates.size(); i += 2) {
      const std::size_t points = surface().points.size();
      // Normals err by up to two degrees, and so does the boundary of the far half.
      EXPECT_NEAR(seenShare(candidates[i], candidates[i], points), 0.5, 0.015);
      // Half of the points that are exactly edge-on, some four in a hundred, count as seen: the same half from both
      // sides.
      EXPECT_NEAR(seenShare(candidates[i], candidates[i + 1], points), 1.0, 0.025);
    }
  }
}

TEST_F(CandidateTest, ABoxsSurface) {
  const Grid grid = gridOf({40, 40, 40}, {0.8, 1.0, 1.3});
  const Scene scene = labelScene(grid, [&](glm::ivec3 i) {
    return i.x >= 8 && i.x < 32 && i.y >= 10 && i.y < 30 && i.z >= 9 && i.z < 31 ? 1 : 0;
  });
  measure(scene, {{1, 0, 0}}, side, 1000);
  const glm::dvec3 s(24 * 0.8, 20 * 1.0, 22 * 1.3);
  // Edges are rounded over two of twenty voxels: a quarter circle in place of two sides.
  EXPECT_NEAR(surface().area / (2.0 * (s.x * s.y + s.y * s.z + s.x * s.z)), 1.0, 0.04);
  for (const FocusSurface::Point& point : surface().points) EXPECT_NEAR(glm::length(point.normal), 1.0, 1e-12);
}

/// CandidateVisibility.comp in double precision: a point is seen when no focus lies between it, moved off its surface,
/// and the camera.
bool seesPoint(const Scene& scene, const FocusSurface& surface, std::size_t which, glm::dvec3 direction) {
  const Grid& grid = scene.volume->grid;
  const FocusSurface::Point& point = surface.points[which];
  const double slope = glm::dot(point.normal, direction);
  if (std::abs(slope) < 1e-5 ? which % 2 != 0 : slope < 0.0) return false;
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  double extent = 0.0;
  for (int axis = 0; axis < 3; ++axis) extent += std::abs(glm::dot(glm::dvec3(worldFromIndex[axis]), point.normal));
  const glm::dvec3 eye = glm::dvec3(worldFromIndex * glm::dvec4(point.index, 1.0)) +
                         extent * std::min(1.0 / std::abs(slope), 8.0) * direction;
  const Camera camera = lookAt(eye, eye + direction, Projection::Orthographic, 1.0);
  return std::isnan(reference::hitPoints(scene, camera, {1, 1}).tFocus.front());
}

TEST_F(CandidateTest, WhatIsSeenAndItsDescriptorsAgreeWithTheCpu) {
  const Grid grid = shearedGrid({31, 25, 17});
  const Scene scene = labelScene(grid, [&](glm::ivec3 index) { return lobes(grid, index); });
  std::vector<Candidate> candidates = measure(scene, ringDirections(1), side, 150);
  const std::vector<FocusSurface::Point>& points = surface().points;
  describeTogether(candidates, points.size());

  const std::size_t n = candidates.size();
  std::vector<std::vector<double>> p(n, std::vector<double>(points.size(), 0.0));  // p(o|v)
  for (std::size_t v = 0; v < n; ++v) {
    double seen = 0.0;
    for (std::size_t o = 0; o < points.size(); ++o) {
      const bool sees = seesPoint(scene, surface(), o, candidates[v].direction);
      EXPECT_EQ(sees, (candidates[v].seen[o / 64] >> (o % 64) & 1u) != 0) << v << ' ' << o;
      p[v][o] = sees ? 1.0 : 0.0;
      seen += p[v][o];
    }
    for (double& share : p[v]) share /= seen;
  }
  const auto entropyOf = [](const std::vector<double>& distribution) {
    double bits = 0.0;
    for (const double share : distribution)
      if (share > 0.0) bits -= share * std::log2(share);
    return bits;
  };
  std::vector<double> mean(points.size(), 0.0), information(n, 0.0);
  for (const auto& distribution : p)
    for (std::size_t o = 0; o < mean.size(); ++o) mean[o] += distribution[o] / static_cast<double>(n);
  for (std::size_t v = 0; v < n; ++v)
    for (std::size_t o = 0; o < mean.size(); ++o)
      if (p[v][o] > 0.0) information[v] += p[v][o] * std::log2(p[v][o] / mean[o]);
  const double greatest = *std::max_element(information.begin(), information.end());
  for (std::size_t v = 0; v < n; ++v) {
    // The eight nearest; ties to the first.
    std::vector<std::size_t> nearest(n);
    std::iota(nearest.begin(), nearest.end(), std::size_t{0});
    std::stable_sort(nearest.begin(), nearest.end(), [&](std::size_t a, std::size_t b) {
      return glm::dot(candidates[a].direction, candidates[v].direction) >
             glm::dot(candidates[b].direction, candidates[v].direction);
    });
    double divergence = 0.0;
    for (std::size_t i = 1; i <= 8; ++i) {
      std::vector<double> middle(points.size());
      for (std::size_t o = 0; o < middle.size(); ++o) middle[o] = 0.5 * (p[v][o] + p[nearest[i]][o]);
      divergence += entropyOf(middle) - 0.5 * entropyOf(p[v]) - 0.5 * entropyOf(p[nearest[i]]);
    }
    const Descriptors& d = candidates[v].descriptors;
    const glm::dvec3 direction = candidates[v].direction;
    EXPECT_NEAR(d.entropy, entropyOf(p[v]) / std::log2(static_cast<double>(points.size())), 1e-4);
    EXPECT_NEAR(d.mutualInformation, 1.0 - information[v] / greatest, 1e-4);
    EXPECT_NEAR(d.stability, 1.0 - divergence / 8.0, 1e-4);
    EXPECT_NEAR(d.orientation, std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)}), 1e-4);
  }
}

TEST_F(CandidateTest, ASymmetricFocusIsSaidToBe) {
  const Grid grid = gridOf({56, 56, 56});
  const Scene scene = valueScene(
      grid, [&](glm::ivec3 i) { return 16.0 - glm::length(glm::dvec3(i) - 27.5); }, 0.0);
  Placer placer;
  gpu().update(scene);
  EXPECT_NE(choose(placer.measure(gpu(), scene, {}, {}), {}, false).note, "");
}

TEST_F(CandidateTest, TheSameCallTwiceGivesTheSameBits) {
  const Grid grid = obliqueGrid({40, 36, 30});
  const Scene scene = labelScene(grid, [&](glm::ivec3 index) { return lobes(grid, index); });
  const auto bitsOf = [](const Measured& measured) {
    std::vector<std::uint64_t> bits;
    for (const Candidate& c : measured.candidates) {
      const double values[] = {c.sums.count,
                               c.sums.depth,
                               c.sums.position.x,
                               c.sums.position.y,
                               c.descriptors.visibility,
                               c.descriptors.coverage,
                               c.descriptors.location,
                               c.descriptors.entropy,
                               c.descriptors.mutualInformation,
                               c.descriptors.stability,
                               c.descriptors.orientation,
                               c.descriptors.endFace};
      for (const double value : values) bits.push_back(std::bit_cast<std::uint64_t>(value));
      for (int i = 0; i < 4; ++i) bits.push_back(static_cast<std::uint64_t>(c.sums.box[i]));
      bits.insert(bits.end(), c.seen.begin(), c.seen.end());
    }
    return bits;
  };
  for (const bool refined : {false, true}) {
    Placer first, second;
    Sampling sampling{.count = 48, .refined = refined, .side = 48, .surfacePoints = 256};
    GpuScene another;
    EXPECT_EQ(bitsOf(first.measure(gpu(), scene, sampling, {})), bitsOf(second.measure(another, scene, sampling, {})));
  }
}

TEST_F(CandidateTest, WhatWasMeasuredIsKept) {
  const Grid grid = gridOf({24, 24, 24});
  Scene scene = labelScene(grid, [&](glm::ivec3 index) { return lobes(grid, index); });
  Placer placer;
  Options options;
  const Candidate* kept = placer.measure(gpu(), scene, {}, options).candidates.data();
  options.weights.coverage = 3.0;
  options.region = Region::Stream;
  EXPECT_EQ(placer.measure(gpu(), scene, {}, options).candidates.data(), kept);
  EXPECT_EQ(placer.measure(gpu(), scene, {48}, options).spread, 48u);
  EXPECT_THROW(placer.measure(gpu(), scene, {100}, options), std::invalid_argument);
}

}  // namespace
}  // namespace fenestra::placement
