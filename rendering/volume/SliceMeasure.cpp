#include "rendering/volume/SliceMeasure.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/gtc/constants.hpp>

#include "rendering/volume/ObliqueSlice.h"

namespace fenestra {
namespace {

/// mm along `right` and along `down` that lead to a point, whose part off the plane is left out. The two directions
/// need not be orthogonal.
glm::dvec2 alongSides(const Measure& measure, glm::dvec3 offset) {
  const double mixed = glm::dot(measure.right, measure.down);
  const double x = glm::dot(offset, measure.right), y = glm::dot(offset, measure.down);
  return glm::dvec2(x - mixed * y, y - mixed * x) / (1.0 - mixed * mixed);
}

/// From the region's first corner to the opposite one.
glm::dvec2 sidesOf(const Measure& measure) { return alongSides(measure, measure.points[1] - measure.points[0]); }

double areaOf(const Measure& measure) {
  const glm::dvec2 sides = sidesOf(measure);
  const double box = std::abs(sides.x * sides.y) * glm::length(glm::cross(measure.right, measure.down));
  return measure.kind == MeasureKind::Ellipse ? 0.25 * glm::pi<double>() * box : box;
}

double angleOf(const Measure& measure) {
  const glm::dvec3 a = measure.points[0] - measure.points[1], b = measure.points[2] - measure.points[1];
  // Exact for small angles and for those near 180°, where an arc cosine is not.
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

/// Whether a point of the plane lies inside; the edge belongs to the region.
bool contains(const Measure& measure, glm::dvec3 world) {
  const glm::dvec2 half = 0.5 * glm::abs(sidesOf(measure));
  const glm::dvec2 from = alongSides(measure, world - 0.5 * (measure.points[0] + measure.points[1]));
  // A pixel centre on the edge stays inside whatever the rounding.
  constexpr double edge = 1.0 + 1e-9;
  if (std::abs(from.x) > half.x * edge || std::abs(from.y) > half.y * edge) return false;
  if (measure.kind == MeasureKind::Rectangle) return true;
  const glm::dvec2 share = from / half;
  return glm::dot(share, share) <= edge;
}

/// Values one by one, after Welford: the deviation of values far from zero loses no digits.
class Statistics {
 public:
  void add(double value) {
    ++values_.count;
    const double from = value - values_.mean;
    values_.mean += from / static_cast<double>(values_.count);
    squares_ += from * (value - values_.mean);
    values_.least = values_.count == 1 ? value : std::min(values_.least, value);
    values_.greatest = values_.count == 1 ? value : std::max(values_.greatest, value);
  }
  std::optional<RegionValues> result() const {
    if (values_.count == 0) return std::nullopt;
    RegionValues values = values_;
    if (values.count > 1) values.deviation = std::sqrt(squares_ / static_cast<double>(values.count - 1));
    return values;
  }

 private:
  RegionValues values_;
  double squares_ = 0.0;
};

std::optional<RegionValues> valuesInside(const Measure& measure, const Volume& volume, const SliceGeometry& geometry,
                                         int slice) {
  glm::dvec2 least(geometry.width, geometry.height), greatest(-1.0);
  const glm::dvec2 sides = sidesOf(measure);
  for (const glm::dvec2 corner : {glm::dvec2(0.0), glm::dvec2(sides.x, 0.0), glm::dvec2(0.0, sides.y), sides}) {
    const glm::dvec2 pixel(
        geometry.pixelFromWorld(measure.points[0] + corner.x * measure.right + corner.y * measure.down));
    least = glm::min(least, pixel);
    greatest = glm::max(greatest, pixel);
  }
  // A pixel more on each side, for rounding; contains() decides.
  const glm::ivec2 last(geometry.width - 1, geometry.height - 1);
  const glm::ivec2 from = glm::clamp(glm::ivec2(glm::max(least, -1.0)) - 1, glm::ivec2(0), last + 1);
  const glm::ivec2 to = glm::clamp(glm::ivec2(glm::min(greatest, glm::dvec2(last))) + 1, glm::ivec2(-1), last);
  const SliceSampler sampler(volume, geometry, slice);
  Statistics statistics;
  for (int j = from.y; j <= to.y; ++j)
    for (int i = from.x; i <= to.x; ++i) {
      if (!contains(measure, geometry.worldFromPixel(i, j, slice))) continue;
      const double value = sampler.at(i, j);
      if (std::isfinite(value)) statistics.add(value);
    }
  return statistics.result();
}

}  // namespace

std::size_t pointCount(MeasureKind kind) { return kind == MeasureKind::Angle ? 3 : kind == MeasureKind::Text ? 1 : 2; }

bool isWellFormed(const Measure& measure) {
  const auto isUnit = [](glm::dvec3 v) { return std::abs(glm::length(v) - 1.0) < 1e-3; };
  const bool hasText = isMark(measure.kind) ? measure.text.size() <= Measure::longestText &&
                                                  (measure.kind == MeasureKind::Arrow || !measure.text.empty())
                                            : measure.text.empty();
  return hasText && measure.points.size() == pointCount(measure.kind) && isUnit(measure.right) &&
         isUnit(measure.down) && std::abs(glm::dot(measure.right, measure.down)) < 0.9;
}

std::optional<int> sliceOf(const Measure& measure, const SliceGeometry& geometry) {
  const glm::dvec3 own = glm::normalize(glm::cross(measure.right, measure.down));
  const glm::dvec3 normal = glm::normalize(glm::cross(geometry.right, geometry.down));
  // 0.1°: half a millimetre over the width of a body. Direction cosines of six digits are well within.
  constexpr double parallel = 0.9999985;
  if (std::abs(glm::dot(own, normal)) < parallel) return std::nullopt;
  const glm::dvec3 middle = std::accumulate(measure.points.begin(), measure.points.end(), glm::dvec3(0.0)) /
                            static_cast<double>(measure.points.size());
  const double slice = std::round(geometry.pixelFromWorld(middle).z);
  if (!(slice >= 0.0 && slice < geometry.count)) return std::nullopt;
  return static_cast<int>(slice);
}

MeasureValues valuesOf(const Measure& measure, const Volume& volume) {
  MeasureValues values;
  if (measure.kind == MeasureKind::Distance) values.length = glm::distance(measure.points[0], measure.points[1]);
  if (measure.kind == MeasureKind::Angle) values.angle = angleOf(measure);
  if (!isRegion(measure.kind)) return values;
  values.area = areaOf(measure);
  for (const SlicePlane plane : {SlicePlane::Axial, SlicePlane::Sagittal, SlicePlane::Coronal}) {
    const SliceGeometry geometry = sliceGeometry(volume.grid, plane);
    if (const std::optional<int> slice = sliceOf(measure, geometry)) {
      values.region = valuesInside(measure, volume, geometry, *slice);
      return values;
    }
  }
  const glm::dvec3 right = glm::normalize(measure.right);
  const glm::dvec3 down = glm::normalize(measure.down - glm::dot(measure.down, right) * right);
  const PlaneAxes axes{right, down, glm::cross(right, down)};
  const SliceGeometry geometry = obliqueGeometry(volume.grid, SlicePlane::Axial, axes, measure.points[0]);
  const auto slice = static_cast<int>(std::lround(geometry.pixelFromWorld(measure.points[0]).z));
  values.region = valuesInside(measure, volume, geometry, slice);
  return values;
}

std::vector<glm::dvec3> handlesOf(const Measure& measure) {
  if (!isRegion(measure.kind)) return measure.points;
  const glm::dvec2 sides = sidesOf(measure);
  const glm::dvec3 first = measure.points[0], across = sides.x * measure.right, down = sides.y * measure.down;
  if (measure.kind == MeasureKind::Rectangle) return {first, first + across, first + across + down, first + down};
  return {first + 0.5 * across, first + across + 0.5 * down, first + 0.5 * across + down, first + 0.5 * down};
}

Measure withHandleAt(Measure measure, std::size_t handle, glm::dvec3 world) {
  if (!isRegion(measure.kind)) {
    measure.points[handle] = world;
    return measure;
  }
  // Corners and ends of axes are counted from the first point's, by way of `right`.
  const glm::dvec3 first = measure.points[0];
  glm::dvec2 begin(0.0), end = sidesOf(measure);
  const glm::dvec2 to = alongSides(measure, world - first);
  const bool corner = measure.kind == MeasureKind::Rectangle;
  if (handle == 3 || (corner && handle == 0)) begin.x = to.x;
  if (handle == 0 || (corner && handle == 1)) begin.y = to.y;
  if (handle == 1 || (corner && handle == 2)) end.x = to.x;
  if (handle == 2 || (corner && handle == 3)) end.y = to.y;
  measure.points[0] = first + begin.x * measure.right + begin.y * measure.down;
  measure.points[1] = first + end.x * measure.right + end.y * measure.down;
  return measure;
}

Measure movedBy(Measure measure, glm::dvec3 offset) {
  for (glm::dvec3& point : measure.points) point += offset;
  return measure;
}

}  // namespace fenestra
