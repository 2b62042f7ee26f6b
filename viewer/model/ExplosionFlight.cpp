#include "viewer/model/ExplosionFlight.h"

#include <QEasingCurve>

#include "rendering/scene/Explosion.h"
#include "viewer/model/Document.h"
#include "viewer/model/ViewLink.h"

namespace fenestra::viewer {
namespace {

constexpr int flightMilliseconds = 400;

}  // namespace

ExplosionFlight::ExplosionFlight(Document& document, const ViewLink& cameras, QObject* parent)
    : QObject(parent), document_(document), cameras_(cameras), explodes_(explosionOf(document.look()).has_value()) {
  flight_.setDuration(flightMilliseconds);
  flight_.setEasingCurve(QEasingCurve::InOutQuad);
  flight_.setStartValue(0.0);
  flight_.setEndValue(1.0);
  connect(&flight_, &QVariantAnimation::valueChanged, this, &ExplosionFlight::moved);
  connect(&flight_, &QVariantAnimation::finished, this, &ExplosionFlight::moved);
  connect(&document, &Document::cutawayChanged, this, &ExplosionFlight::follow);
  connect(&document, &Document::volumeChanged, this, [this] {
    flight_.stop();
    explodes_ = explosionOf(document_.look()).has_value();
  });
}

void ExplosionFlight::follow() {
  const bool explodes = explosionOf(document_.look()).has_value();
  if (explodes) exploded_ = document_.look().method;
  if (explodes == explodes_) return;
  explodes_ = explodes;
  if (!cameras_.isAnimated() || !document_.hasVolume()) return flight_.stop();
  // From where the parts are, should they be on the way the other way.
  flight_.setDirection(explodes ? QAbstractAnimation::Forward : QAbstractAnimation::Backward);
  if (!isFlying()) flight_.start();
}

Look ExplosionFlight::shown(Look look) const {
  if (!isFlying()) return look;
  look.cutaway.enabled = true;
  look.method = exploded_;
  look.method.explosion *= flight_.currentValue().toDouble();
  return look;
}

}  // namespace fenestra::viewer
