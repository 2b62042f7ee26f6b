#pragma once
// The focus as a closed surface of triangles: extracted by flying edges (Schroeder et al. 2015) and smoothed by a
// windowed sinc filter (Taubin et al. 1996), both VTK's; held to the volume and to the place of what it was made from.
//
// VTK is in a part of its own (SurfacePart.h), which is loaded when the first surface is wanted: its libraries would
// add 30 ms to the start of every program.

#include <filesystem>

#include "io/base/Reading.h"
#include "io/surface/Triangles.h"
#include "rendering/scene/Scene.h"

namespace fenestra::io {

/// The focus of `scene`, closed where it meets the border of the volume.
///   labels   the 0.5 level of the 0/1 indicator; encloses the volume of the labelled voxels
///   values   the zero level of min(value - low, high - value), without the components that the focus drops; smoothing
///            keeps its volume
/// No point lies further than half a voxel from the level set. Throws Error, naming `source`, when the focus is empty;
/// Cancelled.
Surface extractSurface(const Scene& scene, const std::filesystem::path& source, const SurfaceOptions& options = {},
                       const Progress& progress = {});

/// Binary STL, binary PLY or OBJ by the file name's ending. The frame is noted in the file ("SPACE=LPS"), as 3D Slicer
/// writes and reads it. Written beside and renamed. Throws Error.
void writeSurface(const Surface& surface, const std::filesystem::path& path, SurfaceFrame frame);

}  // namespace fenestra::io
