#pragma once
// Stage 1 of a picture with several levels of importance (rendering/scene/Importance.h): what rays are opened to in
// place of the focus, or the hits of each level, where cones stand on them.

#include <vector>

#include "rendering/passes/ImportancePass.h"
#include "rendering/stages/HitStage.h"

namespace fenestra {

struct ImportanceKey {
  /// Cones: the hits of each level, for cones to stand on. Surfaces: what rays are opened to. Topmost: the most
  /// important labels, where another camera cuts the opening.
  enum class Found : std::uint8_t { Cones, Surfaces, Topmost };
  Version hits;
  Found found;
  bool operator==(const ImportanceKey&) const = default;
};

class ImportanceStage : public KeyedStage<ImportanceKey> {
 public:
  ImportanceStage(StageList& list, Eye eye, const HitStage& hits);
  bool isUsed(const Frame& frame) const override;
  void begin(const Frame& frame, Steps& steps) override;

  /// RG32F: context hits, and what a ray is opened to. None where cones stand on the levels.
  Output opened() const { return {opened_, version()}; }
  /// RG32F each, from the lowest level up: context hits, and hits of the level. Empty where no cones stand on them.
  const std::vector<gl::Texture>& levels() const { return levels_; }
  Version levelsVersion() const { return version(); }

 private:
  ImportanceKey::Found foundIn(const Frame& frame) const;

  Eye eye_;
  const HitStage& hits_;
  ImportancePass pass_{gpu().programs()};
  std::vector<gl::Texture> levels_;
  gl::Texture opened_;
};

}  // namespace fenestra
