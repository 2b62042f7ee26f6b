#include "rendering/gpu/StrokeLines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

namespace fenestra {
namespace {

/// A projected anchor, as in StrokeLine.
using Point = glm::dvec4;

/// More than any picture's size in pixels, and still exact enough in float32 for a profile.
constexpr double largestRadius = 1e9;

std::optional<Point> pointOf(glm::dvec3 anchor, double radius, const RayFrame& rays) {
  const double depth = rays.depthOf(anchor);
  if (rays.perspective() ? depth <= radius : depth < 0.0) return std::nullopt;
  const double pixels = std::min(radius / rays.pixelSize(depth), largestRadius);
  return Point(rays.pixelOf(anchor), pixels, depth - rays.distance());
}

/// The part of a line that can reach the picture (Liang and Barsky's clipping): far ends would cost float32 its digits.
std::optional<StrokeLine> clipped(const Point& from, const Point& to, glm::ivec2 size) {
  const double reach = std::max(from.z, to.z) + 1.0;
  double first = 0.0, last = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double low = -reach, high = size[axis] + reach, step = to[axis] - from[axis];
    if (step == 0.0) {
      if (from[axis] < low || from[axis] > high) return std::nullopt;
      continue;
    }
    const double a = (low - from[axis]) / step, b = (high - from[axis]) / step;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (!(first <= last)) return std::nullopt;
  const auto at = [&](double u) { return glm::vec4(u == 0.0 ? from : u == 1.0 ? to : glm::mix(from, to, u)); };
  return StrokeLine{at(first), at(last)};
}

ProjectedStroke projectOne(const BrushStroke& stroke, const RayFrame& rays) {
  ProjectedStroke projected;
  projected.mode = stroke.mode;
  projected.coversFocus = stroke.coversFocus;
  projected.toSurface = stroke.toSurface && stroke.mode == BrushMode::Restore;
  projected.radius = static_cast<float>(std::min(stroke.radius, 1e30));
  projected.softness = static_cast<float>(stroke.softness);
  const bool movesRays = stroke.mode == BrushMode::Restore || stroke.mode == BrushMode::Open;
  projected.effect = static_cast<float>(std::min(movesRays ? stroke.depth : stroke.amount, 1e30));
  const auto add = [&](const Point& from, const Point& to) {
    if (const auto line = clipped(from, to, rays.size())) projected.lines.push_back(*line);
  };
  std::optional<Point> previous;
  bool alone = false;  // the previous point has no line yet
  for (const glm::dvec3& anchor : stroke.anchors) {
    const std::optional<Point> point = pointOf(anchor, stroke.radius, rays);
    if (previous && point) add(*previous, *point);
    if (previous && !point && alone) add(*previous, *previous);
    alone = point && !previous;
    previous = point;
  }
  if (previous && alone) add(*previous, *previous);
  return projected;
}

/// Tiles of the picture that anything changes in.
class Tiles {
 public:
  Tiles(glm::ivec2 size, int margin)
      : size_(size),
        margin_(static_cast<float>(margin)),
        count_((size + tile - 1) / tile),
        touched_(static_cast<std::size_t>(count_.x) * static_cast<std::size_t>(count_.y)) {}

  void touch(const StrokeLine& line) {
    forEachTileReached(line, tile, count_, margin_, [&](int i, int j) { touched_[index(i, j)] = 1; });
  }

  /// Runs of tiles along a row, joined with the same run in the rows below.
  std::vector<gl::Region> regions() const {
    std::vector<gl::Region> regions, open;
    for (int j = 0; j < count_.y; ++j) {
      std::vector<gl::Region> row;
      for (int i = 0; i < count_.x;) {
        int end = i;
        while (end < count_.x && touched_[index(end, j)]) ++end;
        if (end > i) row.push_back({{i * tile, j * tile}, {(end - i) * tile, tile}});
        i = std::max(end, i + 1);
      }
      for (gl::Region& run : row) {
        const auto above = std::find_if(open.begin(), open.end(), [&](const gl::Region& other) {
          return other.origin.x == run.origin.x && other.size.x == run.size.x;
        });
        if (above == open.end()) continue;
        run.origin.y = above->origin.y;
        run.size.y += above->size.y;
        open.erase(above);
      }
      regions.insert(regions.end(), open.begin(), open.end());
      open = std::move(row);
    }
    regions.insert(regions.end(), open.begin(), open.end());
    for (gl::Region& region : regions) region.size = glm::min(region.size, size_ - region.origin);
    return regions;
  }

 private:
  static constexpr int tile = 16;  ///< pixels: whole groups of 8×8, and few regions for a brush of usual size
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(count_.x) + static_cast<std::size_t>(i);
  }

  glm::ivec2 size_;
  float margin_;
  glm::ivec2 count_;
  std::vector<std::uint8_t> touched_;
};

bool sameButLines(const ProjectedStroke& a, const ProjectedStroke& b) {
  return a.mode == b.mode && a.coversFocus == b.coversFocus && a.toSurface == b.toSurface && a.radius == b.radius &&
         a.softness == b.softness && a.effect == b.effect;
}

/// What is left of two sequences without what they begin and end with alike.
template <class T>
std::pair<std::span<const T>, std::span<const T>> differing(std::span<const T> a, std::span<const T> b) {
  const std::size_t shorter = std::min(a.size(), b.size());
  const auto prefix =
      static_cast<std::size_t>(std::mismatch(a.begin(), a.begin() + shorter, b.begin()).first - a.begin());
  a = a.subspan(prefix);
  b = b.subspan(prefix);
  const std::size_t rest = std::min(a.size(), b.size());
  std::size_t suffix = 0;
  while (suffix < rest && a[a.size() - 1 - suffix] == b[b.size() - 1 - suffix]) ++suffix;
  return {a.first(a.size() - suffix), b.first(b.size() - suffix)};
}

}  // namespace

ProjectedStrokes project(const BrushStrokes& strokes, const RayFrame& rays) {
  ProjectedStrokes projected;
  for (const BrushStroke& stroke : strokes)
    if (isEffective(stroke)) projected.push_back(projectOne(stroke, rays));
  return projected;
}

bool reaches(const StrokeLine& line, glm::vec2 origin, float size, float margin) {
  const glm::vec2 from(line.from), along = glm::vec2(line.to) - from, middle = origin + 0.5f * size;
  const float size2 = glm::dot(along, along);
  const float u = size2 > 0.0f ? std::clamp(glm::dot(middle - from, along) / size2, 0.0f, 1.0f) : 0.0f;
  // The tile's half diagonal, and a pixel for rounding.
  return glm::distance(middle, from + u * along) <= std::max(line.from.z, line.to.z) + margin + 0.7072f * size + 1.0f;
}

std::vector<gl::Region> changedRegions(const ProjectedStrokes& before, const ProjectedStrokes& after, glm::ivec2 size,
                                       int margin) {
  const auto [was, is] = differing(std::span(before), std::span(after));
  if (was.empty() && is.empty()) return {};
  Tiles tiles(size, margin);
  const auto touch = [&](std::span<const StrokeLine> lines) {
    for (const StrokeLine& line : lines) tiles.touch(line);
  };
  if (was.size() == is.size() && std::equal(was.begin(), was.end(), is.begin(), sameButLines)) {
    // Strokes that grew or shrank.
    for (std::size_t i = 0; i < was.size(); ++i) {
      const auto [gone, come] = differing(std::span(was[i].lines), std::span(is[i].lines));
      touch(gone);
      touch(come);
    }
  } else {
    for (const ProjectedStroke& stroke : was) touch(stroke.lines);
    for (const ProjectedStroke& stroke : is) touch(stroke.lines);
  }
  return tiles.regions();
}

}  // namespace fenestra
