// Labels of the context at an opacity of their own, against closed forms.

#include <gtest/gtest.h>

#include "rendering/reference/Picture.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference::referenceFaintLabelsTest {
namespace {

using namespace tests;

const glm::dvec3 red(0.9, 0.2, 0.1);
constexpr double extinction = 0.05;

/// An even medium, unlit, with a slab of label 1 from voxel 6 to 13 along x: from 5.5 to 13.5.
Scene slab() {
  Scene scene;
  scene.volume = volumeOf(gridOf({20, 5, 5}), [](glm::ivec3) { return 7.0; });
  scene.labels = labelsOf(scene.volume->grid, [](glm::ivec3 i) { return i.x >= 6 && i.x <= 13 ? 1 : 0; });
  scene.look.context.function = {{{0.0, {red, extinction}}}};
  scene.look.shading.enabled = false;
  return scene;
}

constexpr double labelled = 8.0, beside = 12.0;  // mm

glm::dvec4 onePixel(const Scene& scene) {
  const glm::dvec3 centre = scene.volume->grid.centre();
  PictureOptions options;
  options.tolerance = 1e-12;
  return picture(scene, lookAt(centre - glm::dvec3(100.0, 0.0, 0.0), centre, Projection::Orthographic, 1.0), {1, 1},
                 options)
      .focusLayer[0];
}

// The tolerance is that of the integral, 1e-12, and of rounding.
TEST(ReferenceFaintLabels, ASlabFollowsBeerAndLambert) {
  Scene scene = slab();
  for (const double opacity : {1.0, 0.6, 0.3, 1e-3}) {
    scene.look.labels.clear();
    put(scene.look.labels, {.label = 1, .opacity = opacity});
    // 10 mm of the label have that share of their opacity.
    const double faint = -std::log1p(-opacity * -std::expm1(-10.0 * extinction)) / 10.0;
    const double expected = -std::expm1(-(extinction * beside + faint * labelled));
    const glm::dvec4 found = onePixel(scene);
    EXPECT_NEAR(found.a, expected, 2e-12) << opacity;
    EXPECT_NEAR(found.r, red.r * expected, 2e-12) << opacity;
  }
}

TEST(ReferenceFaintLabels, TheNearestVoxelTellsTheFunctionOnAnyRay) {
  Scene scene = slab();
  put(scene.look.labels, {.label = 1, .opacity = 0.3});
  const double faint = opticalExtinction(extinction, 0.3);
  const Camera camera = Camera::fromAngles(25.0, 15.0, scene.volume->grid);
  const glm::ivec2 size(31, 29);
  PictureOptions options;
  options.tolerance = 1e-11;
  const Picture found = picture(scene, camera, size, options);
  int met = 0;
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i) {
      const Ray ray = pixelRay(camera, size, {i, j});
      const auto span = clip(ray, scene.volume->grid);
      if (!span) continue;
      // The grid's axes are the world's: where the ray is between the planes x = 5.5 and x = 13.5.
      const double one = (5.5 - ray.origin.x) / ray.direction.x, other = (13.5 - ray.origin.x) / ray.direction.x;
      const double within =
          std::max(0.0, std::min(span->tOut, std::max(one, other)) - std::max(span->tIn, std::min(one, other)));
      const double depth = extinction * (span->tOut - span->tIn - within) + faint * within;
      EXPECT_NEAR(found.final[static_cast<std::size_t>(j * size.x + i)].a, -std::expm1(-depth), 2e-11);
      met += within > 0.1;
    }
  EXPECT_GT(met, 50);
}

TEST(ReferenceFaintLabels, OpacityZeroIsHidden) {
  Scene faint = slab(), hidden = slab();
  for (Scene* scene : {&faint, &hidden}) {
    scene->volume = volumeOf(scene->volume->grid, [](glm::ivec3 i) { return i.x == 0 ? 0.0 : 7.0; });
    scene->look.context.function = {{{0.0, {red, 0.0}}, {7.0, {red, extinction}}}};
  }
  put(faint.look.labels, {.label = 1, .opacity = 0.0});
  put(hidden.look.labels, {.label = 1, .role = LabelRole::Hidden});
  EXPECT_EQ(onePixel(faint), onePixel(hidden));
  EXPECT_LT(onePixel(faint).a, onePixel(slab()).a);
}

TEST(ReferenceFaintLabels, HitsAreWhereTheFaintFunctionBegins) {
  // Extinction 0.002/mm is no context, and a tenth of 0.02/mm is not, either: the label is met at x = 5.8 as long as it
  // is as opaque as the rest, and the medium behind it at 13.5 otherwise.
  Scene scene = slab();
  scene.volume = volumeOf(scene.volume->grid, [](glm::ivec3 i) { return i.x < 6 ? 0.0 : 7.0; });
  scene.look.context.function = {{{0.0, {red, 0.002}}, {5.6, {red, 0.002}}, {5.6, {red, 0.02}}}};
  const glm::dvec3 centre = scene.volume->grid.centre();
  const Camera camera = lookAt(centre - glm::dvec3(100.0, 0.0, 0.0), centre, Projection::Orthographic, 1.0);
  const auto hitAt = [&] {
    const double t = hitPoints(scene, camera, {1, 1}).tContext[0];
    return centre.x - 100.0 + t;
  };
  EXPECT_NEAR(hitAt(), 5.8, 1e-9);
  put(scene.look.labels, {.label = 1, .opacity = 0.1});
  EXPECT_NEAR(hitAt(), 13.5, 1e-9);
  put(scene.look.labels, {.label = 1, .opacity = 0.5});
  EXPECT_NEAR(hitAt(), 5.8, 1e-9);
}

TEST(ReferenceFaintLabels, ALabelInFocusIsNotOfTheContext) {
  Scene scene = slab();
  scene.look.focus = LabelFocus{{1}};
  scene.look.cutaway.enabled = false;
  put(scene.look.labels, {.label = 1, .opacity = 0.3});
  const double focus = opticalExtinction(scene.look.focusAppearance.extinction, 0.3);
  EXPECT_NEAR(onePixel(scene).a, -std::expm1(-(extinction * beside + focus * labelled)), 2e-12);
}

}  // namespace
}  // namespace fenestra::reference::referenceFaintLabelsTest
