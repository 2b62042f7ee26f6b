#pragma once
// Stage 2: the focus hit of rays that miss the focus. Cones do without.

#include "rendering/passes/PullPushPass.h"
#include "rendering/stages/OpenedHits.h"

namespace fenestra {

struct FillKey {
  Version hits;
  bool operator==(const FillKey&) const = default;
};

class FillStage : public KeyedStage<FillKey> {
 public:
  FillStage(StageList& list, Eye eye, const OpenedHits& opened);
  bool isUsed(const Frame& frame) const override;
  void begin(const Frame& frame, Steps& steps) override;

  /// R32F, of PullPushPass.
  Output filled() const { return {filled_, version()}; }

 private:
  Eye eye_;
  const OpenedHits& opened_;
  PullPushPass pass_{gpu().programs()};
  gl::Texture filled_;
};

}  // namespace fenestra
