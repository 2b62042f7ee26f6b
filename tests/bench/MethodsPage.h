#pragma once
// The page of what each method shows, leaves and costs: its tables, with the best of each column marked, and sentences
// on the adaptive cutaway.

#include <limits>
#include <string>
#include <vector>

#include "tests/bench/Report.h"

namespace fenestra::bench {

/// Stands for a figure that cannot be measured.
inline constexpr double notTold = std::numeric_limits<double>::quiet_NaN();

/// Figures of a method on one scene, over all views.
struct MethodFigures {
  std::string name;
  double seen = 0.0, leastSeen = 0.0;  ///< share of the focus: mean, and of the worst view
  double volume = 1.0, surface = 1.0;  ///< shares of the context that are kept, means; or notTold
  double wrongOrder = 0.0;             ///< mean of DepthOrder::wrong, or notTold
  int wrongPairs = 0, pairs = 0;       ///< sums
  double turning = 0.0;                ///< greatest mean change of a pixel between views 1° apart, 1/255
  double milliseconds = 0.0;           ///< median
  double cost = 1.0;                   ///< in times of the plain picture's
  double error = 0.0;                  ///< 1/255
};

struct SceneFigures {
  std::string id, name;
  MethodFigures plain;                 ///< nothing is opened
  std::vector<MethodFigures> methods;  ///< the adaptive cutaway first
};

/// The scene's table, and the methods that beat the adaptive cutaway. Methods are equal where the digits in the table
/// are.
Section sectionOf(const SceneFigures& scene);

/// In how many scenes each method is best, by column.
Section summaryOf(const std::vector<SceneFigures>& scenes);

/// How everything is defined.
std::string methodsText();

}  // namespace fenestra::bench
