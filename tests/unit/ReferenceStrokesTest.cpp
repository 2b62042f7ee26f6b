// The reference's strokes against values known in closed form: a parallel camera before a flat surface.

#include <cmath>

#include <gtest/gtest.h>

#include "rendering/reference/Strokes.h"
#include "tests/support/Scenes.h"

namespace fenestra::tests::referenceStrokesTest {
namespace {

constexpr glm::ivec2 size{41, 31};

/// One pixel a millimetre. The context's surface lies at t = 100, rays start at 150 and leave at 300; the right part
/// meets the focus at 150.
struct Flat {
  Camera camera = lookAt({0.0, -100.0, 0.0}, {0.0, 0.0, 0.0}, Projection::Orthographic, size.y);
  reference::HitPoints hits;
  reference::Image start;

  Flat() {
    const auto count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    hits.tContext.assign(count, 100.0);
    hits.tFocus.assign(count, nan);
    hits.tOut.assign(count, 300.0);
    start.assign(count, 150.0);
    for (std::size_t i = 0; i < count; ++i)
      if (i % size.x > 30) hits.tFocus[i] = 150.0;
  }
  /// A stroke through points of the surface, in mm from the picture's centre to the right and up.
  static BrushStroke stroke(BrushMode mode, const std::vector<glm::dvec2>& points) {
    BrushStroke made;
    made.mode = mode;
    made.radius = 8.0;
    made.softness = 0.5;
    for (const glm::dvec2 p : points) made.anchors.emplace_back(p.x, 0.0, p.y);
    return made;
  }
  reference::Edits edits(const BrushStrokes& strokes) const {
    return reference::edits(strokes, camera, size, hits, start);
  }
  static std::size_t at(int right, int up) { return static_cast<std::size_t>((15 - up) * size.x + 20 + right); }
};

TEST(ReferenceStrokes, ProfileOfADab) {
  const Flat flat;
  const reference::Edits edits = flat.edits({Flat::stroke(BrushMode::Restore, {{0.0, 0.0}})});
  // Depth 10 mm; full to half the radius, then a smoothstep to the rim at 8 mm.
  for (const auto& [mm, weight] : {std::pair{0, 1.0}, {4, 1.0}, {5, 0.84375}, {6, 0.5}, {7, 0.15625}, {8, 0.0}}) {
    EXPECT_NEAR(edits.offset[Flat::at(mm, 0)], -10.0 * weight, 1e-12) << mm;
    EXPECT_NEAR(edits.offset[Flat::at(0, -mm)], -10.0 * weight, 1e-12) << mm;
    EXPECT_NEAR(edits.tStart[Flat::at(-mm, 0)], 150.0 - 10.0 * weight, 1e-12) << mm;
  }
}

TEST(ReferenceStrokes, LinesOfOneStrokeDoNotAddUpAndStrokesFollowOneAnother) {
  const Flat flat;
  const BrushStroke line = Flat::stroke(BrushMode::Restore, {{-6.0, 0.0}, {6.0, 0.0}, {-6.0, 0.0}});
  EXPECT_NEAR(flat.edits({line}).offset[Flat::at(2, 6)], -5.0, 1e-12) << "as far from the line as from a dab";
  EXPECT_NEAR(flat.edits({line, line}).offset[Flat::at(2, 6)], -10.0, 1e-12);
  // Restore is clamped at once, so Open starts from the clamped value.
  BrushStroke deep = line, open = line;
  deep.depth = 1e4;
  open.mode = BrushMode::Open;
  EXPECT_NEAR(flat.edits({deep}).tStart[Flat::at(0, 0)], 100.0, 1e-12);
  EXPECT_NEAR(flat.edits({deep, open}).tStart[Flat::at(0, 0)], 110.0, 1e-12);
  EXPECT_NEAR(flat.edits({open, deep}).tStart[Flat::at(0, 0)], 100.0, 1e-12);
  open.depth = 1e4;
  EXPECT_NEAR(flat.edits({open}).tStart[Flat::at(0, 0)], 300.0, 1e-12);
}

TEST(ReferenceStrokes, FactorsOfContextLayerAndBorder) {
  const Flat flat;
  const auto bare = Flat::at(0, 0), onFocus = Flat::at(14, 0);
  const auto stroke = [](BrushMode mode) { return Flat::stroke(mode, {{-6.0, 0.0}, {16.0, 0.0}}); };
  BrushStroke fade = stroke(BrushMode::Fade), strengthen = stroke(BrushMode::Strengthen);
  EXPECT_NEAR(flat.edits({fade, fade, strengthen}).factor[onFocus], 0.5 * 0.5 * 1.5, 1e-12);
  EXPECT_EQ(flat.edits({fade}).factor[bare], 1.0) << "the border stays";
  EXPECT_EQ(flat.edits({fade}).offset[onFocus], 0.0);
  // Where a brush moved the cut, its border is gone. Restored, no context layer is left; half of the 50 mm back over
  // the focus leaves half of the context layer.
  BrushStroke restore = stroke(BrushMode::Restore);
  EXPECT_EQ(flat.edits({restore}).factor[bare], 0.0);
  EXPECT_EQ(flat.edits({stroke(BrushMode::Open)}).factor[bare], 0.0);
  EXPECT_EQ(flat.edits({restore}).factor[onFocus], 1.0);
  restore.coversFocus = true;
  restore.depth = 25.0;
  EXPECT_NEAR(flat.edits({restore}).factor[onFocus], 0.5, 1e-12);
  EXPECT_NEAR(flat.edits({restore, fade}).factor[onFocus], 0.25, 1e-12);
}

TEST(ReferenceStrokes, RaysThatMeetTheFocus) {
  const Flat flat;
  BrushStroke stroke = Flat::stroke(BrushMode::Restore, {{14.0, 0.0}});
  EXPECT_EQ(flat.edits({stroke}).offset[Flat::at(14, 0)], 0.0);
  stroke.coversFocus = true;
  EXPECT_NEAR(flat.edits({stroke}).offset[Flat::at(14, 0)], -10.0, 1e-12);
  stroke.mode = BrushMode::Open;
  EXPECT_EQ(flat.edits({stroke}).offset[Flat::at(14, 0)], 0.0) << "nothing goes past the focus";
}

TEST(ReferenceStrokes, ReachToTheSurfaceHoweverDeepItLies) {
  const Flat flat;
  BrushStroke stroke = Flat::stroke(BrushMode::Restore, {{0.0, 0.0}});
  stroke.toSurface = true;
  stroke.depth = 1.0;
  // All 50 mm in the middle, half of them where the profile is half.
  EXPECT_NEAR(flat.edits({stroke}).offset[Flat::at(0, 0)], -50.0, 1e-12);
  stroke.softness = 1.0;
  const int half = static_cast<int>(std::lround(0.5 * stroke.radius));
  EXPECT_NEAR(flat.edits({stroke}).offset[Flat::at(half, 0)], -25.0, 1e-12);
  // Open has no surface to reach.
  stroke.mode = BrushMode::Open;
  stroke.softness = 0.0;
  EXPECT_NEAR(flat.edits({stroke}).offset[Flat::at(0, 0)], 1.0, 1e-12);
}

TEST(ReferenceStrokes, FadeWithTheDistanceOfWhatTheyWerePaintedOn) {
  const Flat flat;
  const auto moved = [&](BrushMode mode, double deeper) {
    BrushStroke stroke = Flat::stroke(mode, {{0.0, 0.0}});
    stroke.anchors[0].y += deeper;
    return std::abs(flat.edits({stroke}).offset[Flat::at(0, 0)]);
  };
  // Restore: on the surface at t = 100; from one radius (8 mm) to two of them away it fades.
  for (const double side : {-1.0, 1.0}) {
    EXPECT_NEAR(moved(BrushMode::Restore, side * 8.0), 10.0, 1e-12);
    EXPECT_NEAR(moved(BrushMode::Restore, side * 12.0), 5.0, 1e-12);
    EXPECT_EQ(moved(BrushMode::Restore, side * 16.0), 0.0);
  }
  // Open: anywhere from there to where the ray starts, at 150.
  EXPECT_NEAR(moved(BrushMode::Open, -12.0), 5.0, 1e-12);
  EXPECT_NEAR(moved(BrushMode::Open, 25.0), 10.0, 1e-12);
  EXPECT_NEAR(moved(BrushMode::Open, 58.0), 10.0, 1e-12);
  EXPECT_NEAR(moved(BrushMode::Open, 62.0), 5.0, 1e-12);
  EXPECT_EQ(moved(BrushMode::Open, 66.0), 0.0);
}

}  // namespace
}  // namespace fenestra::tests::referenceStrokesTest
