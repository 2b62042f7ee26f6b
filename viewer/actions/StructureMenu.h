#pragma once
// The menu of a right click on a picture.

#include <optional>

#include <glm/glm.hpp>

#include <QPoint>

#include "rendering/volume/Slice.h"

namespace fenestra::viewer {

struct Workspace;

/// Focus and crosshair at a world position, and on a slice its plane, as a menu at `at` in screen coordinates. Returns
/// when the menu is closed.
void showStructureMenu(Workspace& workspace, glm::dvec3 world, QPoint at, std::optional<SlicePlane> plane = {});

}  // namespace fenestra::viewer
