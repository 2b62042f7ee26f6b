#include "viewer/views/FidelityChip.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <QWidget>

#include "viewer/style/Overlay.h"

namespace fenestra::viewer {
namespace {

/// Lines of a view's own title at most.
constexpr int titleLines = 5;

/// Colours that colour-blind users tell apart, too; the character says it once more.
QColor colourOf(Fidelity grade) {
  switch (grade) {
    case Fidelity::Faithful:
      return {110, 200, 130};
    case Fidelity::Bounded:
      return {110, 180, 240};
    case Fidelity::Approximate:
      return {200, 205, 210};
    case Fidelity::Altered:
      break;
  }
  return {240, 190, 70};
}

}  // namespace

void drawFidelity(QPainter& painter, const QRectF& view, const std::vector<FidelityCause>& causes) {
  const Fidelity grade = gradeOf(causes);
  drawChip(painter, view, colourOf(grade), symbolOf(grade));
}

void writeFidelity(QPainter& painter, const QRectF& view, const std::vector<FidelityCause>& causes) {
  drawCorner(painter, view, Qt::AlignTop | Qt::AlignLeft, QStringList(titleLines) + linesOf(causes), overlayGrey);
}

bool showFidelity(const QHelpEvent& event, QWidget& view, const std::vector<FidelityCause>& causes) {
  constexpr double slack = 4.0;  // device-independent pixels
  if (!chipIn(view.rect()).adjusted(-slack, -slack, slack, slack).contains(event.pos())) return false;
  QToolTip::showText(event.globalPos(), linesOf(causes).join(QLatin1Char('\n')), &view);
  return true;
}

}  // namespace fenestra::viewer
