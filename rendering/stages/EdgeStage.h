#pragma once
// Smooth edges (rendering/scene/EdgeRays.h): which pixels they run through.

#include "rendering/passes/EdgePass.h"
#include "rendering/stages/PixelPicture.h"

namespace fenestra {

struct EdgeKey {
  Version picture;
  bool operator==(const EdgeKey&) const = default;
};

/// Finds the edges and copies the picture, into which EdgeRayStage blends what it draws.
class EdgeStage : public KeyedStage<EdgeKey> {
 public:
  EdgeStage(StageList& list, const PixelPicture& pixels, const HitStage& hits, const PictureStarts& starts);
  bool isUsed(const Frame& frame) const override;
  void begin(const Frame& frame, Steps& steps) override;

  /// The list of pixels that was found last, over all of the picture or under changed strokes.
  Version found() const { return found_; }
  /// How many there are; waits for the list.
  int count() const { return pass_.count(); }
  const gl::Buffer& list() const { return pass_.list(); }
  /// Adds the steps that write a batch of them: means of the picture and of what their rays have `drawn`.
  void blend(Steps& steps, const Scatter& batch, const gl::Texture& drawn);
  /// To be called when all of the list is blended.
  void setBlended() { isBlended_ = true; }

  /// Premultiplied RGBA32F: the picture with smooth edges, once EdgeRayStage is done.
  Output smoothed() const { return {smoothed_, version()}; }

 private:
  const PixelPicture& pixels_;
  const HitStage& hits_;
  const PictureStarts& starts_;
  EdgePass pass_{gpu().programs()};
  gl::Texture smoothed_;
  Version found_;
  bool isBlended_ = false;
};

}  // namespace fenestra
