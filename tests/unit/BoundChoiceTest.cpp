// When an unlit picture of normal quality is drawn within a bound: by how much it would be wrong without.

#include <gtest/gtest.h>

#include "rendering/scene/BoundChoice.h"
#include "tests/support/Scenes.h"

namespace fenestra::tests::boundChoiceTest {
namespace {

const TransferFunction ridge{
    {{40.0, {{1.0, 0.3, 0.1}, 0.0}}, {50.0, {{0.2, 0.9, 0.4}, 0.4}}, {60.0, {{0.1, 0.3, 1.0}, 0.0}}}};

std::shared_ptr<const Volume> chequered(double spacing) {
  return volumeOf<std::uint8_t>(gridOf({16, 16, 16}, glm::dvec3(spacing)),
                                [](glm::ivec3 i) { return 100 * ((i.x + i.y + i.z) % 2); });
}

/// Unlit, of its voxels, without a cutaway.
Scene plain(std::shared_ptr<const Volume> volume, const TransferFunction& function) {
  Scene scene;
  scene.volume = std::move(volume);
  scene.look.shading.enabled = false;
  scene.look.reconstruction = Reconstruction::Linear;
  scene.look.context.function = function;
  return scene;
}

TEST(BoundChoice, ConstantAndEvenValuesHaveNoError) {
  const auto constant = volumeOf<std::uint8_t>(gridOf({8, 8, 8}), [](glm::ivec3) { return 50; });
  EXPECT_LT(BoundChoice::errorOf({.volume = constant}, ridge), 1e-12) << "rounding of the values between voxels";
  const auto even = volumeOf<std::int16_t>(gridOf({8, 8, 8}), [](glm::ivec3 i) { return 5 * i.x + 4 * i.y + 3 * i.z; });
  EXPECT_LT(BoundChoice::errorOf({.volume = even}, ridge), 1e-12) << "rounding";
}

TEST(BoundChoice, AFunctionMustChangeBetweenTheValuesOfACell) {
  const auto volume = chequered(2.0);
  EXPECT_GT(BoundChoice::errorOf({.volume = volume}, ridge), 4.0 / 255.0);
  const TransferFunction flat{{{0.0, {{0.5, 0.5, 0.5}, 0.2}}, {100.0, {{0.5, 0.5, 0.5}, 0.2}}}};
  EXPECT_LT(BoundChoice::errorOf({.volume = volume}, flat), 1e-12) << "rounding";
  EXPECT_EQ(BoundChoice::errorOf({.volume = volume}, {}), 0.0);
}

TEST(BoundChoice, ThickCellsCountForMore) {
  // 16 cells of 0.02 mm are clear, so that the error grows with them; of 2 mm a few are opaque.
  const double thin = BoundChoice::errorOf({.volume = chequered(0.02)}, ridge);
  EXPECT_GT(BoundChoice::errorOf({.volume = chequered(0.04)}, ridge), 1.8 * thin);
  EXPECT_GT(BoundChoice::errorOf({.volume = chequered(2.0)}, ridge), 5.0 * thin);
}

TEST(BoundChoice, FollowsTheVolumeAndTheFunction) {
  BoundChoice choice;
  const View view;
  const auto volume = chequered(2.0);
  const auto constant = volumeOf<std::uint8_t>(gridOf({8, 8, 8}), [](glm::ivec3) { return 50; });
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(choice.boundFor(plain(volume, ridge), view), BoundChoice::bound);
    EXPECT_FALSE(choice.boundFor(plain(volume, {}), view));
    EXPECT_FALSE(choice.boundFor(plain(constant, ridge), view));
  }
}

TEST(BoundChoice, IsForUnlitVoxelsInNormalQualityAlone) {
  BoundChoice choice;
  const Scene scene = plain(chequered(2.0), ridge);
  ASSERT_TRUE(choice.boundFor(scene, {}));
  for (const Quality quality : {Quality::Draft, Quality::High})
    EXPECT_FALSE(choice.boundFor(scene, {.camera = {}, .quality = quality}));
  EXPECT_FALSE(choice.boundFor(scene, {.camera = {}, .maxError = 8.0}));
  Scene other = scene;
  other.look.shading.enabled = true;
  EXPECT_FALSE(choice.boundFor(other, {}));
  other = scene;
  other.look.reconstruction = Reconstruction::Cubic;
  EXPECT_FALSE(choice.boundFor(other, {}));
}

TEST(BoundChoice, AVolumeOfOneSliceOrWithoutANumberHasNone) {
  BoundChoice choice;
  const auto slice = volumeOf<std::uint8_t>(gridOf({8, 8, 1}), [](glm::ivec3 i) { return 100 * (i.x % 2); });
  EXPECT_FALSE(choice.boundFor(plain(slice, ridge), {}));
  const auto nothing = volumeOf<float>(gridOf({4, 4, 4}), [](glm::ivec3) { return std::nan(""); });
  EXPECT_FALSE(choice.boundFor(plain(nothing, ridge), {}));
}

}  // namespace
}  // namespace fenestra::tests::boundChoiceTest
