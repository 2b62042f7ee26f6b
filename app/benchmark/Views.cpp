#include "app/benchmark/Views.h"
#include "rendering/scene/VisibleFraming.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>

namespace fenestra::bench {

Scene plainScene(const Scene& scene) {
  const Volume& source = *scene.volume;
  const glm::ivec3 dims = source.grid.dims, last = dims - 1;
  auto volume = std::make_shared<Volume>();
  volume->grid = source.grid;
  volume->slope = source.slope;
  volume->intercept = source.intercept;
  volume->range = source.range;
  volume->modality = source.modality;
  source.voxels.visit([&]<class T>(std::span<const T> from) {
    volume->voxels = Voxels(scalarTypeOf<T>(), from.size());
    const std::span<T> to = volume->voxels.as<T>();
    std::copy(from.begin(), from.end(), to.begin());
    const T least = static_cast<T>((source.range.low - source.intercept) / source.slope);
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y) {
        const std::size_t row = source.grid.offset({0, y, z});
        if (z == 0 || z == last.z || y == 0 || y == last.y)
          std::fill_n(to.begin() + static_cast<std::ptrdiff_t>(row), dims.x, least);
        else
          to[row] = to[row + static_cast<std::size_t>(last.x)] = least;
      }
  });
  Scene plain = scene;
  plain.volume = std::move(volume);
  plain.labels = nullptr;
  plain.look.focus = {};
  plain.look.shading.enabled = false;
  plain.look.hideTable = false;  // others draw the whole volume
  return plain;
}

std::vector<Camera> cameraPath(const Scene& scene, int count, Projection projection) {
  const Grid framed = visibleGrid(shownVolume(scene), scene.look.context.shifted());
  std::vector<Camera> path;
  for (int i = 0; i < count; ++i) {
    // Off the axes, where rays would run along the voxels' planes and flatter everybody.
    const double turn = 0.02 + static_cast<double>(i) / count;
    path.push_back(Camera::fromAngles(360.0 * turn, 25.0 * std::sin(6.0 + 17.0 * turn), framed, projection));
  }
  return path;
}

std::vector<glm::ivec2> sampledPixels(glm::ivec2 size, int side) {
  std::vector<glm::ivec2> pixels;
  for (int y = 0; y < size.y; y += side)
    for (int x = 0; x < size.x; x += side) {
      // A hash of the block's place (the finaliser of MurmurHash3).
      auto hash = static_cast<std::uint32_t>(y) * 65537u + static_cast<std::uint32_t>(x);
      hash = (hash ^ (hash >> 16)) * 0x85ebca6bu;
      hash = (hash ^ (hash >> 13)) * 0xc2b2ae35u;
      hash ^= hash >> 16;
      const glm::ivec2 pixel(x + static_cast<int>(hash % static_cast<std::uint32_t>(side)),
                             y + static_cast<int>(hash / 4096u % static_cast<std::uint32_t>(side)));
      pixels.push_back(glm::min(pixel, size - 1));
    }
  return pixels;
}

}  // namespace fenestra::bench
