#include "viewer/tools/ToleranceWheel.h"

#include <QWheelEvent>

#include "viewer/model/Document.h"

namespace fenestra::viewer {
namespace {

constexpr double anglePerStep = 30.0;  ///< a notch, 120, is four steps: the tolerance changes by 9 %
constexpr int pauseMilliseconds = 700;

}  // namespace

ToleranceWheel::ToleranceWheel(Document& document) : document_(document) {
  pause_.setSingleShot(true);
  pause_.setInterval(pauseMilliseconds);
  QObject::connect(&pause_, &QTimer::timeout, &pause_, [this] { document_.history().endGesture(); });
}

bool ToleranceWheel::wheel(const QWheelEvent& event) {
  if (!(event.modifiers() & Qt::AltModifier)) return false;
  // With Alt held, Qt reports a vertical wheel as a horizontal one.
  const QPoint angle = event.angleDelta();
  angle_ += angle.y() != 0 ? angle.y() : angle.x();
  const int steps = static_cast<int>(angle_ / anglePerStep);
  angle_ -= steps * anglePerStep;
  if (steps == 0 || !document_.growth()) return true;
  if (!pause_.isActive()) document_.history().beginGesture();
  pause_.start();
  document_.moveTolerance(steps);
  return true;
}

}  // namespace fenestra::viewer
