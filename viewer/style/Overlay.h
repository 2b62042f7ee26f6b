#pragma once
// What is written and drawn over a picture: corner text, edge letters, scale bar, orientation cube.

#include <QColor>
#include <QPainter>
#include <QRectF>
#include <QString>
#include <QStringList>

#include "rendering/settings/Camera.h"
#include "rendering/volume/Slice.h"

namespace fenestra::viewer {

/// Distance of all overlays from the edge of the view, in device-independent pixels.
inline constexpr double overlayMargin = 8.0;

/// The colour of texts that matter less than a view's title.
inline const QColor overlayGrey(224, 227, 232);

QColor toColour(glm::dvec3 displayRgb);
glm::dvec3 fromColour(const QColor& colour);
/// The colour that stands for a plane: in its view's title, and for its line in the other views' crosshairs.
QColor planeColour(SlicePlane plane);
QString planeName(SlicePlane plane);

/// What drawText() fills, without the halo.
QSizeF textSize(const QPainter& painter, const QString& text);
/// One line of light text with a dark halo, readable on black and on bone.
void drawText(QPainter& painter, const QRectF& box, int alignment, const QString& text, const QColor& colour);
/// Whether a text in a corner leaves room for the letter in the middle of the edge.
bool fitsBesideLetter(const QPainter& painter, const QRectF& view, const QString& text);
/// Lines of text in a corner; the first line in `colour`, the rest in grey. A line that is wider than half the view
/// goes on below. Where the line beside the letter would cover it, all stand a line further from the edge.
void drawCorner(QPainter& painter, const QRectF& view, Qt::Alignment corner, const QStringList& lines,
                const QColor& colour = Qt::white);
/// The width that chipIn() takes of the top left corner.
inline constexpr double chipRoom = 20.0;
/// A chip in the top left corner of a view, beside the title: a coloured plate with one character.
QRectF chipIn(const QRectF& view);
void drawChip(QPainter& painter, const QRectF& view, const QColor& colour, const QString& symbol);
/// The view without the chip's room, on both sides, so that its middle stays.
QRectF besideChip(const QRectF& view);
/// A plate at the bottom of the view with one line of text: what is awaited.
void drawWaiting(QPainter& painter, const QRectF& view, const QString& text);
/// Lines right-aligned in the top right corner, below `above` other lines and no wider than half the view; longer ones
/// end in dots, and those below the upper quarter are left out, but for the first one.
void drawStudyText(QPainter& painter, const QRectF& view, const QStringList& lines, int above);
/// Patient letters at the middle of the four edges; `right` and `down` are world directions.
void drawEdgeLetters(QPainter& painter, const QRectF& view, glm::dvec3 right, glm::dvec3 down);
/// A bar of a round number of mm, at most a quarter of the view wide, at the bottom right.
void drawScaleBar(QPainter& painter, const QRectF& view, double mmPerPixel);
/// A cube lettered A P L R S I as the camera sees the patient, in the square `box`.
void drawOrientationCube(QPainter& painter, const QRectF& box, const Camera::Axes& axes);
/// A small cross-hair mark.
void drawMark(QPainter& painter, QPointF at);
/// The seed of a region: a plus inside, a minus outside.
void drawSeed(QPainter& painter, QPointF at, bool inside);

}  // namespace fenestra::viewer
