#include "viewer/Panels.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QResizeEvent>
#include <QTimer>

#include "viewer/model/Workspace.h"
#include "viewer/panels/AppearancePanel.h"
#include "viewer/panels/BrushPanel.h"
#include "viewer/panels/CamerasPanel.h"
#include "viewer/panels/ContextLayerPanel.h"
#include "viewer/panels/CutawayPanel.h"
#include "viewer/panels/FocusPanel.h"
#include "viewer/panels/ScrollingPanel.h"

namespace fenestra::viewer {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("Panels", text); }

/// When the window becomes higher, a panel whose contents are scrolled gets of the new height what it lacks; the list
/// of structures, which takes any height, the rest.
class HeightSharing : public QObject {
 public:
  HeightSharing(QMainWindow& window, QDockWidget& list, QDockWidget& scrolled)
      : QObject(&window), window_(window), list_(list), scrolled_(scrolled) {
    window.installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Resize && window_.isVisible()) {
      const auto* resize = static_cast<QResizeEvent*>(event);
      gained_ += resize->size().height() - resize->oldSize().height();
      QTimer::singleShot(0, this, [this] { share(std::exchange(gained_, 0)); });  // once the docks have their new sizes
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  void share(int gained) {
    if (!list_.isVisible() || !scrolled_.isVisible()) return;
    const int lacks = scrolled_.widget()->sizeHint().height() - scrolled_.widget()->height();
    const int given = std::min(gained, lacks);
    if (given > 0)
      window_.resizeDocks({&list_, &scrolled_}, {list_.height() - given, scrolled_.height() + given}, Qt::Vertical);
  }

  QMainWindow& window_;
  QDockWidget &list_, &scrolled_;
  int gained_ = 0;
};

}  // namespace

Panels makePanels(QMainWindow& window, Workspace& workspace) {
  Document& document = workspace.document;
  const Panels panels{.focus = new FocusPanel(document, workspace.placement, workspace.cameras),
                      .appearance = new AppearancePanel(document, workspace.looks),
                      .cutaway = new CutawayPanel(document),
                      .contextLayer = new ContextLayerPanel(document),
                      .cameras = new CamerasPanel(document, workspace.cameras, workspace.placement),
                      .brush = new BrushPanel(document, workspace.brush)};
  const auto add = [&window](const QString& title, const char* name, QWidget* panel) {
    auto* dock = new QDockWidget(title);
    dock->setObjectName(QLatin1String(name));
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
    dock->setWidget(panel);
    window.addDockWidget(Qt::RightDockWidgetArea, dock);
    return dock;
  };
  window.setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  auto* focusScroller = new ScrollingPanel;  // a grown region adds rows, for which the window must not grow
  focusScroller->setBody(panels.focus);
  QDockWidget* focus = add(tr("Focus"), "focusDock", focusScroller);
  window.tabifyDockWidget(focus, add(tr("Cameras"), "camerasDock", panels.cameras));
  QDockWidget* brush = add(tr("Brush"), "brushDock", panels.brush);
  window.tabifyDockWidget(focus, brush);
  focus->raise();
  QObject::connect(&workspace.brush, &Brush::activeChanged, brush, [brush](bool active) {
    if (!active) return;
    brush->show();
    brush->raise();
  });
  QDockWidget* context = add(tr("Context"), "contextDock", panels.appearance);
  window.tabifyDockWidget(context, add(tr("Context edges"), "contextLayerDock", panels.contextLayer));
  context->raise();
  add(tr("Cutaway"), "cutawayDock", panels.cutaway);
  // The list of structures takes the remaining height.
  for (QWidget* panel : std::initializer_list<QWidget*>{panels.appearance, panels.cutaway, panels.contextLayer})
    panel->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  window.resizeDocks({focus}, {310}, Qt::Horizontal);
  window.resizeDocks({focus, context}, {panels.appearance->sizeHint().height(), panels.appearance->sizeHint().height()},
                     Qt::Vertical);
  new HeightSharing(window, *focus, *context);
  return panels;
}

}  // namespace fenestra::viewer
