#pragma once
// Volumes that are flat: a slab, or a stack of few slices. Seen edge-on they show next to nothing.
//
// A volume is flat where its extent along one axis is a small share of the next one: wholly from an eighth on, not at
// all from a third on; or where it has three slices or fewer, fading out to six. In between, flatness falls as a
// square, so that a thick slab is hardly flat. Its front is the side from which a slice view shows its slices: axial
// ones from below, coronal ones from the front, sagittal ones from the left.

#include <glm/glm.hpp>

#include "rendering/settings/Camera.h"
#include "rendering/settings/Clipping.h"

namespace fenestra {

struct FlatStack {
  double flatness = 0.0;  ///< from 0 to 1
  glm::dvec3 front{0.0};  ///< unit, world, towards a camera in front of the volume; 0 where flatness is 0
};

FlatStack flatStack(const CropFrame& frame, const Grid& grid);

/// C1 as long as nobody chose a view: from the patient's front, or from that of a flat volume.
Camera firstCamera(const Grid& grid, const Framing& framing, Projection projection);
/// C2 as long as nobody chose a view: beside C1, as Camera::beside() has it. Where C1 looks at the front of a flat
/// volume, which would be seen edge-on from there, C2 looks at its front from 45° off: from the patient's front, of
/// coronal slices from the left.
Camera secondCamera(const Camera& first, const Grid& grid);

}  // namespace fenestra
