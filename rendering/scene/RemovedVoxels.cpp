#include "rendering/scene/RemovedVoxels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// mm, negative inside.
using Distance = std::function<double(glm::dvec3 world)>;

/// A part of a removal: its signed distance, and the box of the world that holds it.
struct Solid {
  Distance distance;
  glm::dvec3 low{-unbounded}, high{unbounded};  ///< world mm, without the rim
  /// Where the distance at a point is beyond ±steepness · (r + b), it is beyond ±b everywhere within r.
  double steepness = 1.0;
};

bool isFinite(glm::dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

template <class Vector>
double distanceToLine(Vector p, Vector a, Vector b) {
  const Vector along = b - a;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0.0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
  return glm::length(p - (a + t * along));
}

/// Signed distance to a box around the origin, by half its sides.
template <class Vector>
double distanceToBox(Vector p, Vector half) {
  const Vector beyond = glm::abs(p) - half;
  double greatest = beyond[0];
  for (int i = 1; i < static_cast<int>(beyond.length()); ++i) greatest = std::max(greatest, beyond[i]);
  return glm::length(glm::max(beyond, Vector(0.0))) + std::min(greatest, 0.0);
}

Solid ballOf(const Removal& part) {
  const glm::dvec3 a = part.points.front(), b = part.points.back();
  const double radius = part.size;
  return {[=](glm::dvec3 world) { return distanceToLine(world, a, b) - radius; }, glm::min(a, b) - radius,
          glm::max(a, b) + radius};
}

Solid boxOf(const Removal& part) {
  const glm::dvec3 centre = part.points.front(), half = 0.5 * part.sides;
  const glm::dvec3 forward = glm::normalize(part.direction);
  const glm::dvec3 up = glm::normalize(part.up - glm::dot(part.up, forward) * forward);
  const glm::dmat3 fromWorld = glm::transpose(glm::dmat3(glm::cross(forward, up), up, forward));
  const double reach = glm::length(half);
  return {[=](glm::dvec3 world) { return distanceToBox(fromWorld * (world - centre), half); }, centre - reach,
          centre + reach};
}

/// Whether a closed line lies around a point: a ray from there crosses it an odd number of times.
bool encloses(const std::vector<glm::dvec2>& outline, glm::dvec2 p) {
  bool inside = false;
  for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
    const glm::dvec2 a = outline[i], b = outline[i + 1];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

Solid sawOf(const Removal& part) {
  const glm::dvec3 forward = glm::normalize(part.direction);
  const glm::dvec3 aside = std::abs(forward.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, aside)), up = glm::cross(right, forward);
  const glm::dvec3 origin = part.points.front();
  std::vector<glm::dvec2> line;
  double nearest = unbounded;
  for (const glm::dvec3& point : part.points) {
    line.emplace_back(glm::dot(point - origin, right), glm::dot(point - origin, up));
    nearest = std::min(nearest, glm::dot(point - origin, forward));
  }
  const bool isClosed = part.points.size() > 3 && part.points.front() == part.points.back();
  const double half = 0.5 * part.size, end = part.depth > 0.0 ? nearest + part.depth : unbounded;
  return {[=, line = std::move(line)](glm::dvec3 world) {
    const glm::dvec2 p(glm::dot(world - origin, right), glm::dot(world - origin, up));
    double across = glm::length(p - line.front());
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      across = std::min(across, distanceToLine(p, line[i], line[i + 1]));
    if (isClosed && encloses(line, p)) across = -across;
    return std::max(across - half, glm::dot(world - origin, forward) - end);
  }};
}

Solid planeOf(const Removal& part) {
  const BentPlane bent(StrokePlane(part.points, part.direction), part.bends);
  const double depth = part.depth > 0.0 ? part.depth : unbounded;
  const double extent = part.extent > 0.0 ? part.extent : unbounded;
  Solid solid{[=](glm::dvec3 world) {
    const glm::dvec2 place = bent.placeOf(world);
    const BentPlane::Height height = bent.at(place);
    // To first order the distance from a graph is the difference in height over the length of its gradient.
    const double above = glm::dot(world - bent.plane().centre, bent.plane().normal) - height.value;
    const double steepness = std::sqrt(1.0 + glm::dot(height.gradient, height.gradient));
    const glm::dvec2 beyond = glm::abs(place) - extent;
    return std::max({-above / steepness, (above - depth) / steepness, beyond.x, beyond.y});
  }};
  // A drag's weight changes by at most 8 / (3 √3 radius) a mm, and along the bent plane a step on the unbent one is
  // √(1 + slope²) times as long.
  double slope = 0.0;
  for (const Bend& bend : part.bends)
    slope += std::abs(bend.distance) * 8.0 / (3.0 * std::sqrt(3.0) * bend.radius) * std::sqrt(1.0 + slope * slope);
  solid.steepness = std::sqrt(1.0 + slope * slope);
  return solid;
}

Solid solidOf(const Removal& part) {
  switch (part.shape) {
    case RemovalShape::Ball:
      return ballOf(part);
    case RemovalShape::Box:
      return boxOf(part);
    case RemovalShape::Saw:
      return sawOf(part);
    case RemovalShape::Plane:
      break;
  }
  return planeOf(part);
}

/// Each line of a ball's path and each box of a box's is a part of its own, so that each covers little of the volume.
void addParts(const Removal& removal, std::vector<Removal>& parts) {
  const std::size_t count = removal.points.size();
  const bool isBall = removal.shape == RemovalShape::Ball;
  if ((!isBall && removal.shape != RemovalShape::Box) || count == 1) {
    parts.push_back(removal);
    return;
  }
  Removal part = removal;
  for (std::size_t i = 0; i + (isBall ? 1 : 0) < count; ++i) {
    const auto first = removal.points.begin() + static_cast<std::ptrdiff_t>(i);
    part.points.assign(first, first + (isBall ? 2 : 1));
    parts.push_back(part);
  }
}

/// Voxels [low, high) of a grid.
struct VoxelSpan {
  glm::ivec3 low{0}, high{0};
  bool isEmpty() const { return glm::any(glm::lessThanEqual(high, low)); }
};

/// The widest that a removal's rim can be.
double widestRim(const Removal& part, const Grid& grid) {
  return std::max(part.softness, 2.0 * glm::length(grid.spacing));
}

/// The voxels of the grid that a part can reach.
VoxelSpan spanOf(const Removal& part, const Solid& solid, const Grid& grid) {
  const double rim = widestRim(part, grid);
  if (!std::isfinite(solid.low.x)) return {glm::ivec3(0), grid.dims};
  const glm::dvec3 low = solid.low - 0.5 * rim, high = solid.high + 0.5 * rim;
  const glm::dmat4 indexFromWorld = grid.indexFromWorld();
  glm::dvec3 least(unbounded), greatest(-unbounded);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 world(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z);
    const glm::dvec3 index(indexFromWorld * glm::dvec4(world, 1.0));
    least = glm::min(least, index);
    greatest = glm::max(greatest, index);
  }
  // Clamped before they are rounded: a far position has no int.
  const glm::dvec3 dims(grid.dims);
  return {glm::ivec3(glm::clamp(glm::ceil(least), glm::dvec3(0.0), dims)),
          glm::ivec3(glm::clamp(glm::floor(greatest) + 1.0, glm::dvec3(0.0), dims))};
}

/// The mean of points, and by how much they spread along the axes.
struct Spread {
  explicit Spread(const std::vector<glm::dvec3>& points) {
    for (const glm::dvec3& point : points) mean += point / static_cast<double>(points.size());
    for (const glm::dvec3& point : points)
      covariance += glm::outerProduct(point - mean, point - mean) / static_cast<double>(points.size());
  }
  glm::dvec3 mean{0.0};
  glm::dmat3 covariance{0.0};
};

/// Eigenvectors of a symmetric matrix as columns, by Jacobi's rotations (Golub, Van Loan: Matrix Computations, 8.5),
/// and the eigenvalues; the greatest first.
std::pair<glm::dmat3, glm::dvec3> eigenvectorsOf(glm::dmat3 a) {
  glm::dmat3 vectors(1.0);
  constexpr int sweeps = 24;  // each squares the size of the elements off the diagonal
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (const auto& [p, q] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
      if (a[p][q] == 0.0) continue;
      const double tau = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
      const double t = std::copysign(1.0, tau) / (std::abs(tau) + std::hypot(1.0, tau));
      const double c = 1.0 / std::sqrt(1.0 + t * t), s = t * c;
      glm::dmat3 turn(1.0);
      turn[p][p] = turn[q][q] = c;
      turn[q][p] = s;
      turn[p][q] = -s;
      a = glm::transpose(turn) * a * turn;
      vectors = vectors * turn;
    }
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return a[i][i] > a[j][j]; });
  const auto [i, j, k] = order;
  return {glm::dmat3(vectors[i], vectors[j], vectors[k]), glm::dvec3(a[i][i], a[j][j], a[k][k])};
}

/// A unit vector square to a unit vector.
glm::dvec3 squareTo(glm::dvec3 unit) {
  const glm::dvec3 aside = std::abs(unit.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(unit, aside));
}

}  // namespace

/// Fills the coverages of a box of voxels, part by part.
class Coverer {
 public:
  explicit Coverer(RemovedVoxels& to) : to_(to), worldFromIndex_(to.grid.worldFromIndex()) {}

  void add(const Removal& part) {
    const Solid solid = solidOf(part);
    const VoxelSpan span = spanOf(part, solid, to_.grid);
    if (span.isEmpty()) return;
    const glm::ivec3 tiles = (span.high - span.low + side - 1) / side;
    const auto layer = static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y);
    constexpr std::size_t worthAThread = 64;  // tiles
    parallelFor(static_cast<std::size_t>(tiles.z), worthAThread / layer + 1, [&](std::size_t begin, std::size_t end) {
      for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
        for (int y = 0; y < tiles.y; ++y) {
          interruptionPoint();
          for (int x = 0; x < tiles.x; ++x) {
            const glm::ivec3 low = span.low + glm::ivec3(x, y, z) * side;
            addTile({low, glm::min(low + side, span.high)}, part, solid);
          }
        }
    });
  }

  void copy(const RemovedVoxels& from) {
    for (int z = 0; z < from.size.z; ++z)
      for (int y = 0; y < from.size.y; ++y) {
        const auto row = from.coverage.begin() + static_cast<std::ptrdiff_t>(from.offset({0, y, z}));
        std::copy_n(
            row, from.size.x,
            to_.coverage.begin() + static_cast<std::ptrdiff_t>(to_.offset(from.low + glm::ivec3(0, y, z) - to_.low)));
      }
  }

 private:
  static constexpr int side = 8;  ///< voxels of a tile

  void addTile(const VoxelSpan& tile, const Removal& part, const Solid& solid) {
    const double rim = widestRim(part, to_.grid);
    const glm::dvec3 size(tile.high - tile.low - 1), middle = glm::dvec3(tile.low) + 0.5 * size;
    // No voxel's centre is farther from the tile's middle than the half of its longest diagonal.
    double reach = 0.0;
    for (int corner = 0; corner < 4; ++corner) {
      const glm::dvec3 diagonal(size.x, corner & 1 ? -size.y : size.y, corner & 2 ? -size.z : size.z);
      reach = std::max(reach, 0.5 * glm::length(glm::dmat3(worldFromIndex_) * diagonal));
    }
    const double safe = solid.steepness * (reach + 0.5 * rim);
    const double atMiddle = solid.distance(glm::dvec3(worldFromIndex_ * glm::dvec4(middle, 1.0)));
    if (atMiddle > safe) return;
    if (atMiddle < -safe) return fill(tile);
    glm::ivec3 voxel;
    for (voxel.z = tile.low.z; voxel.z < tile.high.z; ++voxel.z)
      for (voxel.y = tile.low.y; voxel.y < tile.high.y; ++voxel.y)
        for (voxel.x = tile.low.x; voxel.x < tile.high.x; ++voxel.x) {
          std::uint8_t& own = to_.coverage[to_.offset(voxel - to_.low)];
          if (own == 255) continue;
          const glm::dvec3 world(worldFromIndex_ * glm::dvec4(glm::dvec3(voxel), 1.0));
          const double distance = solid.distance(world);
          if (distance >= 0.5 * rim) continue;
          const double share = distance <= -0.5 * rim ? 1.0 : 0.5 - distance / rimAt(world, part, solid);
          own = std::max(own, static_cast<std::uint8_t>(std::clamp(share, 0.0, 1.0) * 255.0 + 0.5));
        }
  }

  double rimAt(glm::dvec3 world, const Removal& part, const Solid& solid) const {
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      const glm::dvec3 half = 0.5 * glm::dvec3(worldFromIndex_[axis]);
      const double change = solid.distance(world + half) - solid.distance(world - half);
      sum += change * change;
    }
    const double width = std::min(std::sqrt(sum), glm::length(to_.grid.spacing));
    return std::max({part.softness, 2.0 * width, std::numeric_limits<double>::min()});
  }

  void fill(const VoxelSpan& tile) {
    for (int z = tile.low.z; z < tile.high.z; ++z)
      for (int y = tile.low.y; y < tile.high.y; ++y)
        std::fill_n(
            to_.coverage.begin() + static_cast<std::ptrdiff_t>(to_.offset(glm::ivec3(tile.low.x, y, z) - to_.low)),
            tile.high.x - tile.low.x, std::uint8_t{255});
  }

  RemovedVoxels& to_;
  glm::dmat4 worldFromIndex_;
};

bool removesAnything(const Removal& removal) {
  const auto isLength = [](double mm) { return std::isfinite(mm) && mm > 0.0; };
  if (removal.points.empty() || !std::all_of(removal.points.begin(), removal.points.end(), isFinite)) return false;
  if (!(removal.softness >= 0.0 && removal.depth >= 0.0 && removal.extent >= 0.0)) return false;
  if (!std::isfinite(removal.softness + removal.depth + removal.extent)) return false;
  const bool hasDirection = isFinite(removal.direction) && isLength(glm::length(removal.direction));
  switch (removal.shape) {
    case RemovalShape::Ball:
      return isLength(removal.size);
    case RemovalShape::Box: {
      const double sine = glm::length(glm::cross(removal.direction, removal.up));
      return hasDirection && isFinite(removal.up) &&
             sine > 1e-6 * glm::length(removal.direction) * glm::length(removal.up) && isLength(removal.sides.x) &&
             isLength(removal.sides.y) && isLength(removal.sides.z);
    }
    case RemovalShape::Saw:
      return hasDirection && isLength(removal.size);
    case RemovalShape::Plane:
      break;
  }
  return hasDirection && std::all_of(removal.bends.begin(), removal.bends.end(), [&](const Bend& bend) {
           return isFinite(bend.point) && std::isfinite(bend.distance) && isLength(bend.radius);
         });
}

StrokePlane::StrokePlane(const std::vector<glm::dvec3>& points, glm::dvec3 towards) {
  constexpr double leastRatio = 1.0 / 20.0, leastVariance = 1e-12;  // the latter mm², of points a micrometre apart
  const Spread spread(points);
  const auto [axes, variances] = eigenvectorsOf(spread.covariance);
  centre = spread.mean;
  first = axes[0];
  normal = axes[2];
  if (!(variances[1] > leastRatio * leastRatio * variances[0])) {
    // On a line, or in one place.
    const bool isLine = variances[0] > leastVariance;
    glm::dvec3 wanted = isLine ? towards - glm::dot(towards, first) * first : towards;
    if (!(glm::length(wanted) > 1e-9 * glm::length(towards))) wanted = squareTo(first);
    normal = glm::normalize(wanted);
    if (!isLine) first = squareTo(normal);
  }
  if (glm::dot(normal, towards) < 0.0) normal = -normal;
  second = glm::cross(normal, first);
}

BentPlane::BentPlane(const StrokePlane& plane, const std::vector<Bend>& bends) : plane_(plane) {
  for (const Bend& bend : bends) {
    const glm::dvec2 place = placeOf(bend.point);
    drags_.push_back({place, at(place).value, bend.distance, bend.radius});
  }
}

glm::dvec2 BentPlane::placeOf(glm::dvec3 world) const {
  return {glm::dot(world - plane_.centre, plane_.first), glm::dot(world - plane_.centre, plane_.second)};
}

BentPlane::Height BentPlane::at(glm::dvec2 place) const {
  Height height;
  for (const Drag& drag : drags_) apply(drag, place, height);
  return height;
}

void BentPlane::apply(const Drag& drag, glm::dvec2 place, Height& height) const {
  const glm::dvec2 beside = place - drag.place;
  const double above = height.value - drag.height;
  const double left = 1.0 - (glm::dot(beside, beside) + above * above) / (drag.radius * drag.radius);
  if (left <= 0.0) return;
  // w = left², whose gradient is 2 left ∇left; ρ² = beside² + above², and above follows the height.
  const glm::dvec2 slope = -4.0 * left / (drag.radius * drag.radius) * (beside + above * height.gradient);
  height.gradient += drag.distance * slope;
  height.value += drag.distance * left * left;
}

std::shared_ptr<const RemovedVoxels> removedVoxels(const Removals& removals, const Grid& grid,
                                                   const std::shared_ptr<const RemovedVoxels>& before) {
  auto result = std::make_shared<RemovedVoxels>();
  result->grid = grid;
  for (const Removal& removal : removals)
    if (removesAnything(removal)) addParts(removal, result->parts);
  std::vector<Removal>& parts = result->parts;
  const bool goesOn = before && before->grid == grid && before->parts.size() <= parts.size() &&
                      std::equal(before->parts.begin(), before->parts.end(), parts.begin());
  VoxelSpan whole{grid.dims, glm::ivec3(0)};
  const auto include = [&](const VoxelSpan& span) {
    if (span.isEmpty()) return;
    whole.low = glm::min(whole.low, span.low);
    whole.high = glm::max(whole.high, span.high);
  };
  if (goesOn) include({before->low, before->low + before->size});
  const std::size_t first = goesOn ? before->parts.size() : 0;
  for (std::size_t i = first; i < parts.size(); ++i) include(spanOf(parts[i], solidOf(parts[i]), grid));
  if (whole.isEmpty()) return nullptr;
  result->low = whole.low;
  result->size = whole.high - whole.low;
  result->coverage.resize(static_cast<std::size_t>(result->size.x) * static_cast<std::size_t>(result->size.y) *
                          static_cast<std::size_t>(result->size.z));
  Coverer coverer(*result);
  if (goesOn) coverer.copy(*before);
  for (std::size_t i = first; i < parts.size(); ++i) coverer.add(parts[i]);
  const bool isAny =
      std::any_of(result->coverage.begin(), result->coverage.end(), [](std::uint8_t c) { return c > 0; });
  return isAny ? result : nullptr;
}

}  // namespace fenestra
