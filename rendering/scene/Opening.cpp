#include "rendering/scene/Opening.h"

#include <cmath>

#include "rendering/volume/Threads.h"

namespace fenestra {

std::vector<char> openedPixels(const RayStarts& starts, const SliceGeometry& geometry, int slice) {
  const auto width = static_cast<std::size_t>(geometry.width);
  std::vector<char> opened(width * static_cast<std::size_t>(geometry.height), 0);
  const glm::dvec2 size(starts.size);
  if (starts.size.x < 1 || starts.size.y < 1 || starts.tStart.empty()) return opened;
  const Camera& camera = starts.camera;
  const glm::dmat4 clipFromWorld = camera.clipFromWorld(size.x / size.y, starts.grid);
  const glm::dvec3 forward = camera.axes().forward;
  // A ray that starts where it meets the context removes nothing; a tenth of a millimetre is rounding.
  constexpr double least = 0.1;
  parallelFor(static_cast<std::size_t>(geometry.height), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j)
      for (std::size_t i = 0; i < width; ++i) {
        const glm::dvec3 world = geometry.worldFromPixel(static_cast<double>(i), static_cast<double>(j), slice);
        const glm::dvec4 clip = clipFromWorld * glm::dvec4(world, 1.0);
        if (!(clip.w > 0.0)) continue;
        const glm::dvec2 pixel(0.5 * (clip.x / clip.w + 1.0) * size.x, 0.5 * (1.0 - clip.y / clip.w) * size.y);
        if (!(pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < size.x && pixel.y < size.y)) continue;
        const std::size_t at = static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(starts.size.x) +
                               static_cast<std::size_t>(pixel.x);
        const double t = camera.projection == Projection::Perspective ? glm::distance(world, camera.eye)
                                                                      : glm::dot(world - camera.eye, forward);
        const double context = starts.tContext[at], start = starts.tStart[at];
        // Comparisons with NaN are false: such rays remove nothing.
        opened[j * width + i] = start > context + least && t >= context && t < start;
      }
  });
  return opened;
}

}  // namespace fenestra
