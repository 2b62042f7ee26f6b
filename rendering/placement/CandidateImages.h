#pragma once
// Measures candidate cameras on the GPU, many in one dispatch.

#include <vector>

#include "rendering/gl/ShaderProgram.h"
#include "rendering/passes/GpuScene.h"
#include "rendering/placement/FocusSurface.h"
#include "rendering/placement/Placement.h"

namespace fenestra::placement {

/// Needs the current context that `gpu` lives in. Only the tiles of an image that the focus's box projects onto are traced.
class CandidateImages {
 public:
  static constexpr int defaultSide = 128;

  /// Sums over side² images of first focus hits, one a direction; descriptors filled in but for those of
  /// describeTogether(). `surface` may be empty; else each candidate's seen points are found. `gpu` is up to date. The same
  /// call gives the same answer to the bit.
  std::vector<Candidate> measure(const GpuScene& gpu, const std::vector<glm::dvec3>& directions,
                                 const FocusSurface& surface, int side = defaultSide);

 private:
  void setSphere(const GpuScene& gpu, gl::ShaderProgram& program) const;
  void measureImages(const GpuScene& gpu, std::vector<Candidate>& candidates, int side);
  void measureVisibility(const GpuScene& gpu, const FocusSurface& surface, std::vector<Candidate>& candidates);

  gl::ShaderVariants tiles_{"CandidateTiles.comp"}, sums_{"CandidateSums.comp"}, visibility_{"CandidateVisibility.comp"};
};

}  // namespace fenestra::placement
