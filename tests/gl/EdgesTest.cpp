// Smooth edges: pictures against the reference, against pictures of shifted cameras, and patched under strokes; while
// they are off they cost nothing.

#include <random>

#include "rendering/reference/Picture.h"
#include "rendering/scene/EdgeRays.h"
#include "tests/gl/GlTest.h"
#include "tests/gl/SceneKinds.h"

namespace fenestra::tests::edgesTest {
namespace {

constexpr glm::ivec2 size{96, 84};

using EdgesTest = GlTest;

Layers drawn(const Scene& scene, const View& view, Schedule schedule = usualSchedule()) {
  const auto gpu = std::make_shared<GpuScene>();
  gpu->setSchedule(schedule);
  Renderer renderer(gpu);
  renderer.render(scene, view);
  return renderer.readLayers();
}

Scene smooth(Scene scene) {
  scene.look.edges = Edges::Smooth;
  return scene;
}

double greatest(glm::dvec4 difference) {
  double worst = 0.0;
  for (int channel = 0; channel < 4; ++channel) {
    const double error = 255.0 * std::abs(difference[channel]);
    worst = std::isnan(error) ? infinity : std::max(worst, error);
  }
  return worst;
}

/// Errors of a picture's pixels, in 1/255, ascending.
std::vector<double> errors(const std::vector<glm::vec4>& picture, const std::vector<glm::dvec4>& truth) {
  std::vector<double> result;
  for (std::size_t i = 0; i < truth.size(); ++i) result.push_back(greatest(glm::dvec4(picture[i]) - truth[i]));
  std::sort(result.begin(), result.end());
  return result;
}

double share(const std::vector<double>& ascending, double beyond) {
  const auto first = std::upper_bound(ascending.begin(), ascending.end(), beyond);
  return static_cast<double>(ascending.end() - first) / static_cast<double>(ascending.size());
}

struct Case {
  std::string name;
  Scene scene;
  View view;
};

std::vector<Case> cases() {
  Scene body = bodyWithOrgans<std::int16_t>(gridOf({26, 24, 22}));
  body.look.focus = LabelFocus{{1, 2}};
  // Surfaces at which colours end.
  body.look.context.function = {{{30.0, {{0.9, 0.6, 0.4}, 0.0}},
                                 {30.0, {{0.9, 0.6, 0.4}, 2.0}},
                                 {90.0, {{1.0, 0.95, 0.9}, 2.0}},
                                 {90.0, {{0.3, 0.5, 1.0}, 3.0}}}};
  body.look.contextLayer.strength = 0.7;
  body.look.cutaway.borderWidth = 2.0;
  const View view{.camera = Camera::fromAngles(30.0, 20.0, body.volume->grid), .size = size, .maxError = 1.0};
  std::vector<Case> all;
  const auto add = [&](const std::string& name, auto&& change) {
    all.push_back({name, body, view});
    change(all.back().scene, all.back().view);
  };
  add("opened", [](Scene&, View&) {});
  add("unlit", [](Scene& scene, View&) { scene.look.shading.enabled = false; });
  add("no focus", [](Scene& scene, View&) { scene.look.focus = {}; });
  add("no cutaway", [](Scene& scene, View&) { scene.look.cutaway.enabled = false; });
  add("values", [](Scene& scene, View&) { scene.look.focus = ValueFocus{{95.0, 1000.0}, 0.0}; });
  add("orthographic", [](Scene& scene, View& v) {
    v.camera = Camera::fromAngles(-70.0, 35.0, scene.volume->grid, Projection::Orthographic);
  });
  add("one label, no opening width", [](Scene& scene, View&) {
    scene.look.focus = LabelFocus{{1}};
    scene.look.cutaway.openWidth = 0.0;
  });
  add("millimetres", [](Scene& scene, View&) { scene.look.cutaway.unit = WidthUnit::Millimetre; });
  add("brushed", [](Scene& scene, View&) { scene = brushed(scene); });
  add("protected", [](Scene& scene, View&) {
    scene.look.focus = LabelFocus{{1}};
    scene = withProtected(brushed(scene));
  });
  add("faint", [](Scene& scene, View&) {
    scene.look.focus = LabelFocus{{2}};
    scene = withFaint(scene);
  });
  add("axis offset", [](Scene& scene, View&) { scene.look.cutaway.axisOffset = 25.0; });
  add("frozen and brushed", [](Scene& scene, View& v) {
    scene = brushed(scene);
    v.frozen = OpeningView{Camera::fromAngles(-10.0, 5.0, scene.volume->grid), {77, 88}, 1.0};
  });
  add("clipped", [](Scene& scene, View&) { scene = clipped(scene, false); });
  add("clipped in grey, exempt", [](Scene& scene, View&) {
    scene.look.focus = LabelFocus{{1}};
    scene = clipped(scene, true);
    scene.look.clipping.exempt = {2};
  });
  add("spline", [](Scene& scene, View&) { scene.look.reconstruction = Reconstruction::Cubic; });
  add("smoothed labels", [](Scene& scene, View&) { scene.look.labelSmoothing = LabelSmoothing::Strong; });
  add("occlusion", [](Scene& scene, View&) { scene = occluded(scene); });
  return all;
}

TEST_F(EdgesTest, Thorough_PicturesAreWithinTheBoundOfTheReferences) {
  for (const Case& each : cases()) {
    const Scene scene = smooth(each.scene);
    const reference::Picture truth = reference::picture(scene, each.view);
    for (const Schedule schedule : pictureSchedules()) {
      SCOPED_TRACE(each.name + ", " + std::string(nameOf(schedule)));
      const std::vector<double> here = errors(drawn(scene, each.view, schedule).final, truth.final);
      // Where a ray grazes a surface, rounding decides whether it meets it, and one of a pixel's five rays shows
      // another colour: such pixels are held to two in a thousand, as hits are to one in a thousand rays.
      EXPECT_LE(share(here, *each.view.maxError), 0.002) << "greatest: " << here.back();
      EXPECT_LE(here.back(), 255.0);
    }
    const std::vector<double> off = errors(drawn(each.scene, each.view).final, truth.final);
    EXPECT_GT(share(off, 5.0), 0.01) << each.name << ": the test would notice";
  }
}

TEST_F(EdgesTest, Thorough_LayersAreThoseWithoutSmoothEdges) {
  for (const Case& each : cases()) {
    const Layers off = drawn(each.scene, each.view), on = drawn(smooth(each.scene), each.view);
    SCOPED_TRACE(each.name);
    EXPECT_TRUE(off.focusLayer == on.focusLayer);
    EXPECT_TRUE(sameBits(off.tStart, on.tStart));
    EXPECT_TRUE(sameBits(off.distance, on.distance));
  }
}

/// In one of `every` cases.
void expectFreeWhereOff(std::size_t every) {
  const std::vector<Case> all = cases();
  for (std::size_t i = 0; i < all.size(); i += every) {
    const Case& each = all[i];
    SCOPED_TRACE(each.name);
    View view = each.view;
    const auto gpu = std::make_shared<GpuScene>();
    Renderer plain(gpu), renderer(gpu);
    plain.render(each.scene, view);
    renderer.render(smooth(each.scene), view);
    EXPECT_EQ(renderer.stats()[std::size_t(Pass::Edges)].runs, 1u);
    EXPECT_GT(renderer.imageBytes(), plain.imageBytes());
    renderer.render(each.scene, view);
    EXPECT_EQ(renderer.imageBytes(), plain.imageBytes());
    EXPECT_TRUE(renderer.readLayers().final == plain.readLayers().final);
    view.maxError.reset();
    view.quality = Quality::Draft;
    plain.render(each.scene, view);
    renderer.render(smooth(each.scene), view);
    EXPECT_TRUE(renderer.readLayers().final == plain.readLayers().final);
    for (const Pass pass : {Pass::Edges, Pass::EdgeRays}) {
      EXPECT_EQ(renderer.stats()[std::size_t(pass)].runs, 1u);
      EXPECT_EQ(plain.stats()[std::size_t(pass)].runs, 0u);
    }
  }
}

// What decides is the edges' setting and the quality, not the scene.
TEST_F(EdgesTest, Thorough_OffTheyCostNothingAndDraftsHaveNone) { expectFreeWhereOff(3); }

TEST_F(EdgesTest, Exhaustive_OffTheyCostNothingInAnyScene) { expectFreeWhereOff(1); }

TEST_F(EdgesTest, Thorough_StrokesPatchThem) {
  Case base = cases().front();
  base.scene = smooth(base.scene);
  const Scene painted = brushed(base.scene);
  Scene more = painted;
  BrushStroke open = more.look.strokes.front();
  open.mode = BrushMode::Open;
  for (glm::dvec3& anchor : open.anchors) anchor += glm::dvec3(4.0, 0.0, 3.0);
  more.look.strokes.push_back(open);
  for (const std::optional<double> bound : {std::optional<double>(1.0), std::optional<double>()}) {
    base.view.maxError = bound;
    const auto gpu = std::make_shared<GpuScene>();
    Renderer patched(gpu);
    for (const Scene& scene : {base.scene, painted, more, painted, base.scene, more}) {
      patched.render(scene, base.view);
      Renderer whole(gpu);
      whole.render(scene, base.view);
      EXPECT_TRUE(patched.readLayers().final == whole.readLayers().final);
    }
    EXPECT_EQ(patched.stats()[std::size_t(Pass::Edges)].runs, 6u);
  }
}

TEST_F(EdgesTest, NoiseIsTheMeanOfPicturesOfShiftedCamerasInSeveralBatches) {
  // Pixels as wide as a voxel: an edge runs through most of them, more than are drawn at a time.
  const Grid grid = gridOf({320, 4, 300});
  std::mt19937 random(3);
  Scene scene;
  scene.volume = volumeOf<std::uint8_t>(grid, [&](glm::ivec3) { return random() % 200; });
  scene.look.context.function = {{{0.0, {{0.2, 0.1, 0.6}, 0.0}}, {200.0, {{1.0, 0.9, 0.3}, 6.0}}}};
  scene.look.shading.enabled = false;
  const glm::ivec2 large{330, 310};
  View view{.camera = lookAt(grid.centre() - glm::dvec3(0, 50, 0), grid.centre(), Projection::Orthographic, large.y),
            .size = large,
            .maxError = 0.5};
  const std::vector<glm::vec4> here = drawn(smooth(scene), view).final, centres = drawn(scene, view).final;
  std::vector<std::vector<glm::vec4>> shifted;
  for (const glm::dvec2 sample : edges::sampleOffsets) {
    View aside = view;
    aside.camera = view.camera.panned(sample.x, -sample.y);  // a pixel is 1 mm wide
    shifted.push_back(drawn(scene, aside).final);
  }
  std::vector<glm::dvec4> expected;
  std::size_t between = 0;
  for (int y = 0; y < large.y; ++y)
    for (int x = 0; x < large.x; ++x) {
      const auto at = [&](int i, int j) { return static_cast<std::size_t>(j * large.x + i); };
      const glm::dvec4 own(centres[at(x, y)]);
      glm::dvec4 mean = own;
      double contrast = 0.0;
      for (const auto& picture : shifted) mean += glm::dvec4(picture[at(x, y)]);
      for (const std::size_t beside : {at(std::max(x - 1, 0), y), at(std::min(x + 1, large.x - 1), y),
                                       at(x, std::max(y - 1, 0)), at(x, std::min(y + 1, large.y - 1))})
        contrast = std::max(contrast, greatest(own - glm::dvec4(centres[beside])) / 255.0);
      between += contrast > edges::leastContrast;
      expected.push_back(glm::mix(own, mean / 5.0, edges::weight(contrast)));
    }
  EXPECT_GT(between, std::size_t{1} << 16);
  // Both sides are within 0.5 of the exact colours; a ray's place is rounded to 1/100 000 of a voxel.
  const std::vector<double> off = errors(here, expected);
  EXPECT_LE(share(off, 1.0), 1e-4);
  EXPECT_LE(off.back(), 5.0);
}

}  // namespace
}  // namespace fenestra::tests::edgesTest
