#pragma once
// Reference pictures, which take seconds each, kept in a folder from run to run.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "rendering/reference/Picture.h"
#include "rendering/scene/Scene.h"

namespace fenestra::bench {

/// Files are named by a hash of everything that the reference reads, its own sources included: a change of scene, view
/// or reference makes another file.
class TruthStore {
 public:
  /// Makes `folder`.
  explicit TruthStore(std::filesystem::path folder);

  /// Stage 1 of every pixel.
  reference::HitPoints hits(const Scene& scene, const Camera& camera, glm::ivec2 size) const;
  /// Stages 1 to 4 of every pixel; the later three are made anew.
  reference::Stages stages(const Scene& scene, const Camera& camera, glm::ivec2 size) const;
  /// The finished picture, premultiplied RGBA, of some pixels.
  std::vector<glm::dvec4> colours(const Scene& scene, const Camera& camera, glm::ivec2 size,
                                  const std::vector<glm::ivec2>& pixels) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace fenestra::bench
