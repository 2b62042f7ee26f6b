#include "rendering/stages/DistanceStage.h"

#include <algorithm>
#include <cmath>

#include "rendering/scene/EdgeRays.h"
#include "rendering/scene/Edges.h"
#include "rendering/stages/Images.h"

namespace fenestra {
namespace {

/// Distance maps reach this far (rendered pixels) or the next power of two beyond what the widths need: a slider that
/// moves within it leaves the map as it is.
constexpr int leastDistanceRange = 64;

int distanceRange(glm::dvec2 widths, glm::ivec2 size) {
  // Half a pixel more than the border's rim, which is anti-aliased.
  const double needed = std::min(widths.x + widths.y + 1.0, std::hypot(size.x, size.y));
  int range = leastDistanceRange;
  while (range < needed) range *= 2;
  return range;
}

}  // namespace

DistanceStage::DistanceStage(StageList& list, Eye eye, const OpenedHits& opened, const ConeStage& cones)
    : KeyedStage(list, Pass::DistanceMap), eye_(eye), opened_(opened), cones_(cones) {
  owns(distances_, pass_);
}

void DistanceStage::begin(const Frame& frame, Steps& steps) {
  const Sight& sight = frame.sight(eye_);
  // Between pixels the map is read up to a pixel further.
  const double between = hasSmoothEdges(frame.look(), sight.view) ? edges::distanceBeyond - 1.0 : 0.0;
  const Output hits = opened_.hits(), cones = cones_.starts();
  const DistanceKey key{.hits = hits.version,
                        .cones = cones.version,
                        .range = distanceRange(sight.widths + glm::dvec2(between, 0.0), sight.view.size)};
  update(sight, steps, key, {}, [&](Regions) {
    pass_.run(steps, gpu().schedule(), hits.image, key.range, sized(distances_, gl::Format::R32F, sight.view.size),
              cones.orNull());
  });
}

}  // namespace fenestra
