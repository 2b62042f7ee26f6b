#pragma once
// Where the picture's rays start to see, whichever camera cuts the opening.

#include "rendering/stages/RemovedStage.h"

namespace fenestra {

/// Stages 1 to 4 as later stages read them. Either the picture's own camera cuts the opening, or RemovedStage carries
/// over what another one has cut; the stage that is not used has no images.
class PictureStarts {
 public:
  PictureStarts(const StartStages& own, const RemovedStage& removed) : own_(own), removed_(removed) {}

  /// RG32F: context hits, and what a ray is opened to.
  Output hits() const { return own_.opened.hits(); }
  /// R32F, positions along the rays.
  Output starts() const { return firstOf({own_.starts.starts(), removed_.starts()}); }
  /// R32F, pixels from the focus's projection or from the opening.
  Output distances() const { return firstOf({own_.distances.distances(), removed_.distances()}); }
  /// RG32F, of EditMapPass; none without strokes.
  Output edits() const { return firstOf({own_.edits.edits(), removed_.edits()}); }
  /// RG32F, of RemovedPass; null where the picture's own camera cuts the opening.
  const gl::Texture* hole() const { return removed_.hole().orNull(); }

 private:
  const StartStages& own_;
  const RemovedStage& removed_;
};

}  // namespace fenestra
