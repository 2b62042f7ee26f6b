// A focal region in the reference: distances and rays through its middle against closed forms, pictures against a sum
// of short steps.

#include "rendering/reference/FocalRegion.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "rendering/reference/Picture.h"
#include "rendering/scene/Fading.h"
#include "rendering/settings/SettingWords.h"
#include "tests/support/Scenes.h"
#include "tests/unit/FadingContexts.h"

namespace fenestra::reference::referenceFocalRegionTest {
namespace {

using namespace tests;

TEST(ReferenceFocalRegion, DistancesAreThoseToASphereAndACube) {
  const glm::dvec3 middle(10.0, -20.0, 30.0);
  const FocalRegion sphere({FocalShape::Sphere, 5.0, 8.0}, middle), box({FocalShape::Box, 5.0, 8.0}, middle);
  EXPECT_EQ(sphere.distance(middle), 0.0);
  EXPECT_EQ(sphere.distance(middle + glm::dvec3(3.0, 0.0, 4.0)), 0.0);
  EXPECT_EQ(sphere.distance(middle + glm::dvec3(6.0, 0.0, -8.0)), 5.0);
  EXPECT_EQ(box.distance(middle + glm::dvec3(4.9, -4.9, 4.9)), 0.0);
  EXPECT_EQ(box.distance(middle + glm::dvec3(4.0, -12.0, 1.0)), 7.0) << "beside a face";
  EXPECT_EQ(box.distance(middle + glm::dvec3(8.0, 0.0, -9.0)), 5.0) << "beside an edge";
  EXPECT_EQ(box.distance(middle + glm::dvec3(-7.0, 8.0, 11.0)), 7.0) << "beside a corner";
  EXPECT_EQ(sphere.shareAt(0.0), 1.0);
  EXPECT_EQ(sphere.shareAt(8.0), 0.5);
  EXPECT_EQ(sphere.shareAt(24.0), 0.125);
}

TEST(ReferenceFocalRegion, PathsAreCutAtItsBorder) {
  const glm::dvec3 middle(10.0, -20.0, 30.0);
  const auto crossings = [&](FocalShape shape, glm::dvec3 from, glm::dvec3 to) {
    std::vector<double> places;
    FocalRegion({shape, 5.0, 8.0}, middle).appendCrossings(middle + from, middle + to, places);
    std::sort(places.begin(), places.end());
    return places;
  };
  EXPECT_EQ(crossings(FocalShape::Sphere, {-10.0, 3.0, 0.0}, {10.0, 3.0, 0.0}), (std::vector<double>{0.3, 0.7}));
  EXPECT_EQ(crossings(FocalShape::Sphere, {-10.0, 3.0, 0.0}, {0.0, 3.0, 0.0}), (std::vector<double>{0.6}));
  EXPECT_TRUE(crossings(FocalShape::Sphere, {-10.0, 6.0, 0.0}, {10.0, 6.0, 0.0}).empty());
  EXPECT_TRUE(crossings(FocalShape::Sphere, {-1.0, 2.0, 0.0}, {1.0, 2.0, 0.0}).empty()) << "all inside";
  EXPECT_EQ(crossings(FocalShape::Box, {-10.0, 4.0, 0.0}, {10.0, 4.0, 0.0}), (std::vector<double>{0.25, 0.75}));
  EXPECT_EQ(crossings(FocalShape::Box, {0.0, 0.0, -20.0}, {0.0, 0.0, 0.0}), (std::vector<double>{0.75}));
}

constexpr glm::ivec2 size{9, 7};
constexpr double extinction = 0.15;
const glm::dvec3 colour(0.9, 0.6, 0.3);

/// Values that grow evenly, so that the gradient is 1 per mm everywhere; haze of one extinction, a ball in focus beside
/// the middle.
Scene evenRamp(const Method& method) {
  const Grid grid = gridOf({20, 30, 24});
  Scene scene;
  scene.volume = volumeOf<float>(grid, [](glm::ivec3 i) { return i.y; });
  scene.labels = labelsOf(
      grid, [](glm::ivec3 i) { return glm::distance(glm::dvec3(i), glm::dvec3(8.0, 18.0, 12.0)) < 2.2 ? 1 : 0; });
  scene.look.context.function = {{{-10.0, {colour, extinction}}, {200.0, {colour, extinction}}}};
  scene.look.focusAppearance = {{0.2, 0.3, 0.9}, 0.4, {}};
  scene.look.shading.enabled = false;
  scene.look.method = method;
  return scene;
}

Method regionOf(FocalShape shape, double radius, double fallOff) {
  return methods::FocalRegion{.shape = shape, .size = radius, .fallOff = fallOff};
}

/// Looks along an axis of the world at the middle of the volume; the picture's middle pixel has it in its centre.
Camera along(StandardView direction, const Scene& scene) {
  return Camera::standard(direction, scene.volume->grid, Projection::Orthographic);
}

/// Through the middle δ grows evenly on both sides: with the region's half length r and the way to the volume's border
/// R,
///
///   τ = 2 κ (r + g h/ln 2 · (1 - 2^(-(R - r)/h)))
TEST(ReferenceFocalRegion, ARayThroughTheMiddleHasAClosedForm) {
  for (const FocalShape shape : {FocalShape::Sphere, FocalShape::Box})
    for (const double radius : {0.5, 3.0, 7.0})
      for (const double fallOff : {0.4, 5.0, 1e5})
        for (const auto& [direction, axis] : {std::pair(StandardView::Anterior, 1), std::pair(StandardView::Right, 0),
                                              std::pair(StandardView::Superior, 2)}) {
          SCOPED_TRACE(testing::Message() << wordOf(shape).word << ", " << radius << ", " << fallOff << ", " << axis);
          const Scene scene = evenRamp(regionOf(shape, radius, fallOff));
          const Grid& grid = scene.volume->grid;
          const double slope = 1.0 / grid.spacing.y / steepestSlope(*scene.volume);
          const double border = 0.5 * grid.dims[axis] * grid.spacing[axis];
          const double outside =
              slope * fallOff / std::numbers::ln2 * -std::expm1(-(border - radius) / fallOff * std::numbers::ln2);
          const double opacity = -std::expm1(-2.0 * extinction * (radius + outside));
          const Picture here = picture(scene, along(direction, scene), size, {.tolerance = 1e-9, .pixels = {}});
          const glm::dvec4 found = here.final[here.final.size() / 2];
          EXPECT_NEAR(found.a, opacity, 2e-9);
          EXPECT_LT(glm::distance(glm::dvec3(found), opacity * colour), 4e-9);
        }
}

/// δ at a place in the world and in index coordinates.
using Outside = std::function<double(glm::dvec3 world, glm::dvec3 index)>;

Outside outsideAround(glm::dvec3 middle, const Method& method) {
  return [=](glm::dvec3 world, glm::dvec3) {
    const glm::dvec3 from = world - middle;
    if (method.of<methods::FocalRegion>().shape == FocalShape::Box)
      return glm::length(glm::max(glm::abs(from) - method.of<methods::FocalRegion>().size, glm::dvec3(0.0)));
    return std::max(glm::length(from) - method.of<methods::FocalRegion>().size, 0.0);
  };
}

/// Between voxels trilinear, at them by a search through all that have the label.
Outside outsideOfLabel(const Scene& scene, std::uint16_t label) {
  const Grid& grid = scene.volume->grid;
  std::vector<glm::dvec3> held;
  forEachVoxel(grid.dims, [&](glm::ivec3 voxel) {
    if (scene.labels->value(voxel) == label) held.push_back(glm::dvec3(voxel) * grid.spacing);
  });
  std::vector<double> distances(grid.voxelCount(), std::numeric_limits<double>::infinity());
  forEachVoxel(grid.dims, [&](glm::ivec3 voxel) {
    double& least = distances[grid.offset(voxel)];
    for (const glm::dvec3 each : held) least = std::min(least, glm::distance(each, glm::dvec3(voxel) * grid.spacing));
  });
  return [grid, distances, size = scene.look.method.of<methods::FocalRegion>().size](glm::dvec3, glm::dvec3 index) {
    return std::max(interpolated(grid, index, [&](glm::ivec3 voxel) { return distances[grid.offset(voxel)]; }) - size,
                    0.0);
  };
}

/// The sum of short steps along a ray, in the middle of each.
glm::dvec4 summed(const Scene& scene, const Camera& camera, glm::ivec2 pixel, const Outside& outsideAt, int count) {
  const Grid& grid = scene.volume->grid;
  const Ray ray = pixelRay(camera, size, pixel), inIndex = indexRay(ray, grid);
  const std::optional<Span> span = clip(ray, grid);
  glm::dvec4 sum(0.0);
  if (!span) return sum;
  const double step = (span->tOut - span->tIn) / count;
  for (int i = 0; i < count; ++i) {
    const double t = span->tIn + (i + 0.5) * step;
    const glm::dvec3 at = inIndex.origin + t * inIndex.direction;
    const double outside = outsideAt(ray.origin + t * ray.direction, at);
    double share = 1.0;
    if (outside > 0.0)
      share = std::min(glm::length(gradientAt(*scene.volume, at)) / steepestSlope(*scene.volume), 1.0) *
              std::pow(0.5, outside / scene.look.method.of<methods::FocalRegion>().fallOff);
    const double value = interpolated(grid, at, [&](glm::ivec3 voxel) { return scene.volume->value(voxel); });
    const OpticalProperties shown = scene.look.context.function.evaluate(value);
    sum += (1.0 - sum.a) * -std::expm1(-shown.extinction * share * step) * glm::dvec4(shown.colour, 1.0);
  }
  return sum;
}

TEST(ReferenceFocalRegion, PicturesAreTheLimitOfTheSum) {
  for (const FocalShape shape : {FocalShape::Sphere, FocalShape::Box}) {
    Scene scene = evenRamp(regionOf(shape, 5.0, 6.0));
    scene.volume = volumeOf<float>(scene.volume->grid, [](glm::ivec3 i) { return i.y * i.y + 3.0 * i.x * i.z; });
    scene.look.context.function = {{{-10.0, {colour, 0.1}}, {400.0, {glm::dvec3(0.2, 0.5, 0.9), 0.3}}}};
    const Camera camera = Camera::fromAngles(20.0, 15.0, scene.volume->grid, Projection::Perspective);
    const Picture here = picture(scene, camera, size);
    double greatest = 0.0;
    for (int j = 0; j < size.y; ++j)
      for (int i = 0; i < size.x; ++i) {
        const glm::dvec4 sum =
            summed(scene, camera, {i, j}, outsideAround(scene.volume->grid.centre(), scene.look.method), 20000);
        const glm::dvec4 found = here.final[static_cast<std::size_t>(j * size.x + i)];
        // The two steps of 2 µm at the border are half wrong: 0.3 · 2e-3; and the reference has a tolerance of 1e-5.
        EXPECT_LT(glm::distance(found, sum), 7e-4) << i << ", " << j;
        greatest = std::max(greatest, found.a);
      }
    EXPECT_GT(greatest, 0.5);
  }
}

/// The focus's box has its middle at the voxel (8, 18, 12).
TEST(ReferenceFocalRegion, LiesAroundTheMiddleOfTheFocus) {
  Scene scene = evenRamp(regionOf(FocalShape::Sphere, 4.0, 3.0));
  scene.look.focus = LabelFocus{{1}};
  const Grid& grid = scene.volume->grid;
  const glm::dvec3 middle(grid.worldFromIndex() * glm::dvec4(8.0, 18.0, 12.0, 1.0));
  EXPECT_LT(glm::distance(focusCentre(scene), middle), 1e-12);
  scene.look.focusAppearance = {colour, extinction, {}};
  const Camera camera = along(StandardView::Anterior, scene);
  const Picture here = picture(scene, camera, size);
  // With a focus as opaque as its surroundings, and inside the region, the sum knows no focus; labels have their
  // colours.
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i)
      EXPECT_NEAR(here.final[static_cast<std::size_t>(j * size.x + i)].a,
                  summed(scene, camera, {i, j}, outsideAround(middle, scene.look.method), 20000).a, 7e-4)
          << i << ", " << j;
}

/// The focus looks like its surroundings, so the sum leaves it out.
TEST(ReferenceFocalRegion, ByDistanceFollowsTheShapeOfTheFocus) {
  Scene scene = evenRamp(regionOf(FocalShape::Distance, 3.2, 4.0));
  scene.labels =
      labelsOf(scene.volume->grid, [](glm::ivec3 i) { return i.x / 2 == 4 && i.z / 2 == 6 && i.y > 6 ? 1 : 0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.focusAppearance = {colour, extinction, {}};
  const Outside outside = outsideOfLabel(scene, 1);
  for (const double azimuth : {0.0, 25.0, 90.0}) {
    const Camera camera = Camera::fromAngles(azimuth, 15.0, scene.volume->grid, Projection::Perspective);
    const Picture here = picture(scene, camera, size);
    for (int j = 0; j < size.y; ++j)
      for (int i = 0; i < size.x; ++i)
        EXPECT_NEAR(here.final[static_cast<std::size_t>(j * size.x + i)].a,
                    summed(scene, camera, {i, j}, outside, 20000).a, 7e-4)
            << azimuth << ", " << i << ", " << j;
  }
}

/// Beside a focus that fills one end of the volume δ grows evenly towards the other: with the region's end r behind the
/// last voxel's centre and L from there to the last centre of all, half a voxel h' before the border,
///
///   τ = κ (depth of the focus and region + g h/ln 2 · (1 - 2^(-(L - r)/h)) + g h' 2^(-(L - r)/h))
TEST(ReferenceFocalRegion, ByDistanceFromASlabHasAClosedForm) {
  for (const double radius : {0.5, 3.0, 7.0})
    for (const double fallOff : {0.4, 5.0, 1e5}) {
      SCOPED_TRACE(testing::Message() << radius << ", " << fallOff);
      Scene scene = evenRamp(regionOf(FocalShape::Distance, radius, fallOff));
      const Grid& grid = scene.volume->grid;
      scene.labels = labelsOf(grid, [](glm::ivec3 i) { return i.y < 10 ? 1 : 0; });
      scene.look.focus = LabelFocus{{1}};
      scene.look.focusAppearance = {colour, extinction, {}};
      const double slope = 1.0 / grid.spacing.y / steepestSlope(*scene.volume), half = 0.5 * grid.spacing.y;
      const double length = (grid.dims.y - 10) * grid.spacing.y, left = std::exp2(-(length - radius) / fallOff);
      const double outside = slope * (fallOff / std::numbers::ln2 * (1.0 - left) + half * left);
      const double inside = 9.0 * grid.spacing.y + half + radius;
      const Picture here =
          picture(scene, along(StandardView::Anterior, scene), size, {.tolerance = 1e-9, .pixels = {}});
      EXPECT_NEAR(here.final[here.final.size() / 2].a, -std::expm1(-extinction * (inside + outside)), 4e-9);
    }
}

TEST(ReferenceFocalRegion, WithEverythingInsideOrOffItIsPlainRendering) {
  for (const bool lit : {false, true})
    for (const FocalShape shape : {FocalShape::Sphere, FocalShape::Box}) {
      Scene scene = evenRamp(regionOf(shape, 6.0, 4.0));
      scene.look.shading.enabled = lit;
      const Camera camera = Camera::fromAngles(20.0, 15.0, scene.volume->grid);
      const Picture faded = picture(scene, camera, size);
      scene.look.method.of<methods::FocalRegion>().size = 1e5;
      const Picture inside = picture(scene, camera, size);
      scene.look.cutaway.enabled = false;
      const Picture plain = picture(scene, camera, size);
      double greatest = 0.0;
      for (std::size_t i = 0; i < plain.final.size(); ++i) {
        EXPECT_EQ(inside.final[i], plain.final[i]) << i;
        EXPECT_LE(faded.final[i].a, plain.final[i].a + 2e-5) << "what fades is never more opaque";
        greatest = std::max(greatest, plain.final[i].a - faded.final[i].a);
      }
      EXPECT_GT(greatest, 0.1) << "the test would notice";
    }
}

/// A context of one value has no gradient, and nothing of it shows outside; the focus does, also beyond the region.
TEST(ReferenceFocalRegion, TheFocusKeepsItsOpacity) {
  Scene scene = evenRamp(regionOf(FocalShape::Box, 0.1, 3.0));
  scene.volume = volumeOf<float>(scene.volume->grid, [](glm::ivec3 i) { return i == glm::ivec3(0) ? 1.0 : 0.0; });
  scene.look.focus = LabelFocus{{1}};
  const Camera camera = Camera::fromAngles(20.0, 15.0, scene.volume->grid);
  expectTheFocusAlone(scene, camera, size, 0.5);
}

TEST(ReferenceFocalRegion, TheEstimatedErrorKeepsToTheTolerance) {
  for (const FocalShape shape : {FocalShape::Sphere, FocalShape::Box}) {
    Scene scene = evenRamp(regionOf(shape, 4.0, 2.0));
    scene.volume = volumeOf<float>(scene.volume->grid, [](glm::ivec3 i) { return i.y * i.y + 3.0 * i.x * i.z; });
    scene.look.context.function = {{{-10.0, {colour, 0.1}}, {400.0, {glm::dvec3(0.2, 0.5, 0.9), 3.0}}}};
    scene.look.shading.enabled = true;
    scene.look.focus = LabelFocus{{1}};
    const Camera camera = Camera::fromAngles(20.0, 15.0, scene.volume->grid);
    expectErrorsWithinTheTolerance(scene, camera, size);
  }
}

}  // namespace
}  // namespace fenestra::reference::referenceFocalRegionTest
