// The stages with which the methods replace the adaptive cutaway's, and the pattern of the screen door.

#include <array>
#include <cmath>
#include <concepts>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "rendering/methods/Method.h"
#include "rendering/scene/Edges.h"
#include "rendering/scene/Explosion.h"
#include "rendering/scene/Fading.h"
#include "rendering/scene/Maximum.h"
#include "rendering/scene/Occlusion.h"
#include "rendering/scene/Peel.h"
#include "rendering/scene/Scene.h"

namespace fenestra::tests::methodTest {
namespace {

TEST(Method, TheAdaptiveCutawayIsTheUsualOneWhateverTheOthersParameters) {
  EXPECT_EQ(stagesOf(Method{}), MethodStages{});
  EXPECT_FALSE(stagesOf(Method{}).keepsRemoved());
  EXPECT_TRUE(Method{}.is<methods::Adaptive>());
  forEachMethod([]<class M>() {
    Method method;
    forEachSetting<M>([&](const auto& setting) {
      auto& value = method.of<M>().*setting.member;
      if constexpr (std::same_as<std::remove_reference_t<decltype(value)>, double>) value = setting.range.low;
    });
    EXPECT_EQ(stagesOf(method), MethodStages{}) << M::word;
  });
}

TEST(Method, KeepsTheParametersOfTheOthers) {
  Method method = methods::Cone{.angle = 70.0};
  method.kind = kindOf<methods::ClearView>;
  method.of<methods::ClearView>().radius = 40.0;
  EXPECT_EQ(std::get<methods::ClearView>(method.chosen()).radius, 40.0);
  method.kind = kindOf<methods::Cone>;
  EXPECT_EQ(method.chosen(), ChosenMethod(methods::Cone{.angle = 70.0}));
  EXPECT_EQ(method.of<methods::ClearView>().radius, 40.0);
  EXPECT_NE(method, Method(methods::Cone{.angle = 70.0})) << "they are a part of the look";
}

TEST(Method, EachIsChosenByItsKind) {
  std::set<MethodKind> kinds;
  forEachMethod([&]<class M>() {
    EXPECT_TRUE(kinds.insert(kindOf<M>).second) << M::word;
    EXPECT_TRUE(std::holds_alternative<M>(Method(kindOf<M>).chosen())) << M::word;
    EXPECT_EQ(stagesOf(Method(kindOf<M>)), M{}.stages()) << M::word;
    EXPECT_STREQ(wordOf(kindOf<M>).word, M::word);
    EXPECT_STREQ(wordOf(kindOf<M>).name, M::name);
  });
  EXPECT_EQ(kinds.size(), wordsOf(MethodKind{}).size());
}

/// What decides on programs keeps the programs, and so the stages but for their numbers.
TEST(Method, ProgramsKeepNoNumber) {
  forEachMethod([]<class M>() {
    if constexpr (requires(const M method) { method.programs(); }) {
      M other;
      forEachSetting<M>([&](const auto& setting) {
        auto& value = other.*setting.member;
        if constexpr (std::same_as<std::remove_reference_t<decltype(value)>, double>) value = setting.range.high;
      });
      EXPECT_EQ(other.programs(), M{}.programs()) << M::word;
    }
  });
  EXPECT_NE((methods::FocalRegion{.shape = FocalShape::Distance}).programs(), methods::FocalRegion{}.programs());
}

TEST(Method, SmoothEdgesNeedAnOpeningThatIsDefinedBetweenPixels) {
  for (const Method& method : std::initializer_list<Method>{
           methods::Cone{}, methods::Importance{}, methods::Importance{.mode = ImportanceMode::Average, .opacity = 0.0},
           methods::ClearView{}, methods::Walls{}, methods::Mip{}})
    EXPECT_FALSE(stagesOf(method).opensBetweenPixels()) << wordOf(method.kind).word;
  EXPECT_TRUE(methods::Adaptive{}.stages().opensBetweenPixels());
  EXPECT_TRUE(methods::Selection{}.stages().opensBetweenPixels());
}

TEST(Method, ConesHaveTheCotangentOfTheirAngle) {
  // Two correct roundings of angles and tangents near 1.
  EXPECT_NEAR(stagesOf(methods::Cone{.angle = 45.0}).slope, 1.0, 1e-15);
  EXPECT_NEAR(stagesOf(methods::Cone{.angle = 30.0}).slope, std::sqrt(3.0), 4e-15);
  Method method = methods::Importance{};
  method.of<methods::Cone>().angle = 60.0;
  const MethodStages maximum = stagesOf(method);
  EXPECT_NEAR(maximum.slope, 2.0 + std::sqrt(3.0), 8e-15) << "15° as its authors have it";
  EXPECT_TRUE(maximum.onSilhouette);
  EXPECT_FALSE(maximum.hasWidth);
}

TEST(Method, AverageImportanceKeepsWhatHidesTheFocus) {
  const MethodStages stages = stagesOf(methods::Importance{.mode = ImportanceMode::Average});
  EXPECT_EQ(stages.start, MethodStages::Start::Blend);
  EXPECT_FALSE(stages.hasWidth);
  EXPECT_EQ(stages.faintOpacity, 0.05);
}

TEST(Method, ClearViewKeepsAShareByItsLens) {
  const MethodStages stages = stagesOf(methods::ClearView{.fade = LensFade::Depth});
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
  const Method method = methods::ContextPreserving{.reach = 4.5, .sharpness = 0.8};
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
  Method method = methods::FocalRegion{.shape = FocalShape::Box, .size = 20.0, .fallOff = 7.0};
  method.of<methods::ContextPreserving>().reach = 9.0;
  const MethodStages stages = stagesOf(method);
  EXPECT_EQ(stages.start, MethodStages::Start::Entry);
  EXPECT_FALSE(stages.hasWidth || stages.hasBorder || stages.keepsRemoved());
  ASSERT_TRUE(stages.fading && stages.fading->region);
  EXPECT_EQ(*stages.fading->region, (MethodStages::Fading::Region{FocalShape::Box, 20.0, 7.0}));
  EXPECT_FALSE(stagesOf(methods::ContextPreserving{}).fading->region);
  Scene scene;
  scene.look.focus = LabelFocus{{1}};
  scene.look.method = method;
  EXPECT_FALSE(hasCutaway(scene));
  EXPECT_EQ(fadingOf(scene.look), stages.fading);
  scene.look.cutaway.enabled = false;
  EXPECT_FALSE(fadingOf(scene.look));
}

TEST(Method, WallsAreTheAdaptiveCutawayWithSlices) {
  const Method method = methods::Walls{.placement = WallPlacement::Inside, .sagittal = false, .outlines = false};
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
  Method method = methods::Explode{.degree = 0.75, .planes = ExplosionPlanes::Three, .axes = ExplosionAxes::View};
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
  method.of<methods::Explode>().degree = 0.0;
  EXPECT_FALSE(stagesOf(method).explosion);
}

TEST(Method, AGhostedSelectionOpensAsTheAdaptiveCutawayDoes) {
  const Method method = methods::Selection{.strength = 0.75, .edge = 20.0, .outline = 0.25};
  MethodStages stages = stagesOf(method);
  ASSERT_TRUE(stages.fading && stages.fading->ghost);
  EXPECT_EQ(*stages.fading->ghost, (MethodStages::Fading::Ghost{0.75, 0.2, 0.25}));
  EXPECT_FALSE(stages.fading->region || stages.fading->followsLight());
  EXPECT_TRUE(stagesOf(methods::ContextPreserving{}).fading->followsLight());
  EXPECT_FALSE(stagesOf(methods::FocalRegion{}).fading->followsLight());
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
  Method method =
      methods::Peel{.amount = 0.75, .side = PeelSide::Left, .turn = 12.0, .depth = 0.25, .radius = 9.0, .margin = 3.0};
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
  method.of<methods::Peel>().amount = 0.0;
  EXPECT_FALSE(stagesOf(method).peel);
  method.of<methods::Peel>() = {
      .amount = 0.5, .side = PeelSide::Left, .turn = 5.0, .depth = 0.1, .radius = 2.0, .margin = 1.0};
  method.kind = kindOf<methods::Adaptive>;
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

TEST(Method, AMaximumIntensityProjectionOpensAsTheAdaptiveCutawayDoes) {
  const Method method = methods::Mip{.thickness = 3.5};
  MethodStages stages = stagesOf(method);
  EXPECT_EQ(stages.maximum, MethodStages::Maximum{3.5});
  stages.maximum.reset();
  EXPECT_EQ(stages, MethodStages{});
  Scene scene;
  scene.look.method = method;
  EXPECT_EQ(maximumOf(scene.look), MethodStages::Maximum{3.5}) << "without a focus, too";
  scene.look.shading.occlusion = 0.5;
  EXPECT_FALSE(hasOcclusion(scene.look));
  scene.look.edges = Edges::Smooth;
  EXPECT_FALSE(hasSmoothEdges(scene.look, View{}));
  scene.look.cutaway.enabled = false;
  EXPECT_FALSE(maximumOf(scene.look));
  EXPECT_TRUE(hasOcclusion(scene.look) && hasSmoothEdges(scene.look, View{}));
}

TEST(Method, SculptingAndBendingOpenNothingThemselves) {
  Scene scene;
  scene.look.focus = LabelFocus{{1}};
  for (const MethodKind kind : {kindOf<methods::Sculpt>, kindOf<methods::Bend>}) {
    scene.look.method = Method(kind);
    EXPECT_FALSE(hasCutaway(scene));
    const MethodStages stages = stagesOf(scene.look.method);
    EXPECT_FALSE(stages.fading || stages.lens || stages.hasWidth || stages.hasBorder);
  }
}

TEST(Method, EachHasAWordANameAndASource) {
  for (const Word<MethodKind>& word : wordsOf(MethodKind{})) {
    EXPECT_GT(std::string(word.description).size(), 40u) << word.word;
    if (word.value == kindOf<methods::Adaptive>) continue;
    const std::string text = word.description;
    EXPECT_TRUE(text.find(" 19") != text.npos || text.find(" 20") != text.npos) << word.word << " names no year";
  }
}

}  // namespace
}  // namespace fenestra::tests::methodTest
