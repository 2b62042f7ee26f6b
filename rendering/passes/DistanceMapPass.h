#pragma once
// Stage 3: exact Euclidean distance in pixels from every pixel to the focus projection, or to the opening.

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/Schedule.h"
#include "rendering/passes/Steps.h"

namespace fenestra {

/// Separable and limited to a range: rows by bit scans over a packed mask, columns by an outward search that stops once
/// it cannot find a nearer pixel. Tiles with no focus within range are skipped. Squared distances are integers, so the
/// result is exact to one rounding of the square root.
class DistanceMapPass {
 public:
  explicit DistanceMapPass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : maskProgram_("FocusMask.comp", programs),
        tileProgram_("FocusTiles.comp", programs),
        rowProgram_("DistanceRows.comp", programs),
        columnProgram_("DistanceColumns.comp", programs) {}
  static constexpr float beyond = 1e30f;  ///< value of pixels farther than the range

  /// Reads `hitPoints` (RG32F), writes `distances` (R32F). `range` in pixels, ≥ 0. With `starts` (R32F), where rays
  /// start before the brush, the distance is that to all that is opened: to pixels that meet the focus, and to those
  /// whose rays start behind the context's first hit.
  void run(Steps& steps, Schedule schedule, const gl::Texture& hitPoints, int range, gl::Texture& distances,
           const gl::Texture* starts = nullptr);
  std::size_t bytes() const { return mask_.bytes() + tiles_.bytes() + rows_.bytes(); }
  /// Drops the intermediate images.
  void release() {
    mask_ = {};
    tiles_ = {};
    rows_ = {};
  }

 private:
  gl::ShaderVariants maskProgram_, tileProgram_, rowProgram_, columnProgram_;
  gl::Texture mask_, tiles_, rows_;
};

}  // namespace fenestra
