#include "viewer/Actions.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include "viewer/Dialogs.h"
#include "viewer/Exports.h"
#include "viewer/FileOpener.h"
#include "viewer/MeasureMenu.h"
#include "viewer/PictureExports.h"
#include "viewer/SegmentationMenu.h"
#include "viewer/Sessions.h"
#include "viewer/SettingsDialog.h"
#include "viewer/WindowLevelDialog.h"
#include "viewer/jobs/RegionGrower.h"
#include "viewer/model/Paths.h"
#include "viewer/model/WindowPresets.h"
#include "viewer/model/Workspace.h"
#include "viewer/panels/CutawayPanel.h"
#include "viewer/style/Style.h"
#include "viewer/views/ViewArea.h"

namespace fenestra::viewer {

Actions::Actions(const Targets& targets)
    : QObject(&targets.window), targets_(targets), viewCommands_(targets_.workspace, targets_.views) {
  makeFileMenu();
  makeEditMenu();
  makeViewMenu();
  makeWindowLevelMenu();
  makeMeasureMenu();
  makeFocusMenu();
  makeHelpMenu();

  QToolBar* bar = targets_.window.addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("tools"));
  bar->setMovable(false);
  bar->setIconSize({18, 18});
  for (const QList<QAction*>& group : tools_) {
    if (!bar->actions().isEmpty()) bar->addSeparator();
    bar->addActions(group);
  }
  for (QToolButton* button : bar->findChildren<QToolButton*>()) button->setFocusPolicy(Qt::TabFocus);
  connect(&targets_.workspace.document, &Document::volumeChanged, this, [this] {
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
  if (!keys.isEmpty())
    made->setToolTip(
        QStringLiteral("%1 (%2)").arg(QString(text).remove(QLatin1Char('&')), keys.toString(QKeySequence::NativeText)));
  connect(made, &QAction::toggled, this, std::move(does));
  return made;
}

QAction* Actions::preferenceToggle(const QString& text, const QKeySequence& keys, Preference which) {
  Preferences& preferences = targets_.workspace.preferences;
  QAction* made =
      toggle(text, keys, preferences.isOn(which), [&preferences, which](bool on) { preferences.set(which, on); });
  connect(&preferences, &Preferences::changed, made,
          [&preferences, made, which] { made->setChecked(preferences.isOn(which)); });
  return made;
}

void Actions::makeFileMenu() {
  QAction* folder =
      action(tr("Open &folder…"), QKeySequence(tr("Ctrl+Shift+O")), [this] { targets_.files.chooseFolder(); });
  folder->setIcon(icon("folder"));
  QAction* file = action(tr("&Open file…"), QKeySequence::Open, [this] { targets_.files.chooseFile(); });
  file->setIcon(icon("file"));
  QAction* labels =
      volumeAction(tr("Open &labels…"), QKeySequence(tr("Ctrl+L")), [this] { targets_.files.chooseLabels(); });
  labels->setIcon(icon("labels"));
  QAction* series = action(tr("Choose &series…"), {}, [this] { targets_.files.chooseSeries(); });
  series->setEnabled(false);
  connect(&targets_.workspace.document, &Document::volumeChanged, series,
          [this, series] { series->setEnabled(!targets_.workspace.document.study().otherSeries.empty()); });

  QAction* session = action(tr("Open s&ession…"), {}, [this] { targets_.sessions.choose(); });
  QAction* save = volumeAction(tr("&Save session"), QKeySequence::Save, [this] { targets_.sessions.save(); });
  save->setIcon(icon("save"));
  QAction* saveAs =
      volumeAction(tr("Save session &as…"), QKeySequence(tr("Ctrl+Shift+S")), [this] { targets_.sessions.saveAs(); });

  QMenu* menu = targets_.window.menuBar()->addMenu(tr("&File"));
  menu->addActions({folder, file, session});
  recent_ = menu->addMenu(tr("&Recent"));
  connect(recent_, &QMenu::aboutToShow, this, &Actions::fillRecentMenu);
  samples_ = menu->addMenu(tr("&Built-in phantoms"));
  samples_->menuAction()->setVisible(false);
  menu->addSeparator();
  menu->addActions({series, labels});
  addSegmentationMenu(*menu);
  menu->addSeparator();
  menu->addActions({save, saveAs});
  addExports(*menu);
  menu->addSeparator();
  menu->addAction(action(tr("&Quit"), QKeySequence::Quit, [this] { targets_.window.close(); }));
  tools_ << QList<QAction*>{folder, file, labels, save};
}

void Actions::addSegmentationMenu(QMenu& menu) {
  QMenu* segmentations = menu.addMenu(tr("Se&gmentations of this series"));
  segmentations->menuAction()->setVisible(false);
  connect(&targets_.workspace.document, &Document::volumeChanged, segmentations, [this, segmentations] {
    const auto& found = targets_.workspace.document.study().segmentations;
    fillSegmentationMenu(*segmentations, found, targets_.loader);
    segmentations->menuAction()->setVisible(!found.empty());
  });
}

void Actions::addExports(QMenu& menu) {
  Exports& exports = targets_.exports;
  PictureExports& pictures = targets_.pictures;
  QMenu* group = menu.addMenu(tr("E&xport"));
  group->addAction(
      volumeAction(tr("A &picture…"), QKeySequence(tr("Ctrl+E")), [&pictures] { pictures.choosePicture(); }));
  group->addAction(volumeAction(tr("A &turntable…"), {}, [&pictures] { pictures.chooseTurntable(); }));
  group->addSeparator();
  QAction* all = group->addAction(tr("All &labels…"));
  QAction* focus = group->addAction(tr("The &focus as labels…"));
  QAction* surface = group->addAction(tr("The focus as a &surface…"));
  QAction* measures = group->addAction(tr("&Measures as a table…"));
  measures->setObjectName(QStringLiteral("exportMeasures"));
  connect(measures, &QAction::triggered, this, [&exports] { exports.chooseMeasureFile(); });
  connect(all, &QAction::triggered, this, [&exports] { exports.chooseLabelFile(Exports::Labels::All); });
  connect(focus, &QAction::triggered, this, [&exports] { exports.chooseLabelFile(Exports::Labels::Focus); });
  connect(surface, &QAction::triggered, this, [&exports] { exports.chooseSurfaceFile(); });
  const auto enable = [&exports, all, focus, surface, measures] {
    measures->setEnabled(exports.canWriteMeasures());
    all->setEnabled(exports.canWriteLabels(Exports::Labels::All));
    focus->setEnabled(exports.canWriteLabels(Exports::Labels::Focus));
    surface->setEnabled(exports.canWriteSurface());
  };
  Document& document = targets_.workspace.document;
  connect(&document, &Document::volumeChanged, group, enable);
  connect(&document, &Document::labelsChanged, group, enable);
  connect(&document, &Document::focusChanged, group, enable);
  connect(&document, &Document::measuresChanged, group, enable);
  enable();
}

void Actions::makeEditMenu() {
  QUndoStack& steps = targets_.workspace.document.undoStack();
  QAction* undo = steps.createUndoAction(this, tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  undo->setIcon(icon("undo"));
  QAction* redo = steps.createRedoAction(this, tr("&Redo"));
  redo->setShortcut(QKeySequence(tr("Ctrl+Shift+Z")));
  redo->setIcon(icon("redo"));

  Brush& brush = targets_.workspace.brush;
  QAction* paint = volumeAction(tr("&Brush"), QKeySequence(tr("P")), [&brush] { brush.toggle(false); });
  paint->setIcon(icon("brush"));
  paint->setCheckable(true);
  connect(&brush, &Brush::changed, paint, [&brush, paint] { paint->setChecked(brush.isActive()); });
  QAction* opposite = volumeAction(tr("&Opposite brush"), QKeySequence(tr("E")), [&brush] { brush.toggle(true); });
  constexpr double step = 1.2;
  QAction* smaller =
      volumeAction(tr("&Smaller brush"), QKeySequence(tr("[")), [&brush] { brush.scaleRadius(1.0 / step); });
  QAction* larger = volumeAction(tr("&Larger brush"), QKeySequence(tr("]")), [&brush] { brush.scaleRadius(step); });

  QMenu* menu = targets_.window.menuBar()->addMenu(tr("&Edit"));
  menu->addActions({undo, redo});
  menu->addSeparator();
  PictureExports& pictures = targets_.pictures;
  menu->addAction(volumeAction(tr("&Copy picture"), QKeySequence::Copy, [&pictures] { pictures.copyPicture(); }));
  menu->addSeparator();
  menu->addActions({paint, opposite, smaller, larger});
  menu->addSeparator();
  menu->addAction(action(tr("Se&ttings…"), {},
                         [this] { SettingsDialog(targets_.workspace.preferences, &targets_.window).exec(); }));
  tools_ << QList<QAction*>{undo, redo, paint};
}

void Actions::makeViewMenu() {
  QMenu* menu = targets_.window.menuBar()->addMenu(tr("&View"));
  makeLookFromMenu(*menu);
  makeCameraEntries(*menu);
  menu->addMenu(makeAtRestMenu());
  menu->addSeparator();
  makeOverlayEntries(*menu);
  menu->addSeparator();
  menu->addAction(action(tr("All &views"), QKeySequence(tr("Esc")), [this] { stop(); }));
  menu->addAction(action(tr("F&ull screen"), QKeySequence(tr("F11")), [this] {
    targets_.window.setWindowState(targets_.window.windowState() ^ Qt::WindowFullScreen);
  }));
  menu->addSeparator();
  for (QDockWidget* dock : targets_.window.findChildren<QDockWidget*>()) menu->addAction(dock->toggleViewAction());
  menu->addAction(action(tr("Reset la&yout"), {}, [this] { targets_.resetLayout(); }));
  menu->addAction(preferenceToggle(tr("Li&ght theme"), {}, Preference::LightTheme));
}

void Actions::makeLookFromMenu(QMenu& menu) {
  struct Side {
    const char *letter, *name;
    StandardView view;
  };
  QList<QAction*> sides;
  for (const Side& side :
       {Side{"A", QT_TR_NOOP("Anterior"), StandardView::Anterior},
        Side{"P", QT_TR_NOOP("Posterior"), StandardView::Posterior}, Side{"L", QT_TR_NOOP("Left"), StandardView::Left},
        Side{"R", QT_TR_NOOP("Right"), StandardView::Right}, Side{"S", QT_TR_NOOP("Superior"), StandardView::Superior},
        Side{"I", QT_TR_NOOP("Inferior"), StandardView::Inferior}}) {
    QAction* made =
        volumeAction(tr(side.name), QKeySequence(QStringLiteral("Shift+%1").arg(QLatin1String(side.letter))),
                     [this, which = side.view] { viewCommands_.face(which); });
    made->setIconText(QLatin1String(side.letter));
    sides << made;
  }
  menu.addMenu(tr("&Look from"))->addActions(sides);
  tools_ << sides;
}

void Actions::makeCameraEntries(QMenu& menu) {
  ViewLink& cameras = targets_.workspace.cameras;
  PlacementController& placement = targets_.workspace.placement;
  QAction* place = action(tr("P&lace cameras"), QKeySequence(tr("F5")), [&placement] { placement.place(); });
  place->setIcon(icon("place"));
  const auto enablePlace = [&placement, place] { place->setEnabled(placement.canPlace()); };
  connect(&placement, &PlacementController::changed, place, enablePlace);
  enablePlace();
  QAction* reset = volumeAction(tr("&Reset view"), QKeySequence(tr("R")), [this] { viewCommands_.resetActiveView(); });
  reset->setIcon(icon("reset"));
  QAction* resetAll =
      volumeAction(tr("Reset &all views"), QKeySequence(tr("Ctrl+R")), [this] { viewCommands_.resetAllViews(); });

  QAction* link = toggle(tr("&Link the 3-D views"), QKeySequence(tr("L")), cameras.isLinked(),
                         [&cameras](bool on) { cameras.setLinked(on); });
  link->setIcon(icon("link"));
  link->setObjectName(QStringLiteral("link"));
  connect(&cameras, &ViewLink::linkedChanged, link, &QAction::setChecked);
  QAction* parallel = toggle(tr("&Parallel projection"), QKeySequence(tr("Ctrl+P")), false, [&cameras](bool on) {
    cameras.setProjection(on ? Projection::Orthographic : Projection::Perspective);
  });
  parallel->setIcon(icon("parallel"));
  const auto showProjection = [&cameras, parallel] {
    parallel->setChecked(cameras.projection() == Projection::Orthographic);
  };
  connect(&targets_.workspace.document, &Document::volumeChanged, parallel, showProjection);
  connect(&cameras, &ViewLink::projectionChanged, parallel, showProjection);

  menu.addActions({place, reset, resetAll});
  menu.addSeparator();
  menu.addAction(makeFreezeEntry());
  QAction* animated = preferenceToggle(tr("&Animate the cameras"), {}, Preference::AnimatedCameras);
  animated->setObjectName(QStringLiteral("animated"));
  menu.addActions({link, parallel, animated});
  tools_.back() << reset << place;
  tools_ << QList<QAction*>{link, parallel};
}

QAction* Actions::makeFreezeEntry() {
  ViewLink& cameras = targets_.workspace.cameras;
  QAction* freeze = volumeAction(tr("&Freeze the opening"), QKeySequence(tr("F")),
                                 [this, &cameras] { viewCommands_.freeze(!cameras.isFrozen()); });
  freeze->setObjectName(QStringLiteral("freeze"));
  freeze->setIconText(tr("Freeze"));
  freeze->setCheckable(true);
  freeze->setToolTip(tr("Keeps the opening where it is while the cameras move, so that they look into it (%1)")
                         .arg(freeze->shortcut().toString(QKeySequence::NativeText)));
  connect(&cameras, &ViewLink::frozenChanged, freeze, [&cameras, freeze] { freeze->setChecked(cameras.isFrozen()); });
  targets_.cutaway.addFreeze(freeze);
  return freeze;
}

void Actions::makeOverlayEntries(QMenu& menu) {
  ViewOptions& options = targets_.workspace.options;
  QAction* crosshair = toggle(tr("&Crosshair"), QKeySequence(tr("C")), options.crosshair(),
                              [&options](bool on) { options.setCrosshair(on); });
  crosshair->setIcon(icon("crosshair"));
  QAction* labels = toggle(tr("Label &overlay"), QKeySequence(tr("O")), options.labels(),
                           [&options](bool on) { options.setLabels(on); });
  labels->setIcon(icon("overlay"));
  QAction* text =
      toggle(tr("Corner &text"), QKeySequence(tr("T")), options.text(), [&options](bool on) { options.setText(on); });
  text->setIcon(icon("text"));
  QAction* patient = preferenceToggle(tr("&Hide the patient"), QKeySequence(tr("H")), Preference::HidesPatient);
  connect(&options, &ViewOptions::changed, this, [&options, crosshair, labels, text] {
    crosshair->setChecked(options.crosshair());
    labels->setChecked(options.labels());
    text->setChecked(options.text());
  });
  menu.addActions({crosshair, labels, text, patient});
  tools_ << QList<QAction*>{crosshair, labels, text};
}

QMenu* Actions::makeAtRestMenu() {
  auto* menu = new QMenu(tr("&Quality at rest"), &targets_.window);
  menu->setToolTipsVisible(true);
  auto* group = new QActionGroup(this);
  group->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
  for (const Effort& effort : {Effort{.quality = Quality::Draft}, Effort{}, Effort{.maxError = 4.0},
                               Effort{.maxError = 2.0}, Effort{.maxError = 1.0}, Effort{.quality = Quality::High}}) {
    QString name = nameOf(effort);
    name[0] = name[0].toUpper();
    QAction* made = menu->addAction(name);
    if (effort.quality == Quality::High || effort.maxError)
      made->setToolTip(tr("Bound on the error that sampling leaves in a pixel's colour"));
    made->setCheckable(true);
    group->addAction(made);
    const auto show = [this, made, effort] { made->setChecked(targets_.views.atRest() == effort); };
    // Choosing the entry again must not uncheck it.
    connect(made, &QAction::triggered, this, [this, effort, show] {
      targets_.views.setAtRest(effort.quality, effort.maxError);
      targets_.workspace.preferences.setAtRest(effort);
      show();
    });
    connect(&targets_.views, &ViewArea::atRestChanged, made, show);
    show();
  }
  return menu;
}

void Actions::makeWindowLevelMenu() {
  Document& document = targets_.workspace.document;
  QMenu* menu = targets_.window.menuBar()->addMenu(tr("&Window/level"));
  menu->addAction(volumeAction(tr("Of the data"), QKeySequence(tr("1")), [&document] { document.resetWindow(); }));
  for (const WindowPreset& preset : ctWindowPresets)
    menu->addAction(volumeAction(
        tr("CT %1  (%2 / %3)").arg(tr(preset.name)).arg(preset.window.width).arg(preset.window.level),
        QKeySequence(QString::number(preset.key)), [&document, &preset] { document.setWindow(preset.window); }));
  menu->addSeparator();
  menu->addAction(volumeAction(tr("By &number…"), QKeySequence(tr("W")), [this, &document] {
    auto* dialog = new WindowLevelDialog(document, &targets_.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
  }));
  QAction* inverted =
      toggle(tr("&Invert"), QKeySequence(tr("I")), false, [&document](bool on) { document.setInverted(on); });
  connect(&document, &Document::windowChanged, inverted,
          [&document, inverted] { inverted->setChecked(document.isInverted()); });
  menu->addAction(inverted);
}

void Actions::makeMeasureMenu() {
  Document& document = targets_.workspace.document;
  MeasureMode& mode = targets_.workspace.measuring;
  ViewOptions& options = targets_.workspace.options;
  struct Tool {
    const char *text, *key, *icon;
    MeasureKind kind;
  };
  QList<QAction*> tools;
  for (const Tool& tool : {Tool{QT_TR_NOOP("&Distance"), "D", "distance", MeasureKind::Distance},
                           Tool{QT_TR_NOOP("&Angle"), "A", "angle", MeasureKind::Angle},
                           Tool{QT_TR_NOOP("&Ellipse"), "Q", "ellipse", MeasureKind::Ellipse},
                           Tool{QT_TR_NOOP("&Rectangle"), "B", "rectangle", MeasureKind::Rectangle}}) {
    QAction* made =
        volumeAction(tr(tool.text), QKeySequence(QLatin1String(tool.key)), [&mode, &options, kind = tool.kind] {
          options.setMeasures(true);  // or what is drawn would not show
          mode.toggle(kind);
        });
    made->setIcon(icon(tool.icon));
    made->setCheckable(true);
    connect(&mode, &MeasureMode::changed, made,
            [&mode, made, kind = tool.kind] { made->setChecked(mode.kind() == kind); });
    tools << made;
  }
  QAction* copy = action(tr("&Copy"), QKeySequence(tr("Ctrl+Shift+C")),
                         [this, &mode] { copyMeasures(targets_.workspace, mode.selected()); });
  QAction* remove = action(tr("De&lete"), QKeySequence::Delete, [&mode] { mode.removeSelected(); });
  QAction* removeAll = action(tr("Delete a&ll"), {}, [&mode] { mode.removeAll(); });
  const auto enable = [&document, &mode, copy, remove, removeAll] {
    copy->setEnabled(!document.measures().empty());
    remove->setEnabled(mode.selected().has_value());
    removeAll->setEnabled(!document.measures().empty());
  };
  connect(&document, &Document::measuresChanged, this, enable);
  connect(&mode, &MeasureMode::changed, this, enable);
  enable();

  QMenu* menu = targets_.window.menuBar()->addMenu(tr("&Measure"));
  menu->addActions(tools);
  menu->addSeparator();
  menu->addActions({copy, remove, removeAll});
  menu->addSeparator();
  QAction* shown =
      toggle(tr("&Show measures"), {}, options.measures(), [&options](bool on) { options.setMeasures(on); });
  shown->setObjectName(QStringLiteral("showMeasures"));
  connect(&options, &ViewOptions::changed, shown, [&options, shown] { shown->setChecked(options.measures()); });
  menu->addAction(shown);
  tools_ << tools;
}

void Actions::makeFocusMenu() {
  QMenu* menu = targets_.window.menuBar()->addMenu(tr("F&ocus"));
  addRegionEntries(*menu);
  menu->addSeparator();
  menu->addAction(volumeAction(tr("&No focus"), QKeySequence(tr("Ctrl+Backspace")),
                               [this] { targets_.workspace.document.setFocus(std::monostate{}); }));
}

void Actions::addRegionEntries(QMenu& menu) {
  Document& document = targets_.workspace.document;
  ViewOptions& options = targets_.workspace.options;
  QAction* grows = toggle(tr("&Click grows a region"), QKeySequence(tr("G")), options.grows(),
                          [&options](bool on) { options.setGrows(on); });
  grows->setIcon(icon("grow"));
  connect(&options, &ViewOptions::changed, grows, [&options, grows] { grows->setChecked(options.grows()); });
  QAction* less = action(tr("&Lower tolerance"), QKeySequence(tr(",")), [&document] { document.moveTolerance(-1); });
  QAction* more = action(tr("&Higher tolerance"), QKeySequence(tr(".")), [&document] { document.moveTolerance(1); });
  const auto enable = [&document, less, more] {
    less->setEnabled(document.growth());
    more->setEnabled(document.growth());
  };
  connect(&document, &Document::focusChanged, this, enable);
  enable();
  menu.addActions({grows, less, more});
  tools_ << QList<QAction*>{grows};
}

void Actions::makeHelpMenu() {
  QMenu* menu = targets_.window.menuBar()->addMenu(tr("&Help"));
  menu->addAction(action(tr("&Keys and mouse"), QKeySequence(tr("?")),
                         [this] { showKeys(*targets_.window.menuBar(), &targets_.window); }));
  menu->addAction(action(tr("&About Fenestra"), {},
                         [this] { showAbout(targets_.gl, targets_.views.schedule(), &targets_.window); }));
}

void Actions::addSample(const QString& name, StudyLoader::Reader read) {
  samples_->menuAction()->setVisible(true);
  connect(samples_->addAction(name), &QAction::triggered, this, [this, read = std::move(read)] {
    if (targets_.sessions.mayGo()) targets_.loader.open(read);
  });
}

void Actions::stop() {
  if (targets_.loader.job().isRunning())
    targets_.loader.job().cancel();
  else if (targets_.pictures.isBusy())
    targets_.pictures.cancel();
  else if (targets_.grower.isGrowing())
    targets_.grower.cancel();
  else if (targets_.workspace.placement.isBusy())
    targets_.workspace.placement.cancel();
  else if (targets_.workspace.brush.isActive())
    targets_.workspace.brush.setActive(false);
  else if (!targets_.workspace.measuring.stop())
    targets_.views.showAll();
}

void Actions::fillRecentMenu() {
  recent_->clear();
  for (const std::filesystem::path& path : targets_.workspace.preferences.recent()) {
    // A folder or file is often named after its patient.
    QAction* entry = recent_->addAction(targets_.workspace.options.hidesPatient()
                                            ? tr("%1, name hidden").arg(recent_->actions().size() + 1)
                                            : QDir::toNativeSeparators(toQString(path)));
    connect(entry, &QAction::triggered, this, [this, path] { targets_.files.open({path}); });
  }
  if (recent_->isEmpty()) {
    recent_->addAction(tr("Nothing yet"))->setEnabled(false);
    return;
  }
  recent_->addSeparator();
  connect(recent_->addAction(tr("Forget these")), &QAction::triggered, this,
          [this] { targets_.workspace.preferences.clearRecent(); });
}

}  // namespace fenestra::viewer
