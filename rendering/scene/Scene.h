#pragma once
// Everything that one picture needs; plain data, no GL. Copies are cheap, because they share the voxels.

#include <memory>

#include "rendering/scene/ShownVolume.h"
#include "rendering/settings/Camera.h"
#include "rendering/settings/Look.h"
#include "rendering/volume/LabelMap.h"

namespace fenestra {

struct Scene {
  std::shared_ptr<const Volume> volume;
  std::shared_ptr<const LabelMap> labels;  ///< may be null; same grid dims as the volume
  Look look;
  /// Cells that hold the scanner's table: an empty set where the scan shows none, null before the search for it.
  std::shared_ptr<const CoarseMask> table = nullptr;
  /// The label map that look.labels is about, where `labels` holds a region in focus instead; null: `labels`.
  std::shared_ptr<const LabelMap> structures = nullptr;
  /// How much of the voxels look.removals removes, as Sculptor finds it; null: nothing is removed.
  std::shared_ptr<const RemovedVoxels> removed = nullptr;

  bool operator==(const Scene&) const = default;
};

/// What 3-D pictures show of the volume: neither the table, where the look hides it, nor hidden labels, nor what is
/// removed. Slices show all.
ShownVolume shownVolume(const Scene& scene);

/// The look's reconstruction. Auto stands for Smooth where the voxels are wider than the pixels of a picture of the
/// whole volume and mostSplineVoxels at most, for Smoother where they are wider than pixelsOfTerraces of them and the
/// data change more sharply than the voxels, else for Linear. It does not depend on the camera, so that pictures do not
/// change their kind.
Reconstruction reconstructionOf(const Scene& scene);
/// Some 180³. On the device a lit voxel of a spline takes up to 190 bytes, so these take about 1 GiB.
inline constexpr std::size_t mostSplineVoxels = 5'800'000;
/// Pixels across the diagonal of a volume in that picture, a small one: the surface of finer voxels shows no terraces.
inline constexpr double pixelsAcrossVolume = 500.0;
/// Smooth leaves terraces that wide where a step is sharper than the voxels: on the skin in CT, and along thick slices,
/// which are so many times as thick as their pixels are wide.
inline constexpr double pixelsOfTerraces = 2.0, thickSlices = 3.0;

/// The label map that look.labels is about.
const std::shared_ptr<const LabelMap>& structuresOf(const Scene& scene);
/// Whether the labels in focus are labels of that map.
bool focusesStructures(const Scene& scene);
/// Whether a label of that map belongs to the context: not in focus, and neither hidden nor of opacity 0.
bool isInContext(const Scene& scene, const LabelSetting& setting);
/// The labels of that map that have a role and are not in focus, ascending. One of opacity 0 has the role Hidden. For
/// Protected, those that are visible.
std::vector<std::uint16_t> labelsWith(LabelRole role, const Scene& scene);

/// How a label in focus is drawn: a body of one material or, where there is a function, of that; and its opacity, which
/// is 0 where it is not visible. LabelSettings.h says what that means.
struct DrawnInFocus {
  OpticalProperties material{};
  std::optional<TransferFunction> function{};
  double opacity = 1.0;
};
DrawnInFocus drawnInFocus(const Scene& scene, std::uint16_t label);

/// Colour and extinction (1/mm) of an even medium in place of a label in focus (see opticalExtinction), as the look has
/// changed them; where it has no focusFunction.
OpticalProperties focusMaterial(const Scene& scene, std::uint16_t label);
/// Colour and extinction by value of an even medium in place of a label in focus; empty where it is of one material.
/// What is focus does not depend on it: at a point of the focus, the volume's interpolated value there takes the place
/// of the material, and the label is that of the nearest voxel, as it is for materials. Its colour is for slices then.
/// The labels of a grown region have the region's function.
std::optional<TransferFunction> focusFunction(const Scene& scene, std::uint16_t label);
/// Colour and extinction by value of a focus of values; empty where it is of one material.
const std::optional<TransferFunction>& focusFunction(const Scene& scene);
/// Whether some of the focus is shown by value.
bool hasFocusFunction(const Scene& scene);

/// A scene has an opening when it has a focus, its cutaway is on, and its method opens something.
bool hasCutaway(const Scene& scene);
/// Whether a picture needs the shape of the context's first surface: for its edges over the focus, or for a lens.
bool readsContextSurface(const Scene& scene);

/// Makes scenes as they are drawn from scenes as a user set them: `removed` is what their looks remove, and their
/// labels lack the voxels that are gone. What has not changed since the last scene is kept; without removals a scene
/// stays as it is.
class Sculptor {
 public:
  Scene of(Scene scene);

 private:
  using Map = std::shared_ptr<const LabelMap>;
  struct Carved {
    Map source, carved;
    std::shared_ptr<const RemovedVoxels> removed;  ///< that was taken out of it
  };
  Map carved(Carved& kept, const Map& source) const;

  Removals removals_;  ///< that removed_ is of
  Grid grid_;
  std::shared_ptr<const RemovedVoxels> removed_;
  Carved labels_, structures_;
};

}  // namespace fenestra
