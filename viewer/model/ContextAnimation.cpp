#include "viewer/model/ContextAnimation.h"

#include <QEasingCurve>

#include "rendering/scene/Explosion.h"
#include "rendering/scene/Peel.h"
#include "viewer/model/Document.h"
#include "viewer/model/ViewLink.h"

namespace fenestra::viewer {
namespace {

constexpr int milliseconds = 400;

bool movesContext(const Look& look) { return explosionOf(look) || peelOf(look); }

}  // namespace

ContextAnimation::ContextAnimation(Document& document, const ViewLink& cameras, QObject* parent)
    : QObject(parent), document_(document), cameras_(cameras), isMoved_(movesContext(document.look())) {
  animation_.setDuration(milliseconds);
  animation_.setEasingCurve(QEasingCurve::InOutQuad);
  animation_.setStartValue(0.0);
  animation_.setEndValue(1.0);
  connect(&animation_, &QVariantAnimation::valueChanged, this, &ContextAnimation::moved);
  connect(&animation_, &QVariantAnimation::finished, this, &ContextAnimation::moved);
  connect(&document, &Document::cutawayChanged, this, &ContextAnimation::follow);
  connect(&document, &Document::volumeChanged, this, [this] {
    animation_.stop();
    isMoved_ = movesContext(document_.look());
  });
}

void ContextAnimation::follow() {
  const bool moves = movesContext(document_.look());
  if (moves) moving_ = document_.look().method;
  if (moves == isMoved_) return;
  isMoved_ = moves;
  if (!cameras_.isAnimated() || !document_.hasVolume()) return animation_.stop();
  // A running animation turns round where it is.
  animation_.setDirection(moves ? QAbstractAnimation::Forward : QAbstractAnimation::Backward);
  if (!isRunning()) animation_.start();
}

Look ContextAnimation::shown(Look look) const {
  if (!isRunning()) return look;
  look.cutaway.enabled = true;
  look.method = moving_;
  look.method.of<methods::Explode>().degree *= animation_.currentValue().toDouble();
  look.method.of<methods::Peel>().amount *= animation_.currentValue().toDouble();
  return look;
}

}  // namespace fenestra::viewer
