#include "viewer/model/DrawingTurns.h"

namespace fenestra::viewer {

DrawingTurns::DrawingTurns(const FramePacer& pacer) : pacer_(pacer) {
  // Qt handles paint requests before timers, so the pictures of a round are shown before the next round begins.
  timer_.setInterval(0);
  connect(&timer_, &QTimer::timeout, this, &DrawingTurns::next);
}

void DrawingTurns::ask(int view) {
  waiting_[static_cast<std::size_t>(view)] = true;
  if (!timer_.isActive()) timer_.start();
}

int DrawingTurns::firstWaiting() const {
  int first = -1;
  for (int view = 0; view < FramePacer::views; ++view) {
    const auto at = static_cast<std::size_t>(view);
    if (waiting_[at] && !served_[at] && (first < 0 || pacer_.leads(view))) first = view;
  }
  return first;
}

void DrawingTurns::next() {
  if (const int view = firstWaiting(); view >= 0) {
    if (served_ == std::array<bool, FramePacer::views>{}) Q_EMIT roundBegins();
    waiting_[static_cast<std::size_t>(view)] = false;
    served_[static_cast<std::size_t>(view)] = true;
    Q_EMIT turn(view);
  }
  if (firstWaiting() >= 0) return;
  served_.fill(false);
  if (firstWaiting() < 0) timer_.stop();
  Q_EMIT roundEnded();
}

}  // namespace fenestra::viewer
