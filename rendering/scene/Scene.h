#pragma once
// Everything one picture needs and nothing more; plain data, no GL. Copies are cheap: voxels are shared.

#include <memory>

#include "rendering/scene/BrushStroke.h"
#include "rendering/scene/Camera.h"
#include "rendering/scene/Cutaway.h"
#include "rendering/scene/Focus.h"
#include "rendering/scene/LabelMap.h"
#include "rendering/scene/TransferFunction.h"
#include "rendering/scene/Volume.h"

namespace fenestra {

/// How the focus looks. A label focus takes its labels' colours; a value focus takes `colour`. `extinction` is in 1/mm.
struct FocusAppearance {
  glm::dvec3 colour{0.93, 0.87, 0.75};
  double extinction = 2.0;
  bool operator==(const FocusAppearance&) const = default;
};

struct Shading {
  bool enabled = true;  ///< off: no gradient texture is made
  double ambient = 0.3;
  double diffuse = 0.7;
  double specular = 0.2;
  double shininess = 24.0;
  bool operator==(const Shading&) const = default;
};

struct Scene {
  std::shared_ptr<const Volume> volume;
  std::shared_ptr<const LabelMap> labels;  ///< may be null; same grid dims as the volume
  TransferFunction context;                ///< optical properties of everything that is not focus
  Focus focus;
  FocusAppearance focusAppearance;
  Cutaway cutaway;
  ContextLayer contextLayer;
  BrushStrokes strokes;  ///< edits of the opening; without any, nothing is kept or run for them
  Shading shading;
  glm::dvec3 background{0.0};  ///< display RGB 0..1

  bool operator==(const Scene&) const = default;
};

/// A scene has an opening when it has a focus and its cutaway is on.
bool hasCutaway(const Scene& scene);

/// The part of the volume's grid in which `context` shows anything, for a camera to frame: scans hold much air. Slabs
/// of voxels with next to nothing in them (a table's edge, noise) do not count. The whole grid when nothing shows.
Grid visibleGrid(const Volume& volume, const TransferFunction& context);

}  // namespace fenestra
