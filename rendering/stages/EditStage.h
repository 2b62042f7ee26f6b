#pragma once
// The brush: what strokes change of where rays start to see.

#include "rendering/passes/EditMapPass.h"
#include "rendering/stages/StartInputs.h"

namespace fenestra {

class EditStage : public KeyedStage<StartKey> {
 public:
  EditStage(StageList& list, Eye eye, const StartInputs& inputs);
  bool isUsed(const Frame& frame) const override;
  void begin(const Frame& frame, Steps& steps) override;

  /// RG32F, of EditMapPass; none without strokes.
  Output edits() const { return {edits_, version()}; }

 private:
  Eye eye_;
  const StartInputs& inputs_;
  EditMapPass pass_{gpu().programs()};
  gl::Texture edits_;
};

}  // namespace fenestra
