#include "io/surface/Surface.h"

#include <dlfcn.h>

#include "io/base/Error.h"
#include "io/surface/SurfacePart.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// Loads the module once; it stays until the program ends. Found by the program's run path.
SurfaceFunctions functions(const fs::path& wantedFor) {
  static const auto get = [] {
    void* module = ::dlopen(FENESTRA_SURFACE_MODULE, RTLD_NOW | RTLD_LOCAL);
    return reinterpret_cast<GetSurfaceFunctions>(module ? ::dlsym(module, surfaceFunctionsName) : nullptr);
  }();
  if (!get)
    throw Error(wantedFor, std::string("no surface can be made: ") + FENESTRA_SURFACE_MODULE + " is missing or damaged",
                "install Fenestra again; surfaces need all of its files");
  return get();
}

}  // namespace

Surface extractSurface(const Scene& scene, const fs::path& source, const SurfaceOptions& options,
                       const Progress& progress) {
  return functions(source).extract(scene, source, options, progress);
}

void writeSurface(const Surface& surface, const fs::path& path, SurfaceFrame frame) {
  functions(path).write(surface, path, frame);
}

}  // namespace fenestra::io
