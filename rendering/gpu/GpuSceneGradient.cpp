// Which voxels the lighting of a scene needs normals of, and the textures that hold them.

#include <algorithm>
#include <cmath>

#include "rendering/gpu/GpuScene.h"
#include "rendering/scene/Lighting.h"
#include "rendering/volume/Threads.h"

namespace fenestra {

double GpuScene::leastChange() const {
  // It may span two bricks, and has three components.
  return lighting::gradientGateLow * (shown_.volume->range.high - shown_.volume->range.low) /
         (2.0 * std::sqrt(3.0) * refinement_);
}

bool GpuScene::isLitFor(const std::vector<std::size_t>& bricks) const {
  if (refinement_ > 1) return bricks.empty();
  const double least = leastChange();
  const glm::ivec3 dims = bricks_.dims, last = shown_.volume->grid.dims - 1;
  return std::all_of(bricks.begin(), bricks.end(), [&](std::size_t offset) {
    const ValueRange& range = bricks_.ranges[offset];
    if (!(range.high - range.low >= least)) return true;
    const auto x = static_cast<std::size_t>(dims.x), y = static_cast<std::size_t>(dims.y);
    const glm::ivec3 low = glm::ivec3(offset % x, offset / x % y, offset / (x * y)) * brickSide - 1;
    return gradientBox_ && glm::all(glm::lessThanEqual(gradientBox_->low, glm::max(low, 0))) &&
           glm::all(glm::greaterThanEqual(gradientBox_->high, glm::min(low + brickSide, last)));
  });
}

std::optional<IndexBox> GpuScene::variedBox(bool shown) const {
  const double least = leastChange();
  const bool hasFocus = shown && focus_.index().kind != FocusIndex::Kind::None;
  const std::vector<OctantMask> inFocus = hasFocus ? drawnOccupied(focus_.index()) : std::vector<OctantMask>();
  std::vector<std::optional<IndexBox>> layers(static_cast<std::size_t>(bricks_.dims.z));
  parallelFor(layers.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t z = begin; z < end; ++z)
      for (int y = 0; y < bricks_.dims.y; ++y) {
        const std::size_t row = brickOffset(bricks_.dims, {0, y, static_cast<int>(z)});
        const auto isIn = [&](int x) {
          const std::size_t brick = row + static_cast<std::size_t>(x);
          const ValueRange& range = bricks_.ranges[brick];
          return range.high - range.low >= least &&
                 (!shown || contextOccupied_[brick] || (hasFocus && inFocus[brick] != 0));
        };
        int first = 0, last = bricks_.dims.x - 1;
        while (first <= last && !isIn(first)) ++first;
        if (first > last) continue;
        while (!isIn(last)) --last;
        for (const int x : {first, last}) {
          const glm::ivec3 low = glm::ivec3(x, y, static_cast<int>(z)) * brickSide - 1;
          grow(layers[z], low, low + brickSide);
        }
      }
  });
  std::optional<IndexBox> box;
  for (const std::optional<IndexBox>& layer : layers)
    if (layer) grow(box, layer->low, layer->high);
  if (box) box = IndexBox{glm::max(box->low, glm::ivec3(0)), glm::min(box->high, drawnGrid().dims - 1)};
  return box;
}

void GpuScene::updateGradient(const GpuFocus::Change& focus, bool occupancyChanged) {
  if (gradient_.texture && gradientIsWhole_) return;
  if (gradient_.texture && !occupancyChanged && !focus.isNew && isLitFor(focus.flipped)) return;
  const auto contains = [](const std::optional<IndexBox>& outer, const std::optional<IndexBox>& inner) {
    return !inner || (outer && glm::all(glm::lessThanEqual(outer->low, inner->low)) &&
                      glm::all(glm::greaterThanEqual(outer->high, inner->high)));
  };
  // Lighting asks for gradients where something shows and values vary by more than noise.
  std::optional<IndexBox> wanted = variedBox(true);
  if (gradient_.texture && contains(gradientBox_, wanted)) return;
  const std::optional<IndexBox> varied = variedBox(false);
  // More shows than at first: all that can ever be asked for, so that dragging a transfer function rebuilds but once.
  if (gradient_.texture) wanted = varied;
  gradientIsWhole_ = contains(wanted, varied);
  gradient_ = {};
  gradientBox_ = wanted;
  if (spline_) {
    std::optional<SplineVectors> normals;
    together([&] { gradient_ = refinedGradientFor(grid().dims, refinement_, wanted); },
             [&] { normals.emplace(gatedNormals(*shown_.volume, *spline_)); });
    fillRefinedGradient(gradient_, *normals, refinement_, wanted);
    if (!normalCoefficients_) normalCoefficients_ = makeCoefficients(*normals);
  } else {
    gradient_ = makeGradientTexture(shown_, wanted);
  }
  ++versions_.gradient;
}

}  // namespace fenestra
