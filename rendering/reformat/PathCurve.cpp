#include "rendering/reformat/PathCurve.h"

#include <algorithm>
#include <cmath>

namespace fenestra::reformat {
namespace {

/// Chords of each piece between two points. A chord of 1/32 of a quarter circle is shorter than its arc by 1e-4.
constexpr int stepsPerPiece = 32;

/// The point at `t`, 0 to 1 from b to c, by the pyramid of Barry and Goldman. Knots are the square roots of distances.
glm::dvec3 catmullRom(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d, double t) {
  const double t1 = std::sqrt(glm::distance(a, b)), t2 = t1 + std::sqrt(glm::distance(b, c)),
               t3 = t2 + std::sqrt(glm::distance(c, d)), at = t1 + t * (t2 - t1);
  const auto between = [at](glm::dvec3 from, double first, glm::dvec3 to, double last) {
    return ((last - at) * from + (at - first) * to) / (last - first);
  };
  const glm::dvec3 ab = between(a, 0.0, b, t1), bc = between(b, t1, c, t2), cd = between(c, t2, d, t3);
  return between(between(ab, 0.0, bc, t2), t1, between(bc, t1, cd, t3), t2);
}

/// Where the curve is thought to go on beyond its end, from its last three points: it bends there as before. That is
/// the third point's mirror image in the plane half-way between the others; on a circle, the next point.
glm::dvec3 beyond(glm::dvec3 end, glm::dvec3 second, glm::dvec3 third) {
  const glm::dvec3 way = glm::normalize(second - end);
  return third - 2.0 * glm::dot(way, third - 0.5 * (end + second)) * way;
}

/// The curve as many short chords.
std::vector<glm::dvec3> polyline(const std::vector<glm::dvec3>& points) {
  std::vector<glm::dvec3> line{points.front()};
  const std::size_t last = points.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const glm::dvec3 before =
        i > 0 ? points[i - 1] : beyond(points[0], points[1], last > 1 ? points[2] : 2.0 * points[1] - points[0]);
    const glm::dvec3 after = i + 1 < last ? points[i + 2]
                                          : beyond(points[last], points[last - 1],
                                                   last > 1 ? points[last - 2] : 2.0 * points[0] - points[1]);
    for (int step = 1; step <= stepsPerPiece; ++step)
      line.push_back(catmullRom(before, points[i], points[i + 1], after, static_cast<double>(step) / stepsPerPiece));
  }
  return line;
}

glm::dvec3 reflected(glm::dvec3 v, glm::dvec3 mirror) {
  const double squared = glm::dot(mirror, mirror);
  return squared > 0.0 ? v - 2.0 * glm::dot(mirror, v) / squared * mirror : v;
}

/// `right` made perpendicular to `along`.
void setAxes(PathPlace& place, glm::dvec3 along, glm::dvec3 right) {
  place.along = along;
  place.right = glm::normalize(right - glm::dot(right, along) * along);
  place.up = glm::cross(place.along, place.right);
}

}  // namespace

PathCurve::PathCurve(std::span<const glm::dvec3> points) {
  std::vector<glm::dvec3> distinct;
  for (const glm::dvec3& point : points)
    if (distinct.empty() || glm::distance(point, distinct.back()) > 1e-3) distinct.push_back(point);
  if (distinct.size() < 2) return;
  const std::vector<glm::dvec3> line = polyline(distinct);
  const auto tangent = [&](std::size_t i) {
    return glm::normalize(line[std::min(i + 1, line.size() - 1)] - line[i > 0 ? i - 1 : 0]);
  };
  Sample sample{0.0, {}};
  sample.place.point = line[0];
  const glm::dvec3 first = tangent(0);
  setAxes(sample.place, first, std::abs(first.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0));
  samples_.push_back(sample);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const PathPlace& before = samples_.back().place;
    const glm::dvec3 step = line[i] - line[i - 1], along = tangent(i);
    const glm::dvec3 right = reflected(before.right, step), flipped = reflected(before.along, step);
    Sample next{samples_.back().at + glm::length(step), {}};
    next.place.point = line[i];
    setAxes(next.place, along, reflected(right, along - flipped));
    samples_.push_back(next);
  }
}

PathPlace PathCurve::place(double mm) const {
  if (samples_.empty()) return {};
  const auto next = std::upper_bound(samples_.begin(), samples_.end(), mm,
                                     [](double at, const Sample& sample) { return at < sample.at; });
  if (next == samples_.begin()) return samples_.front().place;
  if (next == samples_.end()) return samples_.back().place;
  const Sample &a = *(next - 1), &b = *next;
  const double t = (mm - a.at) / (b.at - a.at);
  PathPlace place;
  place.point = glm::mix(a.place.point, b.place.point, t);
  setAxes(place, glm::normalize(glm::mix(a.place.along, b.place.along, t)), glm::mix(a.place.right, b.place.right, t));
  return place;
}

}  // namespace fenestra::reformat
