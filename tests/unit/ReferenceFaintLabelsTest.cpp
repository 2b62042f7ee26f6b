// Translucent labels against closed forms.

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

/// Transmittance of the label's slab, of which a ray passes `length`.
double through(double opacity, double length, double of = extinction) {
  return 1.0 + opacity * std::expm1(-of * length);
}

// The tolerance is that of the integral, 1e-12, and of rounding.
TEST(ReferenceFaintLabels, ASlabShowsItsOpacityOfItself) {
  Scene scene = slab();
  for (const double opacity : {1.0, 0.6, 0.3, 1e-3}) {
    scene.look.labels.clear();
    put(scene.look.labels, {.label = 1, .opacity = opacity});
    const double expected = 1.0 - std::exp(-extinction * beside) * through(opacity, labelled);
    const glm::dvec4 found = onePixel(scene);
    EXPECT_NEAR(found.a, expected, 2e-12) << opacity;
    EXPECT_NEAR(found.r, red.r * expected, 2e-12) << opacity;
  }
}

TEST(ReferenceFaintLabels, AnOpaqueBodyHasTheOpacityThatIsAskedForHoweverThickItIs) {
  for (const int last : {7, 8, 13, 19})
    for (const double opacity : {0.1, 0.4, 0.8}) {
      Scene scene = slab();
      scene.volume = volumeOf(scene.volume->grid, [&](glm::ivec3 i) { return i.x >= 6 && i.x <= last ? 7.0 : 0.0; });
      scene.labels = labelsOf(scene.volume->grid, [&](glm::ivec3 i) { return i.x >= 6 && i.x <= last ? 1 : 0; });
      scene.look.context.function = {{{3.5, {red, 0.0}}, {3.5, {red, 60.0}}}};
      put(scene.look.labels, {.label = 1, .opacity = opacity});
      EXPECT_NEAR(onePixel(scene).a, opacity, 1e-12) << last;
      scene.look.focus = LabelFocus{{1}};
      scene.look.cutaway.enabled = false;
      scene.look.focusAppearance.extinction = 60.0;
      EXPECT_NEAR(onePixel(scene).a, opacity, 1e-12) << last << ", in focus";
    }
}

TEST(ReferenceFaintLabels, WhatIsBehindABodyIsBehindItOnce) {
  // Two slabs of the label with a voxel between them, and one slab of two labels.
  Scene apart = slab(), touching = slab();
  apart.labels = labelsOf(apart.volume->grid, [](glm::ivec3 i) { return i.x >= 6 && i.x <= 13 && i.x != 9 ? 1 : 0; });
  touching.labels = labelsOf(apart.volume->grid, [](glm::ivec3 i) { return i.x >= 6 && i.x <= 13 ? 1 + i.x / 10 : 0; });
  for (Scene* scene : {&apart, &touching})
    for (const std::uint16_t label : {1, 2}) put(scene->look.labels, {.label = label, .opacity = 0.3});
  EXPECT_NEAR(onePixel(apart).a, 1.0 - std::exp(-extinction * (beside + 1.0)) * through(0.3, 3.0) * through(0.3, 4.0),
              2e-12);
  EXPECT_NEAR(onePixel(touching).a, 1.0 - std::exp(-extinction * beside) * through(0.3, 4.0) * through(0.3, 4.0),
              2e-12);
}

TEST(ReferenceFaintLabels, TheNearestVoxelTellsTheLabelOnAnyRay) {
  Scene scene = slab();
  put(scene.look.labels, {.label = 1, .opacity = 0.3});
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
      const double transmittance = std::exp(-extinction * (span->tOut - span->tIn - within)) * through(0.3, within);
      EXPECT_NEAR(found.final[static_cast<std::size_t>(j * size.x + i)].a, 1.0 - transmittance, 2e-11);
      met += within > 0.1;
    }
  EXPECT_GT(met, 50);
}

TEST(ReferenceFaintLabels, ACreviceNarrowerThanAVoxelEndsABodyInPart) {
  // Rays at an angle cross a corner of the voxel without the label, for less than a voxel: g mm of it.
  Scene scene;
  scene.volume = volumeOf(gridOf({20, 20, 5}), [](glm::ivec3) { return 7.0; });
  scene.labels = labelsOf(scene.volume->grid, [](glm::ivec3 i) { return i.x != 9 || i.y != 9 ? 1 : 0; });
  scene.look.context.function = {{{0.0, {red, extinction}}}};
  scene.look.shading.enabled = false;
  put(scene.look.labels, {.label = 1, .opacity = 0.3});
  PictureOptions options;
  options.tolerance = 1e-12;
  for (const double aside : {0.1, 0.3, 0.45}) {
    // Through (9 - aside, 9 + aside) along (1, 1): 2 (½ - aside) √2 mm of the voxel.
    const glm::dvec3 middle(9.0 - aside, 9.0 + aside, 2.0), direction = glm::normalize(glm::dvec3(1.0, 1.0, 0.0));
    const Camera camera = lookAt(middle - 100.0 * direction, middle, Projection::Orthographic, 1.0);
    const double a = picture(scene, camera, {1, 1}, options).focusLayer[0].a;
    const auto span = clip(pixelRay(camera, {1, 1}, {0, 0}), scene.volume->grid);
    ASSERT_TRUE(span);
    const double gap = 2.0 * std::sqrt(2.0) * (0.5 - aside), t = 100.0;
    const double first = t - 0.5 * gap - span->tIn, second = span->tOut - t - 0.5 * gap;
    const double before = -std::expm1(-extinction * first), left = before * (1.0 - std::min(gap, 1.0));
    const double behind = 1.0 - (1.0 - left) * std::exp(-extinction * second);
    const double transmittance =
        (1.0 - 0.3 * before) * std::exp(-extinction * gap) * (1.0 - 0.3 * behind) / (1.0 - 0.3 * left);
    EXPECT_NEAR(a, 1.0 - transmittance, 2e-11) << aside;
  }
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

TEST(ReferenceFaintLabels, HitsAreWhereTheLabelBeginsToShow) {
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
  EXPECT_NEAR(onePixel(scene).a,
              1.0 - std::exp(-extinction * beside) * through(0.3, labelled, scene.look.focusAppearance.extinction),
              2e-12);
}

}  // namespace
}  // namespace fenestra::reference::referenceFaintLabelsTest
