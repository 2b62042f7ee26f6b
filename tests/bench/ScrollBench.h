#pragma once
// How many slices a second the window shows while the wheel turns: along the axis, and obliquely with a slab.

#include <functional>

#include <nlohmann/json.hpp>

#include "viewer/MainWindow.h"

namespace fenestra::viewer {

/// Shows the axial slice alone in 700 × 700 pixels and scrolls it by single notches, each once the slice before is on
/// the screen. `settle` waits until the window is at rest.
nlohmann::ordered_json scrollRates(MainWindow& window, const std::function<void()>& settle);

}  // namespace fenestra::viewer
