// The reference's focus layer, lighting and composite against closed forms.

#include "rendering/scene/Lighting.h"
#include "tests/unit/ReferenceTesting.h"

namespace fenestra::reference::referencePictureTest {
namespace {

// ---- Focus, lighting, cut faces -------------------------------------------------------------------------------------

TEST(ReferenceFocusLayer, labelsShowTheirColoursFromTheLevelOn) {
  // Context to index 6.5, label 1 to the middle between 9 and 10, label 2 to the box's face.
  Scene scene = profile(14, [](int) { return 1.0; }, {{{0.0, {blue, 0.02}}}});
  auto labels = labelsOf(scene.volume->grid, [](glm::ivec3 i) { return i.x < 7 ? 0 : i.x < 10 ? 1 : 2; });
  labels->labels = {{1, "one", red}, {2, "two", {0.2, 0.9, 0.4}}};
  scene.labels = labels;
  scene.look.focus = LabelFocus{{1, 2}};
  scene.look.focusAppearance.extinction = 0.3;
  scene.look.cutaway.enabled = false;
  const double front = std::exp(-0.02 * 7.0), first = std::exp(-0.3 * 3.0), second = std::exp(-0.3 * 4.0);
  const glm::dvec3 colour =
      blue * (1.0 - front) + front * (red * (1.0 - first) + first * glm::dvec3(0.2, 0.9, 0.4) * (1.0 - second));
  expectNear(onePixel(scene, 1e-12), {colour, 1.0 - front * first * second}, 1e-12);
  // With the cutaway the ray starts on the focus.
  scene.look.cutaway.enabled = true;
  scene.look.contextLayer.strength = 0.0;
  expectNear(onePixel(scene, 1e-12),
             {red * (1.0 - first) + first * glm::dvec3(0.2, 0.9, 0.4) * (1.0 - second), 1.0 - first * second}, 1e-12);
}

TEST(ReferenceFocusLayer, valuesShowTheFocusesColourInsideTheirRange) {
  // The value is the index: focus between 4 and 8, context before and after.
  Scene scene = profile(12, [](int x) { return x; }, {{{0.0, {blue, 0.05}}}});
  scene.look.focus = ValueFocus{{4.0, 8.0}, 0.0};
  scene.look.focusAppearance = {red, 0.2, {}};
  scene.look.cutaway.enabled = false;
  const double front = std::exp(-0.05 * 4.5), focus = std::exp(-0.2 * 4.0), back = std::exp(-0.05 * 3.5);
  const glm::dvec3 colour = blue * (1.0 - front) + front * (red * (1.0 - focus) + focus * blue * (1.0 - back));
  expectNear(onePixel(scene, 1e-12), {colour, 1.0 - front * focus * back}, 1e-12);
}

TEST(ReferenceFocusLayer, labelsShowTheirFunctionsOfTheValue) {
  // The value is the index. Label 1 from 3.5 to 7.5 by a function that steps at 5, label 2 to the face of one material.
  const glm::dvec3 green(0.2, 0.9, 0.4);
  Scene scene = profile(12, [](int x) { return x; }, {{{0.0, {blue, 0.05}}}});
  auto labels = labelsOf(scene.volume->grid, [](glm::ivec3 i) { return i.x < 4 ? 0 : i.x < 8 ? 1 : 2; });
  labels->labels = {{1, "one", {1.0, 1.0, 1.0}}, {2, "two", green}};
  scene.labels = labels;
  scene.look.focus = LabelFocus{{1, 2}};
  scene.look.focusAppearance = {{}, 0.3, {}};
  scene.look.cutaway.enabled = false;
  const TransferFunction step{{{5.0, {red, 0.1}}, {5.0, {blue, 0.2}}}};
  put(scene.look.labels, {.label = 1, .function = step});
  const auto expected = [&](double below, double above) {
    const double t0 = std::exp(-0.05 * 4.0), t1 = t0 * std::exp(-below * 1.5), t2 = t1 * std::exp(-above * 2.5),
                 t3 = t2 * std::exp(-0.3 * 4.0);
    return glm::dvec4(blue * (1.0 - t0) + red * (t0 - t1) + blue * (t1 - t2) + green * (t2 - t3), 1.0 - t3);
  };
  expectNear(onePixel(scene, 1e-12), expected(0.1, 0.2), 1e-12);
  // Half of the label shows at an opacity of a half.
  put(scene.look.labels, {.label = 1, .opacity = 0.5, .function = step});
  const double t0 = std::exp(-0.05 * 4.0), within = std::exp(-0.1 * 1.5), behind = within * std::exp(-0.2 * 2.5);
  const double t2 = t0 * (0.5 + 0.5 * behind), t3 = t2 * std::exp(-0.3 * 4.0);
  const glm::dvec3 half = 0.5 * t0 * (red * (1.0 - within) + blue * (within - behind));
  expectNear(onePixel(scene, 1e-12), {blue * (1.0 - t0) + half + green * (t2 - t3), 1.0 - t3}, 1e-12);
  put(scene.look.labels, {.label = 1, .visible = false, .function = step});
  expectNear(onePixel(scene, 1e-12), expected(0.0, 0.0), 1e-12);
  // A label that is not in focus shows as context, whatever its function.
  put(scene.look.labels, {.label = 1, .function = step});
  scene.look.focus = LabelFocus{{2}};
  EXPECT_FALSE(hasFocusFunction(scene));
  const double front = std::exp(-0.05 * 8.0), back = std::exp(-0.3 * 4.0);
  expectNear(onePixel(scene, 1e-12), {blue * (1.0 - front) + front * green * (1.0 - back), 1.0 - front * back}, 1e-12);
}

TEST(ReferenceFocusLayer, valuesShowTheFocusesFunction) {
  // The value is the index: focus between 4 and 8, whose extinction rises from 0 to 0.4 there; ∫ is 0.8.
  Scene scene = profile(12, [](int x) { return x; }, {{{0.0, {blue, 0.05}}}});
  scene.look.focus = ValueFocus{{4.0, 8.0}, 0.0};
  scene.look.focusAppearance.function = {{{4.0, {red, 0.0}}, {8.0, {red, 0.4}}}};
  scene.look.cutaway.enabled = false;
  const double front = std::exp(-0.05 * 4.5), focus = std::exp(-0.8), back = std::exp(-0.05 * 3.5);
  const glm::dvec3 colour = blue * (1.0 - front) + front * (red * (1.0 - focus) + focus * blue * (1.0 - back));
  expectNear(onePixel(scene, 1e-12), {colour, 1.0 - front * focus * back}, 1e-10);
  // The focus, and so the ray starts, stay the same where the function shows nothing.
  scene.look.focusAppearance.function->nodes.front().properties.extinction = 0.4;
  const auto hits = [&] { return reference::hitPoints(scene, alongX(scene.volume->grid), {1, 1}); };
  const reference::HitPoints dense = hits();
  scene.look.focusAppearance.function = TransferFunction{};
  EXPECT_EQ(hits().tFocus, dense.tFocus);
  EXPECT_EQ(hits().tContext, dense.tContext);
  const double clear = std::exp(-0.05 * 8.0);
  expectNear(onePixel(scene, 1e-12), {blue * (1.0 - clear), 1.0 - clear}, 1e-12);
}

/// Blinn-Phong with the light from the upper left behind the viewer, written out a second time.
glm::dvec3 phong(glm::dvec3 colour, glm::dvec3 normal, const Camera& camera, const Shading& shading) {
  const Camera::Axes axes = camera.axes();
  const glm::dvec3 light = glm::normalize(-axes.forward + 0.45 * axes.up - 0.35 * axes.right);
  const glm::dvec3 half = glm::normalize(light - axes.forward);
  return colour * (shading.ambient + shading.diffuse * std::abs(glm::dot(normal, light))) +
         glm::dvec3(shading.specular * std::pow(std::abs(glm::dot(normal, half)), shading.shininess));
}

TEST(ReferenceLighting, followsTheGradientAsFarAsItIsCertain) {
  // Values rise along (1, 2, 0.5) in world space on an oblique grid, 100 in all; rays parallel.
  const Grid grid = obliqueGrid({24, 24, 24});
  const glm::dvec3 slope(1.0, 2.0, 0.5);
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  const double finest = 0.7;  // mm
  const auto lit = [&](double share) {
    // |gradient| · finest spacing / range = share: set by an outlier that stretches the range and lies off the ray.
    const double range = glm::length(slope) * finest / share;
    Scene scene;
    scene.volume = volumeOf(grid, [&](glm::ivec3 i) {
      if (i == glm::ivec3(0)) return -0.5 * range;
      if (i == glm::ivec3(23)) return 0.5 * range;
      return glm::dot(slope, glm::dvec3(worldFromIndex * glm::dvec4(i, 1.0)));
    });
    scene.look.context.function = {{{0.0, {red, 0.5}}}};
    const glm::dvec3 centre = grid.centre();
    // Along the index z axis: the ray keeps to the middle of the other two.
    const Camera camera = lookAt(centre - 80.0 * grid.direction[2], centre, Projection::Orthographic, 1.0);
    PictureOptions options;
    options.tolerance = 1e-11;
    const glm::dvec4 found = picture(scene, camera, {1, 1}, options).focusLayer[0];
    const glm::dvec3 flat = red * (scene.look.shading.ambient + 0.7 * scene.look.shading.diffuse);
    const glm::dvec3 full = phong(red, glm::normalize(slope), camera, scene.look.shading);
    return std::array<glm::dvec3, 3>{glm::dvec3(found) / found.a, flat, full};
  };
  const auto expectMix = [](const std::array<glm::dvec3, 3>& colours, double certainty) {
    const glm::dvec3 expected = glm::mix(colours[1], colours[2], certainty);
    // The volume's outer half voxels and border differ from the inside by rounding alone.
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(colours[0][channel], expected[channel], 1e-9);
  };
  expectMix(lit(0.5 * lighting::gradientGateLow), 0.0);
  expectMix(lit(2.0 * lighting::gradientGateHigh), 1.0);
  // A quarter of the way through the gate: g = ¼²·(3 - ½), and g over ½ in the same way.
  const double g = 0.0625 * 2.5, over = g / lighting::certainLength;
  expectMix(lit(0.75 * lighting::gradientGateLow + 0.25 * lighting::gradientGateHigh),
            over * over * (3.0 - 2.0 * over));
}

TEST(ReferenceLighting, cutFacesFadeIntoTheirStrata) {
  // A block without gradients whose rays start on a given slanted plane: lit by the plane, fading over two voxels.
  const Grid grid = gridOf({20, 20, 20});
  Scene scene = labelScene(grid, [](glm::ivec3 i) { return i == glm::ivec3(0); });
  const double extinction = 0.3;
  scene.look.context.function = {{{-1.0, {red, extinction}}}};
  scene.look.contextLayer.strength = 0.0;
  scene.look.cutaway.borderWidth = 0.0;
  const Camera camera = lookAt({-50.0, 9.5, 9.5}, {9.5, 9.5, 9.5}, Projection::Orthographic, 3.0);
  const Camera::Axes axes = camera.axes();
  Stages stages;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      // Pixels are a mm apart.
      stages.tStart.push_back(56.0 + 0.5 * (i - 1) + 0.25 * (j - 1));
      stages.hits.tContext.push_back(49.5);
      stages.hits.tFocus.push_back(nan);
    }
  PictureOptions options;
  options.tolerance = 1e-12;
  options.pixels = {{1, 1}};
  const glm::dvec4 found = picture(scene, camera, {3, 3}, stages, options).focusLayer[0];

  const glm::dvec3 normal = glm::normalize(-axes.forward + 0.5 * axes.right - 0.25 * axes.up);
  const glm::dvec3 wall = phong(red, normal, camera, scene.look.shading);
  const glm::dvec3 strata = red * (scene.look.shading.ambient + 0.7 * scene.look.shading.diffuse);
  const double length = 19.5 + 50.0 - 56.0, faster = extinction + 1.0 / 2.0;
  const double opacity = -std::expm1(-extinction * length);
  const double wallPart = 0.75 * extinction / faster * -std::expm1(-faster * length);
  expectNear(found, {strata * opacity + (wall - strata) * wallPart, opacity}, 1e-11);

  // On the context's own surface, and beside a ray that meets nothing, there is no cut face.
  for (const bool bare : {true, false}) {
    Stages other = stages;
    if (bare)
      other.hits.tContext[4] = 55.5;
    else
      other.tStart[5] = nan;
    expectNear(picture(scene, camera, {3, 3}, other, options).focusLayer[0], {strata * opacity, opacity}, 1e-11);
  }
}

TEST(ReferenceLighting, labelsTakeTheirNormalsFromTheSmoothedIndicator) {
  // A half space of labels cut by an oblique plane, in a volume without gradients: the smoothed indicator's level sets
  // are that plane's, to the smoothing's own staircase.
  const Grid grid = gridOf({30, 30, 30}, {1.0, 1.0, 2.0});
  const glm::dvec3 n = glm::normalize(glm::dvec3(1.0, 0.4, 0.3));
  Scene scene =
      labelScene(grid, [&](glm::ivec3 i) { return glm::dot(n, (glm::dvec3(i) - 14.3) * grid.spacing) > 0.0; });
  scene.look.focusAppearance.extinction = 50.0;
  scene.look.contextLayer.strength = 0.0;
  const glm::dvec3 centre = grid.centre();
  const Camera camera = lookAt(centre - glm::dvec3(90.0, 0.0, 0.0), centre, Projection::Orthographic, 8.0);
  const Picture result = picture(scene, camera, {16, 16});
  const glm::dvec3 expected = phong(defaultLabelColour(1), n, camera, scene.look.shading);
  for (const glm::dvec4& pixel : result.final) {
    EXPECT_NEAR(pixel.a, 1.0, 1e-6);
    // The slope of light over normal is below 5 (specular, shininess 24), normals within a degree.
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(pixel[channel], expected[channel], 0.08);
  }
}

// ---- Composite and the picture as a whole ---------------------------------------------------------------------------

TEST(ReferenceComposite, borderCoversItsShareOfAPixel) {
  const Grid grid = gridOf({16, 16, 16});
  Scene scene = labelScene(grid, [](glm::ivec3 i) { return i == glm::ivec3(8); });
  scene.look.context.function = {{{-1.0, {red, 0.5}}}};
  scene.look.contextLayer.strength = 0.0;
  scene.look.cutaway.openWidth = 3.25;
  scene.look.cutaway.borderWidth = 2.5;
  const Camera camera = lookAt({8.0, -50.0, 8.0}, {8.0, 8.0, 8.0}, Projection::Orthographic, 16.0);
  const glm::ivec2 size(17, 17);
  const Stages stages = geometricStages(scene, camera, size);
  const Picture result = picture(scene, camera, size, stages);
  // Focus in the middle pixel alone; along the row distances are whole numbers.
  const std::size_t middle = 8 * 17 + 8;
  ASSERT_EQ(stages.distance[middle], 0.0);
  ASSERT_EQ(stages.distance[middle + 1], 1.0);
  const double expected[] = {0.0, 0.0, 0.0, 0.25, 1.0, 1.0, 0.25, 0.0};
  for (std::size_t d = 0; d < 8; ++d) {
    const glm::dvec4 own = result.focusLayer[middle + d], border(scene.look.cutaway.borderColour, 1.0);
    expectNear(result.final[middle + d], glm::mix(own, border, expected[d]), 1e-12);
  }
}

TEST(ReferenceComposite, contextLayerLiesOverTheFocus) {
  // A ball of values around a small ball of labels: κ = 1/r and the silhouette term are known.
  const Grid grid = gridOf({48, 48, 48});
  const auto radiusAt = [](glm::ivec3 i) { return glm::length(glm::dvec3(i) - 23.5); };
  Scene scene;
  scene.volume = volumeOf<float>(grid, [&](glm::ivec3 i) { return -radiusAt(i); });
  scene.labels = labelsOf(grid, [&](glm::ivec3 i) { return radiusAt(i) < 12.0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = opaqueFrom(-16.0);
  scene.look.cutaway.openWidth = 0.0;
  scene.look.cutaway.borderWidth = 0.0;
  const Camera camera = lookAt({23.5, -60.0, 23.5}, glm::dvec3(23.5), Projection::Orthographic, 48.0);
  const glm::ivec2 size(48, 48);
  const Stages stages = geometricStages(scene, camera, size);
  const Picture result = picture(scene, camera, size, stages);
  const auto step = [](double low, double high, double x) {
    const double s = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return s * s * (3.0 - 2.0 * s);
  };
  int seen = 0;
  for (std::size_t i = 0; i < result.final.size(); ++i) {
    EXPECT_EQ(std::isnan(result.contextLayer[i].x), std::isnan(stages.hits.tFocus[i]));
    if (std::isnan(stages.hits.tFocus[i])) {
      expectNear(result.final[i], result.focusLayer[i], 0.0);
      continue;
    }
    const glm::dvec4 layer = result.contextLayer[i];
    const double rim = result.silhouette[i],
                 bend = std::hypot(layer.x, layer.y) / std::sqrt(2.0) * 2.0;  // 2 mm thinned
    // The ball's own, from where the ray meets it.
    const double across = std::sqrt(256.0 - std::pow(stages.hits.tContext[i] - 83.5, 2));
    EXPECT_NEAR(rim, 1.0 - std::sqrt(1.0 - across * across / 256.0), 0.01);
    EXPECT_NEAR(layer.w, -16.0, 1e-9);
    const double opacity =
        scene.look.contextLayer.strength * std::clamp(step(0.10, 0.40, bend) + step(0.30, 0.85, rim), 0.0, 1.0);
    const glm::dvec4 front(scene.look.contextLayer.colour * layer.z, 1.0);
    expectNear(result.final[i], front * opacity + result.focusLayer[i] * (1.0 - opacity), 1e-12);
    ++seen;
  }
  EXPECT_GT(seen, 300);
}

TEST(ReferencePicture, somePixelsAreThoseOfTheWhole) {
  const Scene scene = roughScene();
  const Camera camera = Camera::fromAngles(25.0, 10.0, scene.volume->grid);
  const glm::ivec2 size(40, 36);
  const Picture whole = picture(scene, camera, size), again = picture(scene, camera, size);
  EXPECT_EQ(whole.final, again.final);
  PictureOptions options;
  options.pixels = {{20, 18}, {0, 0}, {39, 35}, {20, 18}, {7, 30}};
  const Picture some = picture(scene, camera, size, options);
  ASSERT_EQ(some.final.size(), options.pixels.size());
  for (std::size_t i = 0; i < options.pixels.size(); ++i) {
    const auto at = static_cast<std::size_t>(options.pixels[i].y * size.x + options.pixels[i].x);
    EXPECT_EQ(some.final[i], whole.final[at]);
    EXPECT_EQ(some.focusLayer[i], whole.focusLayer[at]);
    EXPECT_EQ(some.error[i], whole.error[at]);
  }
}

}  // namespace
}  // namespace fenestra::reference::referencePictureTest
