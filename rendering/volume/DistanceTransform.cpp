#include "rendering/volume/DistanceTransform.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <nanoflann.hpp>

#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

/// Squared distances along a line of points to the nearest of a set, from those of the axes before.
class LowerEnvelope {
 public:
  /// Squares beyond `mostSquare` play no part.
  LowerEnvelope(std::size_t length, double spacing, float mostSquare)
      : square_(spacing * spacing), mostSquare_(mostSquare), places_(length), bounds_(length) {}

  /// to[i]: the squared distance at the point first + i · step, from those at the points 0, 1, 2, … .
  void sample(std::span<const float> from, int first, int step, std::span<float> to) {
    find(from);
    if (last_ < 0) return std::fill(to.begin(), to.end(), std::numeric_limits<float>::infinity());
    int parabola = 0;
    for (std::size_t i = 0; i < to.size(); ++i) {
      const int q = first + static_cast<int>(i) * step;
      if (q >= 0 && q < static_cast<int>(from.size()) && from[static_cast<std::size_t>(q)] == 0.0f) {
        to[i] = 0.0f;
        continue;
      }
      while (parabola < last_ && bounds_[static_cast<std::size_t>(parabola) + 1] < q) ++parabola;
      const int p = places_[static_cast<std::size_t>(parabola)];
      const double away = static_cast<double>(q) - p;
      to[i] = static_cast<float>(square_ * away * away + from[static_cast<std::size_t>(p)]);
    }
  }

 private:
  /// The parabolas of the envelope, and where each begins.
  void find(std::span<const float> from) {
    last_ = -1;
    const auto isZero = [&](int q) {
      return q >= 0 && q < static_cast<int>(from.size()) && from[static_cast<std::size_t>(q)] == 0.0f;
    };
    for (int q = 0; q < static_cast<int>(from.size()); ++q) {
      if (!(from[static_cast<std::size_t>(q)] <= mostSquare_)) continue;
      // Points outside a stretch of the set are nearer to its ends than to what lies between them.
      if (isZero(q) && isZero(q - 1) && isZero(q + 1)) continue;
      double start = -std::numeric_limits<double>::infinity();
      for (; last_ >= 0; --last_) {
        const int p = places_[static_cast<std::size_t>(last_)];
        const double difference =
            (static_cast<double>(from[static_cast<std::size_t>(q)]) - from[static_cast<std::size_t>(p)]) / square_;
        start = (difference + static_cast<double>(q) * q - static_cast<double>(p) * p) / (2.0 * (q - p));
        if (start > bounds_[static_cast<std::size_t>(last_)]) break;
      }
      if (last_ < 0) start = -std::numeric_limits<double>::infinity();
      ++last_;
      places_[static_cast<std::size_t>(last_)] = q;
      bounds_[static_cast<std::size_t>(last_)] = start;
    }
  }

  double square_;
  float mostSquare_;
  int last_ = -1;
  std::vector<int> places_;
  std::vector<double> bounds_;
};

std::size_t product(int a, int b) { return static_cast<std::size_t>(a) * static_cast<std::size_t>(b); }

/// Replaces the squares of `size` points, x fastest, by those at the lattice's points along y or z, at every line of
/// the others.
void sampleAlong(int axis, std::vector<float>& squares, glm::ivec3 size, double spacing, float mostSquare,
                 const SampledLattice& at) {
  glm::ivec3 result = size;
  result[axis] = at.points[axis];
  // A line is copied out before it is written, so that lines of the same length need no room of their own.
  std::vector<float> elsewhere;
  if (result != size) elsewhere.resize(product(result.x, result.y) * static_cast<std::size_t>(result.z));
  std::vector<float>& sampled = result != size ? elsewhere : squares;
  const auto length = static_cast<std::size_t>(size[axis]), count = static_cast<std::size_t>(at.points[axis]);
  const auto row = static_cast<std::size_t>(size.x);
  const std::size_t step = axis == 1 ? row : product(size.x, size.y);
  const std::size_t stepOut = axis == 1 ? row : product(result.x, result.y);
  const int other = 3 - axis;
  const std::size_t plane = axis == 1 ? product(size.x, size.y) : row;
  const std::size_t planeOut = axis == 1 ? product(result.x, result.y) : row;
  // Neighbouring lines are copied out together: they share the cache's lines.
  constexpr std::size_t together = 16;
  parallelFor(static_cast<std::size_t>(size[other]), 1, [&](std::size_t begin, std::size_t end) {
    LowerEnvelope envelope(length, spacing, mostSquare);
    std::vector<float> lines(length * together), found(count * together);
    for (std::size_t each = begin; each < end; ++each)
      for (std::size_t x = 0; x < row; x += together) {
        const std::size_t width = std::min(together, row - x);
        const float* from = squares.data() + each * plane + x;
        float* to = sampled.data() + each * planeOut + x;
        for (std::size_t q = 0; q < length; ++q)
          for (std::size_t i = 0; i < width; ++i) lines[i * length + q] = from[q * step + i];
        for (std::size_t i = 0; i < width; ++i)
          envelope.sample(std::span(lines).subspan(i * length, length), at.first[axis], at.step[axis],
                          std::span(found).subspan(i * count, count));
        for (std::size_t q = 0; q < count; ++q)
          for (std::size_t i = 0; i < width; ++i) to[q * stepOut + i] = found[i * count + q];
      }
  });
  if (result != size) squares = std::move(elsewhere);
}

std::vector<float> byEnvelopes(std::span<const std::uint8_t> set, glm::ivec3 size, glm::dvec3 spacing,
                               const SampledLattice& at, double reach) {
  // A little more than the square, for rounding. Infinite squares are none in any case.
  const auto mostSquare =
      static_cast<float>(std::min(reach * reach * 1.0001, double{std::numeric_limits<float>::max()}));
  const auto length = static_cast<std::size_t>(size.x), count = static_cast<std::size_t>(at.points.x);
  std::vector<float> squares(count * product(size.y, size.z));
  parallelFor(product(size.y, size.z), 64, [&](std::size_t begin, std::size_t end) {
    LowerEnvelope envelope(length, spacing.x, mostSquare);
    std::vector<float> line(length);
    for (std::size_t row = begin; row < end; ++row) {
      for (std::size_t x = 0; x < length; ++x)
        line[x] = set[row * length + x] ? 0.0f : std::numeric_limits<float>::infinity();
      envelope.sample(line, at.first.x, at.step.x, std::span(squares).subspan(row * count, count));
    }
  });
  size.x = at.points.x;
  sampleAlong(1, squares, size, spacing.y, mostSquare, at);
  size.y = at.points.y;
  sampleAlong(2, squares, size, spacing.z, mostSquare, at);
  parallelFor(squares.size(), 1 << 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) squares[i] = std::sqrt(squares[i]);
  });
  return squares;
}

/// Points as nanoflann's k-d tree reads them.
struct PointCloud {
  std::vector<glm::dvec3> points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t point, std::size_t axis) const { return points[point][static_cast<int>(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;  // the tree finds it
  }
};
using PointTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointCloud>, PointCloud, 3, std::size_t>;

/// The square of the distance to the nearest point, or `least` where none is nearer than that.
double squareTo(const PointTree& tree, glm::dvec3 place, double least) {
  std::size_t nearest = 0;
  double square = 0.0;
  nanoflann::KNNResultSet<double, std::size_t> found(1);
  found.init(&nearest, &square);
  square = least;  // what the set looks at to leave out branches
  tree.findNeighbors(found, &place.x, {});
  return square;
}

std::vector<float> bySearch(std::span<const std::uint8_t> set, const Grid& grid, const SampledLattice& at) {
  const glm::dmat3 fromIndex = glm::dmat3(grid.worldFromIndex());
  const auto isIn = [&](glm::ivec3 index) { return grid.contains(index) && set[grid.offset(index)] != 0; };
  // Also the points inside the set: in a sheared grid one of them may be nearer than those at its border.
  PointCloud cloud;
  for (int z = 0; z < grid.dims.z; ++z)
    for (int y = 0; y < grid.dims.y; ++y)
      for (int x = 0; x < grid.dims.x; ++x)
        if (isIn({x, y, z})) cloud.points.push_back(fromIndex * glm::dvec3(x, y, z));
  const PointTree tree(3, cloud);
  const double step = glm::length(fromIndex[0]) * at.step.x;
  const auto count = static_cast<std::size_t>(at.points.x);
  std::vector<float> distances(at.count());
  parallelFor(product(at.points.y, at.points.z), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      interruptionPoint();
      const auto y = static_cast<int>(row % static_cast<std::size_t>(at.points.y));
      const auto z = static_cast<int>(row / static_cast<std::size_t>(at.points.y));
      double before = std::numeric_limits<double>::infinity();
      for (int x = 0; x < at.points.x; ++x) {
        const glm::ivec3 index = at.first + at.step * glm::ivec3(x, y, z);
        // No farther than by way of the point before; a little more for rounding.
        const double reach = (before + step) * (1.0 + 1e-12);
        before = isIn(index) ? 0.0 : std::sqrt(squareTo(tree, fromIndex * glm::dvec3(index), reach * reach));
        distances[row * count + static_cast<std::size_t>(x)] = static_cast<float>(before);
      }
    }
  });
  return distances;
}

}  // namespace

bool isOrthogonal(const Grid& grid) {
  constexpr double rounding = 1e-4;  // of a cosine, as files state them
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(glm::dot(grid.direction[axis], grid.direction[(axis + 1) % 3])) > rounding) return false;
  return true;
}

std::vector<float> distancesTo(std::span<const std::uint8_t> set, const Grid& grid, const SampledLattice& at,
                               double reach) {
  constexpr float none = std::numeric_limits<float>::infinity();
  if (std::all_of(set.begin(), set.end(), [](std::uint8_t held) { return held == 0; }))
    return std::vector<float>(at.count(), none);
  std::vector<float> distances =
      isOrthogonal(grid) ? byEnvelopes(set, grid.dims, grid.spacing, at, reach) : bySearch(set, grid, at);
  if (std::isinf(reach)) return distances;
  parallelFor(distances.size(), 1 << 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) distances[i] = distances[i] <= reach ? distances[i] : none;
  });
  return distances;
}

}  // namespace fenestra
