#pragma once
// Marks in a slice's picture for planes that were not scanned but interpolated across gaps of the series.

#include <vector>

#include <QPainter>
#include <QRectF>

#include "rendering/volume/Grid.h"
#include "rendering/volume/Slice.h"

namespace fenestra::viewer {

/// Where a slice's picture crosses interpolated planes, in its pixels (the first pixel's corner is (0, 0)): bands over
/// the whole picture. The whole picture is one band where the slice lies on such a plane.
std::vector<QRectF> interpolatedBands(const std::vector<int>& planes, const Grid& grid, const SliceGeometry& geometry,
                                      int slice);
/// Whether the slice itself lies on an interpolated plane.
bool isInterpolated(const std::vector<int>& planes, const Grid& grid, const SliceGeometry& geometry, int slice);

/// Marks bands along the picture's edges, so that they hide nothing. `widgetFromPixel` maps picture pixels.
void drawInterpolatedBands(QPainter& painter, const std::vector<QRectF>& bands, const QTransform& widgetFromPixel);

}  // namespace fenestra::viewer
