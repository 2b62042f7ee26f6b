#include "viewer/actions/StructureMenu.h"

#include <variant>

#include <QCoreApplication>
#include <QMenu>

#include "viewer/actions/PlaneMenu.h"
#include "viewer/model/LabelName.h"
#include "viewer/model/Workspace.h"

namespace fenestra::viewer {
namespace {

struct StructureMenuWords {
  Q_DECLARE_TR_FUNCTIONS(StructureMenu)
};

}  // namespace

void showStructureMenu(Workspace& workspace, glm::dvec3 world, QPoint at, std::optional<SlicePlane> plane) {
  Document& document = workspace.document;
  QMenu menu;
  const auto add = [&menu](const QString& text, auto does) {
    QAction* action = menu.addAction(text);
    QObject::connect(action, &QAction::triggered, &menu, std::move(does));
    return action;
  };
  if (const Label* label = document.labelAt(world)) {
    const std::uint16_t value = label->value;
    const bool focused = document.isFocused(value);
    add(StructureMenuWords::tr("Focus on %1").arg(nameOf(*label)), [&document, value] { document.focusOn(value); });
    add(focused ? StructureMenuWords::tr("Take %1 out of the focus").arg(nameOf(*label))
                : StructureMenuWords::tr("Add %1 to the focus").arg(nameOf(*label)),
        [&document, value, focused] { document.setFocused(value, !focused); });
    menu.addSeparator();
  }
  add(StructureMenuWords::tr("Grow a region from here"), [&document, world] { document.growFrom(world); });
  if (document.region()) {
    add(StructureMenuWords::tr("Add this to the region"), [&document, world] { document.addSeed(world, true); });
    add(StructureMenuWords::tr("Take this away from the region"),
        [&document, world] { document.addSeed(world, false); });
  }
  menu.addSeparator();
  add(StructureMenuWords::tr("Crosshair here"), [&workspace, world] { workspace.cursor.moveTo(world); });
  add(StructureMenuWords::tr("No focus"), [&document] {
    document.setFocus(std::monostate{});
  })->setEnabled(!std::holds_alternative<std::monostate>(document.focus()));
  if (plane) {
    menu.addSeparator();
    fillPlaneMenu(menu, workspace, *plane);
  }
  menu.exec(at);
}

}  // namespace fenestra::viewer
