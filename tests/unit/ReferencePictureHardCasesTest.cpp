// Stages 5 to 7 of the reference in the cases that break volume renderers, against what their pictures must be.

#include <functional>

#include <gtest/gtest.h>

#include "rendering/reference/Picture.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference::referencePictureHardCasesTest {
namespace {

using namespace tests;

const glm::dvec3 skin(0.9, 0.6, 0.4);

/// A ball of labels in a ball of falling values, in world space around `centre` whatever the grid.
Scene ballScene(const Grid& grid, double radius) {
  const glm::dvec3 centre = grid.centre();
  const auto distance = [&](glm::ivec3 i) {
    return glm::distance(glm::dvec3(grid.worldFromIndex() * glm::dvec4(i, 1.0)), centre);
  };
  Scene scene;
  scene.volume = volumeOf<float>(grid, [&](glm::ivec3 i) { return 1000.0 * (1.0 - distance(i) / radius); });
  scene.labels = labelsOf(grid, [&](glm::ivec3 i) { return distance(i) < 0.4 * radius ? 1 : 0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = {
      {{100.0, {skin, 0.0}}, {200.0, {skin, 0.4}}, {500.0, {glm::dvec3(0.7, 0.2, 0.2), 0.1}}}};
  scene.look.cutaway.openWidth = 4.0;
  return scene;
}

double greatestDifference(const Picture& a, const Picture& b) {
  double greatest = a.final.size() == b.final.size() ? 0.0 : infinity;
  for (std::size_t i = 0; i < a.final.size(); ++i)
    for (int channel = 0; channel < 4; ++channel) {
      const double difference = std::abs(a.final[i][channel] - b.final[i][channel]);
      greatest = std::isnan(difference) ? infinity : std::max(greatest, difference);
    }
  return greatest;
}

double shownPixels(const Picture& picture) {
  return static_cast<double>(
      std::count_if(picture.final.begin(), picture.final.end(), [](const glm::dvec4& pixel) { return pixel.a > 0.1; }));
}

/// Parallel rays towards the middle of the grid from `distance` mm away.
Picture fromAfar(const Scene& scene, double distance) {
  const glm::dvec3 centre = scene.volume->grid.centre(), towards = glm::normalize(glm::dvec3(0.4, -1.0, 0.3));
  const Camera camera = lookAt(centre + distance * towards, centre, Projection::Orthographic, 20.0);
  return picture(scene, camera, {25, 25});
}

TEST(ReferencePictureHardCases, aThousandKilometresAwayLooksTheSame) {
  const Scene scene = ballScene(gridOf({20, 20, 20}), 9.0);
  const Picture near = fromAfar(scene, 50.0);
  EXPECT_GT(shownPixels(near), 150);
  // Doubles at 1e6 mm are 1e-10 mm apart; where a ray grazes the focus that moves its start by the root of it, and both
  // pictures are good to 1e-5.
  EXPECT_LT(greatestDifference(near, fromAfar(scene, 1e6)), 3e-5);
}

TEST(ReferencePictureHardCases, originsAKilometreAwayLookTheSame) {
  const Scene near = ballScene(gridOf({20, 20, 20}), 9.0);
  const Scene distant = ballScene(gridOf({20, 20, 20}, glm::dvec3(1.0), {1e6, -1e6, 1e6}), 9.0);
  EXPECT_LT(greatestDifference(fromAfar(near, 50.0), fromAfar(distant, 50.0)), 3e-5);
}

TEST(ReferencePictureHardCases, spacingIsAUnitLikeAnyOther) {
  // Everything twenty times smaller, with extinction per mm twenty times larger: the same picture, but for the
  // cutaway's border and the curvature's scale, which are per pixel and per voxel.
  const Scene large = ballScene(gridOf({20, 20, 20}), 9.0);
  Scene small = ballScene(gridOf({20, 20, 20}, glm::dvec3(0.05)), 0.45);
  small.volume = large.volume;
  auto volume =
      volumeOf<float>(gridOf({20, 20, 20}, glm::dvec3(0.05)), [&](glm::ivec3 i) { return large.volume->value(i); });
  small.volume = volume;
  for (TransferFunction::Node& node : small.look.context.function.nodes) node.properties.extinction *= 20.0;
  small.look.focusAppearance.extinction *= 20.0;
  const auto shot = [](const Scene& scene, double scale) {
    const glm::dvec3 centre = scene.volume->grid.centre();
    const Camera camera =
        lookAt(centre + scale * glm::dvec3(12.0, -30.0, 9.0), centre, Projection::Orthographic, 20.0 * scale);
    Scene plain = scene;
    // The opacity per mm decides what is context; without a cutaway no pixel depends on that.
    plain.look.cutaway.enabled = false;
    return picture(plain, camera, {25, 25});
  };
  const Picture a = shot(large, 1.0), b = shot(small, 0.05);
  EXPECT_GT(shownPixels(a), 150);
  EXPECT_LT(greatestDifference(a, b), 3e-5);
}

TEST(ReferencePictureHardCases, flatVoxelsAndDegenerateGrids) {
  for (const Grid& grid : {gridOf({40, 40, 5}, {0.05, 0.05, 10.0}), gridOf({1, 1, 1}), gridOf({1, 9, 7}),
                           gridOf({9, 1, 7}), gridOf({9, 7, 1})}) {
    Scene scene = ballScene(grid, 2.0 * grid.boundingRadius());
    const Picture result = picture(scene, Camera::fromAngles(35.0, 25.0, grid), {21, 21});
    EXPECT_GT(shownPixels(result), 10);
    for (std::size_t i = 0; i < result.final.size(); ++i) {
      EXPECT_LE(result.error[i], 1e-5);
      EXPECT_TRUE(result.final[i].a >= 0.0 && result.final[i].a <= 1.0);
    }
  }
}

/// Opacity along x through one line of voxels, without lighting.
template <class T>
double opacityAlong(const std::vector<double>& values, const TransferFunction& transfer) {
  Scene scene;
  scene.volume = volumeOf<T>(gridOf({static_cast<int>(values.size()), 1, 1}),
                             [&](glm::ivec3 i) { return values[static_cast<std::size_t>(i.x)]; });
  scene.look.context.function = transfer;
  scene.look.shading.enabled = false;
  const Camera camera = lookAt({-10.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, Projection::Orthographic, 0.5);
  PictureOptions options;
  options.tolerance = 1e-11;
  return picture(scene, camera, {1, 1}, options).final[0].a;
}

TransferFunction stepTo(double value, double extinction) {
  return {{{value, {skin, 0.0}}, {value, {skin, extinction}}}};
}

TEST(ReferencePictureHardCases, valuesThatAreNoNumbersCountAsTheLeastAndGreatest) {
  // Above 5: from 0 to 10 half a voxel, then ten to the right.
  const double clean = opacityAlong<float>({0, 0, 10, 10, 0, 0}, stepTo(5.0, 0.3));
  EXPECT_NEAR(clean, -std::expm1(-0.3 * 2.0), 1e-11);
  EXPECT_EQ(opacityAlong<float>({nan, 0, 10, infinity, -infinity, nan}, stepTo(5.0, 0.3)), clean);
  // A volume of such values alone shows nothing and does not fail.
  EXPECT_EQ(opacityAlong<float>({nan, nan, nan}, stepTo(5.0, 0.3)), 0.0);
}

TEST(ReferencePictureHardCases, hugeValuesAndWholeRanges) {
  // From 0 to 1e30 the step at 5 lies at the voxel before; a path of 1 mm up, half a voxel of it, and 1 mm down.
  EXPECT_NEAR(opacityAlong<float>({0, 0, 1e30, 0, 0}, stepTo(5.0, 0.3)), -std::expm1(-0.3 * 2.0), 1e-9);
  EXPECT_NEAR(opacityAlong<std::int16_t>({-32768, -32768, 32767, 32767}, stepTo(0.0, 0.3)),
              -std::expm1(-0.3 * (1.5 + 32767.0 / 65535.0)), 1e-11);
  EXPECT_NEAR(opacityAlong<std::uint16_t>({0, 0, 65535, 65535}, stepTo(65000.0, 0.3)),
              -std::expm1(-0.3 * (1.5 + 535.0 / 65535.0)), 1e-11);
}

TEST(ReferencePictureHardCases, constantVolumes) {
  EXPECT_EQ(opacityAlong<std::int16_t>({42, 42, 42}, stepTo(42.5, 0.3)), 0.0);
  // The step's upper value belongs to it, as in TransferFunction::evaluate.
  EXPECT_NEAR(opacityAlong<std::int16_t>({42, 42, 42}, stepTo(42.0, 0.3)), -std::expm1(-0.9), 1e-11);
}

TEST(ReferencePictureHardCases, opacityFromNearlyNothingToOne) {
  for (const double opacityPerMm : {1e-15, 1e-9, 0.5, 1.0}) {
    const double extinction = extinctionFromOpacity(opacityPerMm), expected = -std::expm1(-3.0 * extinction);
    EXPECT_NEAR(opacityAlong<float>({7, 7, 7}, {{{0.0, {skin, extinction}}}}) / expected, 1.0, 1e-12) << opacityPerMm;
  }
  EXPECT_EQ(opacityAlong<float>({7, 7, 7}, {{{0.0, {skin, 1e12}}}}), 1.0);
}

TEST(ReferencePictureHardCases, homogeneousRegionsHaveTheLightOfAnAverageSurface) {
  Scene scene;
  scene.volume = volumeOf(gridOf({9, 9, 9}), [](glm::ivec3) { return 5.0; });
  scene.look.context.function = {{{0.0, {skin, 0.5}}}};
  const Picture result = fromAfar(scene, 50.0);
  for (const glm::dvec4& pixel : result.final)
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(pixel[channel], skin[channel] * (0.3 + 0.7 * 0.7) * pixel.a, 1e-5);
}

TEST(ReferencePictureHardCases, theEyeInsideSeesWhatLiesBeforeIt) {
  // A constant block: from the middle half of it is left, and looking out of it nothing but that half.
  Scene scene;
  scene.volume = volumeOf(gridOf({9, 9, 9}), [](glm::ivec3) { return 5.0; });
  scene.look.context.function = {{{0.0, {skin, 0.2}}}};
  const Camera inside = lookAt({4.0, 4.0, 4.0}, {4.0, 90.0, 4.0}, Projection::Orthographic, 1.0);
  EXPECT_NEAR(picture(scene, inside, {1, 1}).final[0].a, -std::expm1(-0.2 * 4.5), 1e-9);
  const Camera behind = lookAt({4.0, 20.0, 4.0}, {4.0, 90.0, 4.0}, Projection::Orthographic, 1.0);
  EXPECT_EQ(picture(scene, behind, {1, 1}).final[0], glm::dvec4(0.0));
  // On a face of the box, and in the plane of one.
  const Camera face = lookAt({4.0, -0.5, 4.0}, {4.0, 90.0, 4.0}, Projection::Orthographic, 1.0);
  EXPECT_NEAR(picture(scene, face, {1, 1}).final[0].a, -std::expm1(-0.2 * 9.0), 1e-9);
  const Camera along = lookAt({8.5, -3.0, 4.0}, {8.5, 90.0, 4.0}, Projection::Orthographic, 1.0);
  EXPECT_NEAR(picture(scene, along, {1, 1}).final[0].a, -std::expm1(-0.2 * 9.0), 1e-9);
}

TEST(ReferencePictureHardCases, emptyFocusAndFocusOutOfViewCutNothing) {
  Scene scene = ballScene(gridOf({20, 20, 20}), 9.0);
  Scene plain = scene;
  plain.look.focus = {};
  scene.labels = labelsOf(scene.volume->grid, [](glm::ivec3) { return 0; });
  // With a cutaway rays start where opacity exceeds 1/255 a mm: over at most 2 mm of less that makes 1/255.
  EXPECT_LT(greatestDifference(fromAfar(scene, 50.0), fromAfar(plain, 50.0)), 2.0 / 255.0);
  const Picture result = fromAfar(scene, 50.0);
  for (const glm::dvec4& layer : result.contextLayer) EXPECT_TRUE(std::isnan(layer.x));
}

TEST(ReferencePictureHardCases, aSymmetricFocusMakesASymmetricPicture) {
  Scene scene = ballScene(gridOf({20, 20, 20}), 9.0);
  scene.labels = labelsOf(scene.volume->grid, [](glm::ivec3 i) {
    return glm::length(glm::abs(glm::dvec3(i) - 9.5) - glm::dvec3(4.0, 0.0, 0.0)) < 2.0 ? 1 : 0;
  });
  scene.look.shading.enabled = false;
  scene.look.contextLayer.strength = 0.0;
  const glm::dvec3 centre = scene.volume->grid.centre();
  const Camera camera = lookAt(centre - glm::dvec3(0.0, 40.0, 0.0), centre, Projection::Orthographic, 20.0);
  // A power of two: halving an odd row of pixels pairs them up from the left.
  const glm::ivec2 size(32, 24);
  const Picture result = picture(scene, camera, size);
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i) {
      const glm::dvec4 left = result.final[static_cast<std::size_t>(j * size.x + i)];
      const glm::dvec4 right = result.final[static_cast<std::size_t>(j * size.x + size.x - 1 - i)];
      for (int channel = 0; channel < 4; ++channel) EXPECT_NEAR(left[channel], right[channel], 2e-5) << i << ", " << j;
    }
}

TEST(ReferencePictureHardCases, everyViewportAndWidth) {
  Scene scene = ballScene(gridOf({20, 20, 20}), 9.0);
  Camera camera = Camera::fromAngles(0.0, 90.0, scene.volume->grid);
  camera.up = {0.0, 0.0, 1.0};  // along the view
  for (const glm::ivec2 size : {glm::ivec2(1), glm::ivec2(1, 23), glm::ivec2(19, 1), glm::ivec2(31, 17)})
    for (const double width : {0.0, 0.3, 1e6}) {
      scene.look.cutaway.openWidth = scene.look.cutaway.borderWidth = width;
      const Picture result = picture(scene, camera, size);
      EXPECT_EQ(result.final.size(), static_cast<std::size_t>(size.x * size.y));
      for (const glm::dvec4& pixel : result.final) EXPECT_TRUE(pixel.a >= 0.0 && pixel.a <= 1.0);
    }
}

}  // namespace
}  // namespace fenestra::reference::referencePictureHardCasesTest
