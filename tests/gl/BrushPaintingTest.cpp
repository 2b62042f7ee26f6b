// Painting: it runs for the pixels under the stroke alone, with the result of a run for all; what it costs; and
// picking.

#include "tests/gl/BrushTesting.h"

namespace fenestra::tests::brushPaintingTest {
namespace {

using Brush = GlTest;

void expectSamePicture(const Layers& a, const Layers& b, const std::string& after) {
  EXPECT_TRUE(sameBits(a.tStart, b.tStart)) << after;
  EXPECT_TRUE(sameBits(a.edits, b.edits)) << after;
  EXPECT_TRUE(sameBits(a.focusLayer, b.focusLayer)) << after;
  EXPECT_TRUE(sameBits(a.final, b.final)) << after;
}

void expectPaintingGivesTheSameBits(Quality quality) {
  Scene scene = ballScene();
  View view = viewOf(scene);
  view.quality = quality;
  Renderer renderer(std::make_shared<GpuScene>());
  renderer.render(scene, view);
  std::vector<glm::dvec2> pixels;
  for (int k = 0; k < 6; ++k) pixels.emplace_back(40.0 + 8.0 * k, 38.0 + 5.0 * (k % 3));
  const BrushStroke along = painted(renderer, BrushMode::Restore, pixels, 2.0);
  BrushStroke cut = painted(renderer, BrushMode::Open, {{52, 60}, {66, 58}}, 2.5);
  BrushStroke fade = painted(renderer, BrushMode::Fade, {{60, 48}, {64, 52}}, 2.0);

  const auto step = [&](const std::string& what) {
    const auto runs = renderer.stats();
    renderer.render(scene, view);
    expectSamePicture(renderer.readLayers(), layersOf(scene, view), what);
    const std::uint64_t whole = std::uint64_t(size.x) * std::uint64_t(size.y);
    for (const Pass pass : {Pass::RayStart, Pass::FocusLayer, Pass::Composite}) {
      const PassStats& mine = renderer.stats()[static_cast<std::size_t>(pass)];
      EXPECT_EQ(mine.runs, runs[static_cast<std::size_t>(pass)].runs + 1) << what << ", " << nameOf(pass);
      EXPECT_LT(mine.pixels, whole) << what << ", " << nameOf(pass);
    }
    for (const Pass pass : {Pass::HitPoints, Pass::PullPush, Pass::DistanceMap, Pass::ContextLayer})
      EXPECT_EQ(renderer.stats()[static_cast<std::size_t>(pass)].runs, 1u) << what << ", " << nameOf(pass);
  };
  scene.look.strokes.emplace_back(along).anchors.clear();
  for (const glm::dvec3& anchor : along.anchors) {
    scene.look.strokes.back().anchors.push_back(anchor);
    step("a point more");
  }
  scene.look.strokes.push_back(cut);
  step("a stroke more");
  scene.look.strokes.push_back(fade);
  step("a fading stroke");
  scene.look.strokes[1].hidden = true;
  step("hidden");
  scene.look.strokes[1].hidden = false;
  step("shown");
  scene.look.strokes[0].depth = 3.0;
  step("another depth");
  std::swap(scene.look.strokes[0], scene.look.strokes[1]);
  step("another order");
  scene.look.strokes.pop_back();
  step("undone");
  scene.look.strokes[1].anchors.resize(2);
  step("shortened");
  scene.look.strokes[0] = fade;
  scene.look.strokes[1] = fade;
  step("all changed");
  scene.look.cutaway.openWidth = 16.0;
  scene.look.strokes[1] = cut;
  step("another width as well");
  scene.look.strokes.clear();
  step("cleared");
}

TEST_F(Brush, PaintingGivesTheSameBitsAsAFullRun) { expectPaintingGivesTheSameBits(Quality::Normal); }

TEST_F(Brush, PaintingGivesTheSameBitsAsAFullRunWithinABound) { expectPaintingGivesTheSameBits(Quality::High); }

TEST_F(Brush, NothingRunsForUnchangedOrInvisibleStrokes) {
  Scene scene = ballScene();
  const View view = viewOf(scene);
  scene.look.strokes = {painted(scene, view, BrushMode::Open, {{50, 50}})};
  Renderer renderer(std::make_shared<GpuScene>());
  renderer.render(scene, view);
  const auto before = renderer.stats();
  renderer.render(scene, view);
  BrushStroke elsewhere = scene.look.strokes[0];
  elsewhere.anchors[0] += 500.0 * view.camera.axes().right;
  scene.look.strokes.push_back(elsewhere);
  renderer.render(scene, view);
  for (std::size_t pass = 0; pass < passCount; ++pass)
    EXPECT_EQ(renderer.stats()[pass].runs, before[pass].runs) << nameOf(static_cast<Pass>(pass));
}

TEST_F(Brush, AStrokeCostsATenthOfAFrameAtMost) {
  Scene scene = ballScene();
  View view = viewOf(scene);
  view.size = {700, 650};
  view.quality = Quality::Draft;
  Renderer renderer(std::make_shared<GpuScene>());
  renderer.render(scene, view);
  constexpr double brush = 24.0;  // px
  constexpr int points = 50;
  std::vector<double> shares;
  BrushStroke stroke;
  stroke.radius = 0.0;
  scene.look.strokes = {stroke};
  for (int k = 0; k < points; ++k) {
    const glm::dvec2 pixel(350.0 + 90.0 * std::cos(0.12 * k), 325.0 + 90.0 * std::sin(0.12 * k));
    const auto point = renderer.pickBrush(pixel, BrushMode::Restore);
    ASSERT_TRUE(point.has_value());
    if (k == 0) scene.look.strokes[0].radius = brush * point->pixelSize;
    ASSERT_TRUE(extend(scene.look.strokes[0], point->anchor));
    renderer.render(scene, view);
    double most = 0.0;
    for (const Pass pass : {Pass::RayStart, Pass::FocusLayer, Pass::Composite})
      most = std::max(most, static_cast<double>(renderer.stats()[static_cast<std::size_t>(pass)].pixels));
    shares.push_back(most / (view.size.x * view.size.y));
  }
  std::sort(shares.begin(), shares.end());
  EXPECT_LE(shares[points / 2], 0.10);
  EXPECT_GT(shares.front(), 0.003) << "a disc of 24 px has 1810 of 455000 pixels";
}

TEST_F(Brush, PickingGivesTheAnchorUnderThePixelAndItsScale) {
  Scene scene = ballScene();
  const glm::dvec3 centre = scene.volume->grid.centre();
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    View view = viewOf(scene, projection);
    view.size *= 2;
    view.pixelScale = 2.0;
    Renderer renderer(std::make_shared<GpuScene>());
    EXPECT_FALSE(renderer.pickBrush({1.0, 1.0}, BrushMode::Open).has_value()) << "no picture yet";
    renderer.render(scene, view);
    const glm::dvec2 pixel(118.25, 88.75);
    const auto surface = renderer.pickBrush(pixel, BrushMode::Restore);
    const auto seen = renderer.pickBrush(pixel, BrushMode::Open);
    ASSERT_TRUE(surface && seen);
    // The body's surface of radius 15 mm, though it was cut away there; within it, what is seen.
    EXPECT_NEAR(glm::distance(surface->anchor, centre), 15.0, 0.1);
    EXPECT_LT(glm::distance(seen->anchor, centre), 13.0);
    // Between the two: what was removed before the focus, which is seen.
    EXPECT_TRUE(surface->hitsContext);
    EXPECT_TRUE(surface->meetsFocus);
    EXPECT_NEAR(surface->removed, glm::distance(surface->anchor, seen->anchor), 0.05);
    EXPECT_NEAR(surface->beforeFocus, 0.0, 1e-3);
    // Two points a device-independent pixel apart are pixelSize apart in the world (surface bending left out).
    const glm::dmat4 clip = view.camera.clipFromWorld(1.2, scene.volume->grid);
    const auto onPicture = [&](glm::dvec3 world) {
      const glm::dvec4 p = clip * glm::dvec4(world, 1.0);
      return glm::dvec2(0.5 + 0.5 * p.x / p.w, 0.5 - 0.5 * p.y / p.w) * glm::dvec2(view.size);
    };
    for (const auto& point : {*surface, *seen}) {
      EXPECT_NEAR(glm::distance(onPicture(point.anchor), pixel), 0.0, 1e-6);
      const glm::dvec3 beside = point.anchor + point.pixelSize * view.camera.axes().right;
      EXPECT_NEAR(glm::distance(onPicture(beside), pixel), 2.0, 1e-6);
    }
    // Off the body there is no anchor but the ray's at a given one's depth.
    EXPECT_FALSE(renderer.pickBrush({1.0, 1.0}, BrushMode::Restore).has_value());
    const auto off = renderer.pickBrush({1.0, 1.0}, BrushMode::Restore, surface->anchor);
    ASSERT_TRUE(off.has_value());
    EXPECT_FALSE(off->hitsContext);
    const glm::dvec3 forward = view.camera.axes().forward;
    EXPECT_NEAR(glm::dot(off->anchor - surface->anchor, forward), 0.0, 1e-9);
    EXPECT_FALSE(renderer.pickBrush({-3.0, 1e6}, BrushMode::Restore, surface->anchor).has_value());
  }
}

}  // namespace
}  // namespace fenestra::tests::brushPaintingTest
