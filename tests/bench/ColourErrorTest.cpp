// The measures that the report rests on, on colours whose differences are known.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "app/benchmark/ColourError.h"

namespace fenestra::bench {
namespace {

constexpr glm::dvec3 black(0.0);

TEST(Distribution, PercentilesAreTheNearestRankAbove) {
  Distribution values;
  for (const double value : {4.0, 1.0, 3.0, 2.0}) values.add(value);
  EXPECT_EQ(values.percentile(0.0), 1.0);
  EXPECT_EQ(values.median(), 3.0);
  EXPECT_EQ(values.percentile(99.0), 4.0);
  EXPECT_DOUBLE_EQ(values.rms(), std::sqrt(7.5));
  values.add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(values.max(), std::numeric_limits<double>::infinity()) << "NaN counts as the greatest error";
}

TEST(ColourErrors, WorstChannelAndRootMeanSquare) {
  ColourErrors errors;
  errors.add({0.5, 0.5, 0.5, 1.0}, {0.5, 0.5 - 3.0 / 255.0, 0.5 + 4.0 / 255.0, 1.0}, black);
  EXPECT_NEAR(errors.channel.max(), 4.0, 1e-12);
  EXPECT_NEAR(errors.squares.max(), 5.0 / std::sqrt(3.0), 1e-12);
}

TEST(ColourErrors, TheBackgroundShowsThroughWhatIsNotOpaque) {
  ColourErrors errors;
  errors.add({0.0, 0.0, 0.0, 0.5}, {0.0, 0.0, 0.0, 0.25}, glm::dvec3(1.0));
  EXPECT_NEAR(errors.channel.max(), 255.0 * 0.25, 1e-12);
}

TEST(ColourErrors, EmptyPixelsOfBothAreLeftOut) {
  ColourErrors errors;
  errors.add(glm::dvec4(0.0), glm::dvec4(0.0), black);
  EXPECT_EQ(errors.channel.count(), 0u);
  errors.add({0.1, 0.0, 0.0, 0.1}, glm::dvec4(0.0), black);
  EXPECT_EQ(errors.channel.count(), 1u);
}

TEST(ColourErrors, NoNumberIsInfinitelyWrong) {
  ColourErrors errors;
  errors.add({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0, 1.0}, {0.0, 0.0, 0.0, 1.0}, black);
  EXPECT_EQ(errors.channel.max(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(errors.squares.max(), std::numeric_limits<double>::infinity());
}

TEST(ColourErrors, DeltaEOfKnownColours) {
  // White against black is L* = 100; sRGB's red is L*a*b* = (53.24, 80.09, 67.20) under D65 (to the digits given).
  ColourErrors white, red;
  white.add(glm::dvec4(1.0), {0.0, 0.0, 0.0, 1.0}, black);
  EXPECT_NEAR(white.deltaE.max(), 100.0, 0.02);
  red.add({1.0, 0.0, 0.0, 1.0}, {0.0, 0.0, 0.0, 1.0}, black);
  EXPECT_NEAR(red.deltaE.max(), std::hypot(53.24, 80.09, 67.20), 0.05);
}

}  // namespace
}  // namespace fenestra::bench
