#pragma once
// How a measure is drawn over a slice: its line with a dark rim, its handles, and its text beside it, off the line.

#include <QPainter>
#include <QPolygonF>
#include <QStringList>

#include "rendering/volume/SliceMeasure.h"

namespace fenestra::viewer {

/// A measure in a view: its handles (see handlesOf) in device-independent pixels, and its text.
struct ShownMeasure {
  MeasureKind kind = MeasureKind::Distance;
  QPolygonF handles;
  QStringList lines;
  bool selected = false;
};

/// The line that is drawn; closed for regions.
QPolygonF outlineOf(const ShownMeasure& measure);
/// The two lines of an arrow's head.
QPolygonF headOf(const ShownMeasure& arrow);
/// Where text of that size goes: off the line, and inside the view where there is room.
QRectF textBoxOf(const ShownMeasure& measure, QSizeF text, const QRectF& view);
void drawMeasure(QPainter& painter, const ShownMeasure& measure, const QRectF& view);

}  // namespace fenestra::viewer
