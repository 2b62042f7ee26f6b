#include "viewer/actions/PlaneMenu.h"

#include <algorithm>

#include <QActionGroup>
#include <QCoreApplication>
#include <QInputDialog>

#include "viewer/model/SlabText.h"
#include "viewer/model/Workspace.h"
#include "viewer/style/Overlay.h"

namespace fenestra::viewer {
namespace {

struct PlaneMenuWords {
  Q_DECLARE_TR_FUNCTIONS(PlaneMenu)
};

/// What the menu offers at once, in mm; any other by a number.
constexpr std::array offeredThicknesses{2.0, 5.0, 10.0, 20.0, 50.0};

void askThickness(SlicePlanes& planes, SlicePlane plane) {
  const Slab slab = planes.pose(plane).slab;
  bool accepted = false;
  const double thickness =
      QInputDialog::getDouble(nullptr, PlaneMenuWords::tr("Slab of the %1 slice").arg(planeName(plane).toLower()),
                              PlaneMenuWords::tr("Thickness in mm, half of it to each side; 0 is the slice alone:"),
                              slab.thickness, 0.0, io::mostSlab, 1, &accepted);
  if (accepted) planes.setSlab(plane, {thickness, slab.mode});
}

void addFollow(QMenu& menu, SlicePlanes& planes, SlicePlane plane, PlaneFollow follow, const QString& text) {
  QAction* action = menu.addAction(text);
  action->setCheckable(true);
  action->setChecked(planes.pose(plane).follow == follow);
  QObject::connect(action, &QAction::triggered, &menu,
                   [&planes, plane, follow](bool on) { planes.setFollow(plane, on ? follow : PlaneFollow::None); });
}

}  // namespace

void fillSlabMenu(QMenu& menu, Workspace& workspace, SlicePlane plane) {
  SlicePlanes& planes = workspace.planes;
  const Slab now = planes.pose(plane).slab;
  const auto choice = [&menu](QActionGroup* group, const QString& text, bool chosen, auto does) {
    QAction* action = menu.addAction(text);
    action->setCheckable(true);
    action->setChecked(chosen);
    group->addAction(action);
    QObject::connect(action, &QAction::triggered, &menu, std::move(does));
  };
  const auto setThickness = [&planes, plane](double thickness) {
    planes.setSlab(plane, {thickness, planes.pose(plane).slab.mode});
  };
  auto* thickness = new QActionGroup(&menu);
  choice(thickness, PlaneMenuWords::tr("Off: the slice alone"), now.thickness == 0.0, [=] { setThickness(0.0); });
  for (const double each : offeredThicknesses)
    choice(thickness, PlaneMenuWords::tr("%1 mm").arg(each), now.thickness == each, [=] { setThickness(each); });
  const bool isOther = now.thickness > 0.0 && std::find(offeredThicknesses.begin(), offeredThicknesses.end(),
                                                        now.thickness) == offeredThicknesses.end();
  choice(thickness, isOther ? PlaneMenuWords::tr("Other: %1 mm…").arg(now.thickness) : PlaneMenuWords::tr("Other…"),
         isOther, [&planes, plane] { askThickness(planes, plane); });
  menu.addSeparator();
  auto* modes = new QActionGroup(&menu);
  for (const auto& [mode, text] : {std::pair(SlabMode::Maximum, PlaneMenuWords::tr("Maximum (MIP)")),
                                   std::pair(SlabMode::Minimum, PlaneMenuWords::tr("Minimum (MinIP)")),
                                   std::pair(SlabMode::Mean, PlaneMenuWords::tr("Mean"))})
    choice(modes, text, now.mode == mode, [&planes, plane, mode = mode] {
      planes.setSlab(plane, {planes.pose(plane).slab.thickness, mode});
    });
  menu.addSeparator();
  QAction* toAll = menu.addAction(PlaneMenuWords::tr("All slices as this one"));
  QObject::connect(toAll, &QAction::triggered, &menu, [&planes, plane] {
    for (const SlicePlane each : SlicePlanes::all) planes.setSlab(each, planes.pose(plane).slab);
  });
}

void fillPlaneMenu(QMenu& menu, Workspace& workspace, SlicePlane plane) {
  SlicePlanes& planes = workspace.planes;
  addFollow(menu, planes, plane, PlaneFollow::C1, PlaneMenuWords::tr("Slice faces C1"));
  addFollow(menu, planes, plane, PlaneFollow::C2, PlaneMenuWords::tr("Slice faces C2"));
  fillSlabMenu(*menu.addMenu(PlaneMenuWords::tr("Slab")), workspace, plane);
  QAction* one = menu.addAction(PlaneMenuWords::tr("Reset this slice's plane"));
  one->setEnabled(planes.isTurned(plane));
  QObject::connect(one, &QAction::triggered, &menu, [&planes, plane] { planes.reset(plane); });
  QAction* every = menu.addAction(PlaneMenuWords::tr("Reset all planes"));
  every->setEnabled(std::any_of(SlicePlanes::all.begin(), SlicePlanes::all.end(),
                                [&planes](SlicePlane each) { return planes.isTurned(each); }));
  QObject::connect(every, &QAction::triggered, &menu, [&planes] { planes.resetAll(); });
}

}  // namespace fenestra::viewer
