// The brush in the renderer: what strokes do to rays and to the context layer, against the reference and on hard cases.

#include "rendering/reference/Picture.h"
#include "rendering/reference/Strokes.h"
#include "tests/gl/BrushTesting.h"

namespace fenestra::tests::brushTest {
namespace {

/// The reference's edits of the renderer's own earlier stages, so that an error shows where it arises.
reference::Edits truthOf(const Scene& scene, const View& view, const Layers& layers) {
  reference::HitPoints hits = reference::hitPoints(scene, view.camera, view.size);
  hits.tContext = widened(layers.tContext);
  hits.tFocus = widened(layers.tFocus);
  const reference::Widths widths = reference::widthsInPixels(scene, view.camera, view.size, view.pixelScale);
  const reference::Image unedited =
      reference::rayStart(hits, widened(layers.tFocusFilled), widened(layers.distance), widths.open);
  return reference::edits(scene.look.strokes, view.camera, view.size, hits, unedited);
}

/// Largest share of the strokes' effect by which the picture may miss the reference: float32 in positions on the
/// picture (1e-5 px of a few px) and along the ray, whose t in the layers rounds the more coarsely the farther it is
/// from the eye.
double tolerance(const Scene& scene, const Layers& layers) {
  double farthest = 0.0, smallest = 1e30;
  for (const float t : layers.tContext)
    if (std::isfinite(t)) farthest = std::max(farthest, static_cast<double>(t));
  for (const BrushStroke& stroke : scene.look.strokes) smallest = std::min(smallest, stroke.radius);
  return 1e-4 + 6e-7 * farthest / smallest;
}

/// Returns how many pixels the strokes changed.
std::size_t expectEditsMatch(const Scene& scene, const View& view) {
  const Layers layers = layersOf(scene, view);
  const reference::Edits truth = truthOf(scene, view, layers);
  if (layers.edits.size() != truth.offset.size()) {
    ADD_FAILURE() << layers.edits.size() << " edited pixels against " << truth.offset.size();
    return 0;
  }
  double effect = 0.0;
  for (const BrushStroke& stroke : scene.look.strokes) effect += stroke.depth;
  const double allowed = tolerance(scene, layers);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < layers.edits.size(); ++i) {
    EXPECT_NEAR(layers.edits[i].x, truth.offset[i], allowed * std::min(effect, 40.0) + 1e-5) << "pixel " << i;
    EXPECT_NEAR(layers.edits[i].y, truth.factor[i], allowed * 4.0) << "pixel " << i;
    if (std::isnan(truth.tStart[i])) {
      EXPECT_TRUE(std::isnan(layers.tStart[i])) << "pixel " << i;
    } else {
      EXPECT_NEAR(layers.tStart[i], truth.tStart[i], allowed * std::min(effect, 40.0) + 1e-5) << "pixel " << i;
    }
    changed += truth.offset[i] != 0.0 || truth.factor[i] != 1.0;
  }
  return changed;
}

using Brush = GlTest;

TEST_F(Brush, Thorough_EditsMatchTheReferenceInBothProjectionsAndAtBothScales) {
  Scene scene = ballScene();
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic})
    for (const double pixelScale : {1.0, 2.0}) {
      scene.look.strokes.clear();
      View view = viewOf(scene, projection);
      view.pixelScale = pixelScale;
      // Crossing strokes of every mode over opening, focus and bare context.
      const auto add = [&](BrushMode mode, double softness, double depth, bool covers,
                           const std::vector<glm::dvec2>& pixels) {
        BrushStroke stroke = painted(scene, view, mode, pixels);
        stroke.softness = softness;
        stroke.depth = depth;
        stroke.coversFocus = covers;
        scene.look.strokes.push_back(stroke);
      };
      add(BrushMode::Restore, 0.5, 50.0, false, {{50, 38}, {62, 40}, {70, 52}});
      add(BrushMode::Restore, 1.0, 4.0, true, {{58, 50}, {66, 47}});
      add(BrushMode::Restore, 0.6, 1.0, true, {{54, 54}, {60, 58}});
      scene.look.strokes.back().toSurface = true;
      add(BrushMode::Open, 0.3, 6.0, false, {{48, 60}, {60, 62}, {72, 60}});
      add(BrushMode::Open, 0.7, 3.0, false, {{60, 62}});
      add(BrushMode::Fade, 0.5, 0.0, false, {{55, 45}, {65, 55}});
      add(BrushMode::Strengthen, 0.2, 0.0, false, {{65, 45}, {55, 55}});
      EXPECT_GT(expectEditsMatch(scene, view), 500u);
      // And as other cameras see the same strokes.
      for (const glm::dvec2 turn : {glm::dvec2(0.4, 0.2), glm::dvec2(-0.7, 0.3), glm::dvec2(3.0, 0.0)}) {
        view.camera = frontOf(scene, projection).orbited(turn.x, turn.y);
        expectEditsMatch(scene, view);
      }
    }
}

TEST_F(Brush, HardEdgesMissNoMoreThanTheirRim) {
  Scene scene = ballScene();
  const View view = viewOf(scene);
  scene.look.strokes = {painted(scene, view, BrushMode::Restore, {{50, 40}, {70, 44}})};
  scene.look.strokes[0].softness = 0.0;
  const Layers layers = layersOf(scene, view);
  const reference::Edits truth = truthOf(scene, view, layers);
  std::size_t changed = 0, missed = 0;
  for (std::size_t i = 0; i < layers.edits.size(); ++i) {
    changed += truth.offset[i] != 0.0;
    missed += std::abs(layers.edits[i].x - truth.offset[i]) > 1e-3;
  }
  EXPECT_GT(changed, 200u);
  EXPECT_LE(missed, 1u);  // a pixel whose centre lies on the rim to 1e-5 px may fall on either side
}

TEST_F(Brush, Thorough_HardCases) {
  const Scene plain = ballScene();
  const glm::dvec3 centre = plain.volume->grid.centre();
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    const View view = viewOf(plain, projection);
    const auto changedBy = [&](const BrushStroke& stroke, const View& seen) {
      Scene scene = plain;
      scene.look.strokes = {stroke};
      return expectEditsMatch(scene, seen);
    };
    const BrushStroke line = painted(plain, view, BrushMode::Restore, {{48, 42}, {70, 40}});
    BrushStroke point = line;
    point.anchors.resize(1);
    const std::size_t dab = changedBy(point, view);
    EXPECT_GT(dab, 50u);
    BrushStroke still = point;
    still.anchors.push_back(still.anchors[0]);
    EXPECT_EQ(changedBy(still, view), dab) << "a line of no length is a dab";

    BrushStroke tiny = line;
    tiny.radius = 1e-6;
    EXPECT_EQ(changedBy(tiny, view), 0u) << "smaller than the gaps between pixel centres";
    BrushStroke huge = line;
    huge.radius = 1e6;
    // A parallel view takes it as it is; in perspective the eye is inside the stroke.
    EXPECT_EQ(changedBy(huge, view) > 1000u, projection == Projection::Orthographic);
    BrushStroke wide = line;
    wide.radius = 40.0;
    EXPECT_GT(changedBy(wide, view), 3 * dab);

    const Camera::Axes axes = view.camera.axes();
    BrushStroke behind = line;
    for (glm::dvec3& anchor : behind.anchors) anchor = view.camera.eye - 5.0 * axes.forward + 0.1 * anchor;
    EXPECT_EQ(changedBy(behind, view), 0u);
    // Behind in the middle breaks the polyline in two dabs.
    BrushStroke broken = line;
    broken.anchors.insert(broken.anchors.begin() + 1, view.camera.eye - 50.0 * axes.forward);
    const std::size_t both = changedBy(broken, view);
    EXPECT_GT(both, dab);
    EXPECT_LT(both, changedBy(line, view));
    // An end far outside the picture, on the same line: the rest stays as it was.
    BrushStroke outside = line;
    outside.anchors.push_back(line.anchors[1] + 1e5 * axes.right);
    EXPECT_GE(changedBy(outside, view), changedBy(line, view));

    View far = view;
    far.camera.eye = centre - 1e6 * axes.forward;
    if (projection == Projection::Perspective) far.camera.verticalFov = 0.003;
    EXPECT_GT(changedBy(line, far), 50u);

    View single = view;
    single.size = {1, 1};
    changedBy(wide, single);
  }
}

TEST_F(Brush, CameraInsideTheVolume) {
  Scene scene = ballScene();
  View view = viewOf(scene);
  view.camera = lookAt(glm::dvec3(19.5, 3.0, 19.5), glm::dvec3(19.5, 17.0, 21.0));
  view.camera.verticalFov = 60.0;
  scene.look.strokes = {painted(scene, view, BrushMode::Open, {{30, 30}, {20, 60}, {30, 80}}, 2.0)};
  scene.look.strokes[0].depth = 3.0;
  BrushStroke around = scene.look.strokes[0];
  around.anchors = {view.camera.eye + glm::dvec3(0.5, 0.5, 0.5), view.camera.eye - glm::dvec3(3.0, 3.0, 3.0)};
  scene.look.strokes.push_back(around);
  expectEditsMatch(scene, view);
}

TEST_F(Brush, StrokesWithoutEffectCostNothing) {
  const Scene plain = ballScene();
  const View view = viewOf(plain);
  const auto render = [&](const BrushStrokes& strokes) {
    Scene scene = plain;
    scene.look.strokes = strokes;
    Renderer renderer(std::make_shared<GpuScene>());
    renderer.render(scene, view);
    EXPECT_EQ(renderer.stats()[static_cast<std::size_t>(Pass::EditMap)].runs, 0u);
    EXPECT_TRUE(renderer.readLayers().edits.empty());
    return std::pair(renderer.readLayers().final, renderer.imageBytes());
  };
  const auto none = render({});
  const BrushStroke good = painted(plain, view, BrushMode::Restore, {{50, 40}, {70, 44}});
  BrushStroke hidden = good, notANumber = good, infinite = good, flat = good, shallow = good, empty = good;
  hidden.hidden = true;
  notANumber.anchors[1].y = nan;
  infinite.anchors[0].x = infinity;
  flat.radius = 0.0;
  shallow.depth = 0.0;
  empty.anchors.clear();
  EXPECT_EQ(render({hidden, notANumber, infinite, flat, shallow, empty}), none);
  // Without a cutaway there is no ray start to move.
  Scene closed = plain;
  closed.look.cutaway.enabled = false;
  const auto before = layersOf(closed, view).final;
  closed.look.strokes = {good};
  EXPECT_EQ(layersOf(closed, view).final, before);
}

TEST_F(Brush, NeverHidesTheFocusUnlessAsked) {
  Scene scene = ballScene();
  const View view = viewOf(scene);
  const Layers plain = layersOf(scene, view);
  BrushStroke stroke = painted(scene, view, BrushMode::Restore, {{45, 50}, {75, 50}}, 8.0);
  stroke.depth = 1e3;
  stroke.softness = 0.0;
  for (const bool covers : {false, true}) {
    stroke.coversFocus = covers;
    scene.look.strokes = {stroke};
    const Layers edited = layersOf(scene, view);
    std::size_t restored = 0, focus = 0;
    for (std::size_t i = 0; i < edited.tStart.size(); ++i) {
      if (std::isnan(edited.tContext[i])) continue;
      if (!covers && !std::isnan(edited.tFocus[i])) {
        EXPECT_EQ(edited.tStart[i], edited.tFocus[i]);
      }
      if (edited.tStart[i] == plain.tStart[i]) continue;
      // A float32 rounding of the offset and one of the sum.
      EXPECT_NEAR(edited.tStart[i], edited.tContext[i], 2e-5) << "a deep hard brush restores all";
      ++restored;
      focus += !std::isnan(edited.tFocus[i]);
    }
    EXPECT_GT(restored, 100u);
    EXPECT_EQ(focus > 100u, covers);
  }
  // Opening stops at the focus and at the volume's end.
  stroke.mode = BrushMode::Open;
  scene.look.strokes = {stroke};
  const Layers opened = layersOf(scene, view);
  for (std::size_t i = 0; i < opened.tStart.size(); ++i)
    if (!std::isnan(opened.tFocus[i])) {
      EXPECT_EQ(opened.tStart[i], opened.tFocus[i]);
    }
}

TEST_F(Brush, ActsOnWhatItWasPaintedOnAlone) {
  Scene scene = ballScene();
  scene.look.cutaway.openWidth = 5.0;
  const View view = viewOf(scene);
  for (const BrushMode mode : {BrushMode::Restore, BrushMode::Open, BrushMode::Fade, BrushMode::Strengthen}) {
    scene.look.strokes.clear();
    // Over focus and cut faces; Open where the cut begins, since at the focus's rim the cuts of both sides meet.
    const std::vector<glm::dvec2> across{{48, 42}, {60, 36}, {74, 42}}, rim{{46, 42}, {60, 33}, {74, 42}};
    BrushStroke stroke = painted(scene, view, mode, mode == BrushMode::Open ? rim : across);
    stroke.coversFocus = true;
    stroke.depth = 100.0;
    scene.look.strokes = {stroke};
    const auto changed = [&](const Camera& camera) {
      View seen = view;
      seen.camera = camera;
      const Layers layers = layersOf(scene, seen);
      return std::count_if(layers.edits.begin(), layers.edits.end(),
                           [](glm::vec2 edit) { return edit != glm::vec2(0.0f, 1.0f); });
    };
    const auto front = changed(view.camera);
    EXPECT_GT(front, 80);
    EXPECT_GT(changed(view.camera.orbited(0.3, 0.0)), front / 2) << "seen from a little aside it is still there";
    for (const double turn : {2.6, 3.14159, 3.6}) EXPECT_EQ(changed(view.camera.orbited(turn, 0.0)), 0) << turn;
  }
}

TEST_F(Brush, RestoresNothingBehindAnotherSurface) {
  // Painted on the ball; then a plate comes between it and the eye.
  Scene scene = ballScene();
  const View view = viewOf(scene, Projection::Orthographic);
  const glm::dvec3 forward = view.camera.axes().forward, centre = scene.volume->grid.centre();
  const BrushStroke stroke = painted(scene, view, BrushMode::Restore, {{50, 42}, {70, 42}});
  const std::shared_ptr<const Volume> ball = scene.volume;
  const Grid grid = gridOf({80, 80, 80}, glm::dvec3(1.0), glm::dvec3(-20.0));
  scene.volume = volumeOf<std::int16_t>(grid, [&](glm::ivec3 i) {
    const glm::dvec3 p = glm::dvec3(i) - 20.0;
    const double before = glm::dot(centre - p, forward);
    return before > 30.0 && before < 33.0 ? 500.0 : 1000.0 - 60.0 * glm::length(p - 19.5);
  });
  scene.labels = labelsOf(grid, [&](glm::ivec3 i) {
    return glm::length(glm::dvec3(i) - 20.0 - glm::dvec3(19.5, 17.0, 21.0)) < 6.0 ? 1 : 0;
  });
  scene.look.strokes = {stroke};
  const Layers layers = layersOf(scene, view);
  ASSERT_FALSE(layers.edits.empty());
  for (const glm::vec2 edit : layers.edits) EXPECT_EQ(edit.x, 0.0f);
}

TEST_F(Brush, GraduatesTheContextLayer) {
  Scene scene = ballScene();
  scene.look.contextLayer.strength = 0.5;
  const View view = viewOf(scene);
  const Layers plain = layersOf(scene, view);
  scene.look.contextLayer.strength = 0.0;
  const Layers bare = layersOf(scene, view);
  scene.look.contextLayer.strength = 0.5;
  BrushStroke stroke = painted(scene, view, BrushMode::Fade, {{40, 50}, {80, 50}}, 30.0);
  stroke.softness = 0.0;
  stroke.amount = 1.0;
  scene.look.strokes = {stroke};
  EXPECT_EQ(layersOf(scene, view).final, bare.final) << "faded away";
  const auto share = [&](const Layers& layers) {
    double sum = 0.0;
    for (std::size_t i = 0; i < bare.final.size(); ++i) sum += glm::distance(layers.final[i], bare.final[i]);
    return sum;
  };
  scene.look.strokes[0].mode = BrushMode::Strengthen;
  const Layers strong = layersOf(scene, view);
  ASSERT_GT(share(plain), 1.0);
  // The layer's opacity doubles, and is added over the same picture below it.
  EXPECT_NEAR(share(strong) / share(plain), 2.0, 1e-3);
}

TEST_F(Brush, PictureMatchesTheReference) {
  Scene scene = ballScene();
  scene.look.contextLayer.illuminationWeight = 0.6;
  scene.look.contextLayer.valueWeight = 0.4;
  View view = viewOf(scene);
  view.maxError = 0.25;
  const BrushStrokes strokes{painted(scene, view, BrushMode::Restore, {{50, 38}, {70, 52}}),
                             painted(scene, view, BrushMode::Open, {{48, 60}, {72, 60}}),
                             painted(scene, view, BrushMode::Fade, {{55, 45}, {60, 48}}),
                             painted(scene, view, BrushMode::Strengthen, {{64, 50}, {60, 55}})};
  scene.look.strokes = strokes;
  scene.look.strokes[0].coversFocus = true;
  const Layers layers = layersOf(scene, view);
  const Layers plain = [&] {
    Scene without = scene;
    without.look.strokes.clear();
    return layersOf(without, view);
  }();

  // The renderer's own stages 1 to 4, so that only the stages after them are compared.
  reference::Stages stages;
  stages.hits = reference::hitPoints(scene, view.camera, view.size);
  stages.hits.tContext = widened(layers.tContext);
  stages.hits.tFocus = widened(layers.tFocus);
  stages.tStart = widened(layers.tStart);
  stages.editFactor = truthOf(scene, view, layers).factor;
  reference::PictureOptions options;
  for (int j = 24; j < 80; j += 3)
    for (int i = 36; i < 86; i += 3) options.pixels.emplace_back(i, j);
  const reference::Picture truth = reference::picture(scene, view.camera, view.size, stages, options);
  double sum = 0.0, worst = 0.0;
  std::size_t edited = 0;
  for (std::size_t k = 0; k < options.pixels.size(); ++k) {
    const auto at = static_cast<std::size_t>(options.pixels[k].y * size.x + options.pixels[k].x);
    const double error = glm::distance(glm::dvec4(layers.final[at]), truth.final[k]);
    sum += error;
    edited += glm::distance(layers.final[at], plain.final[at]) > 0.02f;
    worst = std::max(worst, error);
  }
  // Distances of RGBA: four channels within the bound of a quarter step of 8 bits make half a step. The curvature,
  // found in float32 from a volume of 16 bits and steeply turned into opacity, adds to single pixels.
  EXPECT_LE(sum / static_cast<double>(options.pixels.size()), 0.5 / 255.0);
  EXPECT_LE(worst, 4.0 / 255.0);
  EXPECT_GT(edited, 60u);
}

/// Expects that the layers that depend on strokes are equal, bit for bit.

}  // namespace
}  // namespace fenestra::tests::brushTest
