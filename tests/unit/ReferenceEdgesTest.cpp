// Smooth edges in the reference: closed forms of the pixels that a box's outline runs through, and the stages between
// pixel centres against those at them.

#include <cmath>

#include <gtest/gtest.h>

#include "rendering/reference/Picture.h"
#include "rendering/scene/EdgeRays.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference::referenceEdgesTest {
namespace {

using namespace fenestra::tests;

constexpr glm::ivec2 size{44, 38};
constexpr double side = 8.0;  // mm, of the box

/// A box of one opacity, which parallel rays see as a square that stands askew.
Scene boxOf(double opacity) {
  Scene scene;
  scene.volume = volumeOf(gridOf(glm::ivec3(static_cast<int>(side))), [](glm::ivec3) { return 1.0; });
  scene.look.context.function = {{{0.0, {{0.9, 0.5, 0.1}, -std::log1p(-opacity) / side}}}};
  scene.look.shading.enabled = false;
  scene.look.edges = Edges::Smooth;
  return scene;
}
Camera before(const Scene& scene) {
  const glm::dvec3 centre = scene.volume->grid.centre();
  Camera camera = lookAt(centre - glm::dvec3(0.0, 40.0, 0.0), centre, Projection::Orthographic, 13.0);
  camera.up = {0.28, 0.0, 1.0};
  return camera;
}
bool isInside(const Scene& scene, const Camera& camera, glm::dvec2 place) {
  const glm::dvec3 from = rayThrough(camera, size, place).origin - scene.volume->grid.centre();
  return std::max(std::abs(from.x), std::abs(from.z)) <= 0.5 * side;
}
/// Share of the five rays of a pixel that meet the box.
double shareInside(const Scene& scene, const Camera& camera, glm::dvec2 centre) {
  int inside = isInside(scene, camera, centre);
  for (const glm::dvec2 sample : edges::sampleOffsets) inside += isInside(scene, camera, centre + sample);
  return inside / 5.0;
}

TEST(ReferenceEdges, OutlinesAreTheMeanOfFiveRays) {
  // Contrasts from which a pixel's own ray counts alone, with the mean, and not at all.
  for (const auto& [opacity, weight] : {std::pair(50.0 / 255.0, 0.0), {80.0 / 255.0, 0.5}, {0.8, 1.0}}) {
    const Scene scene = boxOf(opacity);
    const Camera camera = before(scene);
    const Picture smooth = picture(scene, camera, size);
    int between = 0;
    for (std::size_t i = 0; i < smooth.final.size(); ++i) {
      const glm::dvec2 centre = centresOf(size)[i];
      const double own = isInside(scene, camera, centre);
      bool isEdge = false;
      for (const glm::dvec2 step : {glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(-1, 0), glm::dvec2(0, -1)})
        isEdge |= isInside(scene, camera, centre + step) != (own > 0.0);
      const double share = isEdge ? glm::mix(own, shareInside(scene, camera, centre), weight) : own;
      EXPECT_NEAR(smooth.final[i].a, opacity * share, 1e-9) << i;
      EXPECT_NEAR(smooth.final[i].r, 0.9 * opacity * share, 1e-9) << i;
      between += share > 0.05 && share < 0.95;
    }
    EXPECT_EQ(between > 40, weight > 0.0);
  }
}

TEST(ReferenceEdges, AreNearerToTheAreaThanOneRay) {
  Scene scene = boxOf(0.8);
  const Camera camera = before(scene);
  const Picture smooth = picture(scene, camera, size);
  scene.look.edges = Edges::Off;
  const Picture plain = picture(scene, camera, size);
  constexpr int fine = 32;
  const std::vector<glm::dvec2> centres = centresOf(size);
  double squares = 0.0, plainSquares = 0.0;
  for (std::size_t i = 0; i < smooth.final.size(); ++i) {
    int inside = 0;
    for (int k = 0; k < fine * fine; ++k)
      inside += isInside(scene, camera, centres[i] - 0.5 + (glm::dvec2(k % fine, k / fine) + 0.5) / double(fine));
    const double area = 0.8 * inside / (fine * fine);
    squares += std::pow(smooth.final[i].a - area, 2);
    plainSquares += std::pow(plain.final[i].a - area, 2);
  }
  // One ray is wrong by up to half of the contrast, evenly distributed: by 0.29 of it RMS. Five that are alone in their
  // fifth of the width and of the height are wrong by a tenth of it at most on an edge along either, and by some 0.1
  // RMS on others: a third.
  EXPECT_LT(std::sqrt(squares / plainSquares), 0.4);
}

TEST(ReferenceEdges, DraftsHaveNoneUnlessTheyHaveABound) {
  const Scene scene = boxOf(0.8);
  View view{.camera = before(scene), .size = size, .quality = Quality::Draft};
  Scene off = scene;
  off.look.edges = Edges::Off;
  EXPECT_EQ(picture(scene, view).final, picture(off, view).final);
  view.maxError = 1.0;
  EXPECT_NE(picture(scene, view).final, picture(off, view).final);
}

TEST(ReferenceEdges, SomePixelsAreThoseOfTheWholePicture) {
  const Scene scene = boxOf(0.8);
  const Camera camera = before(scene);
  const Picture whole = picture(scene, camera, size);
  PictureOptions options;
  for (int i = 0; i < 300; ++i) options.pixels.emplace_back(i * 7 % size.x, i * 5 % size.y);
  const Picture some = picture(scene, camera, size, options);
  ASSERT_EQ(some.final.size(), options.pixels.size());
  EXPECT_EQ(some.focusLayer.size(), options.pixels.size());
  for (std::size_t i = 0; i < options.pixels.size(); ++i)
    EXPECT_EQ(some.final[i], whole.final[static_cast<std::size_t>(options.pixels[i].y * size.x + options.pixels[i].x)]);
}

/// A ball in focus in an opaque block of one colour.
Scene ballInBlock() {
  const Grid grid = gridOf({20, 18, 19});
  Scene scene;
  scene.volume = volumeOf(grid, [](glm::ivec3) { return 1.0; });
  scene.labels = labelsOf(grid, [&](glm::ivec3 i) { return glm::length(glm::dvec3(i) - grid.centre()) < 4.0 ? 1 : 0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = {{{0.0, {{0.4, 0.6, 0.2}, 50.0}}}};
  scene.look.shading.enabled = false;
  scene.look.contextLayer.strength = 0.0;
  scene.look.cutaway.openWidth = 4.0;
  scene.look.cutaway.borderWidth = 3.0;
  scene.look.edges = Edges::Smooth;
  return scene;
}

TEST(ReferenceEdges, TheLineAroundTheOpeningIsSmoothByItself) {
  Scene scene = ballInBlock();
  const Camera camera = lookAt(scene.volume->grid.centre() - glm::dvec3(0, 60, 0), scene.volume->grid.centre(),
                               Projection::Orthographic, 24.0);
  const Stages stages = geometricStages(scene, camera, size);
  const Picture smooth = picture(scene, camera, size, stages);
  scene.look.edges = Edges::Off;
  const Picture plain = picture(scene, camera, size, stages);
  const Image distance = distanceMap(stages.hits.tFocus, size, 12.0);
  int onLine = 0, changed = 0;
  for (std::size_t i = 0; i < smooth.final.size(); ++i) {
    changed += smooth.final[i] != plain.final[i];
    if (!(distance[i] > 2.0 && distance[i] < 7.6)) continue;
    EXPECT_EQ(smooth.final[i], plain.final[i]) << "at a distance of " << distance[i];
    ++onLine;
  }
  EXPECT_GT(onLine, 200);
  EXPECT_GT(changed, 40) << "around the ball and the block";
}

TEST(ReferenceEdges, StagesBetweenPixelsAreThoseOfThePixelsAtTheirCentres) {
  Scene scene = ballInBlock();
  BrushStroke stroke;
  stroke.mode = BrushMode::Restore;
  stroke.radius = 3.0;
  stroke.depth = 2.0;
  stroke.anchors = {scene.volume->grid.centre() - glm::dvec3(5.0, 9.0, 0.0)};
  for (const bool brushed : {false, true})
    for (const double axisOffset : {0.0, 25.0}) {
      scene.look.strokes = brushed ? BrushStrokes{stroke} : BrushStrokes{};
      scene.look.cutaway.axisOffset = axisOffset;
      const View view{.camera = Camera::fromAngles(20, 15, scene.volume->grid), .size = size};
      const Stages pixels = geometricStages(scene, view);
      const Stages again = stagesBetween(scene, view.camera, size, pixels, 1.0, centresOf(size));
      const double border = scene.look.cutaway.openWidth + scene.look.cutaway.borderWidth;
      int known = 0;
      for (std::size_t i = 0; i < pixels.tStart.size(); ++i) {
        ASSERT_EQ(std::isnan(pixels.tStart[i]), std::isnan(again.tStart[i]));
        if (std::isnan(pixels.tStart[i])) continue;
        EXPECT_NEAR(again.tStart[i], pixels.tStart[i], 1e-9);
        const Image &mine = pixels.apart ? pixels.apart->distance : pixels.distance,
                    &other = again.apart ? again.apart->distance : again.distance;
        if (mine[i] <= border) {
          EXPECT_NEAR(other[i], mine[i], 1e-9);
        }
        if (!pixels.editFactor.empty()) {
          EXPECT_NEAR(again.editFactor[i], pixels.editFactor[i], 1e-9);
        }
        ++known;
      }
      EXPECT_GT(known, 500);
    }
}

}  // namespace
}  // namespace fenestra::reference::referenceEdgesTest
