#pragma once
// Stages 1 to 4 of the method along the rays of one camera.

#include "rendering/stages/RayStartStage.h"

namespace fenestra {

/// In the order in which they are begun.
struct StartStages {
  StartStages(StageList& list, Eye eye)
      : hits(list, eye),
        levels(list, eye, hits),
        cones(list, eye, hits, levels),
        opened(hits, levels, cones),
        fill(list, eye, opened),
        distances(list, eye, opened, cones),
        inputs(opened, cones, fill, distances),
        edits(list, eye, inputs),
        starts(list, eye, inputs, edits) {}

  HitStage hits;
  ImportanceStage levels;
  ConeStage cones;
  OpenedHits opened;
  FillStage fill;
  DistanceStage distances;
  StartInputs inputs;
  EditStage edits;
  RayStartStage starts;

  /// R32F: the deepest that rays start beside the focus's projection.
  Output surface() const { return firstOf({cones.starts(), fill.filled()}); }
};

}  // namespace fenestra
