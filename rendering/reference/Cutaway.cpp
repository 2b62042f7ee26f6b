#include <algorithm>
#include <cmath>
#include <limits>

#include "rendering/reference/Apart.h"
#include "rendering/reference/Importance.h"
#include "rendering/reference/Reference.h"
#include "rendering/reference/Strokes.h"
#include "rendering/reference/Unknown.h"
#include "rendering/scene/EdgeRays.h"
#include "rendering/scene/FocusCells.h"
#include "rendering/volume/Threads.h"

namespace fenestra::reference {
namespace {

std::size_t offset(glm::ivec2 size, int i, int j) {
  return static_cast<std::size_t>(j) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(i);
}

struct Level {
  glm::ivec2 size{0};
  Image pixels;
  double at(int i, int j) const { return pixels[offset(size, i, j)]; }
  double clamped(int i, int j) const { return at(std::clamp(i, 0, size.x - 1), std::clamp(j, 0, size.y - 1)); }
};

Level coarser(const Level& fine) {
  Level coarse{(fine.size + 1) / 2, {}};
  for (int j = 0; j < coarse.size.y; ++j)
    for (int i = 0; i < coarse.size.x; ++i) {
      double sum = 0.0;
      int known = 0;
      for (int y = 2 * j; y < std::min(2 * j + 2, fine.size.y); ++y)
        for (int x = 2 * i; x < std::min(2 * i + 2, fine.size.x); ++x)
          if (const double value = fine.at(x, y); !std::isnan(value)) {
            sum += value;
            ++known;
          }
      coarse.pixels.push_back(known > 0 ? sum / known : unknown);
    }
  return coarse;
}

/// `coarse` has no unknown pixels.
void fillFrom(const Level& coarse, Level& fine) {
  for (int j = 0; j < fine.size.y; ++j)
    for (int i = 0; i < fine.size.x; ++i) {
      double& pixel = fine.pixels[offset(fine.size, i, j)];
      if (!std::isnan(pixel)) continue;
      // The block the pixel lies in, and the neighbours on the pixel's side of it.
      const int x = i / 2, y = j / 2, nextX = i % 2 ? x + 1 : x - 1, nextY = j % 2 ? y + 1 : y - 1;
      pixel = (9.0 * coarse.at(x, y) + 3.0 * coarse.clamped(nextX, y) + 3.0 * coarse.clamped(x, nextY) +
               coarse.clamped(nextX, nextY)) /
              16.0;
    }
}

/// Corners of the focus's bounding box in index space; low > high when there is no focus.
struct IndexBox {
  glm::ivec3 low{std::numeric_limits<int>::max()}, high{std::numeric_limits<int>::min()};
  void add(glm::ivec3 index) {
    low = glm::min(low, index);
    high = glm::max(high, index);
  }
  bool empty() const { return low.x > high.x; }
};

template <class Contains>
IndexBox boxOf(glm::ivec3 dims, const Contains& contains) {
  IndexBox box;
  glm::ivec3 index;
  for (index.z = 0; index.z < dims.z; ++index.z)
    for (index.y = 0; index.y < dims.y; ++index.y)
      for (index.x = 0; index.x < dims.x; ++index.x)
        if (contains(index)) box.add(index);
  return box;
}

IndexBox focusBox(const Scene& scene) {
  const glm::ivec3 dims = scene.volume->grid.dims;
  if (const auto* focus = std::get_if<LabelFocus>(&scene.look.focus); focus && scene.labels)
    return boxOf(dims, [&](glm::ivec3 index) {
      return std::binary_search(focus->labels.begin(), focus->labels.end(), scene.labels->value(index));
    });
  if (const auto* focus = std::get_if<ValueFocus>(&scene.look.focus)) {
    const FocusCells cells = focusCells(shownVolume(scene), *focus);
    IndexBox box = boxOf(cells.dims, [&](glm::ivec3 cell) { return cells.contains(cell); });
    if (!box.empty()) box.high = glm::min(box.high + 1, dims - 1);  // a cell ends at its upper corners
    return box;
  }
  return {};
}

double pixelsPerMillimetre(const Scene& scene, const Camera& camera, glm::ivec2 size) {
  if (camera.projection == Projection::Orthographic) return size.y / camera.orthographicHeight;
  const Grid& grid = scene.volume->grid;
  const glm::dvec3 forward = camera.axes().forward;
  double depth = 0.0;
  if (const IndexBox box = focusBox(scene); !box.empty()) {
    const glm::dvec3 centre = 0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high));
    depth = glm::dot(glm::dvec3(grid.worldFromIndex() * glm::dvec4(centre, 1.0)) - camera.eye, forward);
  }
  if (depth <= 0.0) depth = glm::dot(grid.centre() - camera.eye, forward);
  // A focus at the eye itself would make every width infinite.
  depth = std::max(depth, 1e-3 * grid.boundingRadius());
  return 0.5 * size.y / (std::tan(0.5 * glm::radians(camera.verticalFov)) * depth);
}

}  // namespace

Image fill(const Image& tFocus, glm::ivec2 size) {
  if (std::all_of(tFocus.begin(), tFocus.end(), [](double t) { return std::isnan(t); })) return tFocus;
  std::vector<Level> pyramid{{size, tFocus}};
  while (pyramid.back().size != glm::ivec2(1)) pyramid.push_back(coarser(pyramid.back()));
  for (std::size_t level = pyramid.size() - 1; level > 0; --level) fillFrom(pyramid[level], pyramid[level - 1]);
  return pyramid.front().pixels;
}

Image distanceMap(const Image& tFocus, glm::ivec2 size, double range) {
  // Squared distances are sums of two squares: first the nearest known pixel in each column, then the best column.
  Image column(tFocus.size(), infinity);
  const auto carry = [&](int j, int neighbour) {
    for (int i = 0; i < size.x; ++i) {
      double& nearest = column[offset(size, i, j)];
      if (!std::isnan(tFocus[offset(size, i, j)]))
        nearest = 0.0;
      else if (neighbour >= 0 && neighbour < size.y)
        nearest = std::min(nearest, column[offset(size, i, neighbour)] + 1.0);
    }
  };
  for (int j = 0; j < size.y; ++j) carry(j, j - 1);
  for (int j = size.y - 1; j >= 0; --j) carry(j, j + 1);
  Image result(tFocus.size(), infinity);
  const int reach = static_cast<int>(std::min(std::ceil(range), static_cast<double>(size.x)));
  parallelFor(static_cast<std::size_t>(size.y), 1, [&](std::size_t begin, std::size_t end) {
    for (int j = static_cast<int>(begin); j < static_cast<int>(end); ++j)
      for (int i = 0; i < size.x; ++i) {
        double squared = infinity;
        for (int k = std::max(i - reach, 0); k <= std::min(i + reach, size.x - 1); ++k) {
          const double across = i - k, along = column[offset(size, k, j)];
          squared = std::min(squared, across * across + along * along);
        }
        const double distance = std::sqrt(squared);
        if (distance <= range) result[offset(size, i, j)] = distance;
      }
  });
  return result;
}

Image rayStart(const HitPoints& hits, const Image& tFocusFilled, const Image& distance, double openWidth) {
  Image start = hits.tContext;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const double context = hits.tContext[i];
    if (std::isnan(context)) continue;
    if (!std::isnan(hits.tFocus[i]))
      start[i] = hits.tFocus[i];
    else if (openWidth > 0.0 && distance[i] <= openWidth)
      start[i] = glm::mix(tFocusFilled[i], context, distance[i] / openWidth);
    start[i] = std::clamp(start[i], context, std::max(context, hits.tOut[i]));
  }
  return start;
}

Widths widthsInPixels(const Scene& scene, const Camera& camera, glm::ivec2 size, double pixelScale) {
  const double scale =
      scene.look.cutaway.unit == WidthUnit::Pixel ? pixelScale : pixelsPerMillimetre(scene, camera, size);
  const MethodStages method = stagesOf(scene.look.method);
  return {method.hasWidth ? scene.look.cutaway.openWidth * scale : 0.0,
          method.hasBorder ? scene.look.cutaway.borderWidth * scale : 0.0};
}

glm::dvec3 focusCentre(const Scene& scene) {
  const Grid& grid = scene.volume->grid;
  const IndexBox box = focusBox(scene);
  if (box.empty()) return grid.centre();
  return glm::dvec3(grid.worldFromIndex() * glm::dvec4(0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high)), 1.0));
}

Stages geometricStages(const Scene& scene, const Camera& camera, glm::ivec2 size, double pixelScale) {
  Stages stages;
  stages.hits = hitPoints(scene, camera, size);
  stages.tStart = stages.hits.tContext;
  if (!hasCutaway(scene)) return stages;
  const Widths widths = widthsInPixels(scene, camera, size, pixelScale);
  const MethodStages method = stagesOf(scene.look.method);
  const bool onCones = method.start == MethodStages::Start::Cones;
  const std::vector<Image> levels = importantHits(scene, camera, size, stages.hits, centresOf(size));
  if (onCones && !levels.empty()) {
    ImportantStarts starts = importantStarts(stages.hits, levels, camera, size, method);
    stages.tStart = stages.tCones = std::move(starts.tStart);
    stages.hits.tFocus = std::move(starts.tOpened);
  } else if (onCones) {
    stages.tStart = stages.tCones = coneStart(stages.hits, camera, size, method.slope, method.onSilhouette);
  } else {
    if (!levels.empty()) stages.hits.tFocus = highestHits(levels);
    stages.tFocusFilled = fill(stages.hits.tFocus, size);
  }
  stages.distance = distanceMap(openedBy(stages), size, widths.open + widths.border);
  if (stages.tCones.empty()) stages.tStart = rayStart(stages.hits, stages.tFocusFilled, stages.distance, widths.open);
  if (std::any_of(scene.look.strokes.begin(), scene.look.strokes.end(), isEffective)) {
    Edits made = edits(scene.look.strokes, camera, size, stages.hits, stages.tStart);
    stages.tStart = std::move(made.tStart);
    stages.editOffset = std::move(made.offset);
    stages.editFactor = std::move(made.factor);
  }
  return stages;
}

namespace {

/// Between pixel centres, bilinear, constant beyond the outermost ones.
class Between {
 public:
  Between(glm::ivec2 size, glm::dvec2 place) : size_(size) {
    const glm::dvec2 texel = place - 0.5;
    first_ = glm::ivec2(glm::floor(texel));
    share_ = texel - glm::dvec2(first_);
  }
  template <class ValueAt>
  double value(const ValueAt& valueAt) const {
    const auto at = [&](int i, int j) {
      const glm::ivec2 pixel = glm::clamp(first_ + glm::ivec2(i, j), glm::ivec2(0), size_ - 1);
      return valueAt(offset(size_, pixel.x, pixel.y));
    };
    return glm::mix(glm::mix(at(0, 0), at(1, 0), share_.x), glm::mix(at(0, 1), at(1, 1), share_.x), share_.y);
  }

 private:
  glm::ivec2 size_, first_;
  glm::dvec2 share_;
};

Stages openedBetween(const Scene& scene, const Camera& camera, glm::ivec2 size, const Stages& pixels, double pixelScale,
                     const std::vector<glm::dvec2>& places) {
  const Widths widths = widthsInPixels(scene, camera, size, pixelScale);
  const double reach = widths.open + widths.border + edges::distanceBeyond;
  const Image filled = fill(pixels.hits.tFocus, size), distances = distanceMap(pixels.hits.tFocus, size, reach);
  Stages stages;
  stages.hits = hitPoints(scene, camera, size, places);
  for (const glm::dvec2 place : places) {
    const Between between(size, place);
    stages.tFocusFilled.push_back(between.value([&](std::size_t at) { return filled[at]; }));
    stages.distance.push_back(between.value([&](std::size_t at) { return std::min(distances[at], reach); }));
  }
  stages.tStart = rayStart(stages.hits, stages.tFocusFilled, stages.distance, widths.open);
  if (std::any_of(scene.look.strokes.begin(), scene.look.strokes.end(), isEffective)) {
    Edits made = edits(scene.look.strokes, camera, size, stages.hits, stages.tStart, places);
    stages.tStart = std::move(made.tStart);
    stages.editOffset = std::move(made.offset);
    stages.editFactor = std::move(made.factor);
  }
  // No line around the opening on the focus itself.
  for (std::size_t i = 0; i < places.size(); ++i)
    if (!std::isnan(stages.hits.tFocus[i])) stages.distance[i] = 0.0;
  return stages;
}

}  // namespace

Stages stagesBetween(const Scene& scene, const Camera& camera, glm::ivec2 size, const Stages& pixels, double pixelScale,
                     const std::vector<glm::dvec2>& places) {
  return pixels.apart ? stagesApart(scene, camera, size, pixels.apart->opening, places)
                      : openedBetween(scene, camera, size, pixels, pixelScale, places);
}

}  // namespace fenestra::reference
