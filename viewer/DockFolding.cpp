#include "viewer/DockFolding.h"

#include <algorithm>

#include <QEvent>
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
    connect(button, &QToolButton::toggled, this, [this, dock](bool on) { setFolded(*dock, on); });
    dock->installEventFilter(this);
    folds_.push_back({dock, button});
  }
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
  if (fold != folds_.end() &&
      (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show))
    QMetaObject::invokeMethod(
        this, [fold = *fold] { place(fold); }, Qt::QueuedConnection);
  return QObject::eventFilter(watched, event);
}

bool DockFolding::isFolded(const QDockWidget& dock) const { return dock.widget()->isHidden(); }

void DockFolding::setFolded(QDockWidget& dock, bool folded) {
  QList<QDockWidget*> group = window_.tabifiedDockWidgets(&dock);
  group.prepend(&dock);
  bool changes = false;
  for (const Fold& each : folds_) {
    if (!group.contains(each.dock) || isFolded(*each.dock) == folded) continue;
    changes = true;
    const int title = std::max(each.dock->widget()->y(), dock.fontMetrics().height() + 10);
    each.dock->widget()->setVisible(!folded);
    each.dock->setMaximumHeight(folded ? title : QWIDGETSIZE_MAX);
    each.button->setArrowType(folded ? Qt::RightArrow : Qt::DownArrow);
    each.button->setChecked(folded);
  }
  if (changes) Q_EMIT changed();
}

QStringList DockFolding::folded() const {
  QStringList names;
  for (const Fold& each : folds_)
    if (isFolded(*each.dock)) names << each.dock->objectName();
  return names;
}

void DockFolding::restore(const QStringList& folded) {
  for (const Fold& each : folds_) setFolded(*each.dock, folded.contains(each.dock->objectName()));
}

}  // namespace fenestra::viewer
