#include "viewer/Panels.h"

#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QTimer>

#include "viewer/DockFolding.h"
#include "viewer/DockHeights.h"
#include "viewer/model/Workspace.h"
#include "viewer/panels/AppearancePanel.h"
#include "viewer/panels/BrushPanel.h"
#include "viewer/panels/CamerasPanel.h"
#include "viewer/panels/ClippingPanel.h"
#include "viewer/panels/ContextLayerPanel.h"
#include "viewer/panels/CutawayPanel.h"
#include "viewer/panels/FocusPanel.h"
#include "viewer/panels/KeyImagesPanel.h"
#include "viewer/panels/LabelTable.h"
#include "viewer/panels/ReformatPanel.h"
#include "viewer/panels/ScrollingPanel.h"
#include "viewer/panels/SeriesPanel.h"
#include "viewer/panels/TagsPanel.h"

namespace fenestra::viewer {
namespace {

struct PanelsWords {
  Q_DECLARE_TR_FUNCTIONS(Panels)
};

QDockWidget* addDock(QMainWindow& window, Qt::DockWidgetArea area, const QString& title, const char* name,
                     QWidget* panel) {
  auto* dock = new QDockWidget(title);
  dock->setObjectName(QLatin1String(name));
  dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
  dock->setWidget(panel);
  window.addDockWidget(area, dock);
  return dock;
}

/// Puts a list behind the list of series, out of sight until its key or entry brings it to the front.
void addList(QMainWindow& window, QDockWidget& series, QDockWidget& dock, const QString& key) {
  window.tabifyDockWidget(&series, &dock);
  dock.hide();
  QAction* shows = dock.toggleViewAction();
  shows->setShortcut(QKeySequence(key));
  QObject::connect(shows, &QAction::triggered, &dock, [&window, &dock](bool on) {
    if (!on) return;
    dock.raise();
    // Wide enough for its columns, unless it is wider. From the event loop: the dock is being shown.
    constexpr int wanted = 370;
    QTimer::singleShot(0, &dock, [&window, &dock] {
      if (dock.width() < wanted) window.resizeDocks({&dock}, {wanted}, Qt::Horizontal);
    });
  });
}

void addLists(QMainWindow& window, Panels& panels) {
  const auto add = [&window](const QString& title, const char* name, QWidget* panel) {
    return addDock(window, Qt::LeftDockWidgetArea, title, name, panel);
  };
  panels.seriesDock = add(PanelsWords::tr("Series"), "seriesDock", panels.series);
  panels.seriesDock->hide();
  addList(window, *panels.seriesDock, *add(PanelsWords::tr("DICOM tags"), "tagsDock", panels.tags),
          PanelsWords::tr("Ctrl+T"));
  addList(window, *panels.seriesDock, *add(PanelsWords::tr("Label table"), "labelTableDock", panels.labelTable),
          PanelsWords::tr("Ctrl+Shift+T"));
  addList(window, *panels.seriesDock, *add(PanelsWords::tr("Key images"), "keyImagesDock", panels.keyImages),
          PanelsWords::tr("Ctrl+Shift+D"));
  addList(window, *panels.seriesDock, *add(PanelsWords::tr("Curved reformat"), "reformatDock", panels.reformat),
          PanelsWords::tr("Ctrl+Shift+R"));
}

}  // namespace

Panels makePanels(QMainWindow& window, Workspace& workspace) {
  Document& document = workspace.document;
  Panels panels{.focus = new FocusPanel(document, workspace.placement, workspace.cameras, workspace.selection),
                .appearance = new AppearancePanel(document, workspace.looks),
                .cutaway = new CutawayPanel(document, workspace.carving),
                .contextLayer = new ContextLayerPanel(document),
                .cameras = new CamerasPanel(document, workspace.cameras, workspace.placement),
                .brush = new BrushPanel(document, workspace.brush),
                .clipping = new ClippingPanel(document, workspace.cursor, workspace.planes, workspace.cameras),
                .series = new SeriesPanel(document, workspace.options),
                .tags = new TagsPanel(document, workspace.cursor, workspace.planes, workspace.options),
                .labelTable = new LabelTable(document, workspace.placement, workspace.cursor),
                .keyImages = new KeyImagesPanel(document, workspace.keyImages),
                .reformat = new ReformatPanel(
                    {document, workspace.path, workspace.pathCameras, workspace.pathOpening, workspace.options}),
                .heights = nullptr,
                .seriesDock = nullptr,
                .folding = nullptr};
  const auto add = [&window](const QString& title, const char* name, QWidget* panel) {
    return addDock(window, Qt::RightDockWidgetArea, title, name, panel);
  };
  window.setTabPosition(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea, QTabWidget::North);
  // One column of sections in the order of work: the structure, the opening, the look, the cameras.
  QDockWidget* focus = add(PanelsWords::tr("Focus"), "focusDock", panels.focus);
  auto* cutawayScroller = new ScrollingPanel;
  cutawayScroller->setBody(panels.cutaway);
  QDockWidget* cutaway = add(PanelsWords::tr("Cutaway"), "cutawayDock", cutawayScroller);
  window.tabifyDockWidget(cutaway, add(PanelsWords::tr("Context edges"), "contextLayerDock", panels.contextLayer));
  QDockWidget* clipping = add(PanelsWords::tr("Clipping"), "clippingDock", panels.clipping);
  window.tabifyDockWidget(cutaway, clipping);
  QObject::connect(clipping, &QDockWidget::visibilityChanged, &workspace.options, &ViewOptions::setClipHandles);
  QDockWidget* brush = add(PanelsWords::tr("Brush"), "brushDock", panels.brush);
  window.tabifyDockWidget(cutaway, brush);
  cutaway->raise();
  QObject::connect(&workspace.brush, &Brush::activeChanged, brush, [brush](bool active) {
    if (!active) return;
    brush->show();
    brush->raise();
  });
  QDockWidget* context = add(PanelsWords::tr("Context"), "contextDock", panels.appearance);
  QDockWidget* cameras = add(PanelsWords::tr("Cameras"), "camerasDock", panels.cameras);
  window.resizeDocks({focus}, {310}, Qt::Horizontal);
  addLists(window, panels);
  const QList<QDockWidget*> docks = window.findChildren<QDockWidget*>();
  panels.folding = new DockFolding(window, {docks.begin(), docks.end()});
  panels.heights = new DockHeights(window, *panels.folding, {focus, cutaway, context, cameras});
  QObject::connect(&workspace.brush, &Brush::activeChanged, brush, [brush, folding = panels.folding](bool active) {
    if (active) folding->setFolded(*brush, false);
  });
  return panels;
}

}  // namespace fenestra::viewer
