#include "rendering/segmentation/RegionCut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>

#include "rendering/segmentation/RegionBalls.h"
#include "rendering/segmentation/VoxelBox.h"

namespace fenestra::segmentation {
namespace {

constexpr double mostCutCells = 60000.0;  ///< of a region: a cut of more takes longer than a click may
constexpr float alwaysHeld = 0.02f;       ///< what a contact across the greatest difference costs, of one without any
constexpr float claimed = 1e12f;          ///< mm²: no cut passes here

/// A network of nodes 0 … count - 1, a source and a sink.
class FlowNetwork {
 public:
  explicit FlowNetwork(std::uint32_t count) : source_(count), sink_(count + 1) {}

  void connect(std::uint32_t a, std::uint32_t b, float capacity) { links_.push_back({a, b, capacity, capacity}); }
  void fromSource(std::uint32_t node, float capacity) { links_.push_back({source_, node, capacity, 0.0f}); }
  void toSink(std::uint32_t node, float capacity) { links_.push_back({node, sink_, capacity, 0.0f}); }

  /// By node: whether it lies behind the cheapest cut; of several such cuts the one nearest to the sink.
  std::vector<std::uint8_t> behindCut() const {
    using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                                     boost::no_property, std::uint32_t, std::uint32_t>;
    const std::size_t nodes = std::size_t{sink_} + 1;
    std::vector<std::uint32_t> next(nodes + 1, 0);
    for (const Link& link : links_)
      for (const std::uint32_t end : {link.a, link.b}) ++next[end + 1];
    for (std::size_t node = 0; node < nodes; ++node) next[node + 1] += next[node];
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges(2 * links_.size());
    std::vector<std::uint32_t> opposite(edges.size());
    std::vector<float> capacities(edges.size()), residuals(edges.size());
    for (const Link& link : links_) {
      const std::uint32_t there = next[link.a]++, back = next[link.b]++;
      edges[there] = {link.a, link.b};
      edges[back] = {link.b, link.a};
      opposite[there] = back;
      opposite[back] = there;
      capacities[there] = link.there;
      capacities[back] = link.back;
    }
    const Graph graph(boost::edges_are_sorted, edges.begin(), edges.end(), static_cast<std::uint32_t>(nodes));
    using Edge = boost::graph_traits<Graph>::edge_descriptor;
    std::vector<Edge> reverse(edges.size()), predecessors(nodes);
    for (std::uint32_t i = 0; i < edges.size(); ++i) reverse[i] = Edge(edges[opposite[i]].first, opposite[i]);
    std::vector<boost::default_color_type> colours(nodes);
    std::vector<std::uint32_t> distances(nodes);
    const auto ofEdge = boost::get(boost::edge_index, graph);
    const auto ofNode = boost::get(boost::vertex_index, graph);
    const auto map = [](auto& values, auto index) { return boost::make_iterator_property_map(values.begin(), index); };
    boost::boykov_kolmogorov_max_flow(graph, map(capacities, ofEdge), map(residuals, ofEdge), map(reverse, ofEdge),
                                      map(predecessors, ofNode), map(colours, ofNode), map(distances, ofNode), ofNode,
                                      source_, sink_);
    std::vector<std::uint8_t> behind(source_);
    for (std::size_t node = 0; node < behind.size(); ++node) behind[node] = colours[node] == boost::white_color ? 1 : 0;
    return behind;
  }

 private:
  struct Link {
    std::uint32_t a, b;
    float there, back;
  };
  std::uint32_t source_, sink_;
  std::vector<Link> links_;
};

/// A region as cells of whole voxels, as even in mm as those allow.
class CutCells {
 public:
  CutCells(const Volume& volume, std::span<const Level> joins, int step)
      : volume_(volume), whole_(wholeOf(volume.grid.dims)), joins_(joins), step_(step) {
    std::size_t voxels = 0;
    box_ = {whole_.high, whole_.low};
    for (std::size_t i = 0; i < joins.size(); ++i)
      if (joins[i] < step) {
        const glm::ivec3 at = whole_.at(i);
        box_ = {glm::min(box_.low, at), glm::max(box_.high, at + 1)};
        ++voxels;
      }
    if (box_.empty()) return;
    const double side = std::cbrt(static_cast<double>(voxels) * volume.grid.voxelVolume() / mostCutCells);
    size_ = glm::max(glm::ivec3(1), glm::ivec3(glm::round(glm::dvec3(side) / volume.grid.spacing)));
    cells_ = wholeOf((box_.dims() + size_ - 1) / size_);
    numbers_.assign(cells_.count(), none);
    forRegion([&](glm::ivec3 voxel) {
      std::uint32_t& number = numbers_[cellOf(voxel)];
      if (number == none) {
        number = static_cast<std::uint32_t>(held_.size());
        held_.push_back(0);
      }
      ++held_[number];
    });
  }

  bool holds(glm::ivec3 voxel) const { return whole_.contains(voxel) && joins_[whole_.offset(voxel)] < step_; }
  std::uint32_t numberOf(glm::ivec3 voxel) const { return numbers_[cellOf(voxel)]; }
  std::uint32_t count() const { return static_cast<std::uint32_t>(held_.size()); }
  /// mm³
  double volume() const { return std::accumulate(held_.begin(), held_.end(), 0.0) * volume_.grid.voxelVolume(); }
  double volumeOf(std::uint32_t number) const { return held_[number] * volume_.grid.voxelVolume(); }  ///< mm³

  template <class Visit>
  void forRegion(Visit visit) const {
    for (std::size_t i = 0; i < box_.count(); ++i)
      if (const glm::ivec3 voxel = box_.at(i); holds(voxel)) visit(voxel);
  }

  /// visit(cell, next cell, mm² of their contact times its weight, mm from one to the next).
  template <class Visit>
  void forContacts(double edge, Visit visit) const {
    const auto unit = static_cast<float>(edge);
    for (int axis = 0; axis < 3; ++axis) {
      const auto face = static_cast<float>(volume_.grid.voxelVolume() / volume_.grid.spacing[axis]);
      const auto length = static_cast<float>(size_[axis] * volume_.grid.spacing[axis]);
      std::vector<float> areas(cells_.count(), 0.0f);
      forRegion([&](glm::ivec3 voxel) {
        glm::ivec3 next = voxel;
        ++next[axis];
        if (!holds(next) || cellOf(next) == cellOf(voxel)) return;
        const float apart = static_cast<float>(volume_.value(next) - volume_.value(voxel)) / unit;
        const float square = apart * apart;  // not a number where a value is none: as far apart as can be
        areas[cellOf(voxel)] +=
            face * (alwaysHeld + (square < std::numeric_limits<float>::max() ? 1.0f / (1.0f + square) : 0.0f));
      });
      for (std::size_t cell = 0; cell < areas.size(); ++cell)
        if (areas[cell] > 0.0f) {
          glm::ivec3 next = cells_.at(cell);
          ++next[axis];
          visit(numbers_[cell], numbers_[cells_.offset(next)], areas[cell], length);
        }
    }
  }

 private:
  static constexpr std::uint32_t none = UINT32_MAX;

  std::size_t cellOf(glm::ivec3 voxel) const { return cells_.offset((voxel - box_.low) / size_); }

  const Volume& volume_;
  VoxelBox whole_, box_, cells_;
  std::span<const Level> joins_;
  int step_;
  glm::ivec3 size_{1};                  ///< voxels along the sides of a cell
  std::vector<std::uint32_t> numbers_;  ///< by cell of the box: its place among those of the region
  std::vector<std::uint32_t> held_;     ///< by number: voxels of the region
};

/// The ways between neighbouring cells.
class CellPaths {
 public:
  explicit CellPaths(std::uint32_t count) : first_(std::size_t{count} + 1, 0) {}

  void connect(std::uint32_t a, std::uint32_t b, float length) { ways_.push_back({a, b, length}); }
  /// After the last connect(), before lengthsFrom().
  void sort() {
    for (const Way& way : ways_)
      for (const std::uint32_t end : {way.a, way.b}) ++first_[end + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    next_.resize(2 * ways_.size());
    std::vector<std::uint32_t> at(first_.begin(), first_.end() - 1);
    for (const Way& way : ways_) {
      next_[at[way.a]++] = {way.b, way.length};
      next_[at[way.b]++] = {way.a, way.length};
    }
    ways_ = {};
  }
  /// By cell: mm of the shortest way from one; infinity where there is none.
  std::vector<float> lengthsFrom(std::uint32_t cell) const {
    using Reached = std::pair<float, std::uint32_t>;
    std::vector<float> lengths(first_.size() - 1, std::numeric_limits<float>::infinity());
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> front;
    const auto reach = [&](float length, std::uint32_t to) {
      if (length >= lengths[to]) return;
      lengths[to] = length;
      front.emplace(length, to);
    };
    reach(0.0f, cell);
    while (!front.empty()) {
      const auto [length, from] = front.top();
      front.pop();
      if (length > lengths[from]) continue;
      for (std::uint32_t i = first_[from]; i < first_[from + 1]; ++i) reach(length + next_[i].second, next_[i].first);
    }
    return lengths;
  }

 private:
  struct Way {
    std::uint32_t a, b;
    float length;  ///< mm
  };
  std::vector<Way> ways_;
  std::vector<std::uint32_t> first_;  ///< by cell, and one more: where its neighbours begin
  std::vector<std::pair<std::uint32_t, float>> next_;
};

enum class Side : std::uint8_t { None, Inside, Outside };

/// By cell: whose ball holds it. Where balls of both sides meet, the one that it lies deeper in.
class Claims {
 public:
  Claims(const RegionBalls& shape, const CutCells& cells, bool mayLeak)
      : shape_(shape),
        cells_(cells),
        mayLeak_(mayLeak),
        sides_(cells.count(), Side::None),
        places_(cells.count(), std::numeric_limits<double>::infinity()) {}

  /// Seeds that do not lie in the region claim nothing; false where that is so of all those outside.
  bool add(std::span<const glm::ivec3> inside, std::span<const glm::ivec3> outside) {
    std::vector<HeldBall> balls;
    for (const glm::ivec3 seed : outside)
      if (cells_.holds(seed)) balls.push_back(shape_.ballAt(seed));
    if (balls.empty()) return false;
    for (const glm::ivec3 seed : inside) {
      if (!cells_.holds(seed)) continue;
      const HeldBall own = shape_.ballAt(seed), body = shape_.bodyOf(own);
      claim(own, Side::Inside);
      if (deepest_ == 0.0) deepest_ = shape_.depthOf(own);
      // In a leak a further seed means what lies around it.
      if (seed != inside.front() && mayLeak_ &&
          std::ranges::any_of(balls, [this](const HeldBall& ball) { return isLeak(ball); }))
        continue;
      // A seed outside that lies in the middle of the body, or far nearer to it, means the body.
      const bool isOutside =
          std::ranges::any_of(balls, [&](const HeldBall& ball) { return shape_.means(ball, own, body); });
      if (!isOutside) claim(body, Side::Inside);
    }
    for (const HeldBall& ball : balls) claim(ball, Side::Outside);
    return true;
  }

  Side of(std::uint32_t cell) const { return sides_[cell]; }

  /// Whether a seed outside lies in a part that is far thicker than the one that the first seed inside lies in: that is
  /// a leak, and what is beside the seed's ball is meant, too.
  bool haveLeak() const {
    return std::ranges::any_of(balls_,
                               [this](const auto& each) { return each.second == Side::Outside && isLeak(each.first); });
  }

  /// By cell: whether the way to it from the ball of such a seed is shorter than from any ball of those inside, each
  /// measured in the ball's radii.
  std::vector<std::uint8_t> inLeak(const CellPaths& paths) const {
    std::array<std::vector<float>, 2> least;
    for (auto& each : least) each.assign(sides_.size(), std::numeric_limits<float>::infinity());
    for (const auto& each : balls_) {
      const auto& [ball, side] = each;
      if (side == Side::Outside && !isLeak(ball)) continue;
      const std::vector<float> lengths = paths.lengthsFrom(cells_.numberOf(ball.centre));
      std::vector<float>& own = least[side == Side::Outside ? 1 : 0];
      for (std::size_t cell = 0; cell < own.size(); ++cell)
        own[cell] = std::min(own[cell], lengths[cell] / static_cast<float>(ball.radius));
    }
    std::vector<std::uint8_t> isIn(sides_.size());
    for (std::size_t cell = 0; cell < isIn.size(); ++cell) isIn[cell] = least[1][cell] < least[0][cell] ? 1 : 0;
    return isIn;
  }

 private:
  bool isLeak(const HeldBall& outside) const { return mayLeak_ && outside.depth > leakThickness * deepest_; }

  void claim(const HeldBall& ball, Side side) {
    balls_.emplace_back(ball, side);
    for (const auto& [offset, length] : shape_.offsets()) {
      const double place = length / ball.radius;
      if (place >= 1.0) break;
      const std::uint32_t cell = cells_.numberOf(ball.centre + offset);
      if (place >= places_[cell]) continue;
      places_[cell] = place;
      sides_[cell] = side;
    }
  }

  const RegionBalls& shape_;
  const CutCells& cells_;
  bool mayLeak_;             ///< the region is large enough for a leak
  std::vector<Side> sides_;  ///< by cell
  double deepest_ = 0.0;     ///< mm: the depth of the part that the first seed inside lies in
  std::vector<std::pair<HeldBall, Side>> balls_;
  std::vector<double> places_;  ///< by cell: its distance from the seed over the ball's radius
};

/// Takes away what no seed inside is connected with any more, too.
void takeLoose(const CutCells& cells, const VoxelBox& whole, std::span<const glm::ivec3> inside,
               std::vector<std::uint8_t>& taken) {
  std::vector<std::uint8_t> isKept(taken.size(), 0);
  std::vector<glm::ivec3> kept;
  const auto keep = [&](glm::ivec3 voxel) {
    if (!cells.holds(voxel) || taken[whole.offset(voxel)] || isKept[whole.offset(voxel)]) return;
    isKept[whole.offset(voxel)] = 1;
    kept.push_back(voxel);
  };
  std::ranges::for_each(inside, keep);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const VoxelBox around{kept[i] - 1, kept[i] + 2};
    for (std::size_t n = 0; n < around.count(); ++n) keep(around.at(n));
  }
  cells.forRegion([&](glm::ivec3 voxel) { taken[whole.offset(voxel)] = isKept[whole.offset(voxel)] ? 0 : 1; });
}

}  // namespace

std::vector<std::uint8_t> cutOff(const Volume& volume, std::span<const Level> joins, int step,
                                 std::span<const glm::ivec3> inside, std::span<const glm::ivec3> outside,
                                 const CutCost& cost) {
  const VoxelBox whole = wholeOf(volume.grid.dims);
  std::vector<std::uint8_t> taken(joins.size(), 0);
  const CutCells cells(volume, joins, step);
  const RegionBalls shape(volume.grid, joins, step);
  Claims claims(shape, cells, cells.volume() > cost.leak);
  if (!claims.add(inside, outside)) return taken;
  FlowNetwork network(cells.count());
  const bool hasLeak = claims.haveLeak();
  CellPaths paths(cells.count());
  cells.forContacts(cost.edge, [&](std::uint32_t a, std::uint32_t b, float area, float length) {
    network.connect(a, b, area);
    if (hasLeak) paths.connect(a, b, length);
  });
  std::vector<std::uint8_t> inLeak(cells.count(), 0);
  if (hasLeak) {
    paths.sort();
    inLeak = claims.inLeak(paths);
  }
  for (std::uint32_t cell = 0; cell < cells.count(); ++cell) {
    if (claims.of(cell) == Side::Outside)
      network.toSink(cell, claimed);
    else if (claims.of(cell) == Side::None && inLeak[cell])
      network.toSink(cell, static_cast<float>(cost.perVolume * cells.volumeOf(cell)));
    else
      network.fromSource(
          cell, claims.of(cell) == Side::Inside ? claimed : static_cast<float>(cost.perVolume * cells.volumeOf(cell)));
  }
  const auto take = [&](auto isTaken) {
    cells.forRegion([&](glm::ivec3 voxel) { taken[whole.offset(voxel)] = isTaken(cells.numberOf(voxel)) ? 1 : 0; });
  };
  const std::vector<std::uint8_t> behind = network.behindCut();
  take([&](std::uint32_t cell) { return behind[cell] != 0; });
  double all = 0.0, left = 0.0;  // mm³
  takeLoose(cells, whole, inside, taken);
  cells.forRegion([&](glm::ivec3 voxel) {
    all += volume.grid.voxelVolume();
    left += taken[whole.offset(voxel)] ? 0.0 : volume.grid.voxelVolume();
  });
  // The seeds inside lie in no part of their own, and nothing tells how much those outside mean.
  if (left < cost.crumb && all > cost.crumb) take([&](std::uint32_t cell) { return claims.of(cell) == Side::Outside; });
  return taken;
}

}  // namespace fenestra::segmentation
