#pragma once
// A scene with a layer peeled off, as plain voxels that every pass draws without knowing of it.
//
// Voxels lie where the volume's own do, and as many more on each side as the rolled layer needs. Their values:
//
// - a voxel in focus keeps its value, as does one in place (Peel::Part) with the eight voxels that touch its corners;
// - one that lies in the same half of the layer as those has the trilinear value at its centre's source, in which
//   voxels in focus count as air, because the focus does not move along;
// - any other voxel has the mean over 4³ places, half a voxel apart, around its centre: its own value in place,
//   the value at the source in the layer, and air where nothing shows. So faces rise over two voxels, and have no
//   steps.
//
// What is hidden or removed is air before it is moved. A label map's voxel has the label of the voxel nearest to its
// centre's source, but none of the focus's; voxels in focus keep theirs. Integers are rounded.
//
// The bounds of a picture hold against the integral over this volume. The gradient of f(x + D(x)) is (I + ∂D/∂x)ᵀ ∇f,
// and central differences of these voxels converge to it; no shader computes it otherwise.

#include <memory>

#include "rendering/scene/FocusVoxels.h"
#include "rendering/scene/Peel.h"
#include "rendering/scene/Scene.h"

namespace fenestra {

struct PeeledScene {
  Scene scene;  ///< not to be peeled again
  Peel peel;
  std::shared_ptr<const FocusVoxels> focus;  ///< of the scene before
  Grid grid;                                 ///< of the scene before

  /// Where a place of the volume is shown.
  glm::dvec3 shownAt(glm::dvec3 world) const;
  /// Where in the volume what shows at a place comes from; empty where nothing does, and in the
  /// hollow that the focus leaves in the layer.
  std::optional<glm::dvec3> sourceOf(glm::dvec3 world) const;

 private:
  glm::ivec3 voxelAt(glm::dvec3 world) const;
  bool isInFocus(glm::dvec3 world) const;
};

/// Makes peeled scenes. What has not changed since the last one is kept.
class Peeler {
 public:
  /// Null where nothing is peeled; nothing is kept then. Runs on all cores.
  std::shared_ptr<const PeeledScene> of(const Scene& scene);
  /// Whether of() has the voxels of that scene already, or needs none; and what it gives then.
  bool knows(const Scene& scene) const;
  std::shared_ptr<const PeeledScene> known(const Scene& scene) const;

 private:
  /// What voxels in focus depend on, and the body.
  struct Source {
    ShownVolume shown;
    std::shared_ptr<const LabelMap> labels;
    Focus focus;
    bool operator==(const Source&) const = default;
  };
  static Source sourceOf(const Scene& scene);
  void resample(const Scene& scene);

  Source source_;
  std::shared_ptr<const FocusVoxels> focus_;
  Grid body_;
  std::optional<MethodStages::Peel> settings_;  ///< of peel_; empty before the first
  std::shared_ptr<const LabelMap> structuresOf_;
  std::optional<Peel> peel_;
  std::shared_ptr<const Volume> volume_;
  std::shared_ptr<const LabelMap> labels_, structures_;
};

}  // namespace fenestra
