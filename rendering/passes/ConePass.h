#pragma once
// Stage 4 of the methods that stand cones on the focus: where each ray starts to see, before the brush.

#include <optional>

#include "rendering/gl/Buffer.h"
#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/gpu/Schedule.h"
#include "rendering/passes/Steps.h"

namespace fenestra {

/// On the focus hit of every pixel q stands a cone, open towards the eye. A ray that misses the focus starts where it
/// leaves the last of them (M. Burns, A. Finkelstein, SIGGRAPH Asia 2008, section 4):
///
///   C(p) = max_q (z_q - m ‖p - q‖)                 parallel rays
///   C(p) = max_q  z_q / (1 + m ‖u_p - u_q‖)        perspective
///
/// with z the view depth in mm, ‖p - q‖ in mm across the picture, u = (x, y)/z of a ray, and m the cotangent of the
/// cones' half angle. Both are the depth at which p's ray leaves a cone whose axis is q's ray and whose sections
/// parallel to the picture are circles of radius (z_q - z)/m. The second is the first one's limit for a far eye; it is
/// linear in 1/z, as depth buffers are: 1/C(p) = min_q (w_q + m w_q ‖u_p - u_q‖), w = 1/z.
///
/// The start is C(p), not before the context's first hit and not behind the box; the focus hit where the ray meets the
/// focus; `nothing` where it meets nothing.
///
/// The maximum is exact up to float32's rounding. A pyramid holds the greatest depth of each square of 2, 4, … 256
/// pixels a side; a pixel visits it from the top and leaves out every square whose greatest depth at its least distance
/// does not exceed what was found.
class ConePass {
 public:
  explicit ConePass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : depthsProgram_("ConeDepths.comp", programs),
        levelProgram_("ConeLevel.comp", programs),
        startProgram_("ConeStart.comp", programs) {}
  struct Cones {
    double slope = 1.0;         ///< m, ≥ 0
    bool onSilhouette = false;  ///< on pixels with a neighbour in the picture, of four, that does not meet the focus
    bool operator==(const Cones&) const = default;
  };
  /// One of several levels of importance (rendering/scene/Importance.h), whose hits of ImportancePass are run()'s
  /// `hitPoints`, from the lowest level up: the starts become the deepest of its own and the lower ones'. `opened`,
  /// RG32F, becomes the context hits with what a ray is opened to: the level's hit where the ray starts there,
  /// `nothing` where it starts on a cone.
  struct Level {
    gl::Texture& opened;
    bool isLowest;
  };
  /// Reads `hitPoints` (RG32F), writes `starts` (R32F). All of the focus's projection lies within `around`, which is
  /// the same for all levels.
  void run(Steps& steps, Schedule schedule, const RayFrame& rays, const gl::Texture& hitPoints,
           const gl::Region& around, const Cones& cones, gl::Texture& starts,
           const std::optional<Level>& level = std::nullopt);
  std::size_t bytes() const { return depths_.bytes(); }
  /// Drops the pyramid.
  void release() { depths_ = {}; }

 private:
  gl::ShaderVariants depthsProgram_, levelProgram_, startProgram_;
  gl::Buffer depths_;
};

}  // namespace fenestra
