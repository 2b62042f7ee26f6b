#pragma once
// How alike two orders of the same views are.

#include <vector>

namespace fenestra::placement {

/// Spearman's rank correlation: Pearson's correlation of the ranks, where equal values share the mean of their ranks;
/// from -1 to 1 (C. Spearman: The proof and measurement of association between two things. The American Journal of
/// Psychology 15(1), 1904; for ties M. G. Kendall: Rank correlation methods, 1948, section 3.8). Pairs of which one
/// value is NaN are left out. NaN where one of the two lists has fewer than two different values.
double rankCorrelation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace fenestra::placement
