#pragma once
// Lays slices that stand as walls over or beneath a picture. Walls and their colours are those of
// rendering/scene/Walls.h, how they are laid is said by MethodStages::Walls (rendering/vocabulary/MethodStages.h).

#include <optional>
#include <vector>

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/passes/Steps.h"
#include "rendering/passes/WallImages.h"

namespace fenestra {

class WallPass {
 public:
  explicit WallPass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : programs_("Walls.comp", programs) {}
  /// What walls inside the opening need: the picture's hits (RG32F) and ray starts (R32F), positions along its rays.
  struct OpenedSpace {
    const gl::Texture& hitPoints;
    const gl::Texture& rayStart;
  };
  /// Premultiplied RGBA32F.
  struct Outputs {
    gl::Texture& layer;    ///< the walls alone, where they are not hidden by each other
    gl::Texture& picture;  ///< with them
  };
  /// `scene` has walls. `opening` where they stand inside it; `picture` (premultiplied RGBA32F) is what they are laid
  /// beneath, or, inside the opening, over.
  void run(Steps& steps, const GpuScene& gpu, const Scene& scene, const ShownSlices& slices, const RayFrame& rays,
           const std::optional<OpenedSpace>& opening, const gl::Texture& picture, Regions regions,
           const Outputs& outputs);
  std::size_t bytes() const { return images_.bytes(); }
  /// Drops what the walls show.
  void release() { images_ = {}; }

 private:
  gl::ShaderVariants programs_;
  WallImages images_;
};

}  // namespace fenestra
