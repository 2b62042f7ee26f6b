// What the methods put in the place of the adaptive cutaway's stages, and the pattern of the screen door.

#include "rendering/scene/Method.h"

#include <cmath>

#include <gtest/gtest.h>

#include "rendering/scene/Settings.h"

namespace fenestra::tests {
namespace {

TEST(Method, TheAdaptiveCutawayIsTheUsualOneWhateverTheOthersParameters) {
  EXPECT_EQ(stagesOf(Method{}), MethodStages{});
  EXPECT_EQ(stagesOf({.coneAngle = 70.0, .importance = ImportanceMode::Average, .importanceOpacity = 1.0}),
            MethodStages{});
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

TEST(Method, EachHasAWordANameAndASource) {
  for (const Word<MethodKind>& word : wordsOf(MethodKind{})) {
    EXPECT_GT(std::string(word.description).size(), 40u) << word.word;
    if (word.value == MethodKind::Adaptive) continue;
    EXPECT_NE(std::string(word.description).find("20"), std::string::npos) << word.word << " names no year";
  }
}

}  // namespace
}  // namespace fenestra::tests
