#pragma once
// How the user edits a label.

#include <cstdint>

namespace fenestra::viewer {

/// With a number: a distance in mm, or for RemoveIslands the volume in mm³ below which a part goes.
enum class LabelOperation : std::uint8_t { Grow, Shrink, FillHoles, RemoveIslands };

}  // namespace fenestra::viewer
