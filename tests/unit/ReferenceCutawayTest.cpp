// Fill, distance, ray start and widths of the reference.

#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include "rendering/reference/Reference.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference::referenceCutawayTest {
namespace {

using namespace tests;

Image randomKnown(glm::ivec2 size, double share, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::bernoulli_distribution known(share);
  std::uniform_real_distribution<double> t(100.0, 300.0);
  Image image(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  for (double& pixel : image) pixel = known(random) ? t(random) : nan;
  return image;
}

bool sameBits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

constexpr glm::ivec2 sizes[] = {{1, 1}, {2, 1}, {1, 7}, {3, 3}, {16, 16}, {37, 22}, {701, 649}};

TEST(ReferenceFill, keepsKnownPixelsAndLeavesNoHole) {
  for (const glm::ivec2 size : sizes)
    for (const double share : {0.002, 0.3, 1.0}) {
      Image known = randomKnown(size, share, 1);
      known[known.size() / 2] = 200.0;
      const Image filled = fill(known, size);
      ASSERT_EQ(filled.size(), known.size());
      for (std::size_t i = 0; i < known.size(); ++i) {
        EXPECT_TRUE(std::isnan(known[i]) || sameBits(filled[i], known[i]));
        // Averages and convex combinations stay within the range of their inputs.
        EXPECT_GE(filled[i], 100.0 - 1e-9);
        EXPECT_LE(filled[i], 300.0 + 1e-9);
      }
    }
}

TEST(ReferenceFill, ofNothingIsNothing) {
  for (const glm::ivec2 size : sizes) {
    const Image filled = fill(Image(static_cast<std::size_t>(size.x * size.y), nan), size);
    EXPECT_TRUE(std::all_of(filled.begin(), filled.end(), [](double t) { return std::isnan(t); }));
  }
}

TEST(ReferenceFill, oneKnownPixelFillsThePicture) {
  const glm::ivec2 size(53, 31);
  Image known(53 * 31, nan);
  known[17 * 53 + 40] = 123.25;
  for (const double t : fill(known, size)) EXPECT_EQ(t, 123.25);
}

TEST(ReferenceFill, handComputedRow) {
  // Level 1 of (1, ?, 4) is (1, 4): the unknown pixel takes 12/16 of its own block and 4/16 of the next.
  EXPECT_EQ(fill({1.0, nan, 4.0}, {3, 1}), (Image{1.0, 1.75, 4.0}));
  // Level 1 of (?, ?, 2, 6, ?) is (?, 4, ?), level 2 (4, ?), level 3 (4).
  EXPECT_EQ(fill({nan, nan, 2.0, 6.0, nan}, {5, 1}), (Image{4.0, 4.0, 2.0, 6.0, 4.0}));
}

TEST(ReferenceFill, handComputedBlock) {
  // 4×4 with its four corners known: level 1 holds them, and each unknown pixel is 9, 3, 3 and 1 sixteenths of them.
  Image known(16, nan);
  known[0] = 0.0;
  known[3] = 16.0;
  known[12] = 32.0;
  known[15] = 160.0;
  const Image filled = fill(known, {4, 4});
  EXPECT_DOUBLE_EQ(filled[5], (9.0 * 0 + 3.0 * 16 + 3.0 * 32 + 160) / 16.0);
  EXPECT_DOUBLE_EQ(filled[6], (9.0 * 16 + 3.0 * 0 + 3.0 * 160 + 32) / 16.0);
  EXPECT_DOUBLE_EQ(filled[9], (9.0 * 32 + 3.0 * 0 + 3.0 * 160 + 16) / 16.0);
  EXPECT_DOUBLE_EQ(filled[10], (9.0 * 160 + 3.0 * 16 + 3.0 * 32 + 0) / 16.0);
  EXPECT_DOUBLE_EQ(filled[1], (12.0 * 0 + 4.0 * 16) / 16.0);  // clamped above the picture
}

double bruteForceDistance(const Image& known, glm::ivec2 size, glm::ivec2 pixel) {
  double least = infinity;
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i)
      if (!std::isnan(known[static_cast<std::size_t>(j * size.x + i)]))
        least = std::min(least, glm::length(glm::dvec2(pixel) - glm::dvec2(i, j)));
  return least;
}

TEST(ReferenceDistance, isTheNearestKnownPixel) {
  for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(1, 30), glm::ivec2(30, 1), glm::ivec2(37, 22)})
    for (const double share : {0.0, 0.01, 0.4})
      for (const double range : {0.0, 5.0, infinity}) {
        const Image known = randomKnown(size, share, 9);
        const Image distance = distanceMap(known, size, range);
        for (int j = 0; j < size.y; ++j)
          for (int i = 0; i < size.x; ++i) {
            const double exact = bruteForceDistance(known, size, {i, j});
            const double expected = exact <= range ? exact : infinity;
            EXPECT_EQ(distance[static_cast<std::size_t>(j * size.x + i)], expected) << i << ", " << j;
          }
      }
}

TEST(ReferenceRayStart, followsTheFormula) {
  HitPoints hits;
  hits.tContext = {10.0, 10.0, 10.0, 10.0, nan, 10.0};
  hits.tFocus = {30.0, nan, nan, nan, nan, nan};
  hits.tOut = {100.0, 100.0, 100.0, 100.0, nan, 20.0};
  const Image filled = {30.0, 34.0, 34.0, 34.0, 34.0, 34.0};
  const Image distance = {0.0, 6.0, 24.0, 24.5, 1.0, 1.0};
  const Image start = rayStart(hits, filled, distance, 24.0);
  EXPECT_EQ(start[0], 30.0);
  EXPECT_DOUBLE_EQ(start[1], 34.0 + 0.25 * (10.0 - 34.0));
  EXPECT_EQ(start[2], 10.0);  // the rim meets the context
  EXPECT_EQ(start[3], 10.0);
  EXPECT_TRUE(std::isnan(start[4]));
  EXPECT_EQ(start[5], 20.0);  // never behind the box
}

TEST(ReferenceRayStart, isNeverBeforeTheContext) {
  HitPoints hits{{50.0}, {nan}, {100.0}};
  EXPECT_EQ(rayStart(hits, {20.0}, {3.0}, 24.0)[0], 50.0);
}

TEST(ReferenceRayStart, withoutAnOpeningCutsTheProjectionOnly) {
  HitPoints hits{{10.0, 10.0}, {30.0, nan}, {100.0, 100.0}};
  const Image start = rayStart(hits, {30.0, 30.0}, {0.0, 1.0}, 0.0);
  EXPECT_EQ(start[0], 30.0);
  EXPECT_EQ(start[1], 10.0);
}

TEST(ReferenceWidths, pixelsScaleWithTheScreen) {
  Scene scene = labelScene(gridOf({10, 10, 10}), [](glm::ivec3) { return 1; });
  scene.look.cutaway.openWidth = 24.0;
  scene.look.cutaway.borderWidth = 2.0;
  const Widths widths = widthsInPixels(scene, Camera::standard(StandardView::Left, scene.volume->grid), {64, 48}, 2.0);
  EXPECT_EQ(widths.open, 48.0);
  EXPECT_EQ(widths.border, 4.0);
}

TEST(ReferenceWidths, millimetresAreMeasuredAtTheFocus) {
  // The focus is the voxels x 2 … 4, y 6, z 1 … 3: its centre is (3, 6, 2) in index space.
  const Grid grid = gridOf({10, 10, 10}, {1.0, 2.0, 1.0});
  Scene scene = labelScene(grid, [](glm::ivec3 i) { return i.x >= 2 && i.x <= 4 && i.y == 6 && i.z >= 1 && i.z <= 3; });
  scene.look.cutaway.unit = WidthUnit::Millimetre;
  scene.look.cutaway.openWidth = 5.0;
  scene.look.cutaway.borderWidth = 1.0;
  Camera camera = lookAt({0.0, -100.0, 0.0}, {0.0, 0.0, 0.0});
  const double pixelsPerMm = 0.5 * 480 / (std::tan(glm::radians(15.0)) * 112.0);
  EXPECT_NEAR(widthsInPixels(scene, camera, {640, 480}, 2.0).open, 5.0 * pixelsPerMm, 1e-12 * 480);
  EXPECT_NEAR(widthsInPixels(scene, camera, {640, 480}, 1.0).border, pixelsPerMm, 1e-12 * 480);
  camera.projection = Projection::Orthographic;
  camera.orthographicHeight = 60.0;
  EXPECT_DOUBLE_EQ(widthsInPixels(scene, camera, {640, 480}, 1.0).open, 5.0 * 480 / 60.0);
}

TEST(ReferenceWidths, valueFocusIsTheBoxOfItsCells) {
  const Grid grid = gridOf({20, 20, 20});
  Scene scene = valueScene(
      grid, [](glm::ivec3 i) { return i == glm::ivec3(9, 12, 9) ? 1.0 : 0.0; }, 0.5);
  scene.look.cutaway.unit = WidthUnit::Millimetre;
  scene.look.cutaway.openWidth = 1.0;
  const Camera camera = lookAt({9.0, -100.0, 9.0}, {9.0, 0.0, 9.0});
  // Cells 11 … 12 along y span index 11 … 13.
  EXPECT_NEAR(widthsInPixels(scene, camera, {100, 100}, 1.0).open, 50.0 / (std::tan(glm::radians(15.0)) * 112.0),
              1e-12);
}

TEST(ReferenceWidths, stayFiniteWithTheFocusBehindTheCamera) {
  const Grid grid = gridOf({20, 20, 20});
  Scene scene = labelScene(grid, [](glm::ivec3 i) { return i.y == 0; });
  scene.look.cutaway.unit = WidthUnit::Millimetre;
  scene.look.cutaway.openWidth = 1.0;
  // Between the focus and the volume's centre, looking away from the focus: the centre's depth counts, 4.5 mm.
  Camera camera = lookAt({10.0, 5.0, 10.0}, {10.0, 50.0, 10.0});
  EXPECT_NEAR(widthsInPixels(scene, camera, {100, 100}, 1.0).open, 50.0 / (std::tan(glm::radians(15.0)) * 4.5), 1e-10);
  // Behind everything: a thousandth of the bounding radius.
  camera = lookAt({10.0, 50.0, 10.0}, {10.0, 90.0, 10.0});
  EXPECT_NEAR(widthsInPixels(scene, camera, {100, 100}, 1.0).open,
              50.0 / (std::tan(glm::radians(15.0)) * 1e-3 * grid.boundingRadius()), 1e-9 * 1e5);
}

TEST(ReferenceStages, withoutACutawayRaysStartAtTheContext) {
  Scene scene = labelScene(gridOf({9, 9, 9}), [](glm::ivec3 i) { return i == glm::ivec3(4); });
  scene.look.context.function = opaqueFrom(-1.0);
  scene.look.cutaway.enabled = false;
  const Camera camera = Camera::standard(StandardView::Left, scene.volume->grid);
  const Stages stages = geometricStages(scene, camera, {8, 8});
  EXPECT_TRUE(stages.tFocusFilled.empty());
  EXPECT_TRUE(stages.distance.empty());
  for (std::size_t i = 0; i < 64; ++i)
    EXPECT_TRUE(stages.tStart[i] == stages.hits.tContext[i] ||
                (std::isnan(stages.tStart[i]) && std::isnan(stages.hits.tContext[i])));
}

TEST(ReferenceStages, theOpeningIsACone) {
  // A small focus in the middle of an opaque block, seen along an axis: the start rises linearly to the surface.
  Scene scene = labelScene(gridOf({41, 41, 41}), [](glm::ivec3 i) { return i == glm::ivec3(20); });
  scene.look.context.function = opaqueFrom(-1.0);
  scene.look.cutaway.openWidth = 10.0;
  scene.look.cutaway.borderWidth = 0.0;
  const Camera camera = lookAt({20.0, -100.0, 20.0}, {20.0, 0.0, 20.0}, Projection::Orthographic, 41.0);
  const Stages stages = geometricStages(scene, camera, {41, 41});
  const double surface = 99.5, focus = 119.5;
  for (int d = 0; d <= 20; ++d) {
    const double expected = d <= 10 ? focus + (surface - focus) * d / 10.0 : surface;
    EXPECT_NEAR(stages.tStart[static_cast<std::size_t>(20 * 41 + 20 + d)], expected, 1e-9) << d;
  }
}

}  // namespace
}  // namespace fenestra::reference::referenceCutawayTest
