#pragma once
// Stage 4: where each ray starts to see.

#include <optional>

#include "rendering/stages/EditStage.h"

namespace fenestra {

class RayStartStage : public KeyedStage<StartKey> {
 public:
  RayStartStage(StageList& list, Eye eye, const StartInputs& inputs, const EditStage& edits);
  bool isUsed(const Frame& frame) const override { return frame.isCutFor(eye_); }
  void begin(const Frame& frame, Steps& steps) override;
  void release() override;

  /// R32F, of RayStartPass.
  Output starts() const { return {starts_, version()}; }

  /// How a picture differs from the one before where nothing but the width of the opening has changed.
  struct Move {
    Version before;  ///< starts() of that picture
    double reach;    ///< pixels from the focus, beyond which rays start where they did
  };
  /// Empty where something else has changed.
  const std::optional<Move>& moved() const { return moved_; }

 private:
  Eye eye_;
  const StartInputs& inputs_;
  const EditStage& edits_;
  RayStartPass pass_{gpu().programs()};
  gl::Texture starts_;
  std::optional<Move> moved_;
};

}  // namespace fenestra
