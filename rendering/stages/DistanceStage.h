#pragma once
// Stage 3: how far each pixel is from the focus's projection, or from what cones open.

#include "rendering/passes/DistanceMapPass.h"
#include "rendering/stages/OpenedHits.h"

namespace fenestra {

struct DistanceKey {
  Version hits;
  Version cones;  ///< to whose opening the distance is; none: to the focus's projection
  int range;
  bool operator==(const DistanceKey&) const = default;
};

class DistanceStage : public KeyedStage<DistanceKey> {
 public:
  DistanceStage(StageList& list, Eye eye, const OpenedHits& opened, const ConeStage& cones);
  bool isUsed(const Frame& frame) const override { return frame.isCutFor(eye_); }
  void begin(const Frame& frame, Steps& steps) override;

  /// R32F, pixels.
  Output distances() const { return {distances_, version()}; }

 private:
  Eye eye_;
  const OpenedHits& opened_;
  const ConeStage& cones_;
  DistanceMapPass pass_{gpu().programs()};
  gl::Texture distances_;
};

}  // namespace fenestra
