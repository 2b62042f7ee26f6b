#pragma once
// Costs and tolerances as bytes.
//
// The cost of a voxel says how far its value lies from the seed's, in units of the noise. A level is a cost on a scale
// that is linear for small costs and logarithmic for large ones, so that a byte tells costs apart by 2 % at best and
// reaches to 60 times the noise.

#include <cmath>
#include <cstdint>

namespace fenestra::segmentation {

using Level = std::uint8_t;
inline constexpr int levelCount = 255;  ///< levels 0…254
inline constexpr Level never = 255;     ///< the cost is beyond the last level

inline constexpr double levelsPerOctave = 32.0;
inline constexpr double linearUpTo = 0.25;  ///< noise units: where the scale turns from linear to logarithmic

/// Cost in noise units of a level.
inline double costOf(int level) { return linearUpTo * (std::exp2(level / levelsPerOctave) - 1.0); }

/// Level of a cost in noise units, ≥ 0; `never` beyond the last.
inline Level levelOf(double cost) {
  const double level = std::round(levelsPerOctave * std::log2(1.0 + cost / linearUpTo));
  return level < levelCount ? static_cast<Level>(level) : never;
}

}  // namespace fenestra::segmentation
