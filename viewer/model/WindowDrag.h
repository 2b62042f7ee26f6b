#pragma once
// The window of grey values that a drag over a slice, or over a picture like one, sets.

#include <algorithm>

#include <QPointF>

#include "rendering/volume/Volume.h"

namespace fenestra::viewer {

/// `moved` is what the mouse has moved since the press, in device-independent pixels: to the right widens, down raises
/// the level. 250 pixels double the width. A very narrow window changes faster, so that it can be widened at all.
/// `range` is that of the volume's values.
inline WindowLevel draggedWindow(WindowLevel atPress, QPointF moved, ValueRange range) {
  const double all = range.high - range.low;
  const double perPixel = std::max(atPress.width, 0.02 * all) / 250.0;
  const double least = std::max(1e-4 * all, 1e-9);
  return {std::max(atPress.width + moved.x() * perPixel, least), atPress.level + moved.y() * perPixel};
}

}  // namespace fenestra::viewer
