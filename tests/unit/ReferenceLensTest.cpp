// ClearView's lens in the reference against closed forms: a plane before a ball, where nothing bends, and a ball whose
// bends are known.

#include "rendering/reference/Lens.h"

#include <gtest/gtest.h>

#include "rendering/reference/Picture.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference::referenceLensTest {
namespace {

using namespace tests;

constexpr glm::ivec2 size{45, 45};
constexpr double pixel = 0.6;  // mm
const glm::dvec3 middle{20.0, 25.0, 20.0};

/// Seen along y, with parallel rays.
Camera parallel() { return lookAt({20.0, -100.0, 20.0}, middle, Projection::Orthographic, size.y * pixel); }

/// Where the ray of a pixel runs through the picture.
glm::dvec3 onPlane(std::size_t i, double y) {
  const Ray ray = pixelRay(parallel(), size, {static_cast<int>(i) % size.x, static_cast<int>(i) / size.x});
  return {ray.origin.x, y, ray.origin.z};
}

/// The lens's middle, where the line of sight to the ball's middle meets the plane.
const glm::dvec3 before{20.0, 8.0, 20.0};

/// A half-space of haze that begins at y = 8, before a ball of focus.
Scene planeBeforeBall() {
  const Grid grid = gridOf({41, 46, 41});
  Scene scene;
  scene.volume = volumeOf<float>(grid, [](glm::ivec3 i) { return i.y; });
  scene.labels = labelsOf(grid, [](glm::ivec3 i) { return glm::distance(glm::dvec3(i), middle) < 6.2 ? 1 : 0; });
  scene.look.focus = LabelFocus{{1}};
  const glm::dvec3 colour(0.9, 0.6, 0.3);
  scene.look.context.function = {{{8.0, {colour, 0.0}}, {8.0, {colour, 0.06}}, {50.0, {colour, 0.06}}}};
  scene.look.focusAppearance = {{0.2, 0.3, 0.9}, 100.0, {}};
  scene.look.contextLayer.strength = 0.0;
  scene.look.shading.enabled = false;
  scene.look.method.kind = kindOf<methods::ClearView>;
  return scene;
}

TEST(ReferenceLens, OverAPlaneItMixesByTheDistance) {
  Scene scene = planeBeforeBall(), closed = scene;
  closed.look.cutaway.enabled = false;
  const Picture plain = picture(closed, parallel(), size);
  for (const double radius : {12.0, 18.2, 30.0}) {
    scene.look.method.of<methods::ClearView>().radius = radius;
    const Picture here = picture(scene, parallel(), size);
    const double mm = 0.01 * radius * 46.0;  // of the longest side
    int mixed = 0, onLine = 0;
    for (std::size_t i = 0; i < plain.final.size(); ++i) {
      const double d = glm::distance(onPlane(i, 8.0), before) / mm, w = std::min(d, 1.0);
      const glm::dvec4 mix = w * plain.final[i] + (1.0 - w) * here.focusLayer[i];
      const double line = 0.5 * std::max(1.0 - 60.0 * std::abs(d - 1.0), 0.0);
      const glm::dvec4 expected(glm::max(glm::dvec3(mix) - mix.a * line, 0.0), mix.a);
      // Two integrals of tolerance 1e-5 each.
      EXPECT_LT(glm::distance(here.final[i], expected), 4e-5) << "pixel " << i << ", radius " << radius;
      EXPECT_NEAR(here.lens[i].w, d * mm, 1e-9);
      EXPECT_LT(glm::distance(glm::dvec3(here.lens[i]), glm::dvec3(0.0, 0.0, 1.0)), 1e-12) << "away from the eye";
      mixed += w < 0.95 && here.focusLayer[i].b > 0.8;
      onLine += line > 0.25;
    }
    EXPECT_GT(mixed, 100) << radius;
    EXPECT_GT(onLine, 3) << radius;
  }
}

TEST(ReferenceLens, LiesOverTheCrosshair) {
  Scene scene = planeBeforeBall();
  PictureOptions aside;
  aside.slices.crosshair = glm::dvec3(23.0, 30.0, 18.0);
  const Picture overFocus = picture(scene, parallel(), size, aside);
  scene.look.method.of<methods::ClearView>().place = LensPlace::OverCrosshair;
  const Picture overCrosshair = picture(scene, parallel(), size, aside), unset = picture(scene, parallel(), size);
  for (std::size_t i = 0; i < unset.lens.size(); ++i) {
    EXPECT_NEAR(overFocus.lens[i].w, glm::distance(onPlane(i, 8.0), before), 1e-9);
    EXPECT_NEAR(overCrosshair.lens[i].w, glm::distance(onPlane(i, 8.0), {23.0, 8.0, 18.0}), 1e-9);
    EXPECT_EQ(unset.lens[i].w, overFocus.lens[i].w) << "without a crosshair it stays over the focus";
  }
}

TEST(ReferenceLens, KeepsTheContextBesideTheFocus) {
  Scene scene = planeBeforeBall(), closed = scene;
  closed.look.cutaway.enabled = false;
  scene.look.method.of<methods::ClearView>().radius = 100.0;  // no line in the picture
  for (const LensFade fade : {LensFade::Distance, LensFade::Curvature, LensFade::Depth}) {
    scene.look.method.of<methods::ClearView>().fade = fade;
    const Picture here = picture(scene, parallel(), size), plain = picture(closed, parallel(), size);
    const HitPoints hits = hitPoints(scene, parallel(), size);
    for (std::size_t i = 0; i < plain.final.size(); ++i) {
      if (!std::isnan(hits.tFocus[i])) continue;
      // Both are one integral of tolerance 1e-5.
      EXPECT_LT(glm::distance(here.final[i], plain.final[i]), 2e-5) << i;
    }
  }
}

TEST(ReferenceLens, OtherFadesKeepTheirOwn) {
  Scene scene = planeBeforeBall();
  scene.look.method.of<methods::ClearView>().radius = 40.0;
  const HitPoints hits = hitPoints(scene, parallel(), size);
  std::vector<glm::ivec2> pixels;
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i) pixels.emplace_back(i, j);
  scene.look.method.of<methods::ClearView>().fade = LensFade::Curvature;
  const std::vector<LensPoint> bends = lensPoints(scene, parallel(), size, hits, pixels);
  scene.look.method.of<methods::ClearView>().fade = LensFade::Depth;
  const std::vector<LensPoint> depths = lensPoints(scene, parallel(), size, hits, pixels);
  int within = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const double d = glm::distance(onPlane(i, 8.0), before) / 18.4;
    const double deep = std::isnan(hits.tFocus[i]) ? 1.0 : std::min((hits.tFocus[i] - hits.tContext[i]) / 18.4, 1.0);
    EXPECT_NEAR(bends[i].share, d < 1.0 ? 0.0 : 1.0, 1e-12) << i;
    EXPECT_NEAR(depths[i].share, d < 1.0 ? deep : 1.0, 1e-12) << i;
    within += d < 1.0 && deep < 1.0;
  }
  EXPECT_GT(within, 200);
}

TEST(ReferenceLens, BendsOfABallAreThoseOfItsNormals) {
  // Values fall with the distance from the middle; the context is a ball of radius 14 around a small focus.
  const Grid grid = gridOf({41, 51, 41});
  Scene scene;
  scene.volume = volumeOf<float>(grid, [](glm::ivec3 i) { return 100.0 - glm::distance(glm::dvec3(i), middle); });
  scene.labels = labelsOf(grid, [](glm::ivec3 i) { return glm::distance(glm::dvec3(i), middle) < 4.0 ? 1 : 0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = opaqueFrom(86.0);
  scene.look.method.kind = kindOf<methods::ClearView>;
  scene.look.method.of<methods::ClearView>().fade = LensFade::Curvature;
  scene.look.method.of<methods::ClearView>().radius = 100.0;
  const HitPoints hits = hitPoints(scene, parallel(), size);
  std::vector<glm::ivec2> pixels;
  for (int j = 12; j < 33; ++j)
    for (int i = 12; i < 33; ++i) pixels.emplace_back(i, j);
  // Towards higher values: to the middle, along the view's right, up and forward.
  const auto normal = [&](glm::ivec2 at) {
    const glm::dvec2 aside = pixel * (glm::dvec2(at) + 0.5 - 0.5 * glm::dvec2(size));
    const double deep = std::sqrt(14.0 * 14.0 - glm::dot(aside, aside));
    return glm::dvec3(-aside.x, aside.y, deep) / 14.0;
  };
  for (const double scale : {1.0, 3.0}) {
    scene.look.method.of<methods::ClearView>().bends = scale;
    const std::vector<LensPoint> points = lensPoints(scene, parallel(), size, hits, pixels);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      glm::dvec3 sum(0.0);
      for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)})
        sum += glm::abs(normal(pixels[i] + step) - normal(pixels[i]));
      // The spline over the smoothed volume turns normals by some thousandths where the surface has a radius of 14 mm.
      EXPECT_LT(glm::distance(points[i].normal, normal(pixels[i])), 0.01) << i;
      EXPECT_NEAR(points[i].share, scale * glm::length(sum), 0.01 * scale) << i;
      EXPECT_GT(points[i].share, 0.1 * scale) << i;
    }
  }
}

TEST(ReferenceLens, LiesOnTheLineOfSightToTheFocus) {
  const Scene scene = planeBeforeBall();
  const std::vector<glm::ivec2> pixels{{5, 30}, {22, 22}, {40, 3}};
  for (const glm::dvec3 eye :
       {glm::dvec3(60.0, -70.0, 5.0), glm::dvec3(20.0, 5.0, 20.0), glm::dvec3(15.0, 40.0, 15.0)}) {
    // The last eye lies within the context: what it looks at begins there.
    const Camera camera = lookAt(eye, eye.y > 8.0 ? glm::dvec3(15.0, 90.0, 15.0) : glm::dvec3(24.0, 20.0, 18.0));
    const HitPoints hits = hitPoints(scene, camera, size);
    const std::vector<LensPoint> points = lensPoints(scene, camera, size, hits, pixels);
    const glm::dvec3 expected = eye.y > 8.0 ? middle : glm::mix(eye, middle, (8.0 - eye.y) / (middle.y - eye.y));
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      if (std::isnan(points[i].distance)) continue;
      const Ray ray = pixelRay(camera, size, pixels[i]);
      const double t = hits.tContext[static_cast<std::size_t>(pixels[i].y * size.x + pixels[i].x)];
      EXPECT_NEAR(points[i].distance, glm::distance(ray.origin + t * ray.direction, expected), 1e-9) << i;
    }
    EXPECT_FALSE(std::isnan(points[1].distance));
  }
}

TEST(ReferenceLens, HasNoSurfaceWhereTheScanBeginsOrTheFocusLiesBare) {
  Scene scene = planeBeforeBall();
  // The haze begins with the scan: a face, at a distance but without a normal of its own.
  scene.look.context.function.nodes.front().value = scene.look.context.function.nodes[1].value = -1.0;
  const std::vector<glm::ivec2> pixels{{32, 22}};
  LensPoint point = lensPoints(scene, parallel(), size, hitPoints(scene, parallel(), size), pixels)[0];
  EXPECT_EQ(point.normal, glm::dvec3(0.0));
  EXPECT_NEAR(point.distance, 10.0 * pixel, 1e-9) << "along the face";
  // No context at all.
  scene.look.context.function = opaqueFrom(1000.0);
  point = lensPoints(scene, parallel(), size, hitPoints(scene, parallel(), size), pixels)[0];
  EXPECT_TRUE(std::isnan(point.distance));
  EXPECT_EQ(point.share, 1.0);
  EXPECT_EQ(point.line, 0.0);
}

}  // namespace
}  // namespace fenestra::reference::referenceLensTest
