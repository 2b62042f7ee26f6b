// Cones on the focus in the reference: closed forms over points, discs and bowls, and a search of all pixels.

#include <cmath>

#include <gtest/gtest.h>

#include "rendering/reference/Picture.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference::referenceConesTest {
namespace {

using namespace tests;

constexpr glm::ivec2 size{41, 37};
constexpr double far = 1e6;  ///< behind everything

std::size_t at(int i, int j) { return static_cast<std::size_t>(j * size.x + i); }

/// Hits on a context at a view depth of `context`, and on a focus at depthOf(pixel), NaN for none, as times.
template <class DepthOf>
HitPoints hitsOn(const Camera& camera, double context, DepthOf&& depthOf) {
  HitPoints hits;
  const glm::dvec3 forward = camera.axes().forward;
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i) {
      const double perTime = glm::dot(pixelRay(camera, size, {i, j}).direction, forward);
      hits.tContext.push_back(context / perTime);
      hits.tFocus.push_back(depthOf(i, j) / perTime);
      hits.tOut.push_back(far);
    }
  return hits;
}

double depthAt(const Camera& camera, const Image& times, int i, int j) {
  return times[at(i, j)] * glm::dot(pixelRay(camera, size, {i, j}).direction, camera.axes().forward);
}

Camera parallel(double height) { return lookAt({0, 0, 0}, {0, 1, 0}, Projection::Orthographic, height); }
Camera pinhole() { return lookAt({0, 0, 0}, {0, 1, 0}); }
/// mm from one pixel to the next at a depth of 1 mm.
double pitch(const Camera& camera) { return 2.0 * std::tan(0.5 * glm::radians(camera.verticalFov)) / size.y; }

TEST(ReferenceCones, APointHasOneCone) {
  const Camera camera = parallel(74.0);  // 2 mm a pixel
  const HitPoints hits = hitsOn(camera, 10.0, [](int i, int j) { return i == 20 && j == 15 ? 60.0 : nan; });
  const double slope = 1.5;
  const Image start = coneStart(hits, camera, size, slope, false);
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i) {
      const double aside = 2.0 * std::hypot(i - 20, j - 15);
      EXPECT_NEAR(start[at(i, j)], std::max(10.0, 60.0 - slope * aside), 1e-12);
    }
}

TEST(ReferenceCones, APointInPerspectiveHasAConeAboutItsRay) {
  // Where the ray leaves the cone, its distance from the axis, in the plane of that depth, is the cone's radius there.
  const Camera camera = pinhole();
  const double apex = 80.0, slope = 1.7;
  const HitPoints hits = hitsOn(camera, 1e-3, [&](int i, int j) { return i == 8 && j == 30 ? apex : nan; });
  const Image start = coneStart(hits, camera, size, slope, false);
  const Ray axis = pixelRay(camera, size, {8, 30});
  const glm::dvec3 forward = camera.axes().forward;
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i) {
      const Ray ray = pixelRay(camera, size, {i, j});
      const glm::dvec3 point = ray.origin + start[at(i, j)] * ray.direction;
      const double depth = glm::dot(point, forward);
      const glm::dvec3 onAxis = axis.direction * (depth / glm::dot(axis.direction, forward));
      EXPECT_NEAR(glm::distance(point, onAxis), (apex - depth) / slope, 1e-11);
    }
}

TEST(ReferenceCones, ADiscHasAConeAroundItsRim) {
  // All points of the focus have one depth, so the cone of the nearest one is the last that a ray leaves.
  const auto disc = [](int i, int j) { return std::hypot(i - 22, j - 17) < 6.5 ? 50.0 : nan; };
  for (const Camera& camera : {parallel(37.0), pinhole()}) {
    const bool perspective = camera.projection == Projection::Perspective;
    const HitPoints hits = hitsOn(camera, 0.1, disc);
    const Image distance = distanceMap(hits.tFocus, size, infinity);
    for (const bool onSilhouette : {false, true}) {
      const Image start = coneStart(hits, camera, size, 2.0, onSilhouette);
      for (int j = 0; j < size.y; ++j)
        for (int i = 0; i < size.x; ++i) {
          const double pixels = distance[at(i, j)];
          const double expected = perspective ? 50.0 / (1.0 + 2.0 * pitch(camera) * pixels) : 50.0 - 2.0 * pixels;
          EXPECT_NEAR(depthAt(camera, start, i, j), std::max(0.1, expected), 1e-11) << i << ", " << j;
        }
    }
  }
}

TEST(ReferenceCones, OfABowlTheSilhouettesConesAreTheRims) {
  // Deepest in the middle, steeper than the cones: those of the middle reach beyond the rim's.
  const auto bowl = [](int i, int j) {
    const double r = std::hypot(i - 20, j - 18);
    return r < 8.5 ? 90.0 - 5.0 * r : nan;
  };
  const Camera camera = parallel(37.0);
  const HitPoints hits = hitsOn(camera, 0.0, bowl);
  const Image all = coneStart(hits, camera, size, 2.0, false), rim = coneStart(hits, camera, size, 2.0, true);
  for (int i = 29; i < size.x; ++i) {
    EXPECT_NEAR(all[at(i, 18)], 90.0 - 2.0 * (i - 20), 1e-12);
    EXPECT_NEAR(rim[at(i, 18)], 50.0 - 2.0 * (i - 28), 1e-12);
  }
  EXPECT_NEAR(all[at(20, 18)], 90.0, 1e-12) << "the focus itself";
  EXPECT_NEAR(all[at(28, 18)], 50.0, 1e-12) << "is never removed";
}

TEST(ReferenceCones, IsTheGreatestOfAllConesOverAnyFocus) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> depth(20.0, 90.0);
  std::bernoulli_distribution known(0.1);
  for (const Camera& camera : {parallel(50.0), pinhole()})
    for (const bool onSilhouette : {false, true}) {
      std::vector<double> depths;
      for (std::size_t i = 0; i < at(0, size.y); ++i) depths.push_back(known(random) ? depth(random) : nan);
      for (int j = 20; j < 30; ++j)
        for (int i = 5; i < 18; ++i) depths[at(i, j)] = depth(random);
      const HitPoints hits = hitsOn(camera, 5.0, [&](int i, int j) { return depths[at(i, j)]; });
      const Image start = coneStart(hits, camera, size, 1.2, onSilhouette);
      const bool perspective = camera.projection == Projection::Perspective;
      const auto isNothing = [&](int i, int j) {
        return i >= 0 && j >= 0 && i < size.x && j < size.y && std::isnan(depths[at(i, j)]);
      };
      for (int j = 0; j < size.y; ++j)
        for (int i = 0; i < size.x; ++i) {
          double deepest = 5.0;
          for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
              if (std::isnan(depths[at(x, y)])) continue;
              const bool isRim =
                  isNothing(x + 1, y) || isNothing(x - 1, y) || isNothing(x, y + 1) || isNothing(x, y - 1);
              if (onSilhouette && !isRim) continue;
              const double aside = std::hypot(x - i, y - j), z = depths[at(x, y)];
              deepest = std::max(
                  deepest, perspective ? z / (1.0 + 1.2 * pitch(camera) * aside) : z - 1.2 * 50.0 / size.y * aside);
            }
          const double expected = std::isnan(depths[at(i, j)]) ? deepest : depths[at(i, j)];
          EXPECT_NEAR(depthAt(camera, start, i, j), expected, 1e-11) << i << ", " << j;
        }
    }
}

TEST(ReferenceCones, StayBetweenTheContextAndTheBox) {
  const Camera camera = parallel(37.0);
  HitPoints hits = hitsOn(camera, 10.0, [](int i, int j) { return i == 20 && j == 15 ? 60.0 : nan; });
  hits.tOut.assign(hits.tOut.size(), 40.0);
  hits.tOut[at(20, 15)] = 60.0;
  hits.tContext[at(3, 3)] = nan;
  const Image start = coneStart(hits, camera, size, 1.0, false);
  EXPECT_EQ(start[at(21, 15)], 40.0);
  EXPECT_EQ(start[at(20, 15)], 60.0);
  EXPECT_TRUE(std::isnan(start[at(3, 3)]));
  hits.tFocus.assign(hits.tFocus.size(), nan);
  for (const double t : coneStart(hits, camera, size, 1.0, false)) EXPECT_TRUE(std::isnan(t) || t == 10.0);
}

TEST(ReferenceCones, TheBorderRunsAroundWhatTheyOpen) {
  // A point 20 mm deep under a flat context, cones of 45°: a round opening of 20 pixels of 1 mm.
  Scene scene = labelScene(gridOf({41, 41, 41}), [](glm::ivec3 i) { return i == glm::ivec3(20); });
  scene.look.context.function = opaqueFrom(-1.0);
  scene.look.method = methods::Cone{.angle = 45.0};
  scene.look.cutaway.openWidth = 500.0;
  scene.look.cutaway.borderWidth = 3.0;
  const Camera camera = lookAt({20.0, -100.0, 20.0}, {20.0, 0.0, 20.0}, Projection::Orthographic, 41.0);
  const Stages stages = geometricStages(scene, camera, {41, 41});
  EXPECT_TRUE(stages.tFocusFilled.empty());
  // The box begins half a voxel before the first one; the focus's surface is half a voxel before its own.
  for (int d = 0; d <= 20; ++d) {
    const std::size_t i = static_cast<std::size_t>(20 * 41 + 20 + d);
    EXPECT_NEAR(stages.tStart[i], d == 20 ? 99.5 : 119.5 - d, 1e-9) << d;
    EXPECT_EQ(stages.distance[i], d == 20 ? 1.0 : 0.0) << d;
  }
}

TEST(ReferenceCones, FaintIsAShareOfWhatIsRemoved) {
  // An even medium before a slab of focus: Beer's law for what is removed, and its share over the focus.
  const double extinction = 0.05;
  const glm::dvec3 colour(0.9, 0.5, 0.2);
  Scene scene = labelScene(gridOf({20, 40, 20}), [](glm::ivec3 i) { return i.y >= 20 ? 1 : 0; });
  scene.look.context.function = {{{-1.0, {colour, extinction}}, {1.0, {colour, extinction}}}};
  scene.look.focusAppearance = {{0.2, 0.3, 0.9}, 100.0, {}};
  scene.look.contextLayer.strength = scene.look.cutaway.borderWidth = 0.0;
  scene.look.shading.enabled = false;
  const Camera camera = Camera::standard(StandardView::Anterior, scene.volume->grid, Projection::Orthographic);
  Camera close = camera;
  close.orthographicHeight = 8.0;
  scene.look.method = methods::Importance{.mode = ImportanceMode::Average, .opacity = 0.3};
  // Hit points take an extinction of more than 1/255 over 1 mm for context: from the box's face, y = -½, to the
  // focus's surface, y = 19.5.
  const double opacity = 0.3 * -std::expm1(-extinction * 20.0);
  const Picture picture = reference::picture(scene, close, {8, 8});
  for (std::size_t i = 0; i < 64; ++i) {
    const glm::dvec3 expected = opacity * colour + (1.0 - opacity) * glm::dvec3(picture.focusLayer[i]);
    EXPECT_LT(glm::distance(glm::dvec3(picture.final[i]), expected), 1e-5);
    EXPECT_GT(picture.focusLayer[i].a, 0.999);
  }
  scene.look.method.of<methods::Importance>().sparseness = Sparseness::Colour;
  const glm::dvec4 grey = reference::picture(scene, close, {8, 8}).final[27];
  const double luminance = 0.2126 * colour.r + 0.7152 * colour.g + 0.0722 * colour.b;
  EXPECT_LT(glm::distance(glm::dvec3(grey),
                          opacity * glm::dvec3(luminance) + (1.0 - opacity) * glm::dvec3(picture.focusLayer[27])),
            1e-5);
  scene.look.method.of<methods::Importance>().sparseness = Sparseness::ScreenDoor;
  const Picture dotted = reference::picture(scene, close, {8, 8});
  int shown = 0;
  for (std::size_t i = 0; i < 64; ++i) shown += glm::distance(dotted.final[i], dotted.focusLayer[i]) > 0.1;
  EXPECT_EQ(shown, 19) << "0.3 of 64 pixels";
}

}  // namespace
}  // namespace fenestra::reference::referenceConesTest
