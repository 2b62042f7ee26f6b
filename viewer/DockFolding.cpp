#include "viewer/DockFolding.h"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QMouseEvent>
#include <QStyle>
#include <QToolButton>

namespace fenestra::viewer {

DockFolding::DockFolding(QMainWindow& window, std::vector<QDockWidget*> docks) : QObject(&window), window_(window) {
  for (QDockWidget* dock : docks) {
    auto* button = new QToolButton(dock);
    button->setObjectName(QStringLiteral("fold"));
    button->setAutoRaise(true);
    button->setCheckable(true);
    button->setArrowType(Qt::DownArrow);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(tr("Fold %1").arg(dock->windowTitle()));
    button->setToolTip(tr("Folds this panel to its title, so that others have more room"));
    connect(button, &QToolButton::clicked, this, [this, dock](bool on) { setFolded(*dock, on); });
    connect(dock->toggleViewAction(), &QAction::triggered, this, [this, dock](bool on) {
      if (on) setFolded(*dock, false);
    });
    dock->installEventFilter(this);
    folds_.push_back({dock, button});
  }
  connect(&window, &QMainWindow::tabifiedDockWidgetActivated, this, [this](QDockWidget* dock) {
    if (isFolded(*dock)) setFolded(*dock, false);
  });
}

void DockFolding::place(const Fold& fold) {
  const QDockWidget& dock = *fold.dock;
  // The title is as high as what it leaves to the contents; folded, it is all there is.
  const int height = dock.widget()->isHidden() ? dock.height() : std::max(dock.widget()->y(), 1);
  const int side = std::min(height, 20),
            closes = dock.style()->pixelMetric(QStyle::PM_SmallIconSize, nullptr, &dock) + 12;
  fold.button->setGeometry(dock.width() - closes - side, (height - side) / 2, side, side);
  fold.button->raise();
}

bool DockFolding::eventFilter(QObject* watched, QEvent* event) {
  const auto fold = std::find_if(folds_.begin(), folds_.end(), [&](const Fold& each) { return each.dock == watched; });
  if (fold == folds_.end()) return QObject::eventFilter(watched, event);
  if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show)
    QMetaObject::invokeMethod(
        this, [fold = *fold] { place(fold); }, Qt::QueuedConnection);
  if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonRelease)
    clickTitle(*fold->dock, *static_cast<QMouseEvent*>(event));
  return QObject::eventFilter(watched, event);
}

void DockFolding::clickTitle(QDockWidget& dock, const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) return;
  const QPoint at = event.globalPosition().toPoint();
  if (event.type() == QEvent::MouseButtonPress) {
    const bool inTitle = isFolded(dock) || event.position().y() < dock.widget()->y();
    pressed_ = inTitle ? std::optional(at) : std::nullopt;
    return;
  }
  const std::optional<QPoint> from = std::exchange(pressed_, std::nullopt);
  if (!from || (at - *from).manhattanLength() >= QApplication::startDragDistance()) return;
  // After the dock has handled the release.
  QMetaObject::invokeMethod(
      this, [this, &dock] { setFolded(dock, !isFolded(dock)); }, Qt::QueuedConnection);
}

bool DockFolding::isFolded(const QDockWidget& dock) const { return dock.widget()->isHidden(); }

bool DockFolding::isFoldedByUser(const QDockWidget& dock) const {
  return std::any_of(folds_.begin(), folds_.end(), [&](const Fold& each) { return each.dock == &dock && each.byUser; });
}

void DockFolding::apply(const Fold& fold) {
  QDockWidget& dock = *fold.dock;
  const bool folded = fold.byUser || fold.crowded;
  if (dock.widget()->isHidden() == folded) return;
  const int title = std::max(dock.widget()->y(), dock.fontMetrics().height() + 10);
  // Without height it counts in the dock's layout though it is hidden: a dock with nothing in it is as narrow as its
  // title.
  QSizePolicy policy = dock.widget()->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  dock.widget()->setSizePolicy(policy);
  dock.widget()->setMaximumHeight(folded ? 0 : QWIDGETSIZE_MAX);
  dock.widget()->setVisible(!folded);
  dock.setMaximumHeight(folded ? title : QWIDGETSIZE_MAX);
  fold.button->setArrowType(folded ? Qt::RightArrow : Qt::DownArrow);
  fold.button->setChecked(folded);
}

void DockFolding::setFolded(QDockWidget& dock, bool folded) {
  QList<QDockWidget*> group = window_.tabifiedDockWidgets(&dock);
  group.prepend(&dock);
  const bool opens = isFolded(dock) && !folded;
  bool changes = false;
  for (Fold& each : folds_) {
    if (!group.contains(each.dock) || isFolded(*each.dock) == folded) continue;
    changes = true;
    each.byUser = folded;
    each.crowded = false;
    apply(each);
  }
  if (opens) Q_EMIT opened(&dock);
  if (changes) Q_EMIT changed();
}

void DockFolding::setCrowded(QDockWidget& dock, bool crowded) {
  QList<QDockWidget*> group = window_.tabifiedDockWidgets(&dock);
  group.prepend(&dock);
  for (Fold& each : folds_) {
    if (!group.contains(each.dock)) continue;
    each.crowded = crowded;
    apply(each);
  }
}

QStringList DockFolding::folded() const {
  QStringList names;
  for (const Fold& each : folds_)
    if (each.byUser) names << each.dock->objectName();
  return names;
}

void DockFolding::restore(const QStringList& folded) {
  bool changes = false;
  for (Fold& each : folds_) {
    const bool byUser = folded.contains(each.dock->objectName());
    changes |= byUser != each.byUser;
    each.byUser = byUser;
    each.crowded = false;
    apply(each);
  }
  if (changes) Q_EMIT changed();
}

}  // namespace fenestra::viewer
