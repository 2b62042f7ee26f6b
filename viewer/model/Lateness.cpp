#include "viewer/model/Lateness.h"

#include <utility>

namespace fenestra::viewer {

Lateness::Lateness(QObject* parent) : QObject(parent) {
  timer_.setSingleShot(true);
  timer_.setInterval(milliseconds);
  connect(&timer_, &QTimer::timeout, this, [this] {
    isLate_ = true;
    Q_EMIT changed();
  });
}

void Lateness::setBehind(bool behind) {
  if (behind) {
    if (!isLate_ && !timer_.isActive()) timer_.start();
    return;
  }
  timer_.stop();
  if (std::exchange(isLate_, false)) Q_EMIT changed();
}

}  // namespace fenestra::viewer
