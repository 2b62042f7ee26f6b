// The point that a click on a picture means, for layers along a ray.

#include "rendering/scene/SeenPoint.h"

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::seenPointTest {
namespace {

using tests::gridOf;
using tests::volumeOf;

/// Layers along x by voxel: air, skin from 10 to 14, fat to 29, bone from 30 on.
constexpr double air = -1000.0, skin = 50.0, fat = -100.0, bone = 1000.0;
double layerAt(glm::ivec3 index) { return index.x < 10 ? air : index.x < 15 ? skin : index.x < 30 ? fat : bone; }

Scene layers(double skinExtinction, double boneExtinction) {
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(gridOf({50, 9, 9}), layerAt);
  scene.look.context.function.nodes = {{-200.0, {glm::dvec3(1.0), 0.0}},
                                       {0.0, {glm::dvec3(1.0), skinExtinction}},
                                       {200.0, {glm::dvec3(1.0), skinExtinction}},
                                       {400.0, {glm::dvec3(1.0), boneExtinction}}};
  return scene;
}

double seenAt(const Scene& scene) {
  const auto seen = seenPoint(scene, {-5.0, 4.2, 3.9}, {1.0, 0.0, 0.0});
  EXPECT_TRUE(seen);
  if (!seen) return 0.0;
  EXPECT_EQ(seen->y, 4.2);
  EXPECT_EQ(seen->z, 3.9);
  return seen->x;
}

TEST(SeenPoint, IsTheFirstOfWhatIsOpaque) {
  const double x = seenAt(layers(5.0, 5.0));
  EXPECT_GE(x, 10.0) << "in the skin's voxels, not in the air before them";
  EXPECT_LT(x, 12.0);
}

TEST(SeenPoint, IsTheBoneBehindATranslucentSkin) {
  // Five voxels of 0.02/mm hide a tenth of what lies behind.
  const double x = seenAt(layers(0.02, 3.0));
  EXPECT_GE(x, 30.0);
  EXPECT_LT(x, 32.0);
}

TEST(SeenPoint, IsNothingWhereNothingShows) {
  EXPECT_FALSE(seenPoint(layers(0.0, 0.0), {-5.0, 4.0, 4.0}, {1.0, 0.0, 0.0}));
  EXPECT_FALSE(seenPoint(layers(1.0, 1.0), {-5.0, 40.0, 4.0}, {1.0, 0.0, 0.0})) << "a ray beside the volume";
}

TEST(SeenPoint, IsTheFocusWhereTheFocusShows) {
  Scene scene = layers(0.02, 0.02);
  scene.labels = tests::labelsOf(scene.volume->grid, [](glm::ivec3 index) { return index.x >= 20 && index.x < 24; });
  scene.look.focus = LabelFocus{{1}};
  const double x = seenAt(scene);
  EXPECT_GE(x, 19.5);
  EXPECT_LT(x, 23.5);
}

TEST(SeenPoint, IsNothingThatIsClipped) {
  Scene scene = layers(0.02, 3.0);
  scene.look.clipping.planes = {{{-1.0, 0.0, 0.0}, -25.0}};  // keeps what lies before the bone
  const double x = seenAt(scene);
  EXPECT_GE(x, 10.0);
  EXPECT_LT(x, 16.0);
}

/// A focus from 30 on, and a label from 16 to 19; the opening removes what lies before the focus.
Scene opened(LabelRole role) {
  Scene scene = layers(0.5, 3.0);
  scene.labels = tests::labelsOf(scene.volume->grid, [](glm::ivec3 index) {
    return index.x >= 30 ? 1 : index.x >= 16 && index.x < 20 ? 2 : 0;
  });
  scene.look.context.function.nodes = {{-200.0, {glm::dvec3(1.0), 0.5}}};
  scene.look.focus = LabelFocus{{1}};
  scene.look.labels = {{.label = 2, .role = role}};
  return scene;
}

TEST(SeenPoint, IsTheProtectedLabelThatTheOpeningLeaves) {
  constexpr double removed = 30.0;  // mm, from the volume's edge
  const glm::dvec3 start(29.5, 4.0, 4.0), along(1.0, 0.0, 0.0);
  const auto seen = seenPoint(opened(LabelRole::Protected), start, along, removed);
  ASSERT_TRUE(seen);
  EXPECT_GE(seen->x, 15.5);
  EXPECT_LT(seen->x, 19.5);
  const auto cut = seenPoint(opened(LabelRole::Context), start, along, removed);
  ASSERT_TRUE(cut);
  EXPECT_GE(cut->x, 29.5) << "what is removed is not seen";
}

TEST(SeenPoint, ATranslucentProtectedLabelIsNotSeenBeforeTheFocus) {
  Scene scene = opened(LabelRole::Protected);
  scene.look.context.function.nodes = {{-200.0, {glm::dvec3(1.0), 0.02}}};  // 8 % of opacity
  const auto seen = seenPoint(scene, {29.5, 4.0, 4.0}, {1.0, 0.0, 0.0}, 30.0);
  ASSERT_TRUE(seen);
  EXPECT_GE(seen->x, 29.5);
}

}  // namespace
}  // namespace fenestra::seenPointTest
