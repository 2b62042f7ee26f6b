#include "rendering/reference/Strokes.h"

#include <algorithm>
#include <cmath>

#include "rendering/volume/Threads.h"

namespace fenestra::reference {
namespace {

/// A projected anchor.
struct Spot {
  glm::dvec2 pixel{0.0};
  double radius = 0.0;  ///< pixels
  double depth = 0.0;   ///< mm from the eye (or its plane) along the view
};
struct Line {
  Spot from, to;
};

/// A camera as a map from the world to the picture.
class Projector {
 public:
  Projector(const Camera& camera, glm::ivec2 size) : camera_(camera), axes_(camera.axes()), size_(size) {}

  bool sees(glm::dvec3 anchor, double radius) const {
    const double depth = glm::dot(anchor - camera_.eye, axes_.forward);
    return camera_.projection == Projection::Perspective ? depth > radius : depth >= 0.0;
  }
  Spot spot(glm::dvec3 anchor, double radius) const {
    const glm::dvec3 from = anchor - camera_.eye;
    const double depth = glm::dot(from, axes_.forward);
    const double perMillimetre = camera_.projection == Projection::Perspective
                                     ? 0.5 * size_.y / (std::tan(0.5 * glm::radians(camera_.verticalFov)) * depth)
                                     : size_.y / camera_.orthographicHeight;
    const glm::dvec2 offset(glm::dot(from, axes_.right), -glm::dot(from, axes_.up));
    return {0.5 * glm::dvec2(size_) + perMillimetre * offset, perMillimetre * radius, depth};
  }
  /// t on the ray through a place of the picture at a view depth.
  double timeAt(glm::dvec2 place, double depth) const {
    return depth / glm::dot(rayThrough(camera_, size_, place).direction, axes_.forward);
  }

 private:
  Camera camera_;
  Camera::Axes axes_;
  glm::ivec2 size_;
};

std::vector<Line> linesOf(const BrushStroke& stroke, const Projector& projector) {
  std::vector<Line> lines;
  const auto& anchors = stroke.anchors;
  const auto seen = [&](std::size_t i) { return i < anchors.size() && projector.sees(anchors[i], stroke.radius); };
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    if (!seen(i)) continue;
    const Spot spot = projector.spot(anchors[i], stroke.radius);
    if (seen(i + 1))
      lines.push_back({spot, projector.spot(anchors[i + 1], stroke.radius)});
    else if (i == 0 || !seen(i - 1))
      lines.push_back({spot, spot});
  }
  return lines;
}

double smoothstep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double profile(double d, double softness) {
  return softness > 0.0 ? smoothstep(0.0, softness, 1.0 - d) : d <= 1.0 ? 1.0 : 0.0;
}

/// Greatest weight of the lines at a place of the picture, on what lies between the times `nearest` and `farthest` of
/// its ray.
double weightAt(glm::dvec2 place, const BrushStroke& stroke, const std::vector<Line>& lines, const Projector& projector,
                double nearest, double farthest) {
  double weight = 0.0;
  for (const Line& line : lines) {
    const glm::dvec2 along = line.to.pixel - line.from.pixel;
    const double size2 = glm::dot(along, along);
    const double u = size2 > 0.0 ? std::clamp(glm::dot(place - line.from.pixel, along) / size2, 0.0, 1.0) : 0.0;
    const double radius = glm::mix(line.from.radius, line.to.radius, u);
    const double d = glm::distance(place, line.from.pixel + u * along) / radius;
    if (d > 1.0) continue;
    const double time = projector.timeAt(place, glm::mix(line.from.depth, line.to.depth, u));
    const double off = std::max({nearest - time, time - farthest, 0.0});
    weight = std::max(weight, profile(d, stroke.softness) * (1.0 - smoothstep(1.0, 2.0, off / stroke.radius)));
  }
  return weight;
}

}  // namespace

Edits edits(const BrushStrokes& strokes, const Camera& camera, glm::ivec2 size, const HitPoints& hits,
            const Image& tStart) {
  return edits(strokes, camera, size, hits, tStart, centresOf(size));
}

Edits edits(const BrushStrokes& strokes, const Camera& camera, glm::ivec2 size, const HitPoints& hits,
            const Image& tStart, const std::vector<glm::dvec2>& places) {
  const Projector projector(camera, size);
  std::vector<std::pair<const BrushStroke*, std::vector<Line>>> drawn;
  for (const BrushStroke& stroke : strokes)
    if (isEffective(stroke)) drawn.emplace_back(&stroke, linesOf(stroke, projector));

  Edits result{Image(tStart.size(), 0.0), Image(tStart.size(), 1.0), tStart};
  parallelFor(tStart.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double context = hits.tContext[i];
      if (std::isnan(context)) continue;
      const bool meetsFocus = !std::isnan(hits.tFocus[i]);
      const double farthest = std::max(context, meetsFocus ? hits.tFocus[i] : hits.tOut[i]);
      double& start = result.tStart[i];
      for (const auto& [stroke, lines] : drawn) {
        const bool opens = stroke->mode == BrushMode::Open, movesRays = opens || stroke->mode == BrushMode::Restore;
        const double weight =
            weightAt(places[i], *stroke, lines, projector, context, opens ? std::max(tStart[i], start) : context);
        if (opens) {
          start = std::min(start + stroke->depth * weight, farthest);
        } else if (stroke->mode == BrushMode::Restore) {
          const double change = stroke->toSurface ? (start - context) * weight : stroke->depth * weight;
          if (!meetsFocus || stroke->coversFocus) start = std::max(start - change, context);
        } else if (meetsFocus) {
          result.factor[i] *= 1.0 + (stroke->mode == BrushMode::Fade ? -1.0 : 1.0) * stroke->amount * weight;
        }
        if (movesRays && !meetsFocus) result.factor[i] *= 1.0 - weight;
      }
      result.offset[i] = start - tStart[i];
      if (meetsFocus && start < tStart[i]) result.factor[i] *= (start - context) / (tStart[i] - context);
    }
  });
  return result;
}

}  // namespace fenestra::reference
