#pragma once
// Everything that one picture needs; plain data, no GL. Copies are cheap, because they share the voxels.

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
  /// `volume` with the scanner's table as air; `volume` itself where there is none; null where nobody looked for one.
  std::shared_ptr<const Volume> tissue = nullptr;

  bool operator==(const Scene&) const = default;
};

/// The volume that 3-D pictures show: `tissue` where the look hides the table. Slices show `volume`.
const std::shared_ptr<const Volume>& shownVolume(const Scene& scene);
/// The scene with that as its volume.
Scene shownScene(Scene scene);

/// A scene has an opening when it has a focus and its cutaway is on.
bool hasCutaway(const Scene& scene);

/// The part of the volume's grid that `context` shows, for a camera to frame: scans hold much air. Nearly empty slabs
/// of voxels (a table's edge, noise) do not count. The whole grid when the context shows nothing.
Grid visibleGrid(const Volume& volume, const TransferFunction& context);

}  // namespace fenestra
