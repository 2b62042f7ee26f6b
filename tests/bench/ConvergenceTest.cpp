// The page of how cameras settle: what it calls settled, and its charts.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/bench/Convergence.h"

namespace fenestra::bench {
namespace {

Convergence withAngles(const std::array<double, candidateCounts.size()>& degrees) {
  Convergence measured;
  measured.name = "hand";
  for (std::size_t i = 0; i < degrees.size(); ++i) measured.of[i].c1 = degrees[i];
  return measured;
}

std::size_t occurrences(const std::string& text, const std::string& of) {
  std::size_t count = 0;
  for (std::size_t at = text.find(of); at != std::string::npos; at = text.find(of, at + 1)) ++count;
  return count;
}

TEST(Convergence, IsSettledFromWhereNoGreaterNumberLeavesAgain) {
  EXPECT_EQ(settledFrom(withAngles({40, 20, 8, 12, 10, 9, 3, 1, 0, 2}), &Deviation::c1, 10.0), 300);
  EXPECT_EQ(settledFrom(withAngles({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}), &Deviation::c1, 10.0), 12);
  EXPECT_EQ(settledFrom(withAngles({1, 2, 3, 4, 5, 6, 7, 8, 9, 11}), &Deviation::c1, 10.0), std::nullopt);
}

TEST(Convergence, TheChartHasALineForEachStructureAndTheRefinementApart) {
  Convergence measured = withAngles({40, 20, 8, 12, 10, 9, 3, 1, 0, 2});
  measured.refined.c1 = 0.5;
  measured.refinedImages = 260;
  const Chart chart = convergenceChart({measured, measured}, &Deviation::c1, "C1");
  EXPECT_EQ(chart.name, "convergence-c1");
  ASSERT_EQ(chart.series.size(), 2U);
  ASSERT_EQ(chart.series[0].points.size(), candidateCounts.size());
  EXPECT_EQ(chart.series[0].points[3].x, 192.0);
  EXPECT_EQ(chart.series[0].points[3].y, 12.0);
  ASSERT_EQ(chart.series[0].apart.size(), 1U);
  EXPECT_EQ(chart.series[0].apart[0].x, 260.0);
  EXPECT_EQ(chart.series[0].apart[0].y, 0.5);
}

TEST(Charts, RingsStandApartFromTheLine) {
  const auto at = [](double x, double y) { return ChartPoint{x, y, y, y, {}}; };
  const Chart chart{
      "name", "title", {"x", false}, {"y", false}, {{"one", {at(1, 1), at(2, 2)}, {at(4, 8), at(5, NAN)}}}};
  const std::string drawn = svg(chart);
  EXPECT_EQ(occurrences(drawn, "r=\"3.5\""), 2U);
  EXPECT_EQ(occurrences(drawn, "r=\"5\""), 1U) << "no number is not drawn";
  const std::size_t line = drawn.find("points=\"");
  EXPECT_EQ(occurrences(drawn.substr(line, drawn.find("\"/>", line) - line), ","), 2U);
  EXPECT_NE(drawn.find(">8</text>"), std::string::npos) << "the axes span them";
}

}  // namespace
}  // namespace fenestra::bench
