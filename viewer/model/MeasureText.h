#pragma once
// What measures say, as text beside them and as a table.

#include <QString>
#include <QStringList>

#include "rendering/volume/SliceMeasure.h"

namespace fenestra::viewer {

class Document;

/// "Distance", "Angle", "Ellipse", "Rectangle", "Arrow" or "Text".
QString nameOf(MeasureKind kind);

/// A real value with the digits that a volume of that range asks for.
QString valueText(double value, ValueRange range);

/// The lines beside a measure: "12.3 mm", "41.7°", or mean, deviation, range and area; a mark's text.
QStringList linesOf(const Measure& measure, const MeasureValues& values, const Volume& volume);

/// A mark's text as it may be kept: on one line, cut to Measure::longestText bytes between characters.
std::string markText(QString text);

/// All measures of the document, or only that one, as comma-separated values (RFC 4180) with a header line. Numbers
/// have a point and all their digits; a member that a kind does not have is empty. Coordinates are LPS mm.
QString measuresCsv(const Document& document, std::optional<std::size_t> only = {});

}  // namespace fenestra::viewer
