#pragma once
// Smooth edges: which pixels they run through, and those pixels as means of several rays (rendering/scene/EdgeRays.h).

#include <optional>

#include "rendering/gl/Buffer.h"
#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/gpu/Schedule.h"
#include "rendering/passes/Steps.h"

namespace fenestra {

class EdgePass {
 public:
  explicit EdgePass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : find_("EdgePixels.comp", programs), means_("EdgeMeans.comp", programs) {}
  /// What tells where the line around a cutaway's opening is smooth by itself.
  struct OpeningRim {
    const gl::Texture& hitPoints;
    const gl::Texture& distances;
    glm::dvec2 widths;  ///< w_open, w_border in rendered pixels
  };
  /// Lists the pixels of some regions that edges run through, in no order, and copies `picture` there (both
  /// premultiplied RGBA32F). A pixel of regions that overlap may be listed twice.
  void find(Steps& steps, Schedule schedule, const gl::Texture& picture, const std::optional<OpeningRim>& opening,
            Regions regions, gl::Texture& smoothed);
  /// The number of pixels that find() has listed; waits for it.
  int count() const;
  const gl::Buffer& list() const { return list_; }
  /// Writes a batch of that list: means of `picture` and of what its rays between pixel centres have `drawn`.
  void blend(Steps& steps, Schedule schedule, const Scatter& batch, const gl::Texture& picture,
             const gl::Texture& drawn, gl::Texture& smoothed);
  std::size_t bytes() const { return list_.bytes(); }
  /// Drops the list.
  void release() { list_ = {}; }

 private:
  gl::ShaderVariants find_, means_;
  gl::Buffer list_;  ///< shaders/lib/EdgeList.glsl
};

}  // namespace fenestra
