// The edit map alone, against the reference's strokes: hits at random, strokes of every mode across them, none at all,
// and pictures that need larger tiles.

#include "rendering/passes/EditMapPass.h"

#include "rendering/passes/DistanceMapPass.h"
#include "rendering/reference/Strokes.h"
#include "tests/gl/PassTest.h"

namespace fenestra::tests::editMapPassTest {
namespace {

constexpr double openWidth = 9.0;

struct MadeEdits {
  Grid grid = gridOf({24, 18, 14}, glm::dvec3(1.0, 1.3, 0.8), glm::dvec3(-12.0, 30.0, 5.0));
  Camera camera;
  glm::ivec2 size;
  RayFrame rays;
  MadeHits hits;
  std::vector<float> filled, distances;
  BrushStrokes strokes;

  MadeEdits(glm::ivec2 pictureSize, Where focus, Projection projection = Projection::Perspective)
      : camera(Camera::fromAngles(33.0, 21.0, grid, projection)),
        size(pictureSize),
        rays(camera, size, grid),
        hits(madeHits(camera, size, grid, focus)) {
    std::mt19937 random(23);
    const auto share = [&] { return std::uniform_real_distribution<double>(0.0, 1.0)(random); };
    for (std::size_t i = 0; i < hits.texels.size(); ++i) {
      filled.push_back(static_cast<float>(glm::mix(-20.0, 20.0, share())));
      distances.push_back(share() < 0.2 ? DistanceMapPass::beyond : static_cast<float>(2.0 * openWidth * share()));
    }
  }

  /// A stroke through points of the picture, given as shares of its size, as deep as the box's near half.
  BrushStroke& paint(BrushMode mode, double radius, const std::vector<glm::dvec2>& points) {
    BrushStroke stroke;
    stroke.mode = mode;
    stroke.radius = radius;
    stroke.depth = 6.0;
    for (const glm::dvec2 point : points)
      stroke.anchors.push_back(rays.worldPosition(point * glm::dvec2(size), -0.2 * grid.boundingRadius()));
    return strokes.emplace_back(stroke);
  }

  /// Crossing strokes of every mode.
  void paintAll() {
    paint(BrushMode::Restore, 4.0, {{0.3, 0.35}, {0.5, 0.4}, {0.7, 0.6}});
    BrushStroke& covering = paint(BrushMode::Restore, 5.0, {{0.4, 0.5}, {0.6, 0.45}});
    covering.coversFocus = true;
    covering.softness = 1.0;
    paint(BrushMode::Restore, 4.0, {{0.2, 0.5}, {0.45, 0.7}}).toSurface = true;
    paint(BrushMode::Open, 6.0, {{0.25, 0.6}, {0.5, 0.65}, {0.75, 0.6}}).softness = 0.3;
    paint(BrushMode::Fade, 5.0, {{0.4, 0.4}, {0.6, 0.6}});
    paint(BrushMode::Open, 3.0, {{0.5, 0.65}}).softness = 0.7;
    paint(BrushMode::Strengthen, 4.0, {{0.6, 0.4}, {0.4, 0.6}}).softness = 0.4;
  }

  std::vector<glm::vec2> edits(Schedule schedule, const ProjectedStrokes& projected) const {
    const gl::Texture hitImage = imageOf(hits.texels, size), filledImage = imageOf(filled, size),
                      distanceImage = imageOf(distances, size);
    EditMapPass pass;
    const auto run = [&](const std::vector<gl::Region>& regions, gl::Texture& image) {
      runWhole(pass, schedule, rays, RayStartPass::Inputs{hitImage, filledImage, distanceImage, openWidth}, projected,
               regions, image);
    };
    gl::Texture image = blank<glm::vec2>(size);
    run(whole(size), image);
    const std::vector<glm::vec2> all = texelsOf<glm::vec2>(image);
    expectPartsMakeTheWhole(all, size, run);
    expectOnlyTheRegionIsWritten(all, size, run);
    return all;
  }

  reference::Image unedited() const {
    return reference::rayStart(hits.truth, timesOf(filled, rays), reference::Image(distances.begin(), distances.end()),
                               openWidth);
  }
};

/// Returns how many pixels the strokes change.
std::size_t expectEditsMatch(const MadeEdits& made) {
  const reference::Image unedited = made.unedited();
  const reference::Edits truth = reference::edits(made.strokes, made.camera, made.size, made.hits.truth, unedited);
  double effect = 0.0, smallest = infinity;
  for (const BrushStroke& stroke : made.strokes) {
    effect += stroke.depth;
    smallest = std::min(smallest, stroke.radius);
  }
  // Shares of the strokes' effects: float32 in places on the picture, 1e-5 of a radius of few pixels, and in positions
  // along rays, 2e-5 mm of a radius of few mm.
  const double allowed = 1e-4 + 2e-5 / smallest;
  for (const Schedule schedule : schedules) {
    SCOPED_TRACE(named(schedule, made.size));
    const std::vector<glm::vec2> edits = made.edits(schedule, project(made.strokes, made.rays));
    for (std::size_t i = 0; i < edits.size(); ++i) {
      EXPECT_NEAR(edits[i].x, truth.offset[i], allowed * effect + 2e-5) << "pixel " << i;
      // Over the focus the context layer's share is a quotient of lengths: the part of the removed stretch that is
      // still gone.
      const bool meetsFocus = !std::isnan(made.hits.truth.tFocus[i]);
      const double removed = meetsFocus ? unedited[i] - made.hits.truth.tContext[i] : infinity;
      EXPECT_NEAR(edits[i].y, truth.factor[i], 4.0 * allowed + (allowed * effect + 4e-5) / removed) << "pixel " << i;
      if (std::isnan(made.hits.truth.tContext[i])) {
        EXPECT_EQ(edits[i], glm::vec2(0.0f, 1.0f)) << "pixel " << i;
      }
    }
  }
  std::size_t changed = 0;
  for (std::size_t i = 0; i < truth.offset.size(); ++i) changed += truth.offset[i] != 0.0 || truth.factor[i] != 1.0;
  return changed;
}

using EditMapPassTest = GlTest;

TEST_F(EditMapPassTest, EveryModeInPicturesOfAnySize) {
  for (const glm::ivec2 size : awkwardSizes)
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
      MadeEdits made(size, Where::Somewhere, projection);
      made.paintAll();
      // In a picture of a few pixels the strokes may miss what little of the volume there is.
      EXPECT_GE(expectEditsMatch(made), pixelsIn(size) > 100 ? pixelsIn(size) / 20 : 0);
    }
}

TEST_F(EditMapPassTest, FocusNowhereAndEverywhere) {
  for (const Where focus : {Where::Nowhere, Where::Everywhere}) {
    MadeEdits made({33, 17}, focus);
    made.paintAll();
    EXPECT_GT(expectEditsMatch(made), 50u);
  }
}

TEST_F(EditMapPassTest, WithoutStrokesThereIsNoEdit) {
  MadeEdits made({33, 17}, Where::Somewhere);
  EXPECT_EQ(expectEditsMatch(made), 0u);
  // One whose lines are all out of view, and one that is beside the volume.
  made.paint(BrushMode::Open, 2.0, {{9.0, 9.0}, {12.0, 9.0}});
  EXPECT_EQ(expectEditsMatch(made), 0u);
  ProjectedStrokes lineless = project(made.strokes, made.rays);
  ASSERT_EQ(lineless.size(), 1u);
  lineless[0].lines.clear();
  for (const Schedule schedule : schedules)
    for (const glm::vec2 edit : made.edits(schedule, lineless)) EXPECT_EQ(edit, glm::vec2(0.0f, 1.0f));
}

TEST_F(EditMapPassTest, RaysThatMeetNothingAreNotEdited) {
  MadeEdits made({33, 17}, Where::Somewhere);
  made.paintAll();
  for (glm::vec2& hit : made.hits.texels) hit = glm::vec2(nothing);
  for (const Schedule schedule : schedules)
    for (const glm::vec2 edit : made.edits(schedule, project(made.strokes, made.rays)))
      EXPECT_EQ(edit, glm::vec2(0.0f, 1.0f));
}

TEST_F(EditMapPassTest, ManyStrokesInOneTile) {
  MadeEdits made({33, 17}, Where::Somewhere);
  for (int k = 0; k < 60; ++k) {
    const glm::dvec2 at(0.3 + 0.4 * (k % 8) / 7.0, 0.3 + 0.4 * (k % 5) / 4.0);
    BrushStroke& stroke = made.paint(static_cast<BrushMode>(k % 4), 3.0, {at, at + 0.1, at + glm::dvec2(0.1, 0.0)});
    stroke.depth = 1.0;
    stroke.amount = 0.1;
  }
  EXPECT_GT(expectEditsMatch(made), 50u);
}

TEST_F(EditMapPassTest, PicturesTooLargeForTheSmallestTiles) {
  // 147 × 130 tiles of 16 pixels would be more than there may be. Only a window of it meets anything.
  constexpr glm::ivec2 size{2350, 2070};
  const gl::Region window{{1301, 1003}, {150, 90}};
  MadeEdits made({1, 1}, Where::Nowhere);
  made.size = size;
  made.rays = RayFrame(made.camera, size, made.grid);
  made.filled.assign(pixelsIn(size), 0.0f);
  made.distances.assign(pixelsIn(size), DistanceMapPass::beyond);
  made.hits.texels.assign(pixelsIn(size), glm::vec2(nothing));
  made.hits.truth = {reference::Image(pixelsIn(size), nan), reference::Image(pixelsIn(size), nan),
                     reference::Image(pixelsIn(size), nan)};
  for (int j = 0; j < window.size.y; ++j)
    for (int i = 0; i < window.size.x; ++i) {
      const glm::ivec2 pixel = window.origin + glm::ivec2(i, j);
      const auto span = reference::clip(reference::pixelRay(made.camera, size, pixel), made.grid);
      if (!span) continue;
      const std::size_t at = offsetOf(pixel, size);
      const float context = positionOf(glm::mix(span->tIn, span->tOut, 0.2), made.rays);
      made.hits.texels[at].x = context;
      made.hits.truth.tContext[at] = timeOf(context, made.rays);
      made.hits.truth.tOut[at] = span->tOut;
    }
  made.paint(BrushMode::Open, 3.0, {{0.5, 0.48}, {0.6, 0.5}});
  made.paint(BrushMode::Open, 1.0, {{0.58, 0.51}});
  const reference::Image unedited = made.hits.truth.tContext;
  const reference::Edits truth = reference::edits(made.strokes, made.camera, size, made.hits.truth, unedited);
  const gl::Texture hitImage = imageOf(made.hits.texels, size), filledImage = imageOf(made.filled, size),
                    distanceImage = imageOf(made.distances, size);
  for (const Schedule schedule : schedules) {
    gl::Texture image = blank<glm::vec2>(size);
    EditMapPass pass;
    runWhole(pass, schedule, made.rays, RayStartPass::Inputs{hitImage, filledImage, distanceImage, openWidth},
             project(made.strokes, made.rays), std::span(&window, 1), image);
    EXPECT_GT(pass.bytes(), 0u);
    pass.release();
    EXPECT_EQ(pass.bytes(), 0u);
    const std::vector<glm::vec2> edits = texelsOf<glm::vec2>(image);
    std::size_t changed = 0;
    for (int j = 0; j < window.size.y; ++j)
      for (int i = 0; i < window.size.x; ++i) {
        const std::size_t at = offsetOf(window.origin + glm::ivec2(i, j), size);
        // float32 in places on a picture of 2000 pixels is 1e-4 px, of a radius of 50.
        EXPECT_NEAR(edits[at].x, truth.offset[at], 2e-4 * 12.0) << i << ", " << j;
        EXPECT_NEAR(edits[at].y, truth.factor[at], 2e-4 * 4.0) << i << ", " << j;
        changed += truth.offset[at] != 0.0;
      }
    EXPECT_GT(changed, 2000u);
  }
}

}  // namespace
}  // namespace fenestra::tests::editMapPassTest
