#pragma once
// Everything one picture needs and nothing more; plain data, no GL. Copies are cheap: voxels are shared.

#include <memory>

#include "rendering/scene/Camera.h"
#include "rendering/scene/LabelMap.h"
#include "rendering/scene/Look.h"
#include "rendering/scene/Volume.h"

namespace fenestra {

struct Scene {
  std::shared_ptr<const Volume> volume;
  std::shared_ptr<const LabelMap> labels;  ///< may be null; same grid dims as the volume
  Look look;

  bool operator==(const Scene&) const = default;
};

/// A scene has an opening when it has a focus and its cutaway is on.
bool hasCutaway(const Scene& scene);

/// The part of the volume's grid in which `context` shows anything, for a camera to frame: scans hold much air. Slabs
/// of voxels with next to nothing in them (a table's edge, noise) do not count. The whole grid when nothing shows.
Grid visibleGrid(const Volume& volume, const TransferFunction& context);

}  // namespace fenestra
