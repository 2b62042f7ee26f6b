#include "viewer/DockHeights.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>

#include <QEvent>
#include <QLayout>

namespace fenestra::viewer {

DockHeights::DockHeights(QMainWindow& window, std::vector<QDockWidget*> column)
    : QObject(&window), window_(window), column_(std::move(column)) {
  window.installEventFilter(this);
}

std::vector<QDockWidget*> DockHeights::shown() const {
  std::vector<QDockWidget*> docks;
  for (QDockWidget* of : column_) {
    QList<QDockWidget*> group = window_.tabifiedDockWidgets(of);
    group.prepend(of);
    // A dock behind another tab is shown but has no visible part.
    const auto front = std::find_if(group.begin(), group.end(), [](const QDockWidget* each) {
      return each->isVisible() && !each->isFloating() && !each->visibleRegion().isEmpty();
    });
    if (front == group.end()) return {};
    const bool below = docks.empty() || (*front)->y() > docks.back()->y();
    if (!below || (!docks.empty() && (*front)->x() != docks.back()->x())) return {};
    docks.push_back(*front);
  }
  return docks;
}

std::vector<int> DockHeights::heightsOf(const std::vector<QDockWidget*>& docks) {
  std::vector<int> heights;
  for (const QDockWidget* dock : docks) heights.push_back(dock->height());
  return heights;
}

std::vector<int> DockHeights::wanted(const std::vector<QDockWidget*>& docks) const {
  const std::vector<int> now = heightsOf(docks);
  int room = std::accumulate(now.begin(), now.end(), 0);
  std::vector<int> heights(docks.size(), 0);
  for (std::size_t i = docks.size(); i-- > 1;) {
    const int even = room / static_cast<int>(i + 1);
    heights[i] = std::max(docks[i]->minimumSizeHint().height(), std::min(even, docks[i]->sizeHint().height()));
    heights[i] = std::min(heights[i], docks[i]->maximumHeight());  // of one that is folded
    room -= heights[i];
  }
  heights[0] = room;
  return heights;
}

void DockHeights::reset() {
  isUsers_ = checks_ = false;
  share();
}

void DockHeights::share() {
  isDue_ = false;
  const std::vector<QDockWidget*> docks = shown();
  if (isUsers_ || docks.empty()) return;
  const std::vector<int> heights = wanted(docks);
  if (std::exchange(checks_, false)) {
    // A border is dragged by more than rounding moves it.
    constexpr int rounding = 2;
    const std::vector<int> now = heightsOf(docks);
    for (std::size_t i = 0; i < now.size(); ++i) isUsers_ |= std::abs(now[i] - heights[i]) > rounding;
    if (isUsers_) return;
  }
  window_.resizeDocks({docks.begin(), docks.end()}, {heights.begin(), heights.end()}, Qt::Vertical);
  window_.layout()->activate();
  shared_ = heightsOf(docks);
}

bool DockHeights::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &window_ || (event->type() != QEvent::Resize && event->type() != QEvent::Show))
    return QObject::eventFilter(watched, event);
  // The docks still have the heights from before.
  const std::vector<QDockWidget*> docks = shown();
  if (!isDue_ && !shared_.empty() && docks.size() == shared_.size() && heightsOf(docks) != shared_) isUsers_ = true;
  if (!isUsers_ && !std::exchange(isDue_, true))
    QMetaObject::invokeMethod(this, &DockHeights::share, Qt::QueuedConnection);
  return QObject::eventFilter(watched, event);
}

}  // namespace fenestra::viewer
