// The stages with which the methods replace the adaptive cutaway's, and the pattern of the screen door.

#include "rendering/settings/Method.h"

#include <cmath>

#include <gtest/gtest.h>

#include "rendering/scene/Explosion.h"
#include "rendering/scene/Fading.h"
#include "rendering/scene/Peel.h"
#include "rendering/scene/Scene.h"
#include "rendering/settings/Settings.h"

namespace fenestra::tests {
namespace {

TEST(Method, TheAdaptiveCutawayIsTheUsualOneWhateverTheOthersParameters) {
  EXPECT_EQ(stagesOf(Method{}), MethodStages{});
  EXPECT_EQ(stagesOf({.coneAngle = 70.0, .importance = ImportanceMode::Average, .importanceOpacity = 1.0}),
            MethodStages{});
  EXPECT_EQ(stagesOf({.lensFade = LensFade::Curvature,
                      .lensPlace = LensPlace::OverCrosshair,
                      .lensRadius = 90.0,
                      .lensBends = 4.0,
                      .lensRim = 7.0}),
            MethodStages{});
  EXPECT_EQ(stagesOf({.fadeReach = 9.0, .fadeSharpness = 2.0}), MethodStages{});
  EXPECT_EQ(stagesOf({.focalShape = FocalShape::Box, .focalSize = 9.0, .focalFallOff = 2.0}), MethodStages{});
  EXPECT_EQ(stagesOf({.wallPlacement = WallPlacement::Inside, .wallAxial = false}), MethodStages{});
  EXPECT_EQ(
      stagesOf({.explosion = 0.9, .explosionPlanes = ExplosionPlanes::Three, .explosionAxes = ExplosionAxes::View}),
      MethodStages{});
  EXPECT_EQ(stagesOf({.ghostStrength = 0.2, .ghostEdge = 3.0, .ghostOutline = 1.0}), MethodStages{});
  EXPECT_FALSE(stagesOf(Method{}).keepsRemoved());
}

TEST(Method, ConesHaveTheCotangentOfTheirAngle) {
  // Two correct roundings of angles and tangents near 1.
  EXPECT_NEAR(stagesOf({.kind = MethodKind::Cone, .coneAngle = 45.0}).slope, 1.0, 1e-15);
  EXPECT_NEAR(stagesOf({.kind = MethodKind::Cone, .coneAngle = 30.0}).slope, std::sqrt(3.0), 4e-15);
  const MethodStages maximum = stagesOf({.kind = MethodKind::Importance, .coneAngle = 60.0});
  EXPECT_NEAR(maximum.slope, 2.0 + std::sqrt(3.0), 8e-15) << "15° as its authors have it";
  EXPECT_TRUE(maximum.onSilhouette);
  EXPECT_FALSE(maximum.hasWidth);
}

TEST(Method, AverageImportanceKeepsWhatHidesTheFocus) {
  const MethodStages stages = stagesOf({.kind = MethodKind::Importance, .importance = ImportanceMode::Average});
  EXPECT_EQ(stages.start, MethodStages::Start::Blend);
  EXPECT_FALSE(stages.hasWidth);
  EXPECT_EQ(stages.faintOpacity, 0.05);
}

TEST(Method, ClearViewKeepsAShareByItsLens) {
  const MethodStages stages = stagesOf({.kind = MethodKind::ClearView, .lensFade = LensFade::Depth});
  EXPECT_EQ(stages.start, MethodStages::Start::Blend);
  EXPECT_FALSE(stages.hasWidth || stages.hasBorder);
  EXPECT_EQ(stages.faintOpacity, 0.0);
  ASSERT_TRUE(stages.lens && stages.keepsRemoved());
  EXPECT_EQ(stages.lens->fade, LensFade::Depth);
  EXPECT_EQ(stages.lens->bends, 1.0);
  EXPECT_EQ(stages.lens->rim, 60.0);
  // 5.5 divides the longest side; the default has three digits.
  EXPECT_NEAR(1.0 / stages.lens->radius, 5.5, 0.006);
  Grid grid;
  grid.dims = {10, 20, 40};
  grid.spacing = {3.0, 2.5, 1.0};
  EXPECT_NEAR(radiusOf(*stages.lens, grid), 0.182 * 50.0, 1e-12);
}

TEST(Method, ContextPreservingOpensNothing) {
  const Method method{.kind = MethodKind::ContextPreserving, .fadeReach = 4.5, .fadeSharpness = 0.8};
  const MethodStages stages = stagesOf(method);
  EXPECT_EQ(stages.start, MethodStages::Start::Entry);
  EXPECT_FALSE(stages.hasWidth || stages.hasBorder || stages.keepsRemoved());
  EXPECT_EQ(stages.fading, (MethodStages::Fading{4.5, 0.8}));
  Scene scene;
  scene.look.focus = LabelFocus{{1}};
  EXPECT_TRUE(hasCutaway(scene));
  EXPECT_FALSE(fadingOf(scene.look));
  scene.look.method = method;
  EXPECT_FALSE(hasCutaway(scene));
  EXPECT_EQ(fadingOf(scene.look), stages.fading);
  scene.look.cutaway.enabled = false;
  EXPECT_FALSE(fadingOf(scene.look));
}

TEST(Method, AFocalRegionOpensNothing) {
  const Method method{.kind = MethodKind::FocalRegion,
                      .fadeReach = 9.0,
                      .focalShape = FocalShape::Box,
                      .focalSize = 20.0,
                      .focalFallOff = 7.0};
  const MethodStages stages = stagesOf(method);
  EXPECT_EQ(stages.start, MethodStages::Start::Entry);
  EXPECT_FALSE(stages.hasWidth || stages.hasBorder || stages.keepsRemoved());
  ASSERT_TRUE(stages.fading && stages.fading->region);
  EXPECT_EQ(*stages.fading->region, (MethodStages::Fading::Region{FocalShape::Box, 20.0, 7.0}));
  EXPECT_FALSE(stagesOf({.kind = MethodKind::ContextPreserving}).fading->region);
  Scene scene;
  scene.look.focus = LabelFocus{{1}};
  scene.look.method = method;
  EXPECT_FALSE(hasCutaway(scene));
  EXPECT_EQ(fadingOf(scene.look), stages.fading);
  scene.look.cutaway.enabled = false;
  EXPECT_FALSE(fadingOf(scene.look));
}

TEST(Method, WallsAreTheAdaptiveCutawayWithSlices) {
  const Method method{
      .kind = MethodKind::Walls, .wallPlacement = WallPlacement::Inside, .wallSagittal = false, .wallOutlines = false};
  MethodStages stages = stagesOf(method);
  EXPECT_EQ(stages.walls, (MethodStages::Walls{WallPlacement::Inside, true, false, true, false}));
  stages.walls.reset();
  EXPECT_EQ(stages, MethodStages{});
  Scene scene;
  scene.look.focus = LabelFocus{{1}};
  scene.look.method = method;
  EXPECT_TRUE(hasCutaway(scene));
}

TEST(Method, AnExplodedViewOpensNothingAndAtDegreeZeroIsPlain) {
  Method method{.kind = MethodKind::Explode,
                .explosion = 0.75,
                .explosionPlanes = ExplosionPlanes::Three,
                .explosionAxes = ExplosionAxes::View};
  const MethodStages stages = stagesOf(method);
  EXPECT_EQ(stages.start, MethodStages::Start::Entry);
  EXPECT_FALSE(stages.hasWidth || stages.hasBorder || stages.keepsRemoved() || stages.fading);
  EXPECT_EQ(stages.explosion, (MethodStages::Explosion{0.75, 3, ExplosionAxes::View}));
  Scene scene;
  scene.look.focus = LabelFocus{{1}};
  scene.look.method = method;
  EXPECT_FALSE(hasCutaway(scene));
  EXPECT_EQ(explosionOf(scene.look), stages.explosion);
  scene.look.cutaway.enabled = false;
  EXPECT_FALSE(explosionOf(scene.look));
  method.explosion = 0.0;
  EXPECT_FALSE(stagesOf(method).explosion);
}

TEST(Method, AGhostedSelectionOpensAsTheAdaptiveCutawayDoes) {
  const Method method{.kind = MethodKind::Selection, .ghostStrength = 0.75, .ghostEdge = 20.0, .ghostOutline = 0.25};
  MethodStages stages = stagesOf(method);
  ASSERT_TRUE(stages.fading && stages.fading->ghost);
  EXPECT_EQ(*stages.fading->ghost, (MethodStages::Fading::Ghost{0.75, 0.2, 0.25}));
  EXPECT_FALSE(stages.fading->region || stages.fading->followsLight());
  EXPECT_TRUE(stagesOf({.kind = MethodKind::ContextPreserving}).fading->followsLight());
  EXPECT_FALSE(stagesOf({.kind = MethodKind::FocalRegion}).fading->followsLight());
  stages.fading.reset();
  EXPECT_EQ(stages, MethodStages{}) << "all else is the adaptive cutaway's";
  Scene scene;
  scene.look.method = method;
  EXPECT_FALSE(fadingOf(scene.look)) << "there is nothing to be in front of";
  scene.look.focus = LabelFocus{{1}};
  EXPECT_TRUE(hasCutaway(scene));
  EXPECT_EQ(fadingOf(scene.look), stagesOf(method).fading);
  scene.look.cutaway.enabled = false;
  EXPECT_FALSE(fadingOf(scene.look));
}

TEST(Method, PeelingOpensNothingAndAtAmountZeroIsPlain) {
  Method method{.kind = MethodKind::Peel,
                .peel = 0.75,
                .peelSide = PeelSide::Left,
                .peelTurn = 12.0,
                .peelDepth = 0.25,
                .peelRadius = 9.0,
                .peelMargin = 3.0};
  const MethodStages stages = stagesOf(method);
  EXPECT_EQ(stages.start, MethodStages::Start::Entry);
  EXPECT_FALSE(stages.hasWidth || stages.hasBorder || stages.keepsRemoved() || stages.fading || stages.explosion);
  EXPECT_EQ(stages.peel, (MethodStages::Peel{0.75, PeelSide::Left, 12.0, 0.25, 9.0, 3.0}));
  Scene scene;
  scene.look.focus = LabelFocus{{1}};
  scene.look.method = method;
  EXPECT_FALSE(hasCutaway(scene));
  EXPECT_EQ(peelOf(scene.look), stages.peel);
  scene.look.cutaway.enabled = false;
  EXPECT_FALSE(peelOf(scene.look));
  method.peel = 0.0;
  EXPECT_FALSE(stagesOf(method).peel);
  method = {
      .peel = 0.5, .peelSide = PeelSide::Left, .peelTurn = 5.0, .peelDepth = 0.1, .peelRadius = 2.0, .peelMargin = 1.0};
  EXPECT_EQ(stagesOf(method), MethodStages{});
}

TEST(Method, DistancesRunOverTheBoundingSphere) {
  Grid grid;
  grid.dims = {6, 8, 24};  // 26 mm from corner to corner
  grid.origin = {100.0, -50.0, 7.0};
  const glm::dvec3 centre = grid.centre();
  EXPECT_NEAR(grid.boundingRadius(), 13.0, 1e-12);
  Camera camera{.eye = centre + glm::dvec3(0.0, -100.0, 0.0), .target = centre + glm::dvec3(20.0, 0.0, 0.0)};
  const EyeRange range = eyeRangeOf(camera, grid);
  EXPECT_NEAR(range.nearest, 87.0, 1e-10);
  EXPECT_NEAR(range.farthest, 113.0, 1e-10);
  EXPECT_EQ(range.distance(80.0), 0.0);
  EXPECT_NEAR(range.distance(93.5), 0.25, 1e-10);
  EXPECT_EQ(range.distance(120.0), 1.0);
  // Parallel rays: from the plane of the eye.
  camera.projection = Projection::Orthographic;
  EXPECT_NEAR(eyeRangeOf(camera, grid).nearest, 100.0 * 100.0 / std::hypot(100.0, 20.0) - 13.0, 1e-10);
  // An eye inside: from the eye on. One that looks away from all of it.
  camera = {.eye = centre + glm::dvec3(0.0, -3.0, 0.0), .target = centre};
  EXPECT_EQ(eyeRangeOf(camera, grid).nearest, 0.0);
  EXPECT_NEAR(eyeRangeOf(camera, grid).farthest, 16.0, 1e-10);
  camera = {.projection = Projection::Orthographic,
            .eye = centre + glm::dvec3(0.0, -30.0, 0.0),
            .target = centre + glm::dvec3(0.0, -40.0, 0.0)};
  EXPECT_EQ(eyeRangeOf(camera, grid).distance(5.0), 0.0);
}

TEST(Method, TheSteepestSlopeIsHalfTheRangeOverTheFinestSpacing) {
  Volume volume;
  volume.grid.spacing = {0.5, 2.0, 4.0};
  volume.range = {-100.0, 300.0};
  EXPECT_EQ(steepestSlope(volume), 400.0);
  volume.range = {7.0, 7.0};
  EXPECT_EQ(steepestSlope(volume), 0.0);
}

TEST(Method, AScreenDoorShowsItsShareOfEverySquareEvenly) {
  for (int shown = 0; shown <= 64; ++shown) {
    int pixels = 0;
    std::array<int, 4> quarters{};
    for (int j = 0; j < 8; ++j)
      for (int i = 0; i < 8; ++i) {
        const double share = faintShare(Sparseness::ScreenDoor, shown / 64.0, i, j);
        EXPECT_TRUE(share == 0.0 || share == 1.0);
        EXPECT_EQ(share, faintShare(Sparseness::ScreenDoor, shown / 64.0, i + 8, j + 16)) << "a pattern of 8×8";
        if (share != 1.0) continue;
        ++pixels;
        ++quarters[static_cast<std::size_t>(i / 4 + 2 * (j / 4))];
      }
    EXPECT_EQ(pixels, shown);
    // Each quarter of the square has its quarter of them, to one pixel.
    for (const int quarter : quarters) EXPECT_NEAR(quarter, shown / 4.0, 1.0) << shown;
  }
  EXPECT_EQ(faintShare(Sparseness::Opacity, 0.3, 5, 7), 0.3);
  EXPECT_EQ(faintShare(Sparseness::Colour, 0.3, 5, 7), 0.3);
}

TEST(Method, SculptingAndBendingOpenNothingThemselves) {
  Scene scene;
  scene.look.focus = LabelFocus{{1}};
  for (const MethodKind kind : {MethodKind::Sculpt, MethodKind::Bend}) {
    scene.look.method = {.kind = kind};
    EXPECT_FALSE(hasCutaway(scene));
    const MethodStages stages = stagesOf(scene.look.method);
    EXPECT_FALSE(stages.fading || stages.lens || stages.hasWidth || stages.hasBorder);
  }
}

TEST(Method, EachHasAWordANameAndASource) {
  for (const Word<MethodKind>& word : wordsOf(MethodKind{})) {
    EXPECT_GT(std::string(word.description).size(), 40u) << word.word;
    if (word.value == MethodKind::Adaptive) continue;
    const std::string text = word.description;
    EXPECT_TRUE(text.find(" 19") != text.npos || text.find(" 20") != text.npos) << word.word << " names no year";
  }
}

}  // namespace
}  // namespace fenestra::tests
