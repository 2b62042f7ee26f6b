#pragma once
// Which parts of a volume 3-D pictures leave out, whatever the camera: all outside a crop box, or behind up to three
// planes.
//
// The box and the planes are half-spaces, and what all of them keep is convex: they leave one stretch of every ray. All
// stages of the method know the volume on that stretch alone. Where a ray enters through a half-space's plane, it meets
// a capped face, which shows the data that it cuts: what the volume rendering integral sees from there on, lit as a
// face with the plane's normal as far as the face of an opening is (Lighting.h), or the values in grey.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "rendering/volume/Grid.h"
#include "rendering/volume/Volume.h"

namespace fenestra {

/// Keeps the world positions x with x·normal ≥ offset.
struct HalfSpace {
  glm::dvec3 normal{0.0, 0.0, 1.0};  ///< unit, world
  double offset = 0.0;               ///< mm from the world's origin along it
  double distance(glm::dvec3 world) const { return glm::dot(world, normal) - offset; }  ///< mm; negative: clipped
  bool operator==(const HalfSpace&) const = default;
};

/// The axes of a volume as L, P and S: each is the normal of the volume's faces that is nearest to that direction of
/// the patient, and points to its side. Coordinates along them are mm from the world's origin: in a volume along the
/// patient's axes they are LPS coordinates; in an oblique one they follow its rows, columns and slices.
struct CropFrame {
  explicit CropFrame(const Grid& grid);
  glm::ivec3 axis;                   ///< the volume's index axis for L, P and S
  std::array<glm::dvec3, 3> normal;  ///< unit, world
  glm::dvec3 low, high;              ///< the volume's own ends, voxels counted whole; low < high

  glm::dvec3 coordinates(glm::dvec3 world) const;
  glm::dvec3 world(glm::dvec3 coordinates) const;
  bool operator==(const CropFrame&) const = default;
};

/// Ends in mm along the axes of the volume's CropFrame. Where low ≥ high nothing is kept.
struct CropBox {
  glm::dvec3 low{0.0}, high{0.0};
  bool operator==(const CropBox&) const = default;
};

struct Clipping {
  static constexpr std::size_t mostPlanes = 3;

  bool cropped = false;  ///< off: `box` is kept, without effect
  CropBox box;
  std::vector<HalfSpace> planes;      ///< mostPlanes at most
  std::vector<std::uint16_t> exempt;  ///< labels that are never clipped, ascending, each once
  /// Set: capped faces are opaque and show values in grey as a slice does with this window. The focus keeps its look.
  std::optional<WindowLevel> grey;

  bool operator==(const Clipping&) const = default;
};

/// Six for a box, the planes, and three for a part of an exploded view (Explosion.h).
inline constexpr std::size_t mostHalfSpaces = 6 + Clipping::mostPlanes + 3;
/// What clips a volume: the planes, and those faces of the box that lie inside it. Empty where nothing is clipped.
std::vector<HalfSpace> halfSpaces(const Clipping& clipping, const Grid& grid);
/// Whether all of them keep a world position.
bool keeps(const std::vector<HalfSpace>& clip, glm::dvec3 world);

}  // namespace fenestra
