#pragma once
// What a benchmark draws: scenes made plain, views around the patient, and pixels to compare with the reference.

#include <vector>

#include "rendering/scene/Scene.h"
#include "rendering/settings/Camera.h"

namespace fenestra::bench {

/// A scene as a plain volume rendering without lighting: what every volume renderer can draw. The outermost
/// voxels have the volume's least value, because some programs end the volume at their centres and others half a voxel
/// beyond; with nothing to see there, all have the same limit.
Scene plainScene(const Scene& scene);

/// `count` views around the patient, up and down, framing what shows. The first is the same for any count.
std::vector<Camera> cameraPath(const Scene& scene, int count, Projection projection = Projection::Perspective);

/// One pixel of every block of side×side, at a place of its own in each, row by row.
std::vector<glm::ivec2> sampledPixels(glm::ivec2 size, int side);

}  // namespace fenestra::bench
