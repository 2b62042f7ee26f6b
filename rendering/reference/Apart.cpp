// The parts of a camera's rays that the opening of another camera removes: rendering/passes/RemovedPass.h in double
// precision.

#include <algorithm>
#include <array>
#include <cmath>

#include "rendering/reference/Apart.h"
#include "rendering/reference/Importance.h"
#include "rendering/reference/Unknown.h"
#include "rendering/volume/Threads.h"

namespace fenestra::reference {
namespace {

/// Shares of a voxel's shortest side: the longest piece that does not show between two removed parts, or between one
/// and the focus; and how far behind the surface that the opening's camera sees the border shows.
constexpr double sliver = 0.01, skin = 0.5, behind = 1.0;

/// A plane through the eye, or along parallel rays: n·x + d, a point's distance from it times a factor.
struct Plane {
  glm::dvec3 normal{0.0};
  double offset = 0.0;
  double at(glm::dvec3 point) const { return glm::dot(normal, point) + offset; }
};

/// The picture that the opening is cut for, and its stages.
class Opening {
 public:
  Opening(const Scene& scene, const OpeningView& view)
      : camera_(view.camera),
        axes_(view.camera.axes()),
        size_(view.size),
        stages_(geometricStages(scene, view.camera, view.size, view.pixelScale)),
        widths_(widthsInPixels(scene, view.camera, view.size, view.pixelScale)) {
    const glm::dvec3 spacing = scene.volume->grid.spacing;
    voxel_ = std::min({spacing.x, spacing.y, spacing.z});
    const double reach = widths_.open + widths_.border + 1.0;
    distance_ = distanceMap(openedBy(stages_), size_, reach);
    for (double& distance : distance_) distance = std::min(distance, reach);
    if (perspective()) {
      const Grid& grid = scene.volume->grid;
      nearest_ = 1e-3 * std::max(depthOf(grid.centre()), grid.boundingRadius());
    }
  }

  const Widths& widths() const { return widths_; }
  const Stages& stages() const { return stages_; }
  double voxel() const { return voxel_; }
  bool hasEdits() const { return !stages_.editFactor.empty(); }

  bool shows(glm::dvec3 point) const {
    const glm::dvec2 texel = texelOf(point);
    return depthOf(point) >= nearest_ && glm::all(glm::greaterThanEqual(texel, glm::dvec2(-0.5))) &&
           glm::all(glm::lessThanEqual(texel, glm::dvec2(size_) - 0.5));
  }

  /// The parts of a ray that the opening removes between two times, in order.
  std::vector<Span> removed(const Ray& ray, Span span) const {
    std::vector<Span> parts;
    const std::vector<double> times = bordersOf(ray, span);
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      const double middle = 0.5 * (times[i] + times[i + 1]);
      if (!(times[i] < times[i + 1]) || !shows(pointAt(ray, middle))) continue;
      const glm::ivec2 square(glm::floor(texelOf(pointAt(ray, middle))));
      const Span part = removedIn(ray, square, {times[i], times[i + 1]});
      if (!(part.tIn < part.tOut)) continue;
      if (!parts.empty() && part.tIn <= parts.back().tOut + sliver * voxel_)
        parts.back().tOut = part.tOut;
      else
        parts.push_back(part);
    }
    return parts;
  }

  /// The distance map where a point of the context's surface shows; +inf behind what the opening's camera sees.
  double distanceAt(glm::dvec3 point) const {
    const auto depth = [&](const Image& times) {
      const double found = bilinear(point, [&](std::size_t at, double perTime) { return times[at] * perTime; });
      return std::isnan(found) ? -infinity : found;
    };
    const double deepest = std::max(depth(surface()), depth(stages_.hits.tContext)) + behind * voxel_;
    if (!(depthOf(point) <= deepest)) return infinity;
    const double distance = bilinear(point, [&](std::size_t at, double) { return distance_[at]; });
    return distance < 0.5 ? 0.0 : distance;
  }
  double factorAt(glm::dvec3 point) const {
    return bilinear(point, [&](std::size_t at, double) { return stages_.editFactor[at]; });
  }

  static glm::dvec3 pointAt(const Ray& ray, double t) { return ray.origin + t * ray.direction; }

 private:
  /// The deepest places where rays of the opening's picture may start beside the focus's projection.
  const Image& surface() const { return stages_.tCones.empty() ? stages_.tFocusFilled : stages_.tCones; }
  bool perspective() const { return camera_.projection == Projection::Perspective; }
  double depthOf(glm::dvec3 point) const { return glm::dot(point - camera_.eye, axes_.forward); }
  /// mm on a plane of depth 1 (perspective), or on any, from the middle to the top of the picture.
  double halfHeight() const {
    return perspective() ? std::tan(0.5 * glm::radians(camera_.verticalFov)) : 0.5 * camera_.orthographicHeight;
  }

  /// In pixels from the centre of the first one.
  glm::dvec2 texelOf(glm::dvec3 point) const {
    const glm::dvec3 from = point - camera_.eye;
    const double scale = 0.5 * size_.y / (halfHeight() * (perspective() ? depthOf(point) : 1.0));
    return 0.5 * (glm::dvec2(size_) - 1.0) + scale * glm::dvec2(glm::dot(from, axes_.right), -glm::dot(from, axes_.up));
  }

  /// The plane of all points at a texel coordinate along x or y.
  Plane planeAt(int axis, double texel) const {
    const double side = (texel - 0.5 * (size_[axis] - 1)) * halfHeight() / (0.5 * size_.y);
    Plane plane{axis == 0 ? axes_.right : -axes_.up, 0.0};
    if (perspective())
      plane.normal -= side * axes_.forward;
    else
      plane.offset = -side;
    plane.offset -= glm::dot(plane.normal, camera_.eye);
    return plane;
  }

  /// Ends of a span and what lies between them: where the ray meets the picture's rim, the near plane, and the borders
  /// of the squares between pixel centres.
  std::vector<double> bordersOf(const Ray& ray, Span span) const {
    std::vector<double> times{span.tIn, span.tOut};
    const auto add = [&](const Plane& plane) {
      const double t = -plane.at(ray.origin) / glm::dot(plane.normal, ray.direction);
      if (t > span.tIn && t < span.tOut) times.push_back(t);
    };
    for (int axis = 0; axis < 2; ++axis) {
      for (int k = 0; k < size_[axis]; ++k) add(planeAt(axis, k));
      add(planeAt(axis, -0.5));
      add(planeAt(axis, size_[axis] - 0.5));
    }
    add({axes_.forward, -glm::dot(axes_.forward, camera_.eye) - nearest_});
    std::sort(times.begin(), times.end());
    return times;
  }

  std::size_t pixel(glm::ivec2 texel) const {
    texel = glm::clamp(texel, glm::ivec2(0), size_ - 1);
    return static_cast<std::size_t>(texel.y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(texel.x);
  }
  static glm::ivec2 corner(glm::ivec2 square, int i) { return square + glm::ivec2(i & 1, i >> 1); }
  /// Depth of t = 1 on the ray of a pixel.
  double depthPerTime(std::size_t at) const {
    const glm::ivec2 texel(static_cast<int>(at) % size_.x, static_cast<int>(at) / size_.x);
    return glm::dot(pixelRay(camera_, size_, texel).direction, axes_.forward);
  }

  static double mixed(const std::array<double, 4>& corners, glm::dvec2 at) {
    return glm::mix(glm::mix(corners[0], corners[1], at.x), glm::mix(corners[2], corners[3], at.x), at.y);
  }
  template <class ValueAt>
  double bilinear(glm::dvec3 point, const ValueAt& valueAt) const {
    const glm::dvec2 texel = texelOf(point);
    const glm::ivec2 square(glm::floor(texel));
    std::array<double, 4> corners;
    for (int i = 0; i < 4; ++i) {
      const std::size_t at = pixel(corner(square, i));
      corners[static_cast<std::size_t>(i)] = valueAt(at, depthPerTime(at));
    }
    return mixed(corners, texel - glm::dvec2(square));
  }

  Span removedIn(const Ray& ray, glm::ivec2 square, Span span) const {
    constexpr Span none{1.0, 0.0};
    std::array<double, 4> depths;
    bool open = false;
    double deepest = -infinity;
    for (int i = 0; i < 4; ++i) {
      const std::size_t at = pixel(corner(square, i));
      const double start = stages_.tStart[at];
      open |= start > stages_.hits.tContext[at];
      depths[static_cast<std::size_t>(i)] = start * depthPerTime(at);
      if (!std::isnan(start)) deepest = std::max(deepest, depths[static_cast<std::size_t>(i)]);
    }
    if (!open) return none;
    for (double& depth : depths)
      if (std::isnan(depth)) depth = deepest;
    const auto isBefore = [&](double t) {
      const glm::dvec3 point = pointAt(ray, t);
      const glm::dvec2 at = glm::clamp(texelOf(point) - glm::dvec2(square), glm::dvec2(0.0), glm::dvec2(1.0));
      return mixed(depths, at) > depthOf(point);
    };
    const bool first = isBefore(span.tIn), last = isBefore(span.tOut);
    if (first == last) return first ? span : none;
    double low = span.tIn, high = span.tOut;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (isBefore(middle) == first ? low : high) = middle;
    }
    return first ? Span{span.tIn, low} : Span{high, span.tOut};
  }

  Camera camera_;
  Camera::Axes axes_;
  glm::ivec2 size_;
  Stages stages_;
  Widths widths_;
  Image distance_;
  double voxel_ = 0.0;    ///< mm, its shortest side
  double nearest_ = 0.0;  ///< depth before which nothing is removed
};

/// Where a ray starts, and the hole behind its start.
struct Visible {
  double start = unknown, holeBegin = infinity, holeEnd = infinity;
};

Visible visibleOf(const std::vector<Span>& removed, double tContext, double tFocus, bool holes, double voxel) {
  Visible result{.start = tContext};
  auto next = removed.begin();
  if (next != removed.end() && next->tIn <= tContext + sliver * voxel) result.start = (next++)->tOut;
  if (holes && next != removed.end()) {
    result.holeBegin = next->tIn;
    result.holeEnd = next->tOut;
  }
  if (!std::isnan(tFocus)) {
    if (result.start > tContext && result.start > tFocus - skin * voxel) result.start = tFocus;
    if (result.holeBegin < tFocus && result.holeEnd > tFocus - skin * voxel) result.holeEnd = tFocus;
  }
  return result;
}

}  // namespace

Stages stagesApart(const Scene& scene, const Camera& camera, glm::ivec2 size, const OpeningView& cut,
                   const std::vector<glm::dvec2>& places) {
  const Opening opening(scene, cut);
  // A layer in front of the picture holds what is removed at the ray's start alone.
  const bool holes = labelsWith(LabelRole::Protected, scene).empty() && !stagesOf(scene.look.method).keepsRemoved();
  Stages stages;
  stages.hits = hitPoints(scene, camera, size, places);
  // Only what is most important is never removed.
  if (auto levels = importantHits(scene, camera, size, stages.hits, places); !levels.empty())
    stages.hits.tFocus = std::move(levels.back());
  stages.tStart = stages.hits.tContext;
  const std::size_t count = stages.tStart.size();
  stages.apart =
      Apart{Image(count, infinity),         Image(count, infinity), Image(count, infinity), opening.widths(), cut,
            opening.stages().hits.tContext, opening.stages().tStart};
  if (opening.hasEdits()) stages.editFactor.assign(count, 1.0);
  parallelFor(count, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      interruptionPoint();
      const double tContext = stages.hits.tContext[i];
      if (std::isnan(tContext)) continue;
      const Ray ray = rayThrough(camera, size, places[i]);
      const Visible visible = visibleOf(opening.removed(ray, {tContext, stages.hits.tOut[i]}), tContext,
                                        stages.hits.tFocus[i], holes, opening.voxel());
      stages.tStart[i] = visible.start;
      stages.apart->holeBegin[i] = visible.holeBegin;
      stages.apart->holeEnd[i] = visible.holeEnd;
      const glm::dvec3 surface = Opening::pointAt(ray, tContext);
      if (!opening.shows(surface)) continue;
      stages.apart->distance[i] = opening.distanceAt(surface);
      if (opening.hasEdits()) stages.editFactor[i] = opening.factorAt(surface);
    }
  });
  return stages;
}

Stages geometricStages(const Scene& scene, const View& view) {
  const std::optional<OpeningView> cut =
      hasCutaway(scene) ? openingOf(view, scene.look.cutaway, focusCentre(scene)) : std::nullopt;
  return cut ? stagesApart(scene, view.camera, view.size, *cut, centresOf(view.size))
             : geometricStages(scene, view.camera, view.size, view.pixelScale);
}

}  // namespace fenestra::reference
