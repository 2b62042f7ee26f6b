#include "rendering/settings/TransferFunction.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::transferFunctionTest {
namespace {

using namespace tests;

TransferFunction functionOf(std::initializer_list<std::pair<double, double>> valueAndExtinction) {
  TransferFunction result;
  for (const auto& [value, extinction] : valueAndExtinction)
    result.nodes.push_back({value, {glm::dvec3(value / 100.0), extinction}});
  return result;
}

TransferFunction randomFunction(std::mt19937& random) {
  std::uniform_real_distribution<double> step(0.0, 30.0), extinction(0.0, 0.01);
  std::bernoulli_distribution transparent(0.4), jump(0.2);
  TransferFunction result;
  double value = -50.0;
  for (int i = 0; i < 12; ++i) {
    result.nodes.push_back({value, {glm::dvec3(0.5), transparent(random) ? 0.0 : extinction(random)}});
    if (!jump(random)) value += step(random);
  }
  return result;
}

TEST(TransferFunction, opacityAndExtinctionAreInverse) {
  for (const double opacity : {0.0, 1e-12, 1.0 / 255.0, 0.5, 0.999})
    EXPECT_NEAR(opacityFromExtinction(extinctionFromOpacity(opacity)), opacity, 1e-15);
  EXPECT_TRUE(std::isfinite(extinctionFromOpacity(1.0)));
  EXPECT_EQ(extinctionFromOpacity(-1.0), 0.0);
}

TEST(TransferFunction, isLinearBetweenNodesAndConstantOutside) {
  const TransferFunction f = functionOf({{0, 1}, {10, 3}});
  EXPECT_DOUBLE_EQ(f.evaluate(5.0).extinction, 2.0);
  EXPECT_DOUBLE_EQ(f.evaluate(5.0).colour.x, 0.05);
  EXPECT_DOUBLE_EQ(f.evaluate(-infinity).extinction, 1.0);
  EXPECT_DOUBLE_EQ(f.evaluate(infinity).extinction, 3.0);
  EXPECT_EQ(f.evaluate(nan).extinction, 0.0);
  EXPECT_EQ(TransferFunction{}.evaluate(3.0).extinction, 0.0);
}

TEST(TransferFunction, twoNodesOfOneValueMakeAStep) {
  const TransferFunction f = opaqueFrom(100.0);
  EXPECT_EQ(f.evaluate(std::nextafter(100.0, 0.0)).extinction, 0.0);
  EXPECT_EQ(f.evaluate(100.0).extinction, 5.0);
}

TEST(TransferFunction, emptyRangesEndWhereARampBeginsAndBeforeAStep) {
  using Ranges = std::vector<ValueRange>;
  EXPECT_EQ(TransferFunction{}.emptyRanges(), (Ranges{{-infinity, infinity}}));
  EXPECT_EQ(functionOf({{0, 0}}).emptyRanges(), (Ranges{{-infinity, infinity}}));
  EXPECT_EQ(functionOf({{0, 1}}).emptyRanges(), Ranges{});
  EXPECT_EQ(functionOf({{0, 0}, {10, 0}, {20, 1}, {30, 0}, {40, 0}, {50, 2}}).emptyRanges(),
            (Ranges{{-infinity, 10}, {30, 40}}));
  // One value alone between two ramps, and a spike that shows at one value alone.
  EXPECT_EQ(functionOf({{0, 1}, {10, 0}, {20, 1}}).emptyRanges(), (Ranges{{10, 10}}));
  EXPECT_EQ(functionOf({{10, 0}, {10, 7}, {10, 0}}).emptyRanges(),
            (Ranges{{-infinity, std::nextafter(10.0, 0.0)}, {std::nextafter(10.0, 20.0), infinity}}));
  EXPECT_EQ(functionOf({{0, 2}, {10, 2}, {10, 0}, {20, 0}, {20, 2}}).emptyRanges(),
            (Ranges{{std::nextafter(10.0, 20.0), std::nextafter(20.0, 0.0)}}));
}

TEST(TransferFunction, emptyRangesAreExactlyTheValuesWithoutExtinction) {
  std::mt19937 random(3);
  std::bernoulli_distribution isEmpty(0.5);
  for (int trial = 0; trial < 50; ++trial) {
    TransferFunction f = randomFunction(random);
    for (TransferFunction::Node& node : f.nodes)
      if (isEmpty(random)) node.properties.extinction = 0.0;
    const std::vector<ValueRange> ranges = f.emptyRanges();
    std::vector<double> values{-infinity, infinity};
    for (int i = 0; i <= 1000; ++i) values.push_back(-60.0 + 0.26 * i);
    for (const TransferFunction::Node& node : f.nodes) values.push_back(node.value);
    for (const double value : values) {
      const bool isWithin = std::any_of(ranges.begin(), ranges.end(), [&](const ValueRange& range) {
        return value >= range.low && value <= range.high;
      });
      const bool hasStep = std::any_of(f.nodes.begin(), f.nodes.end(), [&](const TransferFunction::Node& node) {
        return node.value == value && node.properties.extinction > 0.0;
      });
      EXPECT_EQ(isWithin, !hasStep && f.evaluate(value).extinction == 0.0) << value;
    }
  }
}

TEST(TransferFunction, gapsOfARamp) {
  const double threshold = extinctionFromOpacity(1.0 / 255.0);
  const std::vector<ValueGap> gaps = functionOf({{0, 0}, {100, 100 * threshold}}).transparentGaps(1.0 / 255.0);
  ASSERT_EQ(gaps.size(), 1u);
  EXPECT_EQ(gaps[0].low, -infinity);
  EXPECT_NEAR(gaps[0].high, 1.0, 1e-12);
}

TEST(TransferFunction, gapsOfNothingAndOfEverything) {
  EXPECT_EQ(TransferFunction{}.transparentGaps(0.01), (std::vector<ValueGap>{{-infinity, infinity}}));
  EXPECT_TRUE(functionOf({{0, 1}}).transparentGaps(0.01).empty());
  EXPECT_EQ(functionOf({{0, 0}}).transparentGaps(0.01), (std::vector<ValueGap>{{-infinity, infinity}}));
}

TEST(TransferFunction, gapsAreExactlyTheTransparentValues) {
  std::mt19937 random(5);
  const double opacity = 1.0 / 255.0, threshold = extinctionFromOpacity(opacity);
  for (int trial = 0; trial < 100; ++trial) {
    const TransferFunction f = randomFunction(random);
    const std::vector<ValueGap> gaps = f.transparentGaps(opacity);
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      EXPECT_LT(gaps[i].low, gaps[i].high);
      EXPECT_LE(i > 0 ? gaps[i - 1].high : -infinity, gaps[i].low);
    }
    for (double value = -70.0; value < 250.0; value += 0.0837) {
      const double margin = f.evaluate(value).extinction - threshold;
      if (std::abs(margin) < 1e-12) continue;  // on a gap's end
      const bool inGap = std::any_of(gaps.begin(), gaps.end(),
                                     [&](const ValueGap& gap) { return gap.low < value && value < gap.high; });
      EXPECT_EQ(inGap, margin < 0.0) << "value " << value << " in trial " << trial;
    }
  }
}

}  // namespace
}  // namespace fenestra::transferFunctionTest
