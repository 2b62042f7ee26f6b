#pragma once
// What the rays of a camera are opened to.

#include "rendering/stages/ConeStage.h"

namespace fenestra {

/// The focus, or with several levels of importance, what the levels have made of it.
class OpenedHits {
 public:
  OpenedHits(const HitStage& hits, const ImportanceStage& levels, const ConeStage& cones)
      : hits_(hits), levels_(levels), cones_(cones) {}

  /// RG32F: context hits, and what a ray is opened to.
  Output hits() const { return firstOf({cones_.opened(), levels_.opened(), hits_.hits()}); }

 private:
  const HitStage& hits_;
  const ImportanceStage& levels_;
  const ConeStage& cones_;
};

}  // namespace fenestra
