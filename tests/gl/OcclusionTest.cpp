// Ambient occlusion and the soft shadow: pictures against the reference within their bounds, in scenes of every kind;
// what they depend on; and that they cost nothing while they are off.

#include <algorithm>
#include <set>

#include "rendering/reference/Picture.h"
#include "tests/gl/GlTest.h"
#include "tests/gl/SceneKinds.h"

namespace fenestra::tests::occlusionTest {
namespace {

constexpr glm::ivec2 size{61, 53};

using OcclusionTest = GlTest;

std::shared_ptr<GpuScene> gpuWith(Schedule schedule) {
  const auto gpu = std::make_shared<GpuScene>();
  gpu->setSchedule(schedule);
  return gpu;
}

/// A body of 100³ voxels, so that cells are of two voxels, with two organs.
Scene body() {
  const Grid grid = gridOf({72, 100, 60}, {1.0, 0.8, 1.3}, {-30.0, 12.0, 400.0});
  Scene scene = bodyWithOrgans<std::int16_t>(grid);
  const glm::dvec3 middle = (glm::dvec3(grid.dims) - 1.0) * 0.5;
  const auto labels = labelsOf(grid, [&](glm::ivec3 i) {
    const glm::dvec3 p = (glm::dvec3(i) - middle) / middle;
    return glm::length(p - glm::dvec3(0.2, 0.0, 0.1)) < 0.3 ? 1
           : glm::length(glm::dvec2(p.x + 0.3, p.z)) < 0.12 ? 2
                                                            : 0;
  });
  labels->labels = scene.labels->labels;
  scene.labels = labels;
  scene.look.focus = LabelFocus{{1}};
  scene.look.cutaway.openWidth = 9.0;
  return occluded(scene);
}

View within(const Scene& scene, double bound, Projection projection = Projection::Perspective) {
  View view{Camera::fromAngles(30.0, 20.0, scene.volume->grid, projection), size, 1.0, Quality::High};
  view.maxError = bound;
  return view;
}

/// The reference's picture. Without another camera's opening its rays start where the renderer's do: on silhouettes
/// rounding decides where that is.
reference::Picture truthOf(const Scene& scene, const View& view, const Layers& layers) {
  reference::Stages stages;
  if (hasCutaway(scene)) {
    stages = reference::geometricStages(scene, view);
    stages.hits.tContext = widened(layers.tContext);
    stages.hits.tFocus = widened(layers.tFocus);
    if (!stages.apart) stages.tStart = widened(layers.tStart);
  }
  return reference::picture(scene, view.camera, view.size, stages, {});
}

/// Errors of a picture in 1/255 of its worst channel, sorted.
std::vector<double> errorsOf(const Layers& layers, const reference::Picture& truth) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < truth.final.size(); ++i) {
    double worst = 0.0;
    for (int channel = 0; channel < 4; ++channel) {
      const double error = 255.0 * std::abs(layers.final[i][channel] - truth.final[i][channel]);
      worst = std::isnan(error) ? infinity : std::max(worst, error);
    }
    errors.push_back(worst);
  }
  std::sort(errors.begin(), errors.end());
  return errors;
}
std::vector<double> errorsOf(const Scene& scene, const View& view, const Layers& layers) {
  return errorsOf(layers, truthOf(scene, view, layers));
}

struct Case {
  std::string name;
  Scene scene;
};

std::vector<Case> cases() {
  const Scene base = body();
  const auto with = [&](auto&& change) {
    Scene scene = base;
    change(scene);
    return scene;
  };
  return {{"open", base},
          {"closed", with([](Scene& s) { s.look.focus = {}; })},
          {"occlusion alone", with([](Scene& s) { s.look.shading.shadow = 0.0; })},
          {"shadow alone, from above", with([](Scene& s) {
             s.look.shading.occlusion = 0.0;
             s.look.shading.shadow = 1.0;
             s.look.shading.lightElevation = 75.0;
           })},
          {"values", with([](Scene& s) {
             s.look.focus = ValueFocus{{95.0, 1000.0}, 0.0};
           })},
          {"protected", withProtected(base)},
          {"faint", with([](Scene& s) { put(s.look.labels, {.label = 2, .opacity = 0.3}); })},
          {"hidden", with([](Scene& s) { put(s.look.labels, {.label = 2, .role = LabelRole::Hidden}); })},
          {"brushed", brushed(base)},
          {"clipped", clipped(base, false)},
          {"clipped, grey, exempt", with([](Scene& s) {
             s = clipped(s, true);
             s.look.clipping.exempt = {2};
           })},
          {"by value", byValue(base)},
          {"spline", with([](Scene& s) { s.look.reconstruction = Reconstruction::Cubic; })}};
}

TEST_F(OcclusionTest, Exhaustive_PicturesKeepTheirBounds) {
  for (const Case& each : cases()) {
    std::optional<reference::Picture> truth;
    for (const Schedule schedule : pictureSchedules()) {
      Renderer renderer(gpuWith(schedule));
      for (const double bound : {4.0, 2.0, 1.0, 0.5}) {
        const View view = within(each.scene, bound);
        renderer.render(each.scene, view);
        const Layers layers = renderer.readLayers();
        // Rays start in the same places whatever the schedule and the bound.
        if (!truth) truth = truthOf(each.scene, view, layers);
        const std::vector<double> errors = errorsOf(layers, *truth);
        // Where a label or grey begins in a face, rounding decides which of both a pixel shows.
        const std::size_t onEdges = each.scene.look.clipping.grey ? 3 : 0;
        EXPECT_LE(errors[errors.size() - 1 - onEdges], bound) << each.name << ", bound " << bound;
      }
    }
  }
}

TEST_F(OcclusionTest, ParallelRaysKeepTheirBoundsToo) {
  const Scene scene = body();
  Renderer renderer(gpuWith(usualSchedule()));
  const View view = within(scene, 0.5, Projection::Orthographic);
  renderer.render(scene, view);
  EXPECT_LE(errorsOf(scene, view, renderer.readLayers()).back(), 0.5);
}

/// The opening that casts is the one of the camera that cuts it. Rounding decides where rays that graze it start, with
/// occlusion or without.
TEST_F(OcclusionTest, Thorough_AFrozenOpeningIsLitAsTheReferenceHasIt) {
  const Scene scene = body();
  View view = within(scene, 1.0);
  view.frozen = OpeningView{Camera::fromAngles(-10.0, 5.0, scene.volume->grid), {57, 58}, 1.0};
  for (const Schedule schedule : pictureSchedules()) {
    Renderer renderer(gpuWith(schedule));
    const auto beyond = [&](const Scene& shown) {
      renderer.render(shown, view);
      const std::vector<double> errors = errorsOf(shown, view, renderer.readLayers());
      return errors.end() - std::upper_bound(errors.begin(), errors.end(), 1.0);
    };
    Scene without = scene;
    without.look.shading.occlusion = without.look.shading.shadow = 0.0;
    const auto grazing = beyond(without);
    EXPECT_LT(grazing, size.x * size.y / 50);
    EXPECT_LE(beyond(scene), grazing + size.x * size.y / 500);
  }
}

/// Pictures without a bound are as near to the reference as they are without occlusion: their own error is of the
/// integral from face to face.
TEST_F(OcclusionTest, NormalQualityIsNoFurtherOffThanWithout) {
  Scene scene = body();
  const auto rms = [&] {
    const View view{Camera::fromAngles(30.0, 20.0, scene.volume->grid), size, 1.0, Quality::Normal};
    Renderer renderer(gpuWith(Schedule::Llvmpipe));
    renderer.render(scene, view);
    double sum = 0.0;
    const std::vector<double> errors = errorsOf(scene, view, renderer.readLayers());
    for (const double error : errors) sum += error * error;
    return std::sqrt(sum / static_cast<double>(errors.size()));
  };
  const double with = rms();
  scene.look.shading.occlusion = scene.look.shading.shadow = 0.0;
  const double without = rms();
  // Interpolated between faces, the light's own error is of the same order.
  EXPECT_LE(with, 1.2 * without + 0.1) << without;
}

std::uint64_t runsOf(const Renderer& renderer, Pass pass) {
  return renderer.stats()[static_cast<std::size_t>(pass)].runs;
}

TEST_F(OcclusionTest, Thorough_RunsAgainOnlyWhenWhatItDependsOnChanges) {
  Scene scene = body();
  scene.look.strokes.clear();
  Renderer renderer(gpuWith(usualSchedule()));
  View view = within(scene, 2.0);
  std::uint64_t expected = 0;
  const auto render = [&](bool runs, const char* what) {
    expected += runs;
    renderer.render(scene, view);
    EXPECT_EQ(runsOf(renderer, Pass::Occlusion), expected) << what;
  };
  render(true, "first");
  render(false, "nothing changed");
  scene.look.cutaway.borderWidth += 1.0;
  render(false, "the border casts nothing");
  scene.look.shading.ambient = 0.4;
  render(false, "how bright light is");
  scene.look.shading.shadow = 0.2;
  render(true, "strength");
  scene.look.cutaway.openWidth += 4.0;
  render(true, "the opening");
  scene = brushed(scene);
  render(true, "a stroke");
  scene.look.context.shift = 5.0;
  render(true, "the transfer function");
  view.camera = Camera::fromAngles(50.0, 20.0, scene.volume->grid);
  render(true, "the opening turns with the camera");
  scene.look.cutaway.enabled = false;
  render(true, "no opening");
  scene.look.shading.shadow = 0.0;
  render(true, "no shadow");
  view.camera = Camera::fromAngles(70.0, 20.0, scene.volume->grid);
  render(false, "occlusion does not depend on the camera");
  view = {view.camera, size, 1.0, Quality::Draft};
  render(false, "a draft takes what is there");
  scene.look.shading.occlusion = 0.3;
  render(true, "a draft of its own");
  view.quality = Quality::Normal;
  render(true, "at rest with all directions");
}

/// A picture drawn after a change is the one that a fresh renderer draws.
TEST_F(OcclusionTest, Thorough_ChangesLeaveNothingBehind) {
  Scene scene = body();
  Renderer renderer(gpuWith(usualSchedule()));
  const auto expectFresh = [&](const Scene& changed, const char* what) {
    const View view = within(changed, 2.0);
    renderer.render(changed, view);
    Renderer fresh(gpuWith(usualSchedule()));
    fresh.render(changed, view);
    EXPECT_EQ(renderer.readPicture(), fresh.readPicture()) << what;
  };
  expectFresh(scene, "first");
  expectFresh(brushed(scene), "a stroke");
  expectFresh(scene, "the stroke undone");
  Scene wider = scene;
  wider.look.cutaway.openWidth = 13.0;
  expectFresh(wider, "a wider opening");
  Scene off = scene;
  off.look.shading.occlusion = off.look.shading.shadow = 0.0;
  expectFresh(off, "off");
  expectFresh(withProtected(scene), "protected");
  Scene denser = scene;
  denser.look.focusAppearance.extinction = 0.05;
  expectFresh(denser, "a clearer focus");
}

/// A view that leaves them out is that of a look without, and the next one has them again.
TEST_F(OcclusionTest, AViewInMotionLeavesThemOut) {
  const Scene scene = body();
  Scene without = scene;
  without.look.shading.occlusion = without.look.shading.shadow = 0.0;
  const View still = within(scene, 2.0);
  View moving = still;
  moving.occlusion = false;
  Renderer renderer(gpuWith(usualSchedule())), other(gpuWith(usualSchedule()));
  renderer.render(scene, still);
  const auto atRest = renderer.readPicture();
  renderer.render(scene, moving);
  EXPECT_EQ(runsOf(renderer, Pass::Occlusion), 1) << "of the first picture";
  other.render(without, still);
  EXPECT_EQ(renderer.readPicture(), other.readPicture());
  EXPECT_NE(renderer.readPicture(), atRest);
  renderer.render(scene, still);
  EXPECT_EQ(renderer.readPicture(), atRest);
}

/// While it is off, no program contains any of its code.
TEST_F(OcclusionTest, OffItIsInNoProgram) {
  std::set<std::string> paths;
  int with = 0;
  gl::ShaderProgram::listen([&](const gl::ShaderProgram&, std::string_view path, const std::string& source) {
    paths.insert(std::string(path));
    with += source.find("const bool OCCLUDES = true;") != std::string::npos;
  });
  const auto programs = [&] {
    return std::ranges::count_if(paths, [](const std::string& path) { return path.starts_with("Occlu"); });
  };
  Scene scene = body();
  scene.look.shading.occlusion = scene.look.shading.shadow = 0.0;
  Renderer renderer(gpuWith(usualSchedule()));
  renderer.render(scene, within(scene, 2.0));
  EXPECT_EQ(programs(), 0);
  EXPECT_EQ(with, 0);
  scene = occluded(scene);
  scene.look.shading.enabled = false;
  renderer.render(scene, within(scene, 2.0));
  EXPECT_EQ(programs(), 0) << "unlit";
  scene.look.shading.enabled = true;
  renderer.render(scene, within(scene, 2.0));
  gl::ShaderProgram::listen({});
  EXPECT_EQ(programs(), 3);
  EXPECT_EQ(with, 1);
}

/// The bottom of a pit is darker than the ground around it, and lighter again where what walled it in is removed.
TEST_F(OcclusionTest, APitIsDarkerThanTheGround) {
  const Grid grid = gridOf({64, 64, 40});
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [](glm::ivec3 i) {
    const bool pit = std::abs(i.x - 32) < 6 && std::abs(i.y - 32) < 6;
    return i.z < (pit ? 12 : 28) ? 100 : 0;
  });
  scene.look.context.function = {{{20.0, {{1.0, 1.0, 1.0}, 0.0}}, {80.0, {{1.0, 1.0, 1.0}, 2.0}}}};
  scene.look.shading.occlusion = 1.0;
  const Camera camera =
      lookAt(grid.centre() + glm::dvec3(0.0, 0.0, 300.0), grid.centre(), Projection::Orthographic, 64.0);
  View view{camera, {64, 64}, 1.0, Quality::High};
  Renderer renderer(gpuWith(usualSchedule()));
  const auto brightness = [&](glm::ivec2 pixel) {
    const Layers layers = renderer.readLayers();
    return layers.final[static_cast<std::size_t>(pixel.y * 64 + pixel.x)].x;
  };
  renderer.render(scene, view);
  const float pit = brightness({32, 32}), ground = brightness({10, 32});
  scene.look.shading.occlusion = 0.0;
  renderer.render(scene, view);
  EXPECT_NEAR(brightness({32, 32}), brightness({10, 32}), 0.02f);
  // Ambient light is 0.3 of 1, and a pit as deep as it is wide loses more than half of it.
  EXPECT_LT(pit, ground - 0.1f);
}

}  // namespace
}  // namespace fenestra::tests::occlusionTest
