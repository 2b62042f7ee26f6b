// Which of the context's edges are drawn: the least strength that a share of the focus exceeds.

#include "rendering/scene/ContextLines.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace fenestra::contextLinesTest {
namespace {

std::vector<std::uint32_t> countsOf(const std::vector<double>& strengths) {
  std::vector<std::uint32_t> counts(lines::bins, 0);
  for (const double each : strengths) ++counts[lines::binOf(each)];
  return counts;
}

TEST(ContextLines, LeastStrengthLeavesTheShareAboveIt) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(0.0, 1.0);
  std::vector<double> strengths;
  for (int i = 0; i < 20000; ++i) strengths.push_back(anywhere(random));
  const auto counts = countsOf(strengths);
  for (const double share : {0.0, 0.05, 0.1, 0.5}) {
    const double least = lines::leastStrength(counts, 20000, share);
    const auto above = std::count_if(strengths.begin(), strengths.end(), [&](double each) { return each > least; });
    EXPECT_NEAR(above / 20000.0, share, 5.0 / 20000.0) << "within what a bin holds";
    EXPECT_NEAR(least, 1.0 - share, 0.01);
  }
}

TEST(ContextLines, FewEdgesAllStay) {
  EXPECT_EQ(lines::leastStrength(countsOf({0.2, 0.5, 0.9}), 100, 0.1), 0.0);
  EXPECT_EQ(lines::leastStrength(countsOf({}), 0, 0.1), 0.0);
}

TEST(ContextLines, EdgesOfOneStrengthAreThinnedLikeAllOthers) {
  const double least = lines::leastStrength(countsOf(std::vector<double>(1000, 0.5)), 1000, 0.1);
  EXPECT_NEAR(least, 0.5, 2.0 / lines::bins);
}

TEST(ContextLines, StrengthRisesWithBothTermsAndStaysBelowOne) {
  EXPECT_EQ(lines::strength(1.0, 1.0, 0.0, 0.0), 0.0);
  EXPECT_GT(lines::strength(1.0, 1.0, 0.0, 0.9), lines::strength(1.0, 1.0, 0.0, 0.8));
  EXPECT_GT(lines::strength(1.0, 1.0, 2.0, 0.0), lines::strength(1.0, 1.0, 1.0, 0.0));
  EXPECT_LE(lines::strength(1.0, 1.0, 1e9, 1.0), 1.0);
  EXPECT_EQ(lines::strength(0.0, 0.0, 1.0, 1.0), 0.0);
}

}  // namespace
}  // namespace fenestra::contextLinesTest
