#pragma once
// The two numbers that lengths along a ray take where there is none.

#include <limits>

namespace fenestra::reference {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
/// A length or place that a ray does not have, because it meets nothing.
inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace fenestra::reference
