#include "rendering/scene/TransferFunction.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra {
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

TEST(TransferFunction, greatestExtinctionFindsASpikeInsideTheRange) {
  const TransferFunction f = functionOf({{0, 0}, {49.9, 0}, {50, 7}, {50.1, 0}, {100, 2}});
  EXPECT_DOUBLE_EQ(f.maxExtinction({0, 100}), 7.0);
  EXPECT_DOUBLE_EQ(f.maxExtinction({0, 40}), 0.0);
  EXPECT_DOUBLE_EQ(f.maxExtinction({60, 1000}), 2.0);
  EXPECT_DOUBLE_EQ(f.maxExtinction({50, 50}), 7.0);
}

TEST(TransferFunction, greatestExtinctionBoundsEverySample) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const TransferFunction f = randomFunction(random);
    std::uniform_real_distribution<double> value(-60.0, 200.0);
    double a = value(random), b = value(random);
    if (a > b) std::swap(a, b);
    double sampled = 0.0;
    for (int i = 0; i <= 1000; ++i) sampled = std::max(sampled, f.evaluate(a + (b - a) * i / 1000.0).extinction);
    EXPECT_GE(f.maxExtinction({a, b}), sampled);
    EXPECT_LE(f.maxExtinction({a, b}), f.maxExtinction({-infinity, infinity}));
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
}  // namespace fenestra
