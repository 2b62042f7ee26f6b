#include "app/cli/SliceFile.h"

#include <algorithm>

#include "io/ImageWriter.h"
#include "io/VolumeWriter.h"
#include "io/base/Text.h"

namespace fenestra::cli {

bool isValueFile(const std::filesystem::path& file) { return io::lowered(file.extension().string()) == ".mha"; }

void writeValues(const std::filesystem::path& file, const SliceGeometry& geometry, int slice,
                 const std::vector<float>& values) {
  Volume volume;
  Grid& grid = volume.grid;
  grid.dims = {geometry.width, geometry.height, 1};
  grid.origin = geometry.worldFromPixel(0, 0, slice);
  int axis = 0;
  for (const glm::dvec3& step : {geometry.right, geometry.down, geometry.normal}) {
    grid.spacing[axis] = glm::length(step);
    grid.direction[axis] = step / grid.spacing[axis];
    ++axis;
  }
  volume.voxels = Voxels(ScalarType::Float32, values.size());
  std::copy(values.begin(), values.end(), volume.voxels.as<float>().begin());
  io::writeFloats(volume, file);
}

void writeGrey(const std::filesystem::path& file, glm::ivec2 size, const std::vector<float>& values, WindowLevel window,
               bool lowIsWhite) {
  io::writePng(file, size, 1, windowed(values, window, lowIsWhite));
}

}  // namespace fenestra::cli
