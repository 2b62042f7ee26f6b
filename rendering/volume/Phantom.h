#pragma once
// Bodies with closed-form surfaces: built-in data sets, and exact values to test the renderer against.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "rendering/volume/LabelMap.h"
#include "rendering/volume/Volume.h"

namespace fenestra {

/// Semi-axes along the columns of `axes` (orthonormal, world from body).
struct Ellipsoid {
  glm::dvec3 centre{0.0};
  glm::dvec3 semiAxes{1.0};
  glm::dmat3 axes{1.0};
};

/// Elliptic cylinder with flat ends: semi-axes x, y across, half length z along axes[2].
struct Cylinder {
  glm::dvec3 centre{0.0};
  glm::dvec3 semiAxes{1.0};
  glm::dmat3 axes{1.0};
};

/// Swept sphere along the segment from a to b, radius in mm: a rib, a vessel.
struct Capsule {
  glm::dvec3 a{0.0}, b{0.0};
  double radius = 1.0;
};

struct Box {
  glm::dvec3 centre{0.0};
  glm::dvec3 semiAxes{1.0};
  glm::dmat3 axes{1.0};
};

using Shape = std::variant<Ellipsoid, Cylinder, Capsule, Box>;

/// One or more shapes of one material. Where bodies overlap, the later one in the list wins.
struct PhantomBody {
  std::uint16_t label = 0;  ///< 0: drawn into the values only, labels pass through
  std::string name;
  glm::dvec3 colour{0.8};
  double value = 0.0;         ///< HU
  std::vector<Shape> shapes;  ///< their union
};

/// Where a ray runs inside a shape, mm along its unit direction; t may be negative. Empty when it misses.
struct RayInterval {
  double tIn = 0.0, tOut = 0.0;
};
std::optional<RayInterval> intersect(const Shape& shape, glm::dvec3 origin, glm::dvec3 unitDirection);
/// Closed: the surface belongs to the shape.
bool contains(const Shape& shape, glm::dvec3 point);

struct Phantom {
  std::string name;
  glm::dvec3 extent{0.0};       ///< mm, of the box around the world origin that is rasterised
  double background = -1000.0;  ///< HU of air
  std::vector<PhantomBody> bodies;

  /// Value and label at a world point (exact, no interpolation).
  double value(glm::dvec3 point) const;
  std::uint16_t label(glm::dvec3 point) const;

  /// A stretch of a ray through one body; `body` indexes `bodies`.
  struct Segment {
    double tIn = 0.0, tOut = 0.0;
    std::size_t body = 0;
  };
  /// The bodies that a line meets, from -inf to +inf and in order, exact; air between them is left out.
  std::vector<Segment> segments(glm::dvec3 origin, glm::dvec3 unitDirection) const;
  /// First point of a ray (t ≥ 0) that carries one of `labels`, exact; empty when there is none.
  std::optional<double> firstHit(glm::dvec3 origin, glm::dvec3 unitDirection,
                                 const std::vector<std::uint16_t>& labels) const;

  struct Rasterised {
    std::shared_ptr<const Volume> volume;  ///< Int16, HU
    std::shared_ptr<const LabelMap> labels;
  };
  /// Voxelises on all cores at `voxels` (≥ 1) along the longest side, cubic voxels: labels by the voxel centre, values
  /// by how much of the voxel each body fills (exact along x, sampled across), spread over the neighbours by 1 2 1
  /// along each axis, so that surfaces have the soft edge of a scan.
  Rasterised rasterise(int voxels) const;
};

}  // namespace fenestra
