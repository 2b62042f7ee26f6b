#include "viewer/views/RepaintsByRound.h"

#include <utility>

#include <QCoreApplication>
#include <QEvent>
#include <QWidget>

#include "viewer/model/DrawingTurns.h"

namespace fenestra::viewer {

RepaintsByRound::RepaintsByRound(QWidget& window, std::shared_ptr<const DrawingTurns> turns)
    : QObject(&window), turns_(std::move(turns)) {
  window.installEventFilter(this);
  connect(turns_.get(), &DrawingTurns::roundEnded, this, [this, &window] {
    // One repaint passes even if the next round has begun by then: pictures are shown between rounds.
    mayPass_ = true;
    if (std::exchange(isHeld_, false)) QCoreApplication::postEvent(&window, new QEvent(QEvent::UpdateRequest));
  });
}

bool RepaintsByRound::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::UpdateRequest) return QObject::eventFilter(watched, event);
  const bool passes = std::exchange(mayPass_, false) || !turns_->isUnderWay();
  isHeld_ = !passes;
  return isHeld_;
}

}  // namespace fenestra::viewer
