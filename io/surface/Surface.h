#pragma once
// The focus as a closed surface of triangles: extracted by flying edges (Schroeder et al. 2015) and smoothed by a
// windowed sinc filter (Taubin et al. 1996), both VTK's; held to the volume and to the place of what it was made from.
//
// VTK is in a part of its own (SurfacePart.h), which is loaded when the first surface is wanted: its libraries would
// add 30 ms to the start of every program.

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "io/base/Reading.h"
#include "rendering/scene/Scene.h"

namespace fenestra::io {

/// Triangles are counter-clockwise seen from outside; points are LPS mm.
struct Surface {
  std::vector<glm::dvec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// Enclosed volume in mm³ (divergence theorem); cavities count negative.
  double volume() const {
    // From a point on the surface: far from the origin, large terms would cancel.
    const glm::dvec3 centre = points.empty() ? glm::dvec3(0.0) : points.front();
    double sixfold = 0.0;
    for (const auto& [a, b, c] : triangles)
      sixfold += glm::dot(points[a] - centre, glm::cross(points[b] - centre, points[c] - centre));
    return sixfold / 6.0;
  }
};

struct SurfaceOptions {
  bool smooth = true;  ///< false: the level set as it is, with the steps of the voxels
};

/// The focus of `scene`, closed where it meets the border of the volume.
///   labels   the 0.5 level of the 0/1 indicator; encloses the volume of the labelled voxels
///   values   the zero level of min(value - low, high - value), without the components that the focus drops; smoothing
///            keeps its volume
/// No point lies further than half a voxel from the level set. Throws Error, naming `source`, when the focus is empty;
/// Cancelled.
Surface extractSurface(const Scene& scene, const std::filesystem::path& source, const SurfaceOptions& options = {},
                       const Progress& progress = {});

/// The axes that a file's coordinates are in, mm. RAS has x and y reversed.
enum class SurfaceFrame : std::uint8_t { Lps, Ras };

/// Binary STL, binary PLY or OBJ by the file name's ending. The frame is noted in the file ("SPACE=LPS"), as 3D Slicer
/// writes and reads it. Written beside and renamed. Throws Error.
void writeSurface(const Surface& surface, const std::filesystem::path& path, SurfaceFrame frame);

}  // namespace fenestra::io
