// What changes the study and how it is read: the menus Edit, Window/level, Measure and Focus.

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>

#include "viewer/actions/Actions.h"
#include "viewer/actions/MeasureMenu.h"
#include "viewer/archive/ArchiveDock.h"
#include "viewer/archive/CacheRow.h"
#include "viewer/dialogs/KeysDialog.h"
#include "viewer/dialogs/SettingsDialog.h"
#include "viewer/dialogs/WindowLevelDialog.h"
#include "viewer/exports/PictureExports.h"
#include "viewer/model/Workspace.h"
#include "viewer/panels/ReformatPanel.h"
#include "viewer/style/Style.h"

namespace fenestra::viewer {

void Actions::makeEditMenu() {
  QUndoStack& steps = targets_.workspace.document.undoStack();
  QAction* undo = steps.createUndoAction(this, tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  undo->setIcon(icon("undo"));
  QAction* redo = steps.createRedoAction(this, tr("&Redo"));
  redo->setShortcut(QKeySequence(tr("Ctrl+Shift+Z")));
  addKey(*redo, QKeySequence(tr("Ctrl+Y")));
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
  QAction* keys = action(tr("Change &keys…"), {}, [this] { KeysDialog(*keys_, &targets_.window).exec(); });
  keys->setObjectName(QStringLiteral("changeKeys"));
  menu->addAction(keys);
  menu->addAction(action(tr("Se&ttings…"), {}, [this] { showSettings(); }));
  menu->actions().constLast()->setObjectName(QStringLiteral("settings"));
  tools_ << QList<QAction*>{undo, redo, paint};
}

void Actions::showSettings() {
  SettingsDialog dialog(targets_.workspace.preferences, &targets_.window);
  dialog.addRow(tr("They are kept in"), new CacheRow(targets_.archive.archives(), targets_.archive.retrievals()));
  dialog.exec();
}

void Actions::makeWindowLevelMenu() {
  Document& document = targets_.workspace.document;
  QMenu* menu = targets_.window.menuBar()->addMenu(tr("&Window/level"));
  menu->addAction(volumeAction(tr("Of the data"), QKeySequence(tr("1")), [&document] { document.resetWindow(); }));
  addWindowPresets(*menu);
  menu->addSeparator();
  addOwnWindows(*menu);
  menu->addSeparator();
  menu->addAction(volumeAction(tr("By &number…"), QKeySequence(tr("W")), [this, &document] {
    for (auto* open : targets_.window.findChildren<WindowLevelDialog*>())
      if (open->isVisible()) {
        open->raise();
        return open->activateWindow();
      }
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
  struct Entry {
    const char *text, *key, *icon;
    MeasureKind kind;
  };
  QList<QAction*> tools;
  for (const Entry& tool : {Entry{QT_TR_NOOP("&Distance"), "D", "distance", MeasureKind::Distance},
                            Entry{QT_TR_NOOP("&Angle"), "A", "angle", MeasureKind::Angle},
                            Entry{QT_TR_NOOP("&Ellipse"), "Q", "ellipse", MeasureKind::Ellipse},
                            Entry{QT_TR_NOOP("&Rectangle"), "B", "rectangle", MeasureKind::Rectangle},
                            Entry{QT_TR_NOOP("Arro&w"), "Shift+D", "arrow", MeasureKind::Arrow},
                            Entry{QT_TR_NOOP("&Text"), "Shift+T", "mark", MeasureKind::Text}}) {
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
  QAction* change = action(tr("Change te&xt…"), {}, [this, &mode] {
    if (mode.selected()) askForMarkText(targets_.workspace, mode.selected(), &targets_.window);
  });
  change->setObjectName(QStringLiteral("changeMarkText"));
  QAction* copy = action(tr("&Copy"), QKeySequence(tr("Ctrl+Shift+C")),
                         [this, &mode] { copyMeasures(targets_.workspace, mode.selected()); });
  QAction* remove = action(tr("De&lete"), QKeySequence::Delete, [&mode] { mode.removeSelected(); });
  QAction* removeAll = action(tr("Delete all"), {}, [&mode] { mode.removeAll(); });
  removeAll->setObjectName(QStringLiteral("deleteMeasures"));
  const auto enable = [&document, &mode, change, copy, remove, removeAll] {
    change->setEnabled(mode.selected() && isMark(document.measures().at(*mode.selected()).kind));
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
  menu->addActions({change, copy, remove, removeAll});
  menu->addSeparator();
  addPathEntries(*menu);
  menu->addSeparator();
  QAction* shown =
      toggle(tr("&Show measures"), {}, options.measures(), [&options](bool on) { options.setMeasures(on); });
  shown->setObjectName(QStringLiteral("showMeasures"));
  connect(&options, &ViewOptions::changed, shown, [&options, shown] { shown->setChecked(options.measures()); });
  menu->addAction(shown);
  tools_ << tools.first(4);  // marks are in the menu alone, so that the toolbar fits small screens
}

void Actions::addPathEntries(QMenu& menu) {
  PathMode& path = targets_.workspace.path;
  ViewOptions& options = targets_.workspace.options;
  auto* dock = targets_.window.findChild<QDockWidget*>(QStringLiteral("reformatDock"));
  const auto showDock = [dock] {
    // As by its own entry, which also gives it the room that it needs.
    if (!dock->isVisible()) dock->toggleViewAction()->trigger();
    dock->raise();
  };
  QAction* draw = volumeAction(tr("Draw a &path"), QKeySequence(tr("S")), [&path, &options, showDock] {
    options.setMeasures(true);  // or what is drawn would not show
    showDock();
    path.toggle();
  });
  draw->setCheckable(true);
  connect(&path, &PathMode::changed, draw, [&path, draw] { draw->setChecked(path.isDrawing()); });
  QAction* follow = volumeAction(tr("Path along the &focus"), {}, [this, &options, showDock] {
    options.setMeasures(true);
    showDock();
    targets_.window.findChild<ReformatPanel*>()->followFocus();
  });
  follow->setObjectName(QStringLiteral("followFocus"));
  menu.addActions({draw, follow});
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
  QAction* grows = toggle(tr("&Click chooses the focus"), QKeySequence(tr("G")), options.grows(),
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

}  // namespace fenestra::viewer
