#pragma once
// The part of a volume that a camera is to have in its picture.

#include "rendering/settings/Framing.h"
#include "rendering/volume/Grid.h"

namespace fenestra {

struct ShownVolume;
struct TransferFunction;

/// The part of the volume's grid that `context` shows, for a camera to frame: scans hold much air. Nearly empty slabs
/// of voxels (a table's edge, noise) do not count. The whole grid when the context shows nothing.
Grid visibleGrid(const ShownVolume& shown, const TransferFunction& context);

/// What `context` shows of a volume: the hull of the blocks of voxels that show in part, within visibleGrid() and
/// around its centre. Tighter than that box, whose corners are air around a head.
Framing visibleFraming(const ShownVolume& shown, const TransferFunction& context);

}  // namespace fenestra
