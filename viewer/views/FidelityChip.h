#pragma once
// The chip of a view: its colour and character say how faithful the picture is, its tool tip says why.

#include <vector>

#include "viewer/model/Fidelity.h"

class QHelpEvent;
class QPainter;
class QRectF;
class QWidget;

namespace fenestra::viewer {

/// Draws the chip into the corner of `view`.
void drawFidelity(QPainter& painter, const QRectF& view, const std::vector<FidelityCause>& causes);
/// Writes the causes below the title, as exported pictures have them, because they have no tool tip.
void writeFidelity(QPainter& painter, const QRectF& view, const std::vector<FidelityCause>& causes);
/// Shows the tool tip where the mouse is over the chip of `view`; otherwise returns false.
bool showFidelity(const QHelpEvent& event, QWidget& view, const std::vector<FidelityCause>& causes);

}  // namespace fenestra::viewer
