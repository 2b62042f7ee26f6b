// The chain of passes: what re-runs when, what a scene costs, and what the later stages make of known fields.

#include <functional>
#include <initializer_list>
#include <map>

#include "tests/gl/GlTest.h"

namespace fenestra::tests::rendererTest {
namespace {

constexpr glm::ivec2 size{120, 100};

/// A ball of label 1 (radius 5 mm) inside a larger ball of values falling outwards, in air.
Scene ballScene() {
  const Grid grid = gridOf({40, 40, 40});
  const auto radius = [&](glm::ivec3 i) { return glm::length(glm::dvec3(i) - 19.5); };
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [&](glm::ivec3 i) { return 1000.0 - 60.0 * radius(i); });
  scene.labels = labelsOf(grid, [&](glm::ivec3 i) { return radius(i) < 5.0 ? 1 : radius(i) < 9.0 ? 2 : 0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = {
      {{100.0, {glm::dvec3(0.8, 0.5, 0.4), 0.0}}, {100.0, {glm::dvec3(0.8, 0.5, 0.4), 0.5}}}};
  scene.look.cutaway.openWidth = 10.0;
  scene.look.cutaway.borderWidth = 3.0;
  return scene;
}

View viewOf(const Scene& scene, Projection projection = Projection::Perspective) {
  return {Camera::fromAngles(25.0, 15.0, scene.volume->grid, projection), size, 1.0, Quality::Normal};
}

using Passes = GlTest;

/// Runs of every pass caused by one change.
std::string runsCausedBy(const Scene& before, const View& viewBefore, const Scene& after, const View& viewAfter) {
  Renderer renderer(std::make_shared<GpuScene>());
  renderer.render(before, viewBefore);
  const auto first = renderer.stats();
  renderer.render(after, viewAfter);
  std::string names;
  for (std::size_t pass = 0; pass < passCount; ++pass)
    if (renderer.stats()[pass].runs > first[pass].runs)
      names += (names.empty() ? "" : ", ") + std::string(nameOf(static_cast<Pass>(pass)));
  return names;
}

TEST_F(Passes, Thorough_ReRunOnlyWhatAChangeReaches) {
  const Scene scene = ballScene();
  const View view = viewOf(scene);
  const auto after = [&](auto&& change) {
    Scene changed = scene;
    change(changed);
    return runsCausedBy(scene, view, changed, view);
  };
  const std::string all = "hit points, pull-push, distance map, ray start, focus layer, context layer, composite";
  EXPECT_EQ(after([](Scene&) {}), "");
  EXPECT_EQ(after([](Scene& s) { s.look.cutaway.openWidth = 14.0; }), "ray start, focus layer, composite");
  EXPECT_EQ(after([](Scene& s) { s.look.cutaway.borderWidth = 5.0; }), "composite");
  EXPECT_EQ(after([](Scene& s) { s.look.cutaway.borderColour = glm::dvec3(1.0); }), "composite");
  EXPECT_EQ(after([](Scene& s) { s.look.contextLayer.strength = 0.3; }), "composite");
  EXPECT_EQ(after([](Scene& s) { s.look.contextLayer.colour = glm::dvec3(0.2); }), "composite");
  EXPECT_EQ(after([](Scene& s) { s.look.background = glm::dvec3(0.2); }), "");
  EXPECT_EQ(after([](Scene& s) { s.look.backdrop = Backdrop::Gradient; }), "");
  EXPECT_EQ(after([](Scene& s) { s.look.focusAppearance.extinction = 1.0; }), "focus layer, composite");
  // A focus that is shown by value has the same surface.
  const TransferFunction byValue{{{0.0, {glm::dvec3(1.0), 0.0}}, {100.0, {glm::dvec3(1.0), 0.5}}}};
  EXPECT_EQ(after([&](Scene& s) { put(s.look.labels, {.label = 1, .function = byValue}); }), "focus layer, composite");
  // A colour moves no surface; the value at which the context begins does.
  EXPECT_EQ(after([](Scene& s) { s.look.context.function.nodes[1].properties.colour = glm::dvec3(0.1); }),
            "focus layer, composite");
  EXPECT_EQ(
      after([](Scene& s) { s.look.context.function.nodes[0].value = s.look.context.function.nodes[1].value = 150.0; }),
      all);
  EXPECT_EQ(after([](Scene& s) { s.look.labelSmoothing = LabelSmoothing::Light; }), all);
  EXPECT_EQ(after([](Scene& s) { s.look.focus = LabelFocus{{1, 2}}; }), all);
  View turned = view;
  turned.camera = view.camera.orbited(0.3, 0.1);
  EXPECT_EQ(runsCausedBy(scene, view, scene, turned), all);
  View finer = view;
  finer.quality = Quality::High;
  EXPECT_EQ(runsCausedBy(scene, view, scene, finer), "focus layer, composite");
  View larger = view;
  larger.size *= 2;
  EXPECT_EQ(runsCausedBy(scene, view, scene, larger), all);
}

TEST_F(Passes, Thorough_SameAnswerWhetherPassesWereReusedOrNot) {
  Scene scene = ballScene();
  const View view = viewOf(scene);
  Renderer reused(std::make_shared<GpuScene>());
  reused.render(scene, view);
  const std::array<void (*)(Scene&), 10> changes{
      [](Scene& s) { put(s.look.labels, {.label = 2, .role = LabelRole::Protected}); },
      [](Scene& s) { s.look.cutaway.openWidth = 4.0; },
      [](Scene& s) { put(s.look.labels, {.label = 2, .role = LabelRole::Hidden}); },
      [](Scene& s) { put(s.look.labels, {.label = 1, .opacity = 0.25, .colour = glm::dvec3(0.1, 0.9, 0.2)}); },
      [](Scene& s) { s.look.contextLayer.strength = 0.0; },
      [](Scene& s) {
        s.look.focus = ValueFocus{{800.0, 2000.0}, 0.0};
      },
      [](Scene& s) { s.look.cutaway.enabled = false; },
      [](Scene& s) { s.look.shading.enabled = false; },
      [](Scene& s) { put(s.look.labels, {.label = 2, .role = LabelRole::Protected}); },
      [](Scene& s) { s.look.cutaway.enabled = s.look.shading.enabled = true; }};
  for (const auto change : changes) {
    change(scene);
    reused.render(scene, view);
    Renderer fresh(std::make_shared<GpuScene>());
    fresh.render(scene, view);
    EXPECT_EQ(reused.readPicture(), fresh.readPicture());
  }
}

TEST_F(Passes, MovingTheOpeningKeepsOnlyWhatStaysTheSame) {
  for (const bool shading : {true, false}) {
    Scene scene = ballScene();
    scene.look.shading.enabled = shading;
    if (shading) put(scene.look.labels, {.label = 2, .role = LabelRole::Protected});
    View view = viewOf(scene);
    view.size = {64, 48};  // a voxel is less than a pixel wide: every ray is followed, and none is on a list
    Renderer reused(std::make_shared<GpuScene>());
    reused.render(scene, view);
    const std::size_t still = reused.imageBytes();
    // Wider, narrower, closed, beyond the distance map's first range, and together with something else.
    for (const double width : {14.0, 6.0, 0.0, 8.0, 90.0, 12.0}) {
      scene.look.cutaway.openWidth = width;
      if (width == 12.0) scene.look.focusAppearance.extinction *= 0.5;
      reused.render(scene, view);
      Renderer fresh(std::make_shared<GpuScene>());
      fresh.render(scene, view);
      EXPECT_EQ(reused.readLayers().focusLayer, fresh.readLayers().focusLayer) << width;
      EXPECT_EQ(reused.readPicture(), fresh.readPicture()) << width;
    }
    scene.look.background = glm::dvec3(0.5);
    reused.render(scene, view);
    EXPECT_EQ(reused.imageBytes(), still) << "what a moving opening needs is given back";
  }
}

TEST_F(Passes, AGradientLiesBehindThePicture) {
  Scene scene = ballScene();
  scene.look.background = {0.1, 0.6, 0.3};
  scene.look.backdrop = Backdrop::Gradient;
  scene.look.backgroundTop = {0.9, 0.2, 0.4};
  const View view = viewOf(scene);
  Renderer renderer(std::make_shared<GpuScene>());
  renderer.render(scene, view);
  const std::vector<glm::vec4> fronts = renderer.readLayers().final;
  const std::vector<std::uint8_t> shown = renderer.readPicture();
  for (std::size_t i = 0; i < fronts.size(); ++i) {
    const double row = static_cast<double>(i / static_cast<std::size_t>(view.size.x));
    const glm::dvec3 behind = backgroundAt(scene.look, 1.0 - (row + 0.5) / view.size.y);
    for (int channel = 0; channel < 3; ++channel) {
      const double value = std::clamp(fronts[i][channel] + (1.0 - fronts[i].a) * behind[channel], 0.0, 1.0);
      // Rounded once, from single precision.
      ASSERT_NEAR(shown[4 * i + static_cast<std::size_t>(channel)], 255.0 * value, 0.501) << i;
    }
  }
}

TEST_F(Passes, TwoRenderersShareOneScene) {
  const Scene scene = ballScene();
  const auto gpu = std::make_shared<GpuScene>();
  Renderer one(gpu), two(gpu);
  View left = viewOf(scene), right = viewOf(scene);
  right.camera = right.camera.orbited(1.5, 0.0);
  one.render(scene, left);
  const std::uint64_t uploads = gpu->versions().volume;
  two.render(scene, right);
  one.render(scene, left);
  EXPECT_EQ(gpu->versions().volume, uploads);
  Renderer alone(std::make_shared<GpuScene>());
  alone.render(scene, right);
  EXPECT_EQ(two.readPicture(), alone.readPicture());
  EXPECT_EQ(one.stats()[static_cast<std::size_t>(Pass::FocusLayer)].runs, 1u);
}

std::map<std::string, std::size_t> memoryOf(const Scene& scene) {
  const auto gpu = std::make_shared<GpuScene>();
  Renderer renderer(gpu);
  renderer.render(scene, viewOf(scene));
  std::map<std::string, std::size_t> memory;
  for (const GpuScene::Resource& resource : gpu->resources()) memory[resource.name] = resource.bytes;
  memory["images"] = renderer.imageBytes();
  return memory;
}

TEST_F(Passes, AFeatureThatIsOffCostsNoMemoryAndNoPass) {
  Scene scene = ballScene();
  const auto full = memoryOf(scene);
  const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  for (const char* name : {"volume", "gradient", "derivative volume", "focus index", "focus normals"})
    EXPECT_EQ(full.count(name), 1u) << name;
  EXPECT_EQ(full.count("focus palette"), 0u) << "one label has one colour";

  scene.look.contextLayer.strength = 0.0;
  auto memory = memoryOf(scene);
  EXPECT_EQ(memory.count("derivative volume"), 0u);
  EXPECT_EQ(full.at("images") - memory["images"], pixels * (16 + 4));  // the layer and its silhouette

  scene.look.shading.enabled = false;
  memory = memoryOf(scene);
  EXPECT_EQ(memory.count("gradient") + memory.count("focus normals"), 0u);

  scene.look.focus = {};
  memory = memoryOf(scene);
  EXPECT_EQ(memory.count("focus index"), 0u);
  EXPECT_EQ(memory["images"], pixels * 16);  // the layer, which is the picture

  Renderer renderer(std::make_shared<GpuScene>());
  renderer.render(scene, viewOf(scene));
  for (const Pass pass :
       {Pass::HitPoints, Pass::PullPush, Pass::DistanceMap, Pass::RayStart, Pass::ContextLayer, Pass::Composite})
    EXPECT_EQ(renderer.stats()[static_cast<std::size_t>(pass)].runs, 0u) << nameOf(pass);

  // Switched off again, a feature gives back what it took.
  const auto gpu = std::make_shared<GpuScene>();
  Renderer toggled(gpu);
  toggled.render(ballScene(), viewOf(scene));
  toggled.render(scene, viewOf(scene));
  EXPECT_EQ(toggled.imageBytes(), memory["images"]);
  std::size_t bytes = 0, alone = 0;
  for (const GpuScene::Resource& resource : gpu->resources()) bytes += resource.bytes;
  for (const auto& [name, size_] : memory) alone += name == "images" ? 0 : size_;
  EXPECT_EQ(bytes, alone);
}

TEST_F(Passes, VolumeTakesTheNarrowestTextureThatHoldsItExactly) {
  Scene scene = ballScene();
  scene.look.focus = {};
  scene.look.shading.enabled = false;
  const std::size_t voxels = scene.volume->grid.voxelCount();
  const auto bytesPerVoxel = [&]<class T>(T low, T high) {
    scene.volume = volumeOf<T>(scene.volume->grid, [&](glm::ivec3 i) { return i.x % 2 ? low : high; });
    return memoryOf(scene)["volume"] / voxels;
  };
  EXPECT_EQ(bytesPerVoxel(std::uint8_t{0}, std::uint8_t{255}), 1u);
  EXPECT_EQ(bytesPerVoxel(std::int8_t{-128}, std::int8_t{127}), 1u);
  EXPECT_EQ(bytesPerVoxel(std::int16_t{-1000}, std::int16_t{-800}), 1u);
  EXPECT_EQ(bytesPerVoxel(std::int16_t{-32768}, std::int16_t{32767}), 2u);
  EXPECT_EQ(bytesPerVoxel(std::int32_t{-70000}, std::int32_t{-10000}), 2u);
  EXPECT_EQ(bytesPerVoxel(std::int32_t{0}, std::int32_t{1 << 20}), 4u);
  EXPECT_EQ(bytesPerVoxel(0.0f, 0.5f), 4u);
}

/// A plain volume of one value in parallel projection along y.
Layers homogeneous(double extinction, Quality quality) {
  const Grid grid = gridOf({16, 32, 16});
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [](glm::ivec3) { return 100; });
  scene.look.context.function = {{{0.0, {glm::dvec3(0.25, 0.5, 1.0), extinction}}}};
  scene.look.shading.enabled = false;
  return renderOnce(scene, Camera::standard(StandardView::Anterior, grid, Projection::Orthographic), {8, 8}, quality)
      .layers;
}

TEST_F(Passes, HomogeneousMediumFollowsBeerAndLambertAtAnyStep) {
  for (const double extinction : {1e-6, 1e-3, 0.05})
    for (const Quality quality : {Quality::Draft, Quality::Normal, Quality::High}) {
      const glm::vec4 pixel = homogeneous(extinction, quality).final[8 * 4 + 4];
      const double expected = -std::expm1(-extinction * 32.0);
      // At most 128 products of float32 transmittances.
      EXPECT_NEAR(pixel.a / expected, 1.0, 5e-5) << extinction;
      EXPECT_NEAR(pixel.r, 0.25 * expected, 1e-6 + 1e-4 * expected);
      EXPECT_NEAR(pixel.b, expected, 1e-6 + 1e-4 * expected);
    }
}

TEST_F(Passes, EarlyTerminationLeavesLessThanHalfAStepOfEightBits) {
  for (const double extinction : {0.3, 5.0, 100.0}) {
    const glm::vec4 pixel = homogeneous(extinction, Quality::Normal).final[8 * 4 + 4];
    EXPECT_NEAR(pixel.a, -std::expm1(-extinction * 32.0), 1.0 / 512.0) << extinction;
  }
}

TEST_F(Passes, SkippingEmptySpaceNeverChangesThePicture) {
  Scene scene = ballScene();
  for (const auto& [cut, lit] : {std::pair{true, true}, {true, false}, {false, true}, {false, false}}) {
    scene.look.cutaway.enabled = cut;
    scene.look.shading.enabled = lit;
    // Gradients are kept in a box around what shows, and read at positions rounded in its frame: half of 2^-23 times 64
    // texels, over each of which light changes by up to a quarter.
    const double tolerance = lit ? 1e-6 : 1e-20;
    const Layers skipped = renderOnce(scene, viewOf(scene).camera, size, Quality::Normal).layers;
    // An extinction too small to be seen makes every brick count as occupied.
    Scene everywhere = scene;
    for (TransferFunction::Node& node : everywhere.look.context.function.nodes)
      node.properties.extinction = std::max(node.properties.extinction, 1e-30);
    const Layers visited = renderOnce(everywhere, viewOf(scene).camera, size, Quality::Normal).layers;
    ASSERT_EQ(skipped.final.size(), visited.final.size());
    for (std::size_t i = 0; i < skipped.final.size(); ++i)
      for (int channel = 0; channel < 4; ++channel)
        EXPECT_NEAR(skipped.final[i][channel], visited.final[i][channel], tolerance) << "pixel " << i;
  }
}

/// κ1 ≥ κ2 over a field whose level sets are known, seen along -y onto a small label below the surface.
template <class F>
std::vector<glm::vec2> curvaturesOf(F&& field, double level, glm::dvec3 labelled) {
  const Grid grid = gridOf({64, 64, 64});
  Scene scene;
  scene.volume = volumeOf<float>(grid, [&](glm::ivec3 i) { return field(glm::dvec3(i) - 31.5); });
  scene.labels = labelsOf(grid, [&](glm::ivec3 i) { return glm::length(glm::dvec3(i) - 31.5 - labelled) < 3.0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = opaqueFrom(level);
  Camera camera = Camera::standard(StandardView::Anterior, grid, Projection::Orthographic);
  const Layers layers = renderOnce(scene, camera, {64, 64}).layers;
  std::vector<glm::vec2> found;
  for (const glm::vec4& texel : layers.contextLayer)
    if (!std::isnan(texel.x)) found.emplace_back(texel.x, texel.y);
  return found;
}

// The field is smoothed at a scale of 2 voxels (derivative volume and spline: a standard deviation of about 1.4 mm),
// which shifts a distance field's curvature 1/r by about σ²/r³; at r ≥ 14 mm that is below 1 %.
constexpr double curvatureTolerance = 0.02;

TEST_F(Passes, CurvatureOfASphere) {
  const double radius = 20.0;
  const auto found = curvaturesOf([](glm::dvec3 p) { return -glm::length(p); }, -radius, glm::dvec3(0.0));
  ASSERT_GT(found.size(), 20u);
  for (const glm::vec2 k : found) {
    EXPECT_NEAR(k.x * radius, 1.0, curvatureTolerance);
    EXPECT_NEAR(k.y * radius, 1.0, curvatureTolerance);
  }
}

TEST_F(Passes, CurvatureOfACylinderAndOfItsInside) {
  const double radius = 16.0;
  for (const double sign : {1.0, -1.0}) {
    // sign -1: seen from within, the wall bends towards the viewer.
    const auto field = [&](glm::dvec3 p) { return -sign * glm::length(glm::dvec2(p.x, p.y)); };
    const auto found =
        sign > 0.0 ? curvaturesOf(field, -radius, glm::dvec3(0.0))
                   : curvaturesOf([&](glm::dvec3 p) { return p.y < -8.0 ? 0.0 : field(p); }, radius, {0.0, 20.0, 0.0});
    ASSERT_GT(found.size(), 20u);
    for (const glm::vec2 k : found) {
      EXPECT_NEAR((sign > 0.0 ? k.x : -k.y) * radius, 1.0, curvatureTolerance);
      EXPECT_NEAR((sign > 0.0 ? k.y : k.x) * radius, 0.0, curvatureTolerance);
    }
  }
}

TEST_F(Passes, CurvatureOfATorus) {
  // Outer equator of a torus in the x–y plane: 1/r across and 1/(R + r) along.
  const double ring = 14.0, tube = 10.0;
  const auto distance = [&](glm::dvec3 p) { return std::hypot(glm::length(glm::dvec2(p.x, p.y)) - ring, p.z); };
  const auto found = curvaturesOf([&](glm::dvec3 p) { return -distance(p); }, -tube, {0.0, -ring, 0.0});
  ASSERT_GT(found.size(), 20u);
  const auto sharpest = *std::max_element(found.begin(), found.end(), [](auto a, auto b) { return a.y < b.y; });
  EXPECT_NEAR(sharpest.x * tube, 1.0, 0.05);  // r of 10 mm: the smoothing's own 2 %, and pixels off the equator
  EXPECT_NEAR(sharpest.y * (ring + tube), 1.0, 0.05);
}

TEST_F(Passes, NoContextLayerWhereTheScanBeginsInsideIt) {
  const Grid grid = gridOf({24, 24, 24});
  Scene scene = ballScene();
  scene.volume = volumeOf<std::int16_t>(grid, [](glm::ivec3 i) { return 500 + i.x; });
  scene.labels = labelsOf(grid, [](glm::ivec3 i) { return glm::length(glm::dvec3(i) - 11.5) < 5.0; });
  const Layers layers = renderOnce(scene, viewOf(scene).camera, size).layers;
  EXPECT_TRUE(std::all_of(layers.contextLayer.begin(), layers.contextLayer.end(),
                          [](const glm::vec4& texel) { return std::isnan(texel.x); }));
  EXPECT_TRUE(std::any_of(layers.tFocus.begin(), layers.tFocus.end(), [](float t) { return !std::isnan(t); }));
}

TEST_F(Passes, BorderLiesBetweenItsWidthsOnTheContextAlone) {
  Scene scene = ballScene();
  scene.look.contextLayer.strength = 0.0;
  scene.look.cutaway.borderColour = {0.0, 1.0, 0.0};
  // Wide enough for the border to run off the body into empty pixels.
  scene.look.cutaway.openWidth = 10.0;
  scene.look.cutaway.borderWidth = 30.0;
  const Layers layers = renderOnce(scene, viewOf(scene).camera, size, Quality::Normal).layers;
  int inside = 0, empty = 0;
  for (std::size_t i = 0; i < layers.final.size(); ++i) {
    const bool met = !std::isnan(layers.tContext[i]);
    const float d = layers.distance[i];
    const bool green = glm::length(layers.final[i] - glm::vec4(0.0f, 1.0f, 0.0f, 1.0f)) < 1e-5f;
    // Its rims are anti-aliased over one pixel.
    if (met && d >= 10.5f && d <= 39.5f) {
      EXPECT_TRUE(green);
      ++inside;
    } else if (d <= 9.5f) {
      EXPECT_FALSE(green);
    } else if (!met) {
      EXPECT_EQ(layers.final[i], glm::vec4(0.0f));
      ++empty;
    }
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(empty, 100);

  scene.look.cutaway.borderWidth = 0.0;
  for (const glm::vec4& pixel : renderOnce(scene, viewOf(scene).camera, size).layers.final)
    EXPECT_FALSE(pixel == glm::vec4(0.0f, 1.0f, 0.0f, 1.0f));
}

TEST_F(Passes, Thorough_WhatLiesOverTheFocusLayerIsRedrawnAsInANewPicture) {
  // Only around the focus; a narrower border gives back what the wider one covered.
  Scene small = ballScene();
  small.labels = labelsOf(small.volume->grid, [](glm::ivec3 i) { return glm::length(glm::dvec3(i) - 12.0) < 3.0; });
  Scene byValue = ballScene();
  byValue.look.focus = ValueFocus{{700.0, infinity}, 0.0};
  const std::vector<std::function<void(Scene&)>> changes{
      [](Scene& s) { s.look.cutaway.borderWidth = 12.0; },
      [](Scene& s) { s.look.cutaway.borderColour = {0.2, 0.9, 0.4}; },
      [](Scene& s) { s.look.cutaway.borderWidth = 1.5; },
      [](Scene& s) { s.look.contextLayer.strength = 0.4; },
      [](Scene& s) { s.look.cutaway.borderWidth = 0.0; },
      [](Scene& s) { s.look.cutaway.borderWidth = 50.0; },
  };
  for (const Scene& start : {ballScene(), small, byValue})
    for (const Camera& camera :
         {viewOf(start).camera, viewOf(start, Projection::Orthographic).camera,
          lookAt(start.volume->grid.centre() + glm::dvec3(3.0, 6.0, 2.0), start.volume->grid.centre())}) {
      Scene scene = start;
      const View view{camera, size, 1.0, Quality::Draft};
      Renderer kept(std::make_shared<GpuScene>());
      kept.render(scene, view);
      for (std::size_t i = 0; i < changes.size(); ++i) {
        changes[i](scene);
        kept.render(scene, view);
        const std::vector<glm::vec4> picture = kept.readLayers().final;
        EXPECT_TRUE(picture == renderOnce(scene, camera, size, Quality::Draft).layers.final) << "change " << i;
      }
    }
}

TEST_F(Passes, PictureIsTheRightWayUp) {
  // A bright octant at the patient's left, anterior, superior corner, seen from the front: right and up in the picture.
  const Grid grid = gridOf({24, 24, 24});
  Scene scene;
  scene.volume = volumeOf<std::uint8_t>(grid, [](glm::ivec3 i) { return i.x > 14 && i.y < 9 && i.z > 14 ? 200 : 0; });
  scene.look.context.function = opaqueFrom(100.0);
  Renderer renderer(std::make_shared<GpuScene>());
  renderer.render(scene, {Camera::standard(StandardView::Anterior, grid), size, 1.0, Quality::Normal});
  const std::vector<std::uint8_t> picture = renderer.readPicture();
  glm::dvec2 sum(0.0);
  double count = 0.0;
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i)
      if (picture[static_cast<std::size_t>(4 * (j * size.x + i))] > 30) {
        sum += glm::dvec2(i, j);
        ++count;
      }
  ASSERT_GT(count, 100.0);
  EXPECT_GT(sum.x / count, 0.6 * size.x);
  EXPECT_LT(sum.y / count, 0.4 * size.y);
}

TEST_F(Passes, PickingFindsWhatAPixelShows) {
  Scene scene = ballScene();
  const View view = viewOf(scene, Projection::Orthographic);
  Renderer renderer(std::make_shared<GpuScene>());
  const glm::dvec3 centre = scene.volume->grid.centre();
  for (const bool cut : {true, false}) {
    scene.look.cutaway.enabled = cut;
    renderer.render(scene, view);
    const auto hit = renderer.pick(glm::dvec2(size) * 0.5);
    ASSERT_TRUE(hit.has_value());
    // The focus's surface in the opening, the body's without: 5 and 15 mm from the centre, to half a voxel's staircase.
    EXPECT_NEAR(glm::distance(*hit, centre), cut ? 5.0 : 15.0, 0.6);
    EXPECT_FALSE(renderer.pick({1.0, 1.0}).has_value());
    EXPECT_FALSE(renderer.pick({-3.0, 1e6}).has_value());
  }
}

}  // namespace
}  // namespace fenestra::tests::rendererTest
