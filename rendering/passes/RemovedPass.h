#pragma once
// Stage 4 where the opening is cut for another camera than the picture's: what of each ray that opening removes.

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/gpu/Schedule.h"
#include "rendering/passes/Steps.h"

namespace fenestra {

/// The opening's camera has a picture with stages 1 to 4 of its own. Its face is a surface of view depths: bilinear
/// between the depths at which neighbouring rays start; a ray that meets nothing counts as the deepest of the four. A
/// point is removed where it shows in that picture in front of the face, in a square of four rays of which one starts
/// behind the context's first surface.
///
/// A ray of the picture shows the context or the focus from its first hit on, without the first two parts that are
/// removed when one begins at the hit, or else without the first one. What would show between two of them, or in front
/// of the first one, on less than 1/100 of a voxel's shortest side is removed as well: rounding makes such slivers at
/// the borders of the squares. The focus is never removed: a part ends at the ray's first focus hit, and also where it
/// ends less than half a voxel before that, or else shreds of the context would cover the focus between the opening's
/// rays. Between the borders of the squares a ray enters or leaves the opening once at most.
///
/// The border is projected onto the context's first surface, where that is no more than a voxel behind the one that the
/// opening's camera sees, or the filled focus.
class RemovedPass {
 public:
  explicit RemovedPass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : faces_("RemovedFaces.comp", programs), parts_("RemovedParts.comp", programs) {}
  /// The opening's camera and its images, as the other passes of stages 1 to 4 make them.
  struct CutImages {
    const RayFrame& rays;
    const gl::Texture& hitPoints;
    const gl::Texture& focusFilled;
    const gl::Texture& distances;
    const gl::Texture& rayStart;
    const gl::Texture* editMap;  ///< null without strokes
    double reach;                ///< pixels of the distance map that count
  };
  /// The picture's images: where rays start (R32F); from where to where they see nothing again (RG32F, as far as a
  /// float reaches where there is no such hole); the opening's distance map on the context's first surface (R32F); the
  /// factor of context layer and border in the second channel, as EditMapPass has it (RG32F, null without strokes).
  struct Outputs {
    gl::Texture& rayStart;
    gl::Texture& hole;
    gl::Texture& distances;
    gl::Texture* editMap;
  };
  /// `faces`: RGBA32F of the opening's size, for this pass alone. Without `holes` only what is removed at a ray's start
  /// is. `voxel`: mm, its shortest side.
  void run(Steps& steps, Schedule schedule, const RayFrame& rays, const gl::Texture& hitPoints,
           const CutImages& opening, bool holes, double voxel, gl::Texture& faces, const Outputs& outputs);
  /// Runs for other rays, whose images have that part, with the faces that run() has made.
  void runParts(Steps& steps, Schedule schedule, const RayFrame& rays, const gl::Texture& hitPoints,
                const CutImages& opening, bool holes, double voxel, const gl::Texture& faces, const gl::Region& region,
                const Outputs& outputs);

 private:
  gl::ShaderVariants faces_, parts_;
};

}  // namespace fenestra
