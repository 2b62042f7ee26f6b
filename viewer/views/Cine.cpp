#include "viewer/views/Cine.h"

#include <algorithm>
#include <array>

#include "viewer/model/SliceCursor.h"

namespace fenestra::viewer {
namespace {

constexpr std::array cineSpeeds{1, 2, 3, 5, 7, 10, 15, 20, 30, 45, 60};

}  // namespace

Cine::Cine(SliceCursor& cursor, QObject* parent) : QObject(parent), cursor_(cursor) {
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &Cine::step);
}

void Cine::play(SliceView& view) {
  view_ = &view;
  timer_.start(1000 / speed_);
  Q_EMIT changed();
}

bool Cine::stop() {
  if (!isPlaying()) return false;
  timer_.stop();
  Q_EMIT changed();
  return true;
}

void Cine::setSlicesPerSecond(int count) {
  speed_ = std::clamp(count, slowest, fastest);
  timer_.setInterval(1000 / speed_);
  Q_EMIT changed();
}

void Cine::changeSpeed(int step) {
  if (step > 0) {
    const auto next = std::upper_bound(cineSpeeds.begin(), cineSpeeds.end(), speed_);
    if (next != cineSpeeds.end()) setSlicesPerSecond(*next);
  } else {
    const auto now = std::lower_bound(cineSpeeds.begin(), cineSpeeds.end(), speed_);
    if (now != cineSpeeds.begin()) setSlicesPerSecond(*(now - 1));
  }
}

void Cine::step() {
  // A view that went out of sight, or whose study was closed, has nothing to play.
  if (!view_ || !view_->isVisible() || view_->sliceGeometry().count < 2) {
    stop();
    return;
  }
  const int count = view_->sliceGeometry().count;
  cursor_.step(view_->sliceGeometry(), view_->slice() + 1 < count ? 1 : -count);
}

}  // namespace fenestra::viewer
