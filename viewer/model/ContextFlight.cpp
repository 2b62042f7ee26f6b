#include "viewer/model/ContextFlight.h"

#include <QEasingCurve>

#include "rendering/scene/Explosion.h"
#include "rendering/scene/Peel.h"
#include "viewer/model/Document.h"
#include "viewer/model/ViewLink.h"

namespace fenestra::viewer {
namespace {

constexpr int flightMilliseconds = 400;

bool movesContext(const Look& look) { return explosionOf(look) || peelOf(look); }

}  // namespace

ContextFlight::ContextFlight(Document& document, const ViewLink& cameras, QObject* parent)
    : QObject(parent), document_(document), cameras_(cameras), isMoved_(movesContext(document.look())) {
  flight_.setDuration(flightMilliseconds);
  flight_.setEasingCurve(QEasingCurve::InOutQuad);
  flight_.setStartValue(0.0);
  flight_.setEndValue(1.0);
  connect(&flight_, &QVariantAnimation::valueChanged, this, &ContextFlight::moved);
  connect(&flight_, &QVariantAnimation::finished, this, &ContextFlight::moved);
  connect(&document, &Document::cutawayChanged, this, &ContextFlight::follow);
  connect(&document, &Document::volumeChanged, this, [this] {
    flight_.stop();
    isMoved_ = movesContext(document_.look());
  });
}

void ContextFlight::follow() {
  const bool moves = movesContext(document_.look());
  if (moves) moving_ = document_.look().method;
  if (moves == isMoved_) return;
  isMoved_ = moves;
  if (!cameras_.isAnimated() || !document_.hasVolume()) return flight_.stop();
  // From where the context is, should it be on the way the other way.
  flight_.setDirection(moves ? QAbstractAnimation::Forward : QAbstractAnimation::Backward);
  if (!isFlying()) flight_.start();
}

Look ContextFlight::shown(Look look) const {
  if (!isFlying()) return look;
  look.cutaway.enabled = true;
  look.method = moving_;
  look.method.explosion *= flight_.currentValue().toDouble();
  look.method.peel *= flight_.currentValue().toDouble();
  return look;
}

}  // namespace fenestra::viewer
