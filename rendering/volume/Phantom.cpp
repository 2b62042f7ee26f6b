#include "rendering/volume/Phantom.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr RayInterval everything{-infinity, infinity};

std::optional<RayInterval> intersection(std::optional<RayInterval> a, std::optional<RayInterval> b) {
  if (!a || !b) return {};
  const RayInterval both{std::max(a->tIn, b->tIn), std::min(a->tOut, b->tOut)};
  return both.tIn <= both.tOut ? std::optional(both) : std::nullopt;
}

/// The smallest interval around both, which is their union when both lie in one convex body.
std::optional<RayInterval> hull(std::optional<RayInterval> a, std::optional<RayInterval> b) {
  if (!a) return b;
  if (!b) return a;
  return RayInterval{std::min(a->tIn, b->tIn), std::max(a->tOut, b->tOut)};
}

/// Where the line p + t·d lies in |x| ≤ half.
std::optional<RayInterval> slab(double p, double d, double half) {
  if (d == 0.0) return std::abs(p) <= half ? std::optional(everything) : std::nullopt;
  const double a = (-half - p) / d, b = (half - p) / d;
  return RayInterval{std::min(a, b), std::max(a, b)};
}

/// Where the line p + t·d lies in the unit ball (or disc) of its vector type.
template <class Vec>
std::optional<RayInterval> unitBall(Vec p, Vec d) {
  const double dd = glm::dot(d, d);
  if (dd == 0.0) return glm::dot(p, p) <= 1.0 ? std::optional(everything) : std::nullopt;
  // From the point nearest to the centre: no cancellation, however far away the origin is.
  const double nearest = -glm::dot(p, d) / dd;
  const Vec closest = p + nearest * d;
  const double room = 1.0 - glm::dot(closest, closest);
  if (room < 0.0) return {};
  const double half = std::sqrt(room / dd);
  return RayInterval{nearest - half, nearest + half};
}

std::optional<RayInterval> meet(const Ellipsoid& e, glm::dvec3 origin, glm::dvec3 direction) {
  return unitBall((origin - e.centre) * e.axes / e.semiAxes, direction * e.axes / e.semiAxes);
}

std::optional<RayInterval> meet(const Cylinder& c, glm::dvec3 origin, glm::dvec3 direction) {
  const glm::dvec3 p = (origin - c.centre) * c.axes, d = direction * c.axes;
  const glm::dvec2 across(c.semiAxes);
  return intersection(slab(p.z, d.z, c.semiAxes.z), unitBall(glm::dvec2(p) / across, glm::dvec2(d) / across));
}

std::optional<RayInterval> meet(const Capsule& c, glm::dvec3 origin, glm::dvec3 direction) {
  const auto ball = [&](glm::dvec3 centre) { return unitBall((origin - centre) / c.radius, direction / c.radius); };
  const std::optional<RayInterval> ends = hull(ball(c.a), ball(c.b));
  const double length = glm::distance(c.a, c.b);
  if (length == 0.0) return ends;
  const glm::dvec3 axis = (c.b - c.a) / length, p = origin - 0.5 * (c.a + c.b);
  const double pAlong = glm::dot(p, axis), dAlong = glm::dot(direction, axis);
  const std::optional<RayInterval> side =
      unitBall((p - pAlong * axis) / c.radius, (direction - dAlong * axis) / c.radius);
  return hull(ends, intersection(slab(pAlong, dAlong, 0.5 * length), side));
}

std::optional<RayInterval> meet(const Box& b, glm::dvec3 origin, glm::dvec3 direction) {
  const glm::dvec3 p = (origin - b.centre) * b.axes, d = direction * b.axes;
  return intersection(slab(p.x, d.x, b.semiAxes.x),
                      intersection(slab(p.y, d.y, b.semiAxes.y), slab(p.z, d.z, b.semiAxes.z)));
}

bool holds(const Ellipsoid& e, glm::dvec3 point) {
  const glm::dvec3 p = (point - e.centre) * e.axes / e.semiAxes;
  return glm::dot(p, p) <= 1.0;
}

bool holds(const Cylinder& c, glm::dvec3 point) {
  const glm::dvec3 p = (point - c.centre) * c.axes / c.semiAxes;
  return p.x * p.x + p.y * p.y <= 1.0 && std::abs(p.z) <= 1.0;
}

bool holds(const Capsule& c, glm::dvec3 point) {
  const glm::dvec3 axis = c.b - c.a;
  const double squared = glm::dot(axis, axis);
  const double along = squared > 0.0 ? std::clamp(glm::dot(point - c.a, axis) / squared, 0.0, 1.0) : 0.0;
  return glm::distance(point, c.a + along * axis) <= c.radius;
}

bool holds(const Box& b, glm::dvec3 point) {
  return glm::all(glm::lessThanEqual(glm::abs((point - b.centre) * b.axes), b.semiAxes));
}

/// An axis-parallel box in world space.
struct Bounds {
  glm::dvec3 low, high;
};

Bounds around(glm::dvec3 centre, glm::dvec3 reach) { return {centre - reach, centre + reach}; }

/// How far a sum of axes reaches along each world axis.
glm::dvec3 boxReach(const glm::dmat3& axes, glm::dvec3 semiAxes) {
  return glm::abs(axes[0]) * semiAxes.x + glm::abs(axes[1]) * semiAxes.y + glm::abs(axes[2]) * semiAxes.z;
}

Bounds boundsOf(const Ellipsoid& e) { return around(e.centre, boxReach(e.axes, e.semiAxes)); }
Bounds boundsOf(const Cylinder& c) { return around(c.centre, boxReach(c.axes, c.semiAxes)); }
Bounds boundsOf(const Capsule& c) { return {glm::min(c.a, c.b) - c.radius, glm::max(c.a, c.b) + c.radius}; }
Bounds boundsOf(const Box& b) { return around(b.centre, boxReach(b.axes, b.semiAxes)); }

struct BodyInterval {
  RayInterval interval;
  std::size_t body;
};

/// Cuts overlapping intervals into disjoint segments in which the greatest body index wins. Leaves `intervals` sorted.
/// Vectors are the caller's so that a row of voxels allocates nothing.
void resolve(std::vector<BodyInterval>& intervals, std::vector<double>& ends, std::vector<Phantom::Segment>& segments) {
  segments.clear();
  ends.clear();
  for (const BodyInterval& i : intervals) ends.insert(ends.end(), {i.interval.tIn, i.interval.tOut});
  std::sort(ends.begin(), ends.end());
  std::sort(intervals.begin(), intervals.end(), [](const BodyInterval& a, const BodyInterval& b) {
    return a.body > b.body || (a.body == b.body && a.interval.tIn < b.interval.tIn);
  });
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const double tIn = ends[k], tOut = ends[k + 1];
    if (tIn == tOut) continue;
    const auto winner = std::find_if(intervals.begin(), intervals.end(), [&](const BodyInterval& i) {
      return i.interval.tIn <= tIn && tOut <= i.interval.tOut;
    });
    if (winner == intervals.end()) continue;
    if (!segments.empty() && segments.back().body == winner->body && segments.back().tOut == tIn)
      segments.back().tOut = tOut;
    else
      segments.push_back({tIn, tOut, winner->body});
  }
}

/// The bodies that a line meets, among those that `takesPart` picks.
template <class TakesPart>
std::vector<Phantom::Segment> segmentsAlong(const std::vector<PhantomBody>& bodies, glm::dvec3 origin,
                                            glm::dvec3 unitDirection, const TakesPart& takesPart) {
  std::vector<BodyInterval> intervals;
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    if (!takesPart(bodies[body])) continue;
    for (const Shape& shape : bodies[body].shapes)
      if (const auto interval = intersect(shape, origin, unitDirection)) intervals.push_back({*interval, body});
  }
  std::vector<double> ends;
  std::vector<Phantom::Segment> segments;
  resolve(intervals, ends, segments);
  return segments;
}

/// Meets the bodies of a phantom with many parallel lines along x, skipping shapes by their bounds.
class RowCaster {
 public:
  explicit RowCaster(const Phantom& phantom) {
    for (std::size_t body = 0; body < phantom.bodies.size(); ++body)
      for (const Shape& shape : phantom.bodies[body].shapes)
        entries_.push_back({&shape, body, std::visit([](const auto& s) { return boundsOf(s); }, shape)});
  }

  void setPlane(double z) {
    z_ = z;
    inPlane_.clear();
    for (const Entry& entry : entries_)
      if (entry.bounds.low.z <= z && z <= entry.bounds.high.z) inPlane_.push_back(&entry);
  }

  /// Where each shape meets the line along +x through (·, y, z), in the order of the bodies; t is x itself.
  const std::vector<BodyInterval>& intervals(double y) {
    intervals_.clear();
    for (const Entry* entry : inPlane_) {
      if (y < entry->bounds.low.y || entry->bounds.high.y < y) continue;
      if (const auto interval = intersect(*entry->shape, {0.0, y, z_}, {1.0, 0.0, 0.0}))
        intervals_.push_back({*interval, entry->body});
    }
    return intervals_;
  }

  /// That line, cut into disjoint segments.
  const std::vector<Phantom::Segment>& segments(double y) {
    intervals(y);
    resolve(intervals_, ends_, segments_);
    return segments_;
  }

 private:
  struct Entry {
    const Shape* shape;
    std::size_t body;
    Bounds bounds;
  };
  std::vector<Entry> entries_;
  std::vector<const Entry*> inPlane_;
  double z_ = 0.0;
  std::vector<BodyInterval> intervals_;
  std::vector<double> ends_;
  std::vector<Phantom::Segment> segments_;
};

Grid latticeFor(glm::dvec3 extent, int voxels) {
  Grid grid;
  const double size = std::max({extent.x, extent.y, extent.z}) / voxels;
  // A hair less than the quotient, so that rounding adds no voxel.
  grid.dims = glm::max(glm::ivec3(glm::ceil(extent / size - 1e-9)), 1);
  grid.spacing = glm::dvec3(size);
  grid.origin = -0.5 * size * glm::dvec3(grid.dims - 1);
  return grid;
}

/// The mean value of each voxel of a row: the sum over sub-rows of the length of each segment within the voxel. A
/// segment that ends at x changes its voxel partly and all later ones fully, so the cost of a row is that of its
/// surfaces.
class RowAverage {
 public:
  RowAverage(const Grid& grid, double background)
      : grid_(grid), background_(background), step_(static_cast<std::size_t>(grid.dims.x) + 1) {
    clear();
  }

  void clear() {
    std::fill(step_.begin(), step_.end(), 0.0);
    subRows_ = 0;
  }

  void add(const std::vector<Phantom::Segment>& segments, const std::vector<PhantomBody>& bodies) {
    ++subRows_;
    for (const Phantom::Segment& segment : segments) {
      const double contrast = bodies[segment.body].value - background_;
      edge(segment.tIn, contrast);
      edge(segment.tOut, -contrast);
    }
  }

  void write(std::span<float> row) const {
    double level = 0.0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      level += step_[i];
      row[i] = static_cast<float>(background_ + level / subRows_);
    }
  }

 private:
  void edge(double x, double change) {
    const double position = (x - grid_.origin.x) / grid_.spacing.x + 0.5;  // voxel i spans [i, i+1]
    if (position >= grid_.dims.x) return;
    const double inside = std::max(position, 0.0);
    const auto voxel = static_cast<std::size_t>(inside);
    const double covered = static_cast<double>(voxel) + 1.0 - inside;
    step_[voxel] += change * covered;
    step_[voxel + 1] += change * (1.0 - covered);
  }

  const Grid& grid_;
  double background_;
  std::vector<double> step_;
  int subRows_ = 0;
};

/// Spreads each value over its neighbours by 1 2 1 along every axis (borders repeat), like a scanner whose resolution
/// is one voxel. Without it, layers one voxel thick would alias with the lattice.
void spread(std::span<const float> means, const Grid& grid, std::span<std::int16_t> values) {
  const glm::ivec3 dims = grid.dims;
  const auto rowLength = static_cast<std::size_t>(dims.x);
  const auto rowAt = [&](int y, int z) {
    const glm::ivec3 start(0, std::clamp(y, 0, dims.y - 1), std::clamp(z, 0, dims.z - 1));
    return means.subspan(grid.offset(start), rowLength);
  };
  parallelFor(static_cast<std::size_t>(dims.z), 1, [&](std::size_t begin, std::size_t end) {
    std::vector<float> sum(rowLength);
    for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
      for (int y = 0; y < dims.y; ++y) {
        std::fill(sum.begin(), sum.end(), 0.0f);
        for (int dz = -1; dz <= 1; ++dz)
          for (int dy = -1; dy <= 1; ++dy) {
            const std::span<const float> row = rowAt(y + dy, z + dz);
            const auto weight = static_cast<float>((2 - std::abs(dy)) * (2 - std::abs(dz)));
            for (std::size_t x = 0; x < rowLength; ++x) sum[x] += weight * row[x];
          }
        const std::span<std::int16_t> out = values.subspan(grid.offset({0, y, z}), rowLength);
        for (std::size_t x = 0; x < rowLength; ++x) {
          const float before = sum[x > 0 ? x - 1 : x], after = sum[std::min(x + 1, rowLength - 1)];
          const float mean = (before + 2.0f * sum[x] + after) / 64.0f;
          out[x] = static_cast<std::int16_t>(std::lround(std::clamp(mean, -32768.0f, 32767.0f)));
        }
      }
  });
}

std::vector<Label> labelTable(const std::vector<PhantomBody>& bodies) {
  std::vector<Label> labels;
  for (const PhantomBody& body : bodies)
    if (body.label != 0) labels.push_back({body.label, body.name, body.colour});
  std::stable_sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.value < b.value; });
  // Bodies that share a label share its first name.
  labels.erase(
      std::unique(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.value == b.value; }),
      labels.end());
  return labels;
}

}  // namespace

std::optional<RayInterval> intersect(const Shape& shape, glm::dvec3 origin, glm::dvec3 unitDirection) {
  return std::visit([&](const auto& s) { return meet(s, origin, unitDirection); }, shape);
}

bool contains(const Shape& shape, glm::dvec3 point) {
  return std::visit([&](const auto& s) { return holds(s, point); }, shape);
}

double Phantom::value(glm::dvec3 point) const {
  for (auto body = bodies.rbegin(); body != bodies.rend(); ++body)
    for (const Shape& shape : body->shapes)
      if (contains(shape, point)) return body->value;
  return background;
}

std::uint16_t Phantom::label(glm::dvec3 point) const {
  for (auto body = bodies.rbegin(); body != bodies.rend(); ++body) {
    if (body->label == 0) continue;
    for (const Shape& shape : body->shapes)
      if (contains(shape, point)) return body->label;
  }
  return 0;
}

std::vector<Phantom::Segment> Phantom::segments(glm::dvec3 origin, glm::dvec3 unitDirection) const {
  return segmentsAlong(bodies, origin, unitDirection, [](const PhantomBody&) { return true; });
}

std::optional<double> Phantom::firstHit(glm::dvec3 origin, glm::dvec3 unitDirection,
                                        const std::vector<std::uint16_t>& labels) const {
  const auto labelled = [](const PhantomBody& body) { return body.label != 0; };
  for (const Segment& segment : segmentsAlong(bodies, origin, unitDirection, labelled))
    if (segment.tOut >= 0.0 && std::find(labels.begin(), labels.end(), bodies[segment.body].label) != labels.end())
      return std::max(segment.tIn, 0.0);
  return {};
}

namespace {

std::shared_ptr<Volume> emptyCt(const Grid& grid) {
  auto volume = std::make_shared<Volume>();
  volume->grid = grid;
  volume->voxels = Voxels(ScalarType::Int16, grid.voxelCount());
  volume->modality = Modality::CT;
  volume->unit = "HU";
  volume->windows = {{400.0, 40.0}};  // the usual soft-tissue window of CT
  return volume;
}

}  // namespace

Phantom::Rasterised Phantom::rasterise(int voxels) const {
  assert(voxels >= 1);
  const Grid grid = latticeFor(extent, voxels);
  const glm::ivec3 dims = grid.dims;
  const double size = grid.spacing.x;
  // Sub-rows of a voxel on a rank-1 lattice: as many different heights in y as in z, so that a surface along either
  // axis moves the mean in steps of a sixteenth.
  constexpr int subRows = 16, generator = 5;
  const auto subOffset = [size](int k) { return size * ((k % subRows + 0.5) / subRows - 0.5); };

  const std::shared_ptr<Volume> volume = emptyCt(grid);
  auto map = std::make_shared<LabelMap>();
  map->grid = grid;
  map->labels = labelTable(bodies);
  map->voxels = Voxels(ScalarType::UInt16, grid.voxelCount());

  Voxels meanVoxels(ScalarType::Float32, grid.voxelCount());
  const std::span<float> means = meanVoxels.as<float>();
  const std::span<std::uint16_t> labels = map->voxels.as<std::uint16_t>();
  const auto rowLength = static_cast<std::size_t>(dims.x);

  // Bodies are painted in their order: the later one wins, as everywhere.
  const auto paintLabels = [&](const std::vector<BodyInterval>& intervals, std::span<std::uint16_t> row) {
    std::fill(row.begin(), row.end(), std::uint16_t{0});
    for (const BodyInterval& i : intervals) {
      if (bodies[i.body].label == 0) continue;
      const double first = std::ceil((i.interval.tIn - grid.origin.x) / size);
      const double last = std::floor((i.interval.tOut - grid.origin.x) / size);
      const auto begin = static_cast<std::size_t>(std::clamp(first, 0.0, static_cast<double>(dims.x)));
      const auto end = static_cast<std::size_t>(std::clamp(last + 1.0, 0.0, static_cast<double>(dims.x)));
      if (begin < end) std::ranges::fill(row.subspan(begin, end - begin), bodies[i.body].label);
    }
  };

  parallelFor(static_cast<std::size_t>(dims.z), 1, [&](std::size_t begin, std::size_t end) {
    RowCaster centres(*this);
    std::vector<RowCaster> subPlanes(subRows, RowCaster(*this));
    RowAverage average(grid, background);
    for (std::size_t k = begin; k < end; ++k) {
      const double z = grid.origin.z + size * static_cast<double>(k);
      centres.setPlane(z);
      for (int sub = 0; sub < subRows; ++sub)
        subPlanes[static_cast<std::size_t>(sub)].setPlane(z + subOffset(sub * generator));
      for (int j = 0; j < dims.y; ++j) {
        const double y = grid.origin.y + size * j;
        const std::size_t offset = (k * static_cast<std::size_t>(dims.y) + static_cast<std::size_t>(j)) * rowLength;
        paintLabels(centres.intervals(y), labels.subspan(offset, rowLength));
        average.clear();
        for (int sub = 0; sub < subRows; ++sub)
          average.add(subPlanes[static_cast<std::size_t>(sub)].segments(y + subOffset(sub)), bodies);
        average.write(means.subspan(offset, rowLength));
      }
    }
  });
  spread(means, grid, volume->voxels.as<std::int16_t>());
  volume->computeRange();
  return {volume, map};
}

}  // namespace fenestra
