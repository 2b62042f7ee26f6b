#include "viewer/Actions.h"

#include <QAction>
#include <QActionGroup>
#include <QDir>
#include <QDockWidget>
#include <QMenuBar>
#include <QToolBar>

#include "viewer/Dialogs.h"
#include "viewer/MainWindow.h"
#include "viewer/Sessions.h"
#include "viewer/Style.h"
#include "viewer/model/Paths.h"
#include "viewer/model/WindowPresets.h"

namespace fenestra::viewer {

Actions::Actions(MainWindow& window) : QObject(&window), window_(window) {
  makeFileMenu();
  makeEditMenu();
  makeViewMenu();
  makeWindowLevelMenu();
  makeFocusMenu();
  makeHelpMenu();

  QToolBar* bar = window.addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("tools"));
  bar->setMovable(false);
  bar->setIconSize({18, 18});
  for (const QList<QAction*>& group : tools_) {
    if (!bar->actions().isEmpty()) bar->addSeparator();
    bar->addActions(group);
  }
  connect(&window.document(), &Document::volumeChanged, this, [this] {
    for (QAction* each : needVolume_) each->setEnabled(true);
  });
}

QAction* Actions::action(const QString& text, const QKeySequence& keys, std::function<void()> does) {
  auto* made = new QAction(text, this);
  if (!keys.isEmpty()) {
    made->setShortcut(keys);
    made->setToolTip(QStringLiteral("%1 (%2)").arg(QString(text).remove(QLatin1Char('&')).remove(QStringLiteral("…")),
                                                   keys.toString(QKeySequence::NativeText)));
  }
  connect(made, &QAction::triggered, this, std::move(does));
  return made;
}

QAction* Actions::volumeAction(const QString& text, const QKeySequence& keys, std::function<void()> does) {
  QAction* made = action(text, keys, std::move(does));
  made->setEnabled(false);
  needVolume_ << made;
  return made;
}

QAction* Actions::toggle(const QString& text, const QKeySequence& keys, bool on, std::function<void(bool)> does) {
  auto* made = new QAction(text, this);
  made->setCheckable(true);
  made->setChecked(on);
  made->setShortcut(keys);
  made->setToolTip(
      QStringLiteral("%1 (%2)").arg(QString(text).remove(QLatin1Char('&')), keys.toString(QKeySequence::NativeText)));
  connect(made, &QAction::toggled, this, std::move(does));
  return made;
}

void Actions::makeFileMenu() {
  QAction* folder = action(tr("Open &folder…"), QKeySequence(tr("Ctrl+Shift+O")), [this] { window_.chooseFolder(); });
  folder->setIcon(icon("folder"));
  QAction* file = action(tr("&Open file…"), QKeySequence::Open, [this] { window_.chooseFile(); });
  file->setIcon(icon("file"));
  QAction* labels = volumeAction(tr("Open &labels…"), QKeySequence(tr("Ctrl+L")), [this] { window_.chooseLabels(); });
  labels->setIcon(icon("labels"));
  QAction* series = action(tr("Choose &series…"), {}, [this] { window_.chooseSeries(); });
  series->setEnabled(false);
  connect(&window_.document(), &Document::volumeChanged, series,
          [this, series] { series->setEnabled(!window_.document().study().otherSeries.empty()); });

  QAction* session = action(tr("Open s&ession…"), {}, [this] { window_.sessions().choose(); });
  QAction* save = volumeAction(tr("&Save session"), QKeySequence::Save, [this] { window_.sessions().save(); });
  save->setIcon(icon("save"));
  QAction* saveAs =
      volumeAction(tr("Save session &as…"), QKeySequence(tr("Ctrl+Shift+S")), [this] { window_.sessions().saveAs(); });

  QMenu* menu = window_.menuBar()->addMenu(tr("&File"));
  menu->addActions({folder, file, session});
  recent_ = menu->addMenu(tr("&Recent"));
  connect(recent_, &QMenu::aboutToShow, this, &Actions::fillRecentMenu);
  samples_ = menu->addMenu(tr("&Built-in phantoms"));
  samples_->menuAction()->setVisible(false);
  menu->addSeparator();
  menu->addActions({series, labels});
  menu->addSeparator();
  menu->addActions({save, saveAs});
  menu->addSeparator();
  menu->addAction(action(tr("&Quit"), QKeySequence::Quit, [this] { window_.close(); }));
  tools_ << QList<QAction*>{folder, file, labels, save};
}

void Actions::makeEditMenu() {
  QUndoStack& steps = window_.document().undoStack();
  QAction* undo = steps.createUndoAction(this, tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  undo->setIcon(icon("undo"));
  QAction* redo = steps.createRedoAction(this, tr("&Redo"));
  redo->setShortcut(QKeySequence(tr("Ctrl+Shift+Z")));
  redo->setIcon(icon("redo"));

  Brush& brush = window_.brush();
  QAction* paint = volumeAction(tr("&Brush"), QKeySequence(tr("P")), [&brush] { brush.toggle(false); });
  paint->setIcon(icon("brush"));
  paint->setCheckable(true);
  connect(&brush, &Brush::changed, paint, [&brush, paint] { paint->setChecked(brush.isActive()); });
  QAction* otherWay = volumeAction(tr("Brush the &other way"), QKeySequence(tr("E")), [&brush] { brush.toggle(true); });
  constexpr double step = 1.2;
  QAction* smaller =
      volumeAction(tr("&Smaller brush"), QKeySequence(tr("[")), [&brush] { brush.scaleRadius(1.0 / step); });
  QAction* larger = volumeAction(tr("&Larger brush"), QKeySequence(tr("]")), [&brush] { brush.scaleRadius(step); });

  QMenu* menu = window_.menuBar()->addMenu(tr("&Edit"));
  menu->addActions({undo, redo});
  menu->addSeparator();
  menu->addActions({paint, otherWay, smaller, larger});
  tools_ << QList<QAction*>{undo, redo, paint};
}

void Actions::makeViewMenu() {
  Document& document = window_.document();
  ViewLink& cameras = window_.cameras();
  PlacementController& placement = window_.placement();
  ViewOptions& options = window_.options();

  QAction* reset = volumeAction(tr("&Reset view"), QKeySequence(tr("R")), [this] { window_.resetActiveView(); });
  reset->setIcon(icon("reset"));
  QAction* resetAll =
      volumeAction(tr("Reset &all views"), QKeySequence(tr("Ctrl+R")), [this] { window_.resetAllViews(); });
  QAction* link = toggle(tr("&Link the 3-D views"), QKeySequence(tr("L")), cameras.isLinked(),
                         [&cameras](bool on) { cameras.setLinked(on); });
  link->setIcon(icon("link"));
  link->setObjectName(QStringLiteral("link"));
  connect(&cameras, &ViewLink::linkedChanged, link, &QAction::setChecked);
  QAction* parallel = toggle(tr("&Parallel projection"), QKeySequence(tr("Ctrl+P")), false, [&cameras](bool on) {
    cameras.setProjection(on ? Projection::Orthographic : Projection::Perspective);
  });
  parallel->setIcon(icon("parallel"));
  connect(&document, &Document::volumeChanged, parallel,
          [&cameras, parallel] { parallel->setChecked(cameras.projection() == Projection::Orthographic); });
  connect(&cameras, &ViewLink::projectionChanged, parallel,
          [parallel](Projection now) { parallel->setChecked(now == Projection::Orthographic); });
  QAction* crosshair = toggle(tr("&Crosshair"), QKeySequence(tr("C")), options.crosshair(),
                              [&options](bool on) { options.setCrosshair(on); });
  crosshair->setIcon(icon("crosshair"));
  QAction* overlay = toggle(tr("Label &overlay"), QKeySequence(tr("O")), options.labels(),
                            [&options](bool on) { options.setLabels(on); });
  overlay->setIcon(icon("overlay"));
  QAction* text =
      toggle(tr("Corner &text"), QKeySequence(tr("T")), options.text(), [&options](bool on) { options.setText(on); });
  text->setIcon(icon("text"));
  connect(&options, &ViewOptions::changed, this, [&options, crosshair, overlay, text] {
    crosshair->setChecked(options.crosshair());
    overlay->setChecked(options.labels());
    text->setChecked(options.text());
  });

  QMenu* menu = window_.menuBar()->addMenu(tr("&View"));
  QMenu* sides = menu->addMenu(tr("&Look from"));
  struct Side {
    const char *letter, *name;
    StandardView view;
  };
  QList<QAction*> sideActions;
  for (const Side& side :
       {Side{"A", QT_TR_NOOP("Anterior"), StandardView::Anterior},
        Side{"P", QT_TR_NOOP("Posterior"), StandardView::Posterior}, Side{"L", QT_TR_NOOP("Left"), StandardView::Left},
        Side{"R", QT_TR_NOOP("Right"), StandardView::Right}, Side{"S", QT_TR_NOOP("Superior"), StandardView::Superior},
        Side{"I", QT_TR_NOOP("Inferior"), StandardView::Inferior}}) {
    QAction* made =
        volumeAction(tr(side.name), QKeySequence(QStringLiteral("Shift+%1").arg(QLatin1String(side.letter))),
                     [this, which = side.view] { window_.face(which); });
    made->setIconText(QLatin1String(side.letter));
    sideActions << made;
  }
  sides->addActions(sideActions);
  QAction* place = action(tr("P&lace cameras"), QKeySequence(tr("F5")), [&placement] { placement.place(); });
  place->setIcon(icon("place"));
  const auto enablePlace = [&placement, place] { place->setEnabled(placement.canPlace()); };
  connect(&placement, &PlacementController::changed, place, enablePlace);
  enablePlace();
  menu->addAction(place);
  menu->addActions({reset, resetAll});
  menu->addSeparator();
  menu->addActions({link, parallel});
  menu->addMenu(makeAtRestMenu());
  menu->addSeparator();
  menu->addActions({crosshair, overlay, text});
  menu->addSeparator();
  menu->addAction(action(tr("All &views"), QKeySequence(tr("Esc")), [this] { window_.stop(); }));
  menu->addAction(action(tr("F&ull screen"), QKeySequence(tr("F11")),
                         [this] { window_.setWindowState(window_.windowState() ^ Qt::WindowFullScreen); }));
  menu->addSeparator();
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) menu->addAction(dock->toggleViewAction());

  tools_ << sideActions + QList<QAction*>{reset, place};
  tools_ << QList<QAction*>{link, parallel};
  tools_ << QList<QAction*>{crosshair, overlay, text};
}

QMenu* Actions::makeAtRestMenu() {
  auto* menu = new QMenu(tr("&Quality at rest"), &window_);
  menu->setToolTipsVisible(true);
  auto* group = new QActionGroup(this);
  group->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
  for (const Effort& effort : {Effort{.quality = Quality::Draft}, Effort{}, Effort{.maxError = 4.0},
                               Effort{.maxError = 2.0}, Effort{.maxError = 1.0}, Effort{.quality = Quality::High}}) {
    QString name = nameOf(effort);
    name[0] = name[0].toUpper();
    QAction* made = menu->addAction(name);
    if (effort.quality == Quality::High || effort.maxError)
      made->setToolTip(tr("The greatest error of a pixel's colour that sampling may leave"));
    made->setCheckable(true);
    group->addAction(made);
    const auto show = [this, made, effort] { made->setChecked(window_.views().atRest() == effort); };
    // Chosen again, the entry stays chosen.
    connect(made, &QAction::triggered, this, [this, effort, show] {
      window_.setAtRest(effort);
      show();
    });
    connect(&window_.views(), &ViewArea::atRestChanged, made, show);
    show();
  }
  return menu;
}

void Actions::makeWindowLevelMenu() {
  Document& document = window_.document();
  QMenu* menu = window_.menuBar()->addMenu(tr("&Window/level"));
  menu->addAction(volumeAction(tr("Of the data"), QKeySequence(tr("1")), [&document] { document.resetWindow(); }));
  for (const WindowPreset& preset : ctWindowPresets)
    menu->addAction(volumeAction(
        tr("CT %1  (%2 / %3)").arg(tr(preset.name)).arg(preset.window.width).arg(preset.window.level),
        QKeySequence(QString::number(preset.key)), [&document, &preset] { document.setWindow(preset.window); }));
}

void Actions::makeFocusMenu() {
  QMenu* menu = window_.menuBar()->addMenu(tr("F&ocus"));
  menu->addAction(volumeAction(tr("&No focus"), QKeySequence(tr("Ctrl+Backspace")),
                               [this] { window_.document().setFocus(std::monostate{}); }));
}

void Actions::makeHelpMenu() {
  QMenu* menu = window_.menuBar()->addMenu(tr("&Help"));
  menu->addAction(action(tr("&Keys and mouse"), QKeySequence(tr("?")), [this] { showKeys(&window_); }));
  menu->addAction(action(tr("&About Fenestra"), {}, [this] { showAbout(window_.gl(), &window_); }));
}

void Actions::addSample(const QString& name, std::function<void()> open) {
  samples_->menuAction()->setVisible(true);
  connect(samples_->addAction(name), &QAction::triggered, this, std::move(open));
}

void Actions::fillRecentMenu() {
  recent_->clear();
  for (const std::filesystem::path& path : window_.preferences().recent()) {
    QAction* entry = recent_->addAction(QDir::toNativeSeparators(toQString(path)));
    connect(entry, &QAction::triggered, this, [this, path] { window_.open({path}); });
  }
  if (recent_->isEmpty()) {
    recent_->addAction(tr("Nothing yet"))->setEnabled(false);
    return;
  }
  recent_->addSeparator();
  connect(recent_->addAction(tr("Forget these")), &QAction::triggered, this,
          [this] { window_.preferences().clearRecent(); });
}

}  // namespace fenestra::viewer
