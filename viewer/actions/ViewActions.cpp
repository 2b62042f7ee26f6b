// The View menu: cameras, quality, what is drawn over the pictures, panels.

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>

#include "viewer/actions/Actions.h"
#include "viewer/actions/PlaneMenu.h"
#include "viewer/exports/Verification.h"
#include "viewer/model/Workspace.h"
#include "viewer/panels/CutawayPanel.h"
#include "viewer/style/Style.h"
#include "viewer/views/ViewArea.h"

namespace fenestra::viewer {

void Actions::makeViewMenu() {
  QMenu* menu = targets_.window.menuBar()->addMenu(tr("&View"));
  makeLookFromMenu(*menu);
  makeCameraEntries(*menu);
  menu->addMenu(makeAtRestMenu());
  QAction* verify = volumeAction(tr("V&erify this picture…"), {}, [this] { targets_.verification.start(); });
  verify->setObjectName(QStringLiteral("verify"));
  verify->setToolTip(
      tr("Computes pixels drawn at random again, in double precision, and states how exact the picture is"));
  menu->addAction(verify);
  menu->addSeparator();
  makeOverlayEntries(*menu);
  QMenu* slices = makeSlicesMenu();
  addSlicePictures(*slices);
  menu->addMenu(slices);
  menu->addSeparator();
  makeLayoutMenu(*menu);
  makeCompareMenu(*menu);
  menu->addAction(action(tr("All &views"), QKeySequence(tr("Esc")), [this] { stop(); }));
  menu->addAction(
      volumeAction(tr("Keep a key image"), QKeySequence(tr("Ctrl+D")), [this] { targets_.keepKeyImage(); }));
  menu->addAction(action(tr("Full screen"), QKeySequence(tr("F11")), [this] {
    targets_.window.setWindowState(targets_.window.windowState() ^ Qt::WindowFullScreen);
  }));
  menu->addSeparator();
  for (QDockWidget* dock : targets_.window.findChildren<QDockWidget*>()) {
    dock->toggleViewAction()->setObjectName(dock->objectName() + QStringLiteral("Shown"));
    menu->addAction(dock->toggleViewAction());
  }
  menu->addAction(action(tr("Reset la&yout"), {}, [this] { targets_.resetLayout(); }));
  menu->actions().constLast()->setObjectName(QStringLiteral("resetLayout"));
  menu->addAction(preferenceToggle(tr("Li&ght theme"), {}, Preference::LightTheme));
  menu->actions().constLast()->setObjectName(QStringLiteral("lightTheme"));
}

void Actions::makeLookFromMenu(QMenu& menu) {
  struct Side {
    const char *letter, *name;
    StandardView view;
    const char* numpad;  ///< as in Blender: 1 the front, 3 a side, 7 the top, with Ctrl the opposite one
  };
  QList<QAction*> sides;
  for (const Side& side : {Side{"A", QT_TR_NOOP("Anterior"), StandardView::Anterior, "Num+1"},
                           Side{"P", QT_TR_NOOP("Posterior"), StandardView::Posterior, "Ctrl+Num+1"},
                           Side{"L", QT_TR_NOOP("Left"), StandardView::Left, "Num+3"},
                           Side{"R", QT_TR_NOOP("Right"), StandardView::Right, "Ctrl+Num+3"},
                           Side{"S", QT_TR_NOOP("Superior"), StandardView::Superior, "Num+7"},
                           Side{"I", QT_TR_NOOP("Inferior"), StandardView::Inferior, "Ctrl+Num+7"}}) {
    QAction* made =
        volumeAction(tr(side.name), QKeySequence(QStringLiteral("Shift+%1").arg(QLatin1String(side.letter))),
                     [this, which = side.view] { viewCommands_.face(which); });
    made->setIconText(QLatin1String(side.letter));
    addKey(*made, QKeySequence(QLatin1String(side.numpad)));
    sides << made;
  }
  menu.addMenu(tr("&Look from"))->addActions(sides);
  tools_ << sides;
}

void Actions::makeCameraEntries(QMenu& menu) {
  ViewLink& cameras = targets_.workspace.cameras;
  PlacementController& placement = targets_.workspace.placement;
  QAction* place = action(tr("Place cameras"), QKeySequence(tr("F5")), [&placement] { placement.place(); });
  place->setIcon(icon("place"));
  const auto enablePlace = [&placement, place] { place->setEnabled(placement.canPlace()); };
  connect(&placement, &PlacementController::changed, place, enablePlace);
  enablePlace();
  QAction* reset = volumeAction(tr("&Reset view"), QKeySequence(tr("R")), [this] { viewCommands_.resetActiveView(); });
  reset->setIcon(icon("reset"));
  QAction* resetAll =
      volumeAction(tr("Reset &all views"), QKeySequence(tr("Ctrl+R")), [this] { viewCommands_.resetAllViews(); });

  QAction* link = toggle(tr("Link the 3-D views"), QKeySequence(tr("L")), cameras.isLinked(),
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
  QAction* animated = preferenceToggle(tr("Animate the cameras"), {}, Preference::AnimatedCameras);
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

SlicePlane Actions::usedPlane() const {
  const auto* slice = qobject_cast<const SliceView*>(targets_.views.activeView());
  return slice ? slice->plane() : SlicePlane::Axial;
}

QMenu* Actions::makeSlicesMenu() {
  SlicePlanes& planes = targets_.workspace.planes;
  auto* menu = new QMenu(tr("&Slices"), &targets_.window);
  const auto addFace = [&](const QString& text, const QKeySequence& keys, PlaneFollow follow) {
    QAction* made = volumeAction(text, keys, [this, &planes, follow] {
      const SlicePlane plane = usedPlane();
      planes.setFollow(plane, planes.pose(plane).follow == follow ? PlaneFollow::None : follow);
    });
    made->setCheckable(true);
    connect(menu, &QMenu::aboutToShow, made,
            [this, made, &planes, follow] { made->setChecked(planes.pose(usedPlane()).follow == follow); });
    menu->addAction(made);
  };
  addFace(tr("Face C&1"), QKeySequence(tr("Shift+F")), PlaneFollow::C1);
  addFace(tr("Face C&2"), {}, PlaneFollow::C2);
  QMenu* slab = menu->addMenu(tr("&Slab"));
  connect(slab, &QMenu::aboutToShow, slab, [this, slab] {
    slab->clear();
    qDeleteAll(slab->findChildren<QActionGroup*>());
    fillSlabMenu(*slab, targets_.workspace, usedPlane());
  });
  ViewOptions& options = targets_.workspace.options;
  QAction* shown = toggle(tr("&Outlines in 3-D"), QKeySequence(tr("Shift+O")), options.planes(),
                          [&options](bool on) { options.setPlanes(on); });
  connect(&options, &ViewOptions::changed, shown, [&options, shown] { shown->setChecked(options.planes()); });
  menu->addAction(shown);
  menu->addSeparator();
  menu->addAction(
      volumeAction(tr("&Reset the plane"), QKeySequence(tr("V")), [this, &planes] { planes.reset(usedPlane()); }));
  menu->addAction(volumeAction(tr("Reset &all planes"), QKeySequence(tr("Shift+V")), [&planes] { planes.resetAll(); }));
  return menu;
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

}  // namespace fenestra::viewer
