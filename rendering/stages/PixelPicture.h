#pragma once
// The picture that the rays through the pixels' centres make.

#include "rendering/stages/WallsAroundStage.h"

namespace fenestra {

/// The last of the stages up to there that lays something over the picture or beneath it.
class PixelPicture {
 public:
  PixelPicture(const MaximumStage& seen, const CompositeStage& composite, const ExemptStage& exempt,
               const WallsAroundStage& walls)
      : seen_(seen), composite_(composite), exempt_(exempt), walls_(walls) {}

  /// Premultiplied RGBA32F.
  Output picture() const { return firstOf({walls_.picture(), exempt_.picture(), composite_.picture(), seen_.layer()}); }

 private:
  const MaximumStage& seen_;
  const CompositeStage& composite_;
  const ExemptStage& exempt_;
  const WallsAroundStage& walls_;
};

}  // namespace fenestra
