#include "viewer/DockHeights.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>

#include <QEvent>
#include <QLayout>
#include <QMouseEvent>
#include <QStyle>

#include "viewer/DockFolding.h"
#include "viewer/panels/ScrollingPanel.h"

namespace fenestra::viewer {

DockHeights::DockHeights(QMainWindow& window, DockFolding& folding, std::vector<QDockWidget*> column)
    : QObject(&window), window_(window), folding_(folding), column_(std::move(column)), order_(column_) {
  window.installEventFilter(this);
  connect(&folding, &DockFolding::opened, this, [this](QDockWidget* dock) {
    QList<QDockWidget*> group = window_.tabifiedDockWidgets(dock);
    group.prepend(dock);
    const auto at = std::find_if(order_.begin() + 1, order_.end(), [&](auto* each) { return group.contains(each); });
    if (at != order_.end()) std::rotate(order_.begin() + 1, at, at + 1);
  });
  // Queued: the panels have their new hints once the layout has seen what was hidden.
  connect(&folding, &DockFolding::changed, this, &DockHeights::reset, Qt::QueuedConnection);
}

std::vector<DockHeights::Section> DockHeights::shown() const {
  std::vector<Section> sections;
  for (QDockWidget* of : column_) {
    QList<QDockWidget*> group = window_.tabifiedDockWidgets(of);
    group.prepend(of);
    // A dock behind another tab is shown but has no visible part.
    const auto front = std::find_if(group.begin(), group.end(), [](const QDockWidget* each) {
      return each->isVisible() && !each->isFloating() && !each->visibleRegion().isEmpty();
    });
    if (front == group.end()) continue;  // closed
    const bool below = sections.empty() || (*front)->y() > sections.back().dock->y();
    if (!below || (!sections.empty() && (*front)->x() != sections.back().dock->x())) return {};
    sections.push_back({*front, of});
  }
  return sections;
}

std::vector<int> DockHeights::heightsOf(const std::vector<Section>& sections) {
  std::vector<int> heights;
  for (const Section& section : sections) heights.push_back(section.dock->height());
  return heights;
}

int DockHeights::titleOf(const Section& section) const {
  const QDockWidget& dock = *section.dock;
  if (folding_.isFolded(dock)) return dock.maximumHeight();
  return dock.widget()->y() + dock.style()->pixelMetric(QStyle::PM_DockWidgetFrameWidth, nullptr, &dock);
}

int DockHeights::usefulHeightOf(const Section& section) {
  const QWidget* contents = section.first->widget();
  const auto* panel = dynamic_cast<const ScrollingPanel*>(contents);
  return panel ? panel->usefulHeight() : contents->sizeHint().height();
}

void DockHeights::fold(const std::vector<Section>& sections) {
  const std::vector<int> now = heightsOf(sections);
  int room = std::accumulate(now.begin(), now.end(), 0);
  for (const Section& section : sections) room -= titleOf(section);
  int open = 0;
  for (const QDockWidget* dock : order_) {
    const auto section =
        std::find_if(sections.begin(), sections.end(), [&](const Section& each) { return each.first == dock; });
    if (section == sections.end() || folding_.isFoldedByUser(*section->dock)) continue;
    const int useful = usefulHeightOf(*section);
    // However low the window is, there is one section beside the first.
    constexpr int always = 2;
    const bool fits = open < always || useful <= room;
    if (fits) {
      ++open;
      room -= useful;
    }
    folding_.setCrowded(*section->dock, !fits);
  }
}

std::vector<int> DockHeights::wanted(const std::vector<Section>& sections) const {
  const std::vector<int> now = heightsOf(sections);
  const int column = std::accumulate(now.begin(), now.end(), 0);
  std::vector<int> heights;
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const bool folded = folding_.isFolded(*sections[i].dock);
    if (!folded) open.push_back(i);
    heights.push_back(titleOf(sections[i]) + (folded ? 0 : usefulHeightOf(sections[i])));
  }
  if (open.empty()) return heights;
  int spare = column - std::accumulate(heights.begin(), heights.end(), 0);
  if (spare < 0 && open.size() > 1) {
    // Not even two have the height that they should: the second one keeps at least two fifths.
    const int least = std::min(heights[open.back()], 2 * (heights[open.front()] + heights[open.back()] + spare) / 5);
    const int kept = std::max(heights[open.back()] + spare, least);
    spare += std::exchange(heights[open.back()], kept) - kept;
  }
  for (std::size_t k = 1; k < open.size() && spare > 0; ++k) {
    const Section& section = sections[open[k]];
    const int more = std::max(0, section.first->widget()->sizeHint().height() - usefulHeightOf(section));
    const int given = std::min(more, spare / static_cast<int>(open.size() - k + 1));
    heights[open[k]] += given;
    spare -= given;
  }
  heights[open.front()] += spare;
  return heights;
}

void DockHeights::reset() {
  isUsers_ = checks_ = false;
  share();
}

QStringList DockHeights::openedLast() const {
  QStringList names;
  for (const QDockWidget* dock : order_) names << dock->objectName();
  return names;
}

void DockHeights::restore(const QStringList& openedLast) {
  order_ = column_;
  const auto placeOf = [&](const QDockWidget* dock) {
    const auto place = openedLast.indexOf(dock->objectName());
    return place < 0 ? openedLast.size() : place;
  };
  // The first section is always open, and stays the first.
  std::stable_sort(order_.begin() + 1, order_.end(), [&](auto* a, auto* b) { return placeOf(a) < placeOf(b); });
}

void DockHeights::share() {
  isDue_ = false;
  window_.layout()->activate();
  if (isUsers_ || shown().empty()) return;
  fold(shown());
  window_.layout()->activate();
  const std::vector<Section> sections = shown();
  const std::vector<int> heights = wanted(sections);
  if (std::exchange(checks_, false)) {
    // A border is dragged by more than rounding moves it.
    constexpr int rounding = 2;
    const std::vector<int> now = heightsOf(sections);
    for (std::size_t i = 0; i < now.size(); ++i) isUsers_ |= std::abs(now[i] - heights[i]) > rounding;
    if (isUsers_) return;
  }
  // The height that the layout is told is that of a group, with its bar of tabs, which lies in the gap above the dock.
  const int separator = window_.style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent, nullptr, &window_);
  QList<QDockWidget*> docks;
  QList<int> groups;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const QDockWidget* above = i > 0 ? sections[i - 1].dock : nullptr;
    const int tabs = above ? sections[i].dock->y() - above->geometry().bottom() - 1 - separator : 0;
    docks << sections[i].dock;
    groups << heights[i] + std::max(tabs, 0);
  }
  window_.resizeDocks(docks, groups, Qt::Vertical);
  window_.layout()->activate();
}

bool DockHeights::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &window_) return QObject::eventFilter(watched, event);
  // The borders between docks are the window's own: where the mouse is pressed on no child, it may drag one. Contents
  // that want another height move borders, too, but at other times.
  if (event->type() == QEvent::MouseButtonPress) {
    const bool isOnBorder = !window_.childAt(static_cast<QMouseEvent*>(event)->position().toPoint());
    pressed_ = isOnBorder ? heightsOf(shown()) : std::vector<int>();
  }
  // From the event loop: the window moves borders from there.
  if (event->type() == QEvent::MouseButtonRelease && !pressed_.empty())
    QMetaObject::invokeMethod(
        this, [this, before = std::exchange(pressed_, {})] { isUsers_ |= heightsOf(shown()) != before; },
        Qt::QueuedConnection);
  const bool fits = event->type() == QEvent::Resize || event->type() == QEvent::Show;
  if (fits && !isUsers_ && !std::exchange(isDue_, true))
    QMetaObject::invokeMethod(this, &DockHeights::share, Qt::QueuedConnection);
  return QObject::eventFilter(watched, event);
}

}  // namespace fenestra::viewer
