#pragma once
// Stage 1 of a picture with several levels of importance: first hits of the labels of a level or more.

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/passes/Steps.h"

namespace fenestra {

/// H_k of rendering/scene/Importance.h.
class ImportancePass {
 public:
  explicit ImportancePass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : programs_("ImportantHits.comp", programs) {}
  /// Reads `hitPoints` of HitPointPass, writes `hits` of the same size: RG32F (s_context, H_k). `isHigher`: rays that
  /// miss the level keep what `hits` has of a lower one.
  void run(Steps& steps, const GpuScene& gpu, const KeptLabels& level, const RayFrame& rays,
           const gl::Texture& hitPoints, gl::Texture& hits, bool isHigher = false);

 private:
  gl::ShaderVariants programs_;
};

}  // namespace fenestra
