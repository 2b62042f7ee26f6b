#pragma once
// Which voxels a transfer function shows, for loops over a whole volume.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "rendering/settings/TransferFunction.h"
#include "rendering/volume/Volume.h"

namespace fenestra {

/// Whether stored scalars of type T show: where 1 mm of them has an opacity of at least 5 %, so that a frame leaves
/// haze out. Scalars of at most 16 bits are looked up instead of compared.
template <class T>
class VisibleValues {
 public:
  VisibleValues(const Volume& volume, const TransferFunction& context)
      : gaps_(context.transparentGaps(visibleOpacity)), slope_(volume.slope), intercept_(volume.intercept) {
    if constexpr (isLookedUp) {
      table_.resize(std::size_t{1} << (8 * sizeof(T)));
      for (std::size_t i = 0; i < table_.size(); ++i) table_[i] = shows(static_cast<T>(i));
    }
  }

  /// 1 where it shows, otherwise 0.
  std::uint8_t operator()(T stored) const {
    if constexpr (isLookedUp)
      return table_[static_cast<std::make_unsigned_t<T>>(stored)];
    else
      return shows(stored);
  }

 private:
  static constexpr double visibleOpacity = 0.05;  ///< of 1 mm
  static constexpr bool isLookedUp = std::is_integral_v<T> && sizeof(T) <= 2;

  std::uint8_t shows(T stored) const {
    const double value = slope_ * static_cast<double>(stored) + intercept_;
    return std::none_of(gaps_.begin(), gaps_.end(),
                        [&](const ValueGap& gap) { return !(value <= gap.low || value >= gap.high); });
  }

  std::vector<ValueGap> gaps_;
  double slope_, intercept_;
  std::vector<std::uint8_t> table_;
};

}  // namespace fenestra
