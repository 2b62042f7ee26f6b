#pragma once
// How a slice lies and how thick it is, as entries of menus.

#include <QMenu>

#include "rendering/volume/Slice.h"

namespace fenestra::viewer {

struct Workspace;

/// Adds entries for one plane: the cameras that it may face, its slab, and the ways back. `workspace` outlives the
/// menu.
void fillPlaneMenu(QMenu& menu, Workspace& workspace, SlicePlane plane);
/// Adds the slab's thickness and mode alone.
void fillSlabMenu(QMenu& menu, Workspace& workspace, SlicePlane plane);

}  // namespace fenestra::viewer
