#pragma once
// What the part that links VTK gives the programs: a module that they load when they need it.

#include <filesystem>

#include "io/base/Reading.h"
#include "io/surface/Triangles.h"
#include "rendering/scene/Scene.h"

namespace fenestra::io {

/// What extractSurface() and writeSurface() call.
Surface extractWithVtk(const Scene& scene, const std::filesystem::path& source, const SurfaceOptions& options,
                       const Progress& progress);
void writeWithVtk(const Surface& surface, const std::filesystem::path& path, SurfaceFrame frame);

struct SurfaceFunctions {
  decltype(&extractWithVtk) extract;
  decltype(&writeWithVtk) write;
};

/// The module's only exported function, by this name.
inline constexpr const char* surfaceFunctionsName = "fenestraSurfaceFunctions";
using GetSurfaceFunctions = SurfaceFunctions (*)();

}  // namespace fenestra::io
