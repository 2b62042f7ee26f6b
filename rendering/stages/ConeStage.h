#pragma once
// Where rays start by the cones that a method stands on the focus, or on each level of importance.

#include "rendering/passes/ConePass.h"
#include "rendering/stages/ImportanceStage.h"

namespace fenestra {

struct ConeKey {
  Version hits;
  Version levels;
  ConePass::Cones cones;
  bool operator==(const ConeKey&) const = default;
};

class ConeStage : public KeyedStage<ConeKey> {
 public:
  ConeStage(StageList& list, Eye eye, const HitStage& hits, const ImportanceStage& levels);
  bool isUsed(const Frame& frame) const override;
  void begin(const Frame& frame, Steps& steps) override;

  /// R32F, of ConePass.
  Output starts() const { return {starts_, version()}; }
  /// RG32F, of several levels of importance: context hits, and what a ray is opened to.
  Output opened() const { return {opened_, version()}; }

 private:
  Eye eye_;
  const HitStage& hits_;
  const ImportanceStage& levels_;
  ConePass pass_{gpu().programs()};
  gl::Texture starts_, opened_;
};

}  // namespace fenestra
