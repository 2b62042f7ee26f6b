// Translucent labels: every stage against the reference, pictures within their bounds, the opacity that is asked for,
// and no cost without such labels.

#include <map>
#include <set>

#include "rendering/passes/FocusLayerPass.h"
#include "rendering/reference/Picture.h"
#include "tests/gl/MadeOpening.h"

namespace fenestra::tests::faintLabelsTest {
namespace {

constexpr glm::ivec2 size{61, 53};

using FaintLabelsTest = GlTest;

/// A body with a ball of label 1 in focus. Half of the context has a label: 2 and 3 in blocks, 4 and 5 voxel by voxel.
Scene body(bool lit) {
  const Grid grid = obliqueGrid({30, 26, 20});
  const glm::dvec3 middle = (glm::dvec3(grid.dims) - 1.0) * 0.5;
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [&](glm::ivec3 i) {
    const double r = glm::length((glm::dvec3(i) - middle) / middle);
    return 1000.0 * (1.1 - r) + 90.0 * std::sin(0.9 * i.x) * std::cos(0.7 * i.y + 0.5 * i.z);
  });
  scene.labels = labelsOf(grid, [&](glm::ivec3 i) {
    if (glm::length(glm::dvec3(i) - middle - glm::dvec3(2, 0, 0)) < 5.5) return 1;
    if (i.x < 14) return (i.y / 3 + i.z / 4) % 2 == 0 ? 2 + (i.x / 5) % 2 : 0;
    return i.z < 10 ? 4 + (i.x * 7 + i.y * 3 + i.z * 5) % 3 : 0;  // 6 has no setting
  });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = {{{150.0, {{0.8, 0.5, 0.4}, 0.0}},
                                  {300.0, {{0.9, 0.7, 0.6}, 0.2}},
                                  {700.0, {{0.5, 0.2, 0.2}, 0.05}},
                                  {900.0, {{1.0, 0.95, 0.9}, 1.5}}}};
  scene.look.cutaway.openWidth = 6.0;
  scene.look.shading.enabled = lit;
  put(scene.look.labels, {.label = 2, .opacity = 0.3});
  put(scene.look.labels, {.label = 3, .role = LabelRole::Protected, .opacity = 0.6});
  put(scene.look.labels, {.label = 4, .opacity = 0.02});
  put(scene.look.labels, {.label = 5, .opacity = 0.3});
  return scene;
}

std::vector<std::pair<const char*, Focus>> focuses() {
  return {{"no focus", {}}, {"labels", LabelFocus{{1}}}, {"values", ValueFocus{{620.0, 800.0}, 0.0}}};
}

Layers drawn(const Scene& scene, const View& view, Schedule schedule) {
  const auto gpu = std::make_shared<GpuScene>();
  gpu->setSchedule(schedule);
  Renderer renderer(gpu);
  renderer.render(scene, view);
  return renderer.readLayers();
}

/// Errors of the finished picture in 1/255, where the reference takes the renderer's own ray starts.
Errors pictureErrors(const Scene& scene, const View& view, const Layers& layers) {
  reference::Stages stages;
  if (hasCutaway(scene)) {
    stages = reference::geometricStages(scene, view.camera, view.size);
    stages.hits.tContext = widened(layers.tContext);
    stages.hits.tFocus = widened(layers.tFocus);
    stages.tStart = widened(layers.tStart);
  }
  const reference::Picture truth = reference::picture(scene, view.camera, view.size, stages, {});
  return errorsOf(layers.final, truth.final);
}

/// The pass alone, where every pixel has a ray; without an opening.
std::vector<glm::vec4> faceToFace(const Scene& scene, const Camera& camera, Schedule schedule) {
  GpuScene gpu;
  gpu.setSchedule(schedule);
  gpu.update(scene);
  FocusLayerPass pass;
  gl::Texture image = blank<glm::vec4>(size);
  runWhole(pass, gpu, scene.look, RayFrame(camera, size, scene.volume->grid), std::nullopt, FocusLayerPass::Sampling{},
           whole(size), image);
  return texelsOf<glm::vec4>(image);
}

double rmsOf(const Scene& scene, const Camera& camera, Schedule schedule) {
  return errorsOf(faceToFace(scene, camera, schedule), reference::picture(scene, camera, size, {}, {}).focusLayer).rms;
}

TEST_F(FaintLabelsTest, Thorough_StagesAreTheReferences) {
  for (const auto& [name, focus] : focuses()) {
    SCOPED_TRACE(name);
    Scene scene = body(false);
    scene.look.focus = focus;
    if (!hasCutaway(scene)) continue;
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic})
      expectStagesMatch(scene, aside(scene, projection), size);
  }
}

TEST_F(FaintLabelsTest, Thorough_HitsFollowTheLabels) {
  const Scene scene = body(false);
  Scene whole = scene;
  whole.look.labels.clear();
  const std::vector<float> here = renderOnce(scene, aside(scene), size).layers.tContext;
  const std::vector<float> before = renderOnce(whole, aside(scene), size).layers.tContext;
  std::size_t later = 0;
  for (std::size_t i = 0; i < here.size(); ++i) later += here[i] > before[i] + 0.05f;
  EXPECT_GT(later, here.size() / 50) << "else the test above would hold for either";
}

TEST_F(FaintLabelsTest, Thorough_BoundsHold) {
  for (const auto& [name, focus] : focuses())
    for (const bool lit : {false, true})
      for (const bool open : {false, true}) {
        Scene scene = body(lit);
        scene.look.focus = focus;
        scene.look.cutaway.enabled = open;
        if (open && !hasCutaway(scene)) continue;
        for (const Schedule schedule : pictureSchedules())
          for (const double bound : {4.0, 2.0, 1.0, 0.5}) {
            View view{aside(scene), size, 1.0, Quality::High};
            view.maxError = bound;
            EXPECT_LE(pictureErrors(scene, view, drawn(scene, view, schedule)).worst, bound)
                << name << (lit ? ", lit" : ", unlit") << (open ? ", open, " : ", closed, ") << nameOf(schedule);
          }
      }
}

TEST_F(FaintLabelsTest, Exhaustive_HoldInSplines) {
  for (const auto& [name, focus] : focuses())
    for (const bool lit : {false, true}) {
      SCOPED_TRACE(std::string(name) + (lit ? ", lit" : ", unlit"));
      Scene scene = body(lit);
      scene.look.reconstruction = Reconstruction::Cubic;
      scene.look.focus = focus;
      if (hasCutaway(scene) && !lit) expectStagesMatch(scene, aside(scene), size);
      for (const Schedule schedule : pictureSchedules())
        for (const double bound : {4.0, 0.5}) {
          View view{aside(scene), size, 1.0, Quality::High};
          view.maxError = bound;
          EXPECT_LE(pictureErrors(scene, view, drawn(scene, view, schedule)).worst, bound) << nameOf(schedule);
        }
    }
}

TEST_F(FaintLabelsTest, Exhaustive_BoundsHoldBesideFunctionsOfTheFocusAndClipping) {
  const TransferFunction function{
      {{600.0, {{1.0, 0.2, 0.1}, 0.0}}, {800.0, {{0.9, 0.9, 0.2}, 0.4}}, {900.0, {{0.1, 0.4, 1.0}, 1.5}}}};
  for (const bool lit : {false, true}) {
    Scene scene = body(lit);
    scene.look.focus = LabelFocus{{1, 5}};
    put(scene.look.labels, {.label = 1, .function = function});
    Clipping& clipping = scene.look.clipping;
    clipping.planes.push_back({glm::normalize(glm::dvec3(0.3, 1.0, 0.2)), 0.0});
    clipping.planes.back().offset = glm::dot(clipping.planes.back().normal, scene.volume->grid.centre()) - 6.0;
    clipping.exempt = {2, 4};
    for (const bool open : {false, true}) {
      scene.look.cutaway.enabled = open;
      for (const Schedule schedule : pictureSchedules())
        for (const double bound : {4.0, 1.0, 0.5}) {
          View view{aside(scene), size, 1.0, Quality::High};
          view.maxError = bound;
          EXPECT_LE(pictureErrors(scene, view, drawn(scene, view, schedule)).worst, bound)
              << (lit ? "lit" : "unlit") << (open ? ", open, " : ", closed, ") << nameOf(schedule);
        }
    }
  }
}

/// One body on a grid of n voxels along each axis; the labels change at the same planes for every even n.
Scene refined(int n, bool lit) {
  const double spacing = 40.0 / n;
  Scene scene;
  scene.volume =
      volumeOf<float>(gridOf(glm::ivec3(n), glm::dvec3(spacing), glm::dvec3(0.5 * spacing)), [&](glm::ivec3 i) {
        const glm::dvec3 p = (glm::dvec3(i) + 0.5) * spacing;
        return 500.0 + 400.0 * std::sin(p.x / 9.0 + p.z / 13.0) * std::cos(p.y / 11.0 - p.x / 17.0);
      });
  scene.labels = labelsOf(scene.volume->grid, [&](glm::ivec3 i) {
    const glm::ivec3 block = i * 8 / n;
    return (block.x + block.y + block.z) % 2;
  });
  scene.look.context.function = {
      {{50.0, {{1.0, 0.2, 0.1}, 0.0}}, {500.0, {{0.8, 0.7, 0.3}, 0.03}}, {950.0, {{0.2, 0.4, 1.0}, 0.08}}}};
  scene.look.shading.enabled = lit;
  put(scene.look.labels, {.label = 1, .opacity = 0.3});
  return scene;
}

TEST_F(FaintLabelsTest, PicturesWithoutABoundAreOfSecondOrder) {
  for (const bool lit : {false, true})
    for (const Schedule schedule : pictureSchedules()) {
      const Camera camera = Camera::fromAngles(30.0, 20.0, refined(16, lit).volume->grid);
      std::vector<double> errors;
      for (const int n : {16, 32, 64}) errors.push_back(rmsOf(refined(n, lit), camera, schedule));
      // A quarter of the cells' side: a sixteenth of the error by second order, a quarter by first. The tables'
      // rounding and early termination take their share.
      EXPECT_LT(errors[2], errors[0] / 9.0) << nameOf(schedule) << (lit ? ", lit" : ", unlit");
      EXPECT_LT(errors[1], errors[0] / 2.5) << nameOf(schedule) << (lit ? ", lit" : ", unlit");
      EXPECT_LT(errors[0], 0.5) << nameOf(schedule) << (lit ? ", lit" : ", unlit");
    }
}

TEST_F(FaintLabelsTest, Thorough_PicturesWithoutABoundAreNearTheReference) {
  for (const auto& [name, focus] : focuses())
    for (const bool lit : {false, true}) {
      Scene scene = body(lit);
      scene.look.focus = focus;
      scene.look.cutaway.enabled = false;
      Scene plain = scene;
      plain.look.labels.clear();
      for (const Schedule schedule : pictureSchedules()) {
        const double here = rmsOf(scene, aside(scene), schedule), before = rmsOf(plain, aside(plain), schedule);
        // The functions' cuts within these cells may raise the error by a half at most.
        EXPECT_LE(here, 1.5 * before + 0.1) << name << (lit ? ", lit, " : ", unlit, ") << nameOf(schedule);
      }
    }
}

TEST_F(FaintLabelsTest, AnEvenMediumShowsItsOpacityOfItself) {
  Scene scene = body(false);
  scene.look.focus = {};
  const OpticalProperties even{{0.9, 0.5, 0.2}, 0.06};
  scene.look.context.function = {{{0.0, even}, {1000.0, even}}};
  scene.labels = labelsOf(scene.volume->grid, [](glm::ivec3) { return 2; });
  Scene plain = scene;
  plain.labels = nullptr;
  View view{aside(scene), size, 1.0, Quality::High};
  for (const Schedule schedule : pictureSchedules())
    for (const std::optional<double> bound : {std::optional<double>(), std::optional(0.5)}) {
      view.maxError = bound;
      const Layers here = drawn(scene, view, schedule), there = drawn(plain, view, schedule);
      for (std::size_t i = 0; i < here.final.size(); ++i)
        // Some forty pieces of a ray, each with an exponential in float32.
        EXPECT_LE(glm::length(here.final[i] - 0.3f * there.final[i]), 1e-4f) << nameOf(schedule);
    }
}

/// An opaque ball of label 2 and a thin and a thick slab of label 3 in a clear medium; label 1, behind them all, is a
/// wall.
Scene opaqueBodies(bool lit) {
  const Grid grid = gridOf({48, 40, 40});
  const auto ball = [](glm::ivec3 i) { return glm::length(glm::dvec3(i) - glm::dvec3(20.0, 12.0, 20.0)) < 8.3; };
  const auto slabs = [](glm::ivec3 i) {
    return i.y >= 24 && i.y < 36 && i.x >= 8 && i.x < (i.z < 20 ? 10 : 24) && i.z >= 6 && i.z < 34;
  };
  Scene scene;
  scene.volume =
      volumeOf<std::int16_t>(grid, [&](glm::ivec3 i) { return ball(i) || slabs(i) || i.x >= 40 ? 1000 : 0; });
  scene.labels = labelsOf(grid, [&](glm::ivec3 i) { return i.x >= 40 ? 1 : ball(i) ? 2 : slabs(i) ? 3 : 0; });
  scene.look.context.function = {{{520.0, {{1.0, 0.9, 0.8}, 0.0}}, {540.0, {{1.0, 0.9, 0.8}, 40.0}}}};
  scene.look.focusAppearance.extinction = 40.0;
  scene.look.shading.enabled = lit;
  put(scene.look.labels, {.label = 1, .role = LabelRole::Hidden});
  return scene;
}

/// From the front, so that slabs are seen face on.
View headOn(const Scene& scene) {
  const glm::dvec3 centre = scene.volume->grid.centre();
  return {lookAt(centre - glm::dvec3(200.0, 0.0, 0.0), centre, Projection::Orthographic, 42.0),
          {84, 84},
          1.0,
          Quality::High};
}

TEST_F(FaintLabelsTest, BodiesHaveTheOpacityThatIsAskedForThinOrThick) {
  for (const double opacity : {0.1, 0.4, 0.8})
    for (const bool inFocus : {false, true})
      for (const std::optional<double> bound : {std::optional<double>(), std::optional(0.5)}) {
        Scene scene = opaqueBodies(false);
        for (const std::uint16_t label : {2, 3}) put(scene.look.labels, {.label = label, .opacity = opacity});
        if (inFocus) scene.look.focus = LabelFocus{{2, 3}};
        scene.look.cutaway.enabled = false;
        View view = headOn(scene);
        view.maxError = bound;
        const Layers layers = drawn(scene, view, usualSchedule());
        const auto alphaAt = [&](glm::ivec2 pixel) {
          return layers.final[static_cast<std::size_t>(pixel.y * view.size.x + pixel.x)].a;
        };
        // In the context a voxel beside the label shows, where it is as bright, as what it is: away from the rim, then.
        int met = 0, right = 0;
        for (int y = 0; y < view.size.y; ++y)
          for (int x = 0; x < view.size.x; ++x) {
            if (alphaAt({x, y}) == 0.0f) continue;
            ++met;
            right += std::abs(alphaAt({x, y}) - opacity) <= 1.0 / 255.0;
            EXPECT_LE(alphaAt({x, y}), (inFocus ? opacity : 1.0) + 1.0 / 255.0);
          }
        EXPECT_GT(met, 1000);
        EXPECT_GT(right, met * (inFocus ? 0.95 : 0.8)) << (bound ? "bounded" : "normal");
      }
}

TEST_F(FaintLabelsTest, TheRimOfAProtectedLabelIsNotRagged) {
  for (const double opacity : {0.1, 0.4, 0.8}) {
    Scene scene = opaqueBodies(false);
    scene.look.labels.clear();
    scene.look.focus = LabelFocus{{1}};
    scene.look.cutaway.openWidth = 60.0;
    scene.look.cutaway.borderWidth = 0.0;
    scene.look.contextLayer.strength = 0.0;
    put(scene.look.labels, {.label = 2, .role = LabelRole::Protected, .opacity = opacity});
    const View view = headOn(scene);
    const std::vector<glm::vec4> layer = drawn(scene, view, usualSchedule()).protectedLayer;
    ASSERT_EQ(layer.size(), std::size_t{84 * 84});
    int met = 0, ragged = 0;
    for (int y = 1; y < 83; ++y)
      for (int x = 1; x < 83; ++x) {
        const auto alphaAt = [&](int i, int j) { return layer[static_cast<std::size_t>(j * 84 + i)].a; };
        const float here = alphaAt(x, y);
        if (here == 0.0f) continue;
        ++met;
        EXPECT_LE(here, opacity + 1.0 / 255.0);
        // Along the rim and inside, neighbours that meet the label differ by little.
        for (const float beside : {alphaAt(x + 1, y), alphaAt(x, y + 1)})
          ragged += beside > 0.0f && std::abs(beside - here) > 4.0f / 255.0f;
      }
    EXPECT_GT(met, 500) << opacity;
    EXPECT_LE(ragged, met / 50) << opacity << ": " << met;
  }
}

TEST_F(FaintLabelsTest, Thorough_TheDevicesCopyFollowsEveryChange) {
  const auto gpu = std::make_shared<GpuScene>();
  Renderer renderer(gpu);
  Scene scene = body(true);
  View view{aside(scene), size, 1.0, Quality::High};
  view.maxError = 1.0;
  const auto expectRight = [&](const char* what) {
    renderer.render(scene, view);
    EXPECT_EQ(renderer.readLayers().final, drawn(scene, view, gpu->schedule()).final) << what;
  };
  expectRight("at first");
  put(scene.look.labels, {.label = 2, .opacity = 0.31});
  expectRight("one more opacity");
  put(scene.look.labels, {.label = 2, .opacity = 0.7});
  expectRight("another order of opacities");
  put(scene.look.labels, {.label = 4});
  expectRight("one opacity fewer");
  scene.look.focusAppearance.function =
      TransferFunction{{{600.0, {{1.0, 0.2, 0.1}, 0.0}}, {900.0, {{0.1, 0.4, 1.0}, 1.5}}}};
  scene.look.focus = ValueFocus{{620.0, 800.0}, 0.0};
  expectRight("a function of the focus");
  put(scene.look.labels, {.label = 5});
  expectRight("a function fewer before it");
  scene.look.focus = LabelFocus{{1, 2}};
  expectRight("a faint label in focus");
  scene.look.context.shift = 40.0;
  expectRight("a shift");
  put(scene.look.labels, {.label = 3, .opacity = 0.0});
  expectRight("a label hidden by its opacity");
  scene.look.labels.clear();
  expectRight("none");
}

TEST_F(FaintLabelsTest, CostNothingWhereThereAreNone) {
  Scene whole = body(true);
  whole.look.labels.clear();
  // Settings that make no label translucent.
  Scene none = whole;
  put(none.look.labels, {.label = 1, .role = LabelRole::Protected});  // in focus
  put(none.look.labels, {.label = 77, .opacity = 0.4});               // without voxels
  const auto memoryOf = [](const Scene& scene) {
    const auto gpu = std::make_shared<GpuScene>();
    Renderer(gpu).render(scene, {aside(scene), size});
    std::vector<std::pair<std::string, std::size_t>> memory;
    for (const GpuScene::Resource& resource : gpu->resources()) memory.emplace_back(resource.name, resource.bytes);
    return memory;
  };
  EXPECT_EQ(memoryOf(none), memoryOf(whole));
  Scene faint = whole;
  put(faint.look.labels, {.label = 2, .opacity = 0.3});
  put(faint.look.labels, {.label = 3, .opacity = 0.3});
  const auto more = memoryOf(faint), less = memoryOf(whole);
  std::map<std::string, std::size_t> bytes(more.begin(), more.end()), without(less.begin(), less.end());
  EXPECT_GT(bytes["faint labels"], 0u);
  EXPECT_LE(bytes["faint labels"], whole.volume->grid.voxelCount() * 8 / 5) << "a byte a voxel of a box";
  EXPECT_EQ(bytes["transfer tables"], without["transfer tables"]) << "labels share the volume's function";

  // No further programs draw the picture, and none declares the index.
  std::set<std::string> sources, before;
  gl::ShaderProgram::listen(
      [&](const gl::ShaderProgram&, std::string_view, const std::string& source) { sources.insert(source); });
  drawn(whole, {aside(whole), size}, usualSchedule());
  before = std::exchange(sources, {});
  drawn(none, {aside(none), size}, usualSchedule());
  EXPECT_EQ(sources, before);
  drawn(faint, {aside(faint), size}, usualSchedule());
  EXPECT_NE(sources, before);
  gl::ShaderProgram::listen({});
}

}  // namespace
}  // namespace fenestra::tests::faintLabelsTest
