#pragma once
// What the shape of a scan says about directions to look from: at which ends of the volume the body goes on, whether
// the volume is a flat stack, and on which side of the body the focus lies. Transfer functions have no say in it.
//
// The body is what is denser than air: above -500 HU in a CT, half way from air to water; elsewhere above
// v2 + 0.1 (v98 - v2), where v2 and v98 are percentiles of all values (the robust threshold of Smith, Fast robust
// automated brain extraction, Human Brain Mapping 17(3), 2002). What is hidden or removed, a CT's table among it, is
// air, and so is what is clipped.
//
// A face of the volume is cut as far as the body touches it. Let k be the body's area in the face's layer of voxels
// over its greatest area in any layer parallel to it, and s the share of the focus that lies behind the body in that
// layer, along the volume's axis. With ramp(x, a, b) = (x - a) / (b - a), clamped to [0, 1],
//
//     cut = max(ramp(k, 0.2, 0.4), s · ramp(k, 0.05, 0.15))
//
// The first term is that of a whole limb, neck or trunk that is cut: of fifteen scans of heads, trunks, hands and feet
// those ends have k from 0.33 on. The second is that of a smaller end in front of the focus: a leg above the foot
// (k = 0.25) is in front of the talus, but the metatarsal bones lie beside it and are looked at from there; arms that
// leave the field of view of a trunk (0.14 to 0.21) count where the focus is behind them. A nose or a vertex that
// touches the face stays below 0.05. The least cut of the six faces is subtracted from all, so that a piece from the
// middle of a body, of which no face is better than another, has no cut end.

#include <array>
#include <span>

#include <glm/glm.hpp>

#include "rendering/scene/ShownVolume.h"
#include "rendering/settings/Clipping.h"
#include "rendering/settings/FlatStack.h"

namespace fenestra::placement {

struct ScanShape {
  /// A face of the volume.
  struct Face {
    glm::dvec3 normal{0.0};  ///< unit, world, outwards
    double contact = 0.0;    ///< k
    double behind = 0.0;     ///< s
    double cut = 0.0;        ///< less the least of all faces
  };
  /// Towards L, P, S, then R, A, I, as CropFrame names the volume's axes.
  std::array<Face, 6> faces;
  FlatStack stack;
  /// World: the way from the body's middle to the focus's, along each axis of the volume as a share of half the body's
  /// extent, from -1 to 1.
  glm::dvec3 offset{0.0};

  /// How far a view from `direction` (unit, towards the camera) comes in through cut ends: the sum over the faces of
  /// cut · max(0, direction·normal)², where the cuts of a flat volume's front and back count by 1 - flatness. 1
  /// straight through a cut end, ½ at 45° to it.
  double throughCutEnd(glm::dvec3 direction) const;
  /// How far such a view is from a flat volume's front: flatness · (1 - max(0, direction·front)²).
  double edgeOn(glm::dvec3 direction) const;
  /// How far on the other side of the body the focus lies for such a view: max(0, -direction·offset), 1 at most.
  double farSide(glm::dvec3 direction) const;
};

/// Reads some 32³ voxels; deterministic. `kept` are the scene's halfSpaces(), `focus` are points of the focus, in
/// continuous indices.
ScanShape scanShape(const ShownVolume& shown, const std::vector<HalfSpace>& kept, std::span<const glm::dvec3> focus);

}  // namespace fenestra::placement
