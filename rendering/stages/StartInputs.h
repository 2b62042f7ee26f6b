#pragma once
// What decides where a ray starts to see, before the brush.

#include "rendering/passes/RayStartPass.h"
#include "rendering/stages/DistanceStage.h"
#include "rendering/stages/FillStage.h"

namespace fenestra {

struct StartKey {
  Version hits, filled, distances, cones;  ///< none for what does not decide
  double openWidth;
  bool operator==(const StartKey&) const = default;
};

class StartInputs {
 public:
  StartInputs(const OpenedHits& opened, const ConeStage& cones, const FillStage& fill, const DistanceStage& distances)
      : opened_(opened), cones_(cones), fill_(fill), distances_(distances) {}

  StartKey key(const Sight& sight) const {
    return {.hits = opened_.hits().version,
            .filled = fill_.filled().version,
            .distances = distances_.distances().version,
            .cones = cones_.starts().version,
            .openWidth = sight.widths.x};
  }
  RayStartPass::Inputs of(const Sight& sight) const {
    return {.hitPoints = opened_.hits().image,
            .focusFilled = fill_.filled().image,
            .distances = distances_.distances().image,
            .openWidth = sight.widths.x,
            .given = cones_.starts().orNull()};
  }

 private:
  const OpenedHits& opened_;
  const ConeStage& cones_;
  const FillStage& fill_;
  const DistanceStage& distances_;
};

}  // namespace fenestra
