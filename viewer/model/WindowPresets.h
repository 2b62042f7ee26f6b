#pragma once
// Display windows for CT on the number keys, as radiologists know them.

#include <array>

#include "rendering/volume/Volume.h"

namespace fenestra::viewer {

struct WindowPreset {
  int key;  ///< number key
  const char* name;
  WindowLevel window;  ///< HU
};

/// Keys and figures of Weasis and OsiriX-like viewers.
inline constexpr std::array<WindowPreset, 5> ctWindowPresets{{
    {3, "Brain", {110.0, 35.0}},
    {4, "Abdomen", {320.0, 50.0}},
    {5, "Mediastinum", {400.0, 80.0}},
    {6, "Bone", {2000.0, 350.0}},
    {7, "Lung", {1500.0, -500.0}},
}};

}  // namespace fenestra::viewer
