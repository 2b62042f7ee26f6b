#include "io/dicom/Slabs.h"

#include <algorithm>
#include <cstddef>

namespace fenestra::io {

Slabs::Slabs(std::vector<double> positions, double step) : positions_(std::move(positions)) {
  // A thousandth of a step: slices of the target that lie on the border but for rounding belong to the slab.
  const double reach = 0.501 * step;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    const double before = i > 0 ? positions_[i] - positions_[i - 1] : 2.0 * step;
    const double after = i + 1 < positions_.size() ? positions_[i + 1] - positions_[i] : 2.0 * step;
    low_.push_back(positions_[i] - (before <= 1.5 * step ? 0.5 * before : reach));
    high_.push_back(positions_[i] + (after <= 1.5 * step ? 0.5 * after : reach));
  }
}

int Slabs::at(double position) const {
  // The nearest plane: the first at or above, or the one below.
  const auto above = std::lower_bound(positions_.begin(), positions_.end(), position);
  const auto index = static_cast<std::size_t>(above - positions_.begin());
  if (index < positions_.size() && position >= low_[index]) return static_cast<int>(index);
  if (index > 0 && position <= high_[index - 1]) return static_cast<int>(index - 1);
  return -1;
}

double usualGap(const std::vector<double>& positions) {
  if (positions.size() < 2) return 0.0;
  std::vector<double> gaps;
  for (std::size_t i = 1; i < positions.size(); ++i) gaps.push_back(positions[i] - positions[i - 1]);
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>((gaps.size() - 1) / 2);
  std::nth_element(gaps.begin(), middle, gaps.end());
  return *middle;
}

}  // namespace fenestra::io
