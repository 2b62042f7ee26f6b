#pragma once
// The menu of a right click on a picture.

#include <glm/glm.hpp>

#include <QPoint>

namespace fenestra::viewer {

struct Workspace;

/// Focus and crosshair at a world position, as a menu at `at` in screen coordinates. Returns when the menu is closed.
void showStructureMenu(Workspace& workspace, glm::dvec3 world, QPoint at);

}  // namespace fenestra::viewer
