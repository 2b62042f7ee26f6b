// Clipped scenes: every stage against the reference, pictures within their bounds, and no cost without clipping.

#include "rendering/reference/Picture.h"
#include "tests/gl/GlTest.h"

namespace fenestra::tests::clippingTest {
namespace {

constexpr glm::ivec2 size{61, 53};

using ClippingTest = GlTest;

/// A body with a ball in focus, on an oblique lattice.
Scene body() {
  const Grid grid = obliqueGrid({30, 26, 20});
  const glm::dvec3 middle = (glm::dvec3(grid.dims) - 1.0) * 0.5;
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [&](glm::ivec3 i) {
    const double r = glm::length((glm::dvec3(i) - middle) / middle);
    return 1000.0 * (1.1 - r) + 90.0 * std::sin(0.9 * i.x) * std::cos(0.7 * i.y + 0.5 * i.z);
  });
  scene.labels = labelsOf(
      grid, [&](glm::ivec3 i) { return glm::length(glm::dvec3(i) - middle - glm::dvec3(2, 0, 0)) < 5.5 ? 1 : 0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = {{{150.0, {{0.8, 0.5, 0.4}, 0.0}},
                                  {300.0, {{0.9, 0.7, 0.6}, 0.2}},
                                  {700.0, {{0.5, 0.2, 0.2}, 0.05}},
                                  {900.0, {{1.0, 0.95, 0.9}, 1.5}}}};
  scene.look.cutaway.openWidth = 6.0;
  return scene;
}

/// body() with a rod of label 2 through all of it.
Scene bodyWithRod() {
  Scene scene = body();
  const glm::dvec3 middle = (glm::dvec3(scene.volume->grid.dims) - 1.0) * 0.5;
  scene.labels = labelsOf(scene.volume->grid, [&](glm::ivec3 i) {
    const glm::dvec3 p = glm::dvec3(i) - middle;
    return glm::length(p - glm::dvec3(2, 0, 0)) < 5.0 ? 1 : std::abs(p.x + 3.0) < 3.0 && std::abs(p.z) < 3.0 ? 2 : 0;
  });
  return scene;
}

struct ClipCase {
  const char* name;
  Clipping clipping;
};

/// Planes through the middle and boxes of every kind.
std::vector<ClipCase> clipCases(const Grid& grid) {
  const CropFrame frame(grid);
  const glm::dvec3 centre = grid.centre(), middle = frame.coordinates(centre), extent = frame.high - frame.low;
  const auto box = [&](glm::dvec3 low, glm::dvec3 high) {
    Clipping clipping;
    clipping.cropped = true;
    clipping.box = {middle + low * extent, middle + high * extent};
    return clipping;
  };
  const auto planes = [&](const std::vector<glm::dvec3>& normals, double offset) {
    Clipping clipping;
    for (const glm::dvec3& n : normals) {
      const glm::dvec3 unit = glm::normalize(n);
      clipping.planes.push_back({unit, glm::dot(unit, centre) + offset});
    }
    return clipping;
  };
  ClipCase both{"box and planes", box({-0.3, -0.2, -0.5}, {0.5, 0.4, 0.3})};
  both.clipping.planes = planes({{0.2, 1.0, 0.4}, {-1.0, 0.3, 0.1}, {0.3, 0.2, -1.0}}, -4.0).planes;
  Clipping face;
  const int axis = frame.axis.y;
  face.planes = {{frame.normal[1], frame.low.y + 6.0 * grid.spacing[axis]}};
  return {{"box", box({-0.26, -0.11, -0.31}, {0.3, 0.4, 0.26})},
          {"a plane", planes({{0.3, 1.0, -0.2}}, 0.0)},
          both,
          {"a plane between two layers of voxels", face},
          {"a box of about a voxel", box(glm::dvec3(-0.02), glm::dvec3(0.02))},
          {"a thin slice", planes({{0.1, 1.0, 0.2}, {-0.1, -1.0, -0.2}}, -0.4)},
          {"nothing is kept", planes({{0.0, 1.0, 0.0}, {0.0, -1.0, 0.0}}, 1.0)}};
}

std::vector<std::pair<const char*, Camera>> cameras(const Grid& grid) {
  const glm::dvec3 centre = grid.centre();
  return {{"from aside", Camera::fromAngles(30.0, 20.0, grid)},
          {"parallel, along the box", Camera::fromAngles(-60.0, 35.0, grid, Projection::Orthographic)},
          {"inside", lookAt(centre - glm::dvec3(0.0, 2.0, 0.0), centre + glm::dvec3(3.0, 20.0, 5.0))}};
}

/// The reference from the renderer's own starts.
reference::Picture truthOf(const Scene& scene, const View& view, const Layers& layers) {
  reference::Stages stages;
  if (hasCutaway(scene)) {
    stages = reference::geometricStages(scene, view.camera, view.size);
    stages.hits.tContext = widened(layers.tContext);
    stages.hits.tFocus = widened(layers.tFocus);
    stages.tStart = widened(layers.tStart);
  }
  return reference::picture(scene, view.camera, view.size, stages, {});
}

/// Pixels that are further than `bound`, in 1/255, off the reference's.
std::size_t wrongOf(const std::vector<glm::vec4>& layer, const std::vector<glm::dvec4>& truth, double bound) {
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    for (int channel = 0; channel < 4; ++channel)
      if (!(255.0 * std::abs(layer[i][channel] - truth[i][channel]) <= bound)) {
        ++wrong;
        break;
      }
  return wrong;
}

/// Greatest error of the focus layer in 1/255, from the renderer's own starts.
double worstOf(const Scene& scene, const View& view, const Layers& layers) {
  const reference::Picture truth = truthOf(scene, view, layers);
  double worst = 0.0;
  for (std::size_t i = 0; i < truth.focusLayer.size(); ++i)
    for (int channel = 0; channel < 4; ++channel) {
      const double error = 255.0 * std::abs(layers.focusLayer[i][channel] - truth.focusLayer[i][channel]);
      worst = std::isnan(error) ? infinity : std::max(worst, error);
    }
  return worst;
}

std::shared_ptr<GpuScene> gpuWith(Schedule schedule) {
  const auto gpu = std::make_shared<GpuScene>();
  gpu->setSchedule(schedule);
  return gpu;
}

TEST_F(ClippingTest, StagesAreTheReferences) {
  Scene scene = body();
  for (const ClipCase& each : clipCases(scene.volume->grid))
    for (const auto& [name, camera] : cameras(scene.volume->grid)) {
      SCOPED_TRACE(std::string(each.name) + ", " + name);
      scene.look.clipping = each.clipping;
      expectStagesMatch(scene, camera, size);
    }
}

TEST_F(ClippingTest, Thorough_BoundsHold) {
  Scene scene = body();
  for (const Schedule schedule : pictureSchedules()) {
    Renderer renderer(gpuWith(schedule));
    for (const bool lit : {false, true})
      for (const bool open : {false, true})
        for (const ClipCase& each : clipCases(scene.volume->grid))
          for (const double bound : {4.0, 1.0, 0.5}) {
            scene.look.shading.enabled = lit;
            scene.look.cutaway.enabled = open;
            scene.look.clipping = each.clipping;
            View view{Camera::fromAngles(30.0, 20.0, scene.volume->grid), size, 1.0, Quality::High};
            view.maxError = bound;
            renderer.render(scene, view);
            EXPECT_LE(worstOf(scene, view, renderer.readLayers()), bound)
                << each.name << (lit ? ", lit" : ", unlit") << (open ? ", open" : ", closed");
          }
  }
}

TEST_F(ClippingTest, BoundsHoldFromInsideAndAlongParallelRays) {
  Scene scene = body();
  Renderer renderer(gpuWith(usualSchedule()));
  for (const ClipCase& each : clipCases(scene.volume->grid))
    for (const auto& [name, camera] : cameras(scene.volume->grid)) {
      scene.look.clipping = each.clipping;
      View view{camera, size, 1.0, Quality::High};
      view.maxError = 1.0;
      renderer.render(scene, view);
      EXPECT_LE(worstOf(scene, view, renderer.readLayers()), 1.0) << each.name << ", " << name;
    }
}

/// Draft and normal pictures end inside cells, too: with the exact rays' ends, values that run evenly are exact.
TEST_F(ClippingTest, RaysFromFaceToFaceEndWhereTheyAreClipped) {
  Scene scene;
  const Grid grid = gridOf({40, 40, 40});
  scene.volume = volumeOf<std::int16_t>(grid, [](glm::ivec3 i) { return 100 * i.x + 60 * i.y; });
  scene.look.context.function = {{{0.0, {{1.0, 0.2, 0.1}, 0.0}}, {8000.0, {{0.2, 0.9, 0.4}, 0.04}}}};
  scene.look.shading.enabled = false;
  const Camera camera = Camera::fromAngles(33.0, 21.0, grid);
  for (const ClipCase& each : clipCases(grid))
    for (const Schedule schedule : pictureSchedules()) {
      scene.look.clipping = each.clipping;
      const View view{camera, size, 1.0, Quality::Normal};
      Renderer renderer(gpuWith(schedule));
      renderer.render(scene, view);
      // The self-attenuation of a segment is of second order in its depth: 1/255 at most here.
      EXPECT_LE(worstOf(scene, view, renderer.readLayers()), 1.0) << each.name;
    }
}

TEST_F(ClippingTest, Thorough_GreyFacesAreTheReferences) {
  Scene scene = body();
  for (const Focus& focus : {Focus(LabelFocus{{1}}), Focus(ValueFocus{{850.0, 1e4}, 0.0}), Focus()})
    for (const bool open : {true, false})
      for (const Schedule schedule : pictureSchedules()) {
        Renderer renderer(gpuWith(schedule));
        for (const ClipCase& each : clipCases(scene.volume->grid)) {
          scene.look.focus = focus;
          scene.look.cutaway.enabled = open;
          scene.look.clipping = each.clipping;
          scene.look.clipping.grey = WindowLevel{900.0, 500.0};
          View view{Camera::fromAngles(30.0, 20.0, scene.volume->grid), size, 1.0, Quality::High};
          view.maxError = 1.0;
          renderer.render(scene, view);
          const Layers layers = renderer.readLayers();
          SCOPED_TRACE(each.name);
          if (open && hasCutaway(scene)) {
            const reference::HitPoints truth = reference::hitPoints(scene, view.camera, size);
            expectStagesMatch(layers, truth, scene, view.camera, size);
          }
          // Where the focus reaches the face, rounding decides which of both a pixel shows.
          const std::size_t wrong = wrongOf(layers.focusLayer, truthOf(scene, view, layers).focusLayer, 1.0);
          EXPECT_LE(wrong, 3u) << each.name << (open ? ", open" : ", closed");
        }
      }
}

TEST_F(ClippingTest, Thorough_ExemptLabelsStayAsTheReferenceHasThem) {
  Scene scene = bodyWithRod();
  int more = 0;
  for (const Schedule schedule : pictureSchedules()) {
    Renderer renderer(gpuWith(schedule));
    for (const bool lit : {false, true})
      for (const bool open : {true, false})
        for (const ClipCase& each : clipCases(scene.volume->grid)) {
          scene.look.shading.enabled = lit;
          scene.look.cutaway.enabled = open;
          scene.look.contextLayer.strength = 0.0;
          scene.look.cutaway.borderWidth = 0.0;
          scene.look.clipping = each.clipping;
          View view{Camera::fromAngles(30.0, 20.0, scene.volume->grid), size, 1.0, Quality::High};
          view.maxError = 1.0;
          renderer.render(scene, view);
          const std::vector<glm::vec4> without = renderer.readLayers().final;
          scene.look.clipping.exempt = {2};
          renderer.render(scene, view);
          const Layers layers = renderer.readLayers();
          const reference::Picture truth = truthOf(scene, view, layers);
          double worst = 0.0;
          for (std::size_t i = 0; i < truth.final.size(); ++i)
            for (int channel = 0; channel < 4; ++channel) {
              const double error = 255.0 * std::abs(layers.final[i][channel] - truth.final[i][channel]);
              worst = std::isnan(error) ? infinity : std::max(worst, error);
            }
          EXPECT_LE(worst, 1.0) << each.name << (lit ? ", lit" : ", unlit") << (open ? ", open" : ", closed");
          more += layers.final != without;
        }
  }
  EXPECT_GT(more, 10 * static_cast<int>(pictureSchedules().size())) << "too little to tell";
}

TEST_F(ClippingTest, Thorough_StagesOfSplinesAreTheReferences) {
  Scene scene = body();
  for (const Reconstruction kind : {Reconstruction::Cubic, Reconstruction::Smooth})
    for (const bool grey : {false, true})
      for (const ClipCase& each : clipCases(scene.volume->grid)) {
        SCOPED_TRACE(std::string(each.name) + (grey ? ", grey" : ""));
        scene.look.reconstruction = kind;
        scene.look.clipping = each.clipping;
        if (grey) scene.look.clipping.grey = WindowLevel{900.0, 500.0};
        expectStagesMatch(scene, Camera::fromAngles(30.0, 20.0, scene.volume->grid), size);
      }
}

/// Capped faces, lit and grey, with a label that neither the opening nor the clipping removes.
TEST_F(ClippingTest, Thorough_SplinesAreTheReferences) {
  constexpr glm::ivec2 few{31, 27};
  Scene scene = bodyWithRod();
  scene.look.contextLayer.strength = 0.0;
  scene.look.cutaway.borderWidth = 0.0;
  scene.look.reconstruction = Reconstruction::Cubic;
  put(scene.look.labels, {.label = 2, .role = LabelRole::Protected});
  Renderer renderer(gpuWith(usualSchedule()));
  const std::vector<ClipCase> cases = clipCases(scene.volume->grid);
  for (const bool lit : {false, true})
    for (const bool open : {true, false})
      for (const bool grey : {false, true})
        for (const std::size_t which : {0, 2, 5}) {
          scene.look.shading.enabled = lit;
          scene.look.cutaway.enabled = open;
          scene.look.clipping = cases[which].clipping;
          scene.look.clipping.exempt = {2};
          if (grey) scene.look.clipping.grey = WindowLevel{900.0, 500.0};
          View view{Camera::fromAngles(30.0, 20.0, scene.volume->grid), few, 1.0, Quality::High};
          view.maxError = 1.0;
          renderer.render(scene, view);
          const Layers layers = renderer.readLayers();
          // Where the focus reaches a grey face, rounding decides which of both a pixel shows.
          EXPECT_LE(wrongOf(layers.final, truthOf(scene, view, layers).final, 1.0), grey ? 2u : 1u)
              << cases[which].name << (lit ? ", lit" : ", unlit") << (open ? ", open" : ", closed")
              << (grey ? ", grey" : "");
        }
}

/// Where every voxel has a label and all labels are exempt, clipping removes nothing.
TEST_F(ClippingTest, WhereEverythingIsExemptNothingIsClipped) {
  Scene scene = body();
  scene.look.focus = std::monostate{};
  scene.labels = labelsOf(scene.volume->grid, [](glm::ivec3) { return 1; });
  scene.look.shading.enabled = false;
  View view{Camera::fromAngles(30.0, 20.0, scene.volume->grid), size, 1.0, Quality::High};
  view.maxError = 0.5;
  Renderer renderer(std::make_shared<GpuScene>());
  renderer.render(scene, view);
  const std::vector<glm::vec4> whole = renderer.readLayers().final;
  scene.look.clipping.exempt = {1};
  for (const ClipCase& each : clipCases(scene.volume->grid)) {
    scene.look.clipping.planes = each.clipping.planes;
    scene.look.clipping.cropped = each.clipping.cropped;
    scene.look.clipping.box = each.clipping.box;
    renderer.render(scene, view);
    const std::vector<glm::vec4> kept = renderer.readLayers().final;
    for (std::size_t i = 0; i < whole.size(); ++i)
      for (int channel = 0; channel < 4; ++channel)
        ASSERT_NEAR(kept[i][channel], whole[i][channel], 2.0 * 0.5 / 255.0) << each.name;
  }
}

TEST_F(ClippingTest, OnlyWhatDependsOnItRunsAgain) {
  Scene scene = body();
  const View view{Camera::fromAngles(30.0, 20.0, scene.volume->grid), size};
  Renderer renderer(std::make_shared<GpuScene>());
  const auto runs = [&] {
    renderer.render(scene, view);
    return renderer.stats()[static_cast<std::size_t>(Pass::HitPoints)].runs;
  };
  EXPECT_EQ(runs(), 1u);
  const std::vector<std::uint8_t> whole = renderer.readPicture();
  scene.look.clipping.planes = {{{0.0, 1.0, 0.0}, scene.volume->grid.centre().y - 4.0}};
  EXPECT_EQ(runs(), 2u);
  EXPECT_EQ(runs(), 2u) << "nothing changed";
  EXPECT_NE(renderer.readPicture(), whole);
  scene.look.clipping.exempt = {7};
  EXPECT_EQ(runs(), 2u) << "a label that is not there";
  scene.look.clipping = {};
  scene.look.clipping.box = {{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
  EXPECT_EQ(runs(), 3u);
  EXPECT_EQ(renderer.readPicture(), whole) << "a box that is off";
}

/// A scene without clipping, or whose box is as large as the volume, uses no program that clips.
TEST_F(ClippingTest, CostsNothingWithoutClipping) {
  Scene scene = body();
  std::vector<std::string> sources;
  gl::ShaderProgram::listen(
      [&](const gl::ShaderProgram&, std::string_view, const std::string& source) { sources.push_back(source); });
  const auto gpu = std::make_shared<GpuScene>();
  Renderer renderer(gpu);
  const View view{Camera::fromAngles(30.0, 20.0, scene.volume->grid), size};
  renderer.render(scene, view);
  const std::vector<std::uint8_t> plain = renderer.readPicture();
  const std::size_t bytes = renderer.imageBytes(), programs = sources.size();
  const CropFrame frame(scene.volume->grid);
  scene.look.clipping.cropped = true;
  scene.look.clipping.box = {frame.low - 1.0, frame.high};
  renderer.render(scene, view);
  gl::ShaderProgram::listen({});
  EXPECT_EQ(renderer.readPicture(), plain);
  EXPECT_EQ(renderer.imageBytes(), bytes);
  EXPECT_EQ(sources.size(), programs);
  EXPECT_GT(programs, 5u);
  for (const std::string& source : sources) EXPECT_EQ(source.find("CLIPS = true"), std::string::npos);
}

TEST_F(ClippingTest, APickOnACappedFaceIsOnItsPlane) {
  Scene scene = body();
  const HalfSpace plane{glm::normalize(glm::dvec3(0.1, 1.0, 0.2)),
                        glm::dot(glm::normalize(glm::dvec3(0.1, 1.0, 0.2)), scene.volume->grid.centre())};
  scene.look.clipping.planes = {plane};
  for (const bool open : {true, false}) {
    scene.look.cutaway.enabled = open;
    Renderer renderer(std::make_shared<GpuScene>());
    renderer.render(scene, {Camera::fromAngles(0.0, 0.0, scene.volume->grid), size});
    const auto picked = renderer.pick(glm::dvec2(size) * 0.5);
    ASSERT_TRUE(picked);
    EXPECT_NEAR(plane.distance(*picked), 0.0, 1e-3);
  }
}

}  // namespace
}  // namespace fenestra::tests::clippingTest
