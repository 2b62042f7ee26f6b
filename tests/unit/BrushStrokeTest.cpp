// Brush strokes as data: which have an effect, which apply in a view, and how one grows.

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::tests::brushStrokeTest {
namespace {

BrushStroke dab() {
  BrushStroke stroke;
  stroke.anchors = {{1.0, 2.0, 3.0}};
  return stroke;
}

TEST(BrushStrokes, HaveAnEffectOnlyWithNumbersInTheirRanges) {
  EXPECT_TRUE(isEffective(dab()));
  const auto changed = [](auto&& change) {
    BrushStroke stroke = dab();
    change(stroke);
    return isEffective(stroke);
  };
  EXPECT_FALSE(changed([](BrushStroke& s) { s.hidden = true; }));
  EXPECT_FALSE(changed([](BrushStroke& s) { s.anchors.clear(); }));
  EXPECT_FALSE(changed([](BrushStroke& s) { s.anchors.emplace_back(0.0, nan, 0.0); }));
  EXPECT_FALSE(changed([](BrushStroke& s) { s.anchors.emplace_back(0.0, 0.0, -infinity); }));
  for (const double wrong : {0.0, -1.0, nan, infinity}) {
    EXPECT_FALSE(changed([=](BrushStroke& s) { s.radius = wrong; })) << wrong;
    EXPECT_FALSE(changed([=](BrushStroke& s) { s.depth = wrong; })) << wrong;
    EXPECT_FALSE(changed([=](BrushStroke& s) { s.mode = BrushMode::Fade, s.amount = wrong; })) << wrong;
    EXPECT_TRUE(changed([=](BrushStroke& s) { s.amount = wrong; })) << "which Restore does not use";
  }
  for (const double wrong : {-0.1, 1.1, nan}) EXPECT_FALSE(changed([=](BrushStroke& s) { s.softness = wrong; }));
  EXPECT_FALSE(changed([](BrushStroke& s) { s.mode = BrushMode::Strengthen, s.amount = 1.01; }));
}

TEST(BrushStrokes, ApplyInTheirViewOrInAll) {
  BrushStrokes strokes(3, dab());
  strokes[0].view = 1;
  strokes[2].view = 0;
  EXPECT_EQ(strokesIn(0, strokes), (BrushStrokes{strokes[1], strokes[2]}));
  EXPECT_EQ(strokesIn(1, strokes), (BrushStrokes{strokes[0], strokes[1]}));
}

TEST(BrushStrokes, GrowByPointsApart) {
  BrushStroke stroke;
  stroke.radius = 8.0;
  EXPECT_TRUE(extend(stroke, {1.0, 0.0, 0.0}));
  EXPECT_FALSE(extend(stroke, {1.4, 0.0, 0.0})) << "less than a sixteenth of the radius away";
  EXPECT_FALSE(extend(stroke, {nan, 0.0, 0.0}));
  EXPECT_FALSE(extend(stroke, {0.0, infinity, 0.0}));
  EXPECT_TRUE(extend(stroke, {1.6, 0.0, 0.0}));
  EXPECT_EQ(stroke.anchors, (std::vector<glm::dvec3>{{1.0, 0.0, 0.0}, {1.6, 0.0, 0.0}}));
}

}  // namespace
}  // namespace fenestra::tests::brushStrokeTest
