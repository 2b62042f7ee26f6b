#pragma once
// Brush strokes as a view sees them: straight lines on the picture, and the part of the picture that a change of
// strokes reaches. See rendering/settings/BrushStroke.h for what they do there.

#include <algorithm>
#include <vector>

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/settings/BrushStroke.h"

namespace fenestra {

/// From one projected anchor to the next, or a dab where both are the same: x, y and radius in rendered pixels, and
/// view depth in mm behind the rays' anchor plane. Clipped to what can reach the picture.
struct StrokeLine {
  glm::vec4 from, to;
  bool operator==(const StrokeLine&) const = default;
};

/// An effective stroke without anything that a picture does not depend on.
struct ProjectedStroke {
  BrushMode mode = BrushMode::Restore;
  bool coversFocus = false, toSurface = false;
  float radius = 0.0f;    ///< mm
  float softness = 0.0f;  ///< share of the radius
  float effect = 0.0f;    ///< depth in mm, or amount
  std::vector<StrokeLine> lines;
  bool operator==(const ProjectedStroke&) const = default;
};
using ProjectedStrokes = std::vector<ProjectedStroke>;

/// The strokes that have an effect, in order; one that is out of view has no lines. Empty when there are none.
ProjectedStrokes project(const BrushStrokes& strokes, const RayFrame& rays);

/// Whether a line, or what lies within `margin` pixels of its rim, may reach the square of `size` pixels at `origin`.
bool reaches(const StrokeLine& line, glm::vec2 origin, float size, float margin);

/// Calls f(i, j) for the tiles of `tile` pixels a side, `count` of them, that a line may reach.
template <class F>
void forEachTileReached(const StrokeLine& line, int tile, glm::ivec2 count, float margin, F&& f) {
  const float reach = std::max(line.from.z, line.to.z) + margin, size = static_cast<float>(tile);
  const glm::vec2 low = (glm::min(glm::vec2(line.from), glm::vec2(line.to)) - reach) / size;
  const glm::vec2 high = (glm::max(glm::vec2(line.from), glm::vec2(line.to)) + reach) / size;
  const glm::ivec2 first(glm::max(glm::floor(low), glm::vec2(0.0f)));
  const glm::ivec2 last(glm::min(glm::floor(high), glm::vec2(count - 1)));
  for (int j = first.y; j <= last.y; ++j)
    for (int i = first.x; i <= last.x; ++i)
      if (reaches(line, glm::vec2(i, j) * size, size, margin)) f(i, j);
}

/// Where the picture may differ between two states of the strokes seen by one camera: the lines that only one of them
/// has, with `margin` pixels around for passes that look at neighbours. Disjoint, in whole groups of 8×8 pixels.
std::vector<gl::Region> changedRegions(const ProjectedStrokes& before, const ProjectedStrokes& after, glm::ivec2 size,
                                       int margin);

}  // namespace fenestra
