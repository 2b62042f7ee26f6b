#pragma once
// Stage 2: the focus hit of rays that miss the focus, interpolated from those that meet it.

#include <vector>

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/Schedule.h"
#include "rendering/passes/Steps.h"

namespace fenestra {

/// Pyramid interpolation of scattered pixels (Strengert, Kraus, Ertl, VMV 2006). Known pixels stay bit for bit; with no
/// known pixel at all everything is `nothing`. Any picture size.
class PullPushPass {
 public:
  explicit PullPushPass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : analysis_("PullPushAnalysis.comp", programs), synthesis_("PullPushSynthesis.comp", programs) {}
  /// Reads the y component of `hitPoints` (RG32F), writes `filled` (R32F) of the same size.
  void run(Steps& steps, Schedule schedule, const gl::Texture& hitPoints, gl::Texture& filled);
  std::size_t bytes() const;
  /// Drops the pyramid.
  void release();

 private:
  gl::ShaderVariants analysis_, synthesis_;
  std::vector<gl::Texture> known_;   ///< level 1 (half size) upwards: averages of known pixels
  std::vector<gl::Texture> filled_;  ///< the same levels without holes
};

}  // namespace fenestra
