#pragma once
// A head of ellipsoids: brain, skull, scalp, and a face with nose, eyes and chin. Its centre is that of the brain;
// world (LPS), mm, as the patient lies.

#include <memory>

#include "rendering/volume/Volume.h"

namespace fenestra::tests {

enum class MadeTissue : std::uint8_t { Air, Scalp, Skull, Brain, Face };

/// `p` from the centre of the brain.
inline MadeTissue madeHeadAt(const glm::dvec3& p) {
  const auto in = [&p](const glm::dvec3& centre, const glm::dvec3& radii) {
    const glm::dvec3 from = (p - centre) / radii;
    return glm::dot(from, from) <= 1.0;
  };
  // The orbits' roofs rise to the front.
  if (in({0, 0, 0}, {66, 77, 62}) && (p.z > 10.0 || in({0, 0, 0}, {66, 60, 62}) || p.y > 0.0)) return MadeTissue::Brain;
  if (in({0, 0, 0}, {73, 87, 69})) return MadeTissue::Skull;
  if (in({0, 0, 0}, {78, 92, 74})) return MadeTissue::Scalp;
  const bool isFace = in({0, -45, -85}, {62, 50, 68}) ||   // cheeks and jaws
                      in({0, -100, -62}, {16, 22, 24}) ||  // nose
                      in({0, -78, -138}, {24, 20, 16});    // chin
  const bool isNeck = p.z < -60.0 && glm::length(glm::dvec2(p.x, p.y - 15.0)) < 58.0;
  return isFace ? MadeTissue::Face : isNeck ? MadeTissue::Scalp : MadeTissue::Air;
}

/// A volume of cubes of `side` mm that shows it from `top` mm above the brain's centre downwards. As CT in HU, or as MR
/// with a background of noise.
inline std::shared_ptr<Volume> madeHead(Modality modality, double side = 4.0, double top = 96.0) {
  auto volume = std::make_shared<Volume>();
  Grid& grid = volume->grid;
  grid.spacing = glm::dvec3(side);
  const glm::dvec3 low(-110.0, -140.0, -180.0), high(110.0, 120.0, top);
  grid.dims = glm::ivec3(glm::floor((high - low) / side)) + 1;
  grid.origin = low;
  volume->modality = modality;
  volume->unit = modality == Modality::CT ? "HU" : "";
  volume->voxels = Voxels(ScalarType::Int16, grid.voxelCount());
  std::int16_t* to = volume->voxels.as<std::int16_t>().data();
  std::uint32_t random = 1;
  for (int z = 0; z < grid.dims.z; ++z)
    for (int y = 0; y < grid.dims.y; ++y)
      for (int x = 0; x < grid.dims.x; ++x) {
        random = random * 1664525u + 1013904223u;
        const auto noise = static_cast<int>(random >> 27);  // 0 to 31
        const bool isCt = modality == Modality::CT;
        int value = isCt ? -1000 : 0;
        switch (madeHeadAt(low + side * glm::dvec3(x, y, z))) {
          case MadeTissue::Air:
            break;
          case MadeTissue::Scalp:
          case MadeTissue::Face:
            value = isCt ? 40 : 700;
            break;
          case MadeTissue::Skull:
            value = isCt ? 900 : 60;
            break;
          case MadeTissue::Brain:
            value = isCt ? 30 : 500;
            break;
        }
        *to++ = static_cast<std::int16_t>(value + noise);
      }
  volume->computeRange();
  return volume;
}

}  // namespace fenestra::tests
