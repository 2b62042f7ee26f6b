#include "viewer/guide/Guide.h"

#include <utility>

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>

#include "viewer/dialogs/Dialogs.h"
#include "viewer/guide/GuideWindow.h"
#include "viewer/views/SliceView.h"
#include "viewer/views/VolumeView.h"

namespace fenestra::viewer {
namespace {

/// The page of a dock.
QString placeOf(const QDockWidget& dock) {
  for (const auto& [name, place] : {std::pair{"focusDock", "focus"},
                                    {"camerasDock", "cameras"},
                                    {"brushDock", "brush"},
                                    {"clippingDock", "opening#clipping"},
                                    {"contextDock", "look"},
                                    {"contextLayerDock", "opening#edges-of-what-was-removed"},
                                    {"cutawayDock", "opening"},
                                    {"archiveDock", "archive#in-the-window"}})
    if (dock.objectName() == QLatin1String(name)) return QLatin1String(place);
  return QStringLiteral("look");
}

}  // namespace

Guide::Guide(QMainWindow& window) : QObject(&window), window_(window), place_(QStringLiteral("first-minute")) {
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { follow(now); });
  for (QDockWidget* dock : window.findChildren<QDockWidget*>())
    connect(dock, &QDockWidget::visibilityChanged, this, [this, dock](bool visible) {
      // All docks come into sight with the window. After that, one comes into sight because the user chose its tab.
      if (visible && window_.isVisible() && window_.isActiveWindow()) place_ = placeOf(*dock);
    });
}

GuideWindow* Guide::window() { return shown_; }

void Guide::opened(const QDockWidget* dock) { place_ = placeOf(*dock); }

void Guide::follow(const QWidget* focused) {
  for (; focused; focused = focused->parentWidget()) {
    if (qobject_cast<const VolumeView*>(focused)) place_ = QStringLiteral("cameras");
    if (qobject_cast<const SliceView*>(focused)) place_ = QStringLiteral("slices");
    if (const auto* dock = qobject_cast<const QDockWidget*>(focused)) place_ = placeOf(*dock);
  }
}

void Guide::open(const QString& place) {
  if (!shown_) {
    shown_ = new GuideWindow([this] { return keysPageHtml(*window_.menuBar()); }, &window_);
    shown_->setAttribute(Qt::WA_DeleteOnClose);
  }
  shown_->open(place);
  shown_->show();
  shown_->raise();
  shown_->activateWindow();
}

}  // namespace fenestra::viewer
