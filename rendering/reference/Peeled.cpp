#include "rendering/reference/Peeled.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include <glm/gtc/matrix_transform.hpp>

#include "rendering/scene/FocusCells.h"
#include "rendering/scene/Peel.h"
#include "rendering/volume/Threads.h"

namespace fenestra::reference {
namespace {

constexpr double hair = 1e-6;  // mm; what lies nearer to a face of the opening is outside

/// Which voxels of a scene are in focus.
class InFocus {
 public:
  explicit InFocus(const Scene& scene) : scene_(scene), shown_(shownVolume(scene)), voxels_(shown_) {
    if (const auto* labels = std::get_if<LabelFocus>(&scene.look.focus)) labels_ = labels->labels;
    if (const auto* values = std::get_if<ValueFocus>(&scene.look.focus)) cells_ = focusCells(shown_, *values);
  }

  bool operator()(glm::ivec3 voxel) const {
    if (!scene_.volume->grid.contains(voxel)) return false;
    if (!labels_.empty())
      return scene_.labels && std::find(labels_.begin(), labels_.end(), scene_.labels->value(voxel)) != labels_.end();
    const auto* focus = std::get_if<ValueFocus>(&scene_.look.focus);
    if (!focus || voxels_.isGone(voxel)) return false;
    const double value = voxels_.value(voxel);
    if (!(focus->values.low <= value && value <= focus->values.high)) return false;
    bool isKept = false;
    for (int z = -1; z <= 0; ++z)
      for (int y = -1; y <= 0; ++y)
        for (int x = -1; x <= 0; ++x) isKept = isKept || cells_.contains(voxel + glm::ivec3(x, y, z));
    return isKept;
  }
  /// A voxel's real value as it is moved along; air where it is in focus, because the focus stays in its place.
  double moved(glm::ivec3 voxel) const { return (*this)(voxel) ? voxels_.air() : voxels_.value(voxel); }
  const ShownVoxels& voxels() const { return voxels_; }
  const ShownVolume& shown() const { return shown_; }

 private:
  const Scene& scene_;
  ShownVolume shown_;
  ShownVoxels voxels_;
  std::vector<std::uint16_t> labels_;
  FocusCells cells_;
};

/// The layer in its plane across the cut: l along the break from where it begins to be rolled, h above the break.
class Roll {
 public:
  Roll(double axis, double radius, double thickness) : axis_(axis), radius_(radius), thickness_(thickness) {}

  struct Frame {
    glm::dvec2 break_, along, up;  ///< (w, h): where the break has gone to, and the layer's directions there
  };
  Frame at(double l) const {
    const double turn = std::min(l / radius_, std::numbers::pi);
    const glm::dvec2 along(-std::cos(turn), std::sin(turn)), up(std::sin(turn), std::cos(turn));
    const glm::dvec2 onArc = glm::dvec2(axis_, radius_) - radius_ * up;
    return {onArc + std::max(l - std::numbers::pi * radius_, 0.0) * along, along, up};
  }
  /// The (l, h) that is brought to a place; empty where there is none.
  std::optional<glm::dvec2> sourceOf(glm::dvec2 place) const {
    // How far the place lies ahead of l; it falls as l grows.
    const auto ahead = [&](double l) {
      const Frame frame = at(l);
      return glm::dot(place - frame.break_, frame.along);
    };
    const double half = std::numbers::pi * radius_;
    double low = place.x > axis_ ? half : 0.0, high = place.x > axis_ ? axis_ : std::min(axis_, half);
    if (low > high || ahead(low) < 0.0 || ahead(high) > 0.0) return std::nullopt;
    constexpr int halvings = 60;  // beyond the digits of a double
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (low + high);
      (ahead(middle) > 0.0 ? low : high) = middle;
    }
    const Frame frame = at(low);
    const double h = glm::dot(place - frame.break_, frame.up);
    if (h < 0.0 || h > thickness_) return std::nullopt;
    return glm::dvec2(low, h);
  }

 private:
  double axis_, radius_, thickness_;
};

/// The definitions of Peel.h.
struct Layer {
  glm::dvec3 u, v, a;
  double middleU = 0.0, middleV = 0.0, breakAt = 0.0;
  double thickness = 0.0, halfLength = 0.0, axis = 0.0;  ///< axis: the w of the roll's
  double radius = 1.0;

  Layer(const MethodStages::Peel& peel, const Scene& scene, const InFocus& inFocus) {
    const std::map<PeelSide, std::pair<glm::dvec3, glm::dvec3>> sides{
        {PeelSide::Anterior, {{0, -1, 0}, {0, 0, 1}}}, {PeelSide::Posterior, {{0, 1, 0}, {0, 0, 1}}},
        {PeelSide::Left, {{1, 0, 0}, {0, 0, 1}}},      {PeelSide::Right, {{-1, 0, 0}, {0, 0, 1}}},
        {PeelSide::Superior, {{0, 0, 1}, {0, 1, 0}}},  {PeelSide::Inferior, {{0, 0, -1}, {0, 1, 0}}}};
    a = sides.at(peel.side).first;
    u = glm::dvec3(glm::rotate(glm::dmat4(1.0), glm::radians(peel.turn), a) *
                   glm::dvec4(sides.at(peel.side).second, 0.0));
    v = glm::cross(a, u);
    const Grid& grid = scene.volume->grid;
    const auto [lowU, highU] = extent(grid, inFocus, u);
    const auto [lowV, highV] = extent(grid, inFocus, v);
    const auto [lowA, highA] = extent(grid, inFocus, a);
    const double beside = 0.5 * voxelExtent(grid, a);
    middleU = 0.5 * (lowU + highU);
    middleV = 0.5 * (lowV + highV);
    breakAt = glm::mix(highA + beside, lowA - beside, peel.depth);
    for (const glm::dvec3& corner : bodyBox(inFocus.shown()).corners())
      thickness = std::max(thickness, glm::dot(corner, a) - breakAt);
    const double farthestU = reach(grid, u, middleU), farthestV = reach(grid, v, middleV);
    halfLength = std::min(0.5 * (highU - lowU) + peel.margin, farthestU);
    radius = thickness + peel.radius;
    axis = peel.amount * (std::min(0.5 * (highV - lowV) + peel.margin, farthestV) + radius);
  }

  /// How far the volume reaches along a direction, on whichever side of `from` it reaches farther.
  static double reach(const Grid& grid, glm::dvec3 along, double from) {
    double farthest = 0.0;
    for (const glm::dvec3& corner : grid.corners())
      farthest = std::max(farthest, std::abs(glm::dot(corner, along) - from));
    return farthest;
  }
  static double voxelExtent(const Grid& grid, glm::dvec3 along) {
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis) sum += std::abs(grid.spacing[axis] * glm::dot(grid.direction[axis], along));
    return sum;
  }
  static std::pair<double, double> extent(const Grid& grid, const InFocus& inFocus, glm::dvec3 along) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const glm::dmat4 world = grid.worldFromIndex();
    for (int z = 0; z < grid.dims.z; ++z)
      for (int y = 0; y < grid.dims.y; ++y)
        for (int x = 0; x < grid.dims.x; ++x)
          if (inFocus({x, y, z})) {
            const double at = glm::dot(glm::dvec3(world * glm::dvec4(x, y, z, 1.0)), along);
            low = std::min(low, at);
            high = std::max(high, at);
          }
    if (low > high) return {glm::dot(grid.centre(), along), glm::dot(grid.centre(), along)};
    return {low - 0.5 * voxelExtent(grid, along), high + 0.5 * voxelExtent(grid, along)};
  }

  /// 0: in place; 1: nothing; 2 and 3: of a half of the layer, from `source`.
  int partAt(glm::dvec3 world, glm::dvec3& source) const {
    const double p = glm::dot(world, u) - middleU, q = glm::dot(world, v) - middleV, h = glm::dot(world, a) - breakAt;
    if (h < hair || std::abs(p) > halfLength - hair) return 0;
    const bool isOpen = std::abs(q) < axis - hair;
    const auto from = Roll(axis, radius, thickness).sourceOf({std::abs(q), h});
    // A place outside the opening is covered only by what folds back beyond half a turn.
    if (from && (isOpen || from->x >= std::numbers::pi * radius)) {
      const double w = axis - from->x;
      source = world + (q < 0.0 ? -1.0 : 1.0) * (w - std::abs(q)) * v + (from->y - h) * a;
      return q < 0.0 ? 2 : 3;
    }
    return isOpen ? 1 : 0;
  }
};

/// The volume's grid and as many voxels around it as the rolled layer needs, found by rolling points of it up.
Grid around(const Grid& grid, const Layer& layer, glm::ivec3& before) {
  const Roll roll(layer.axis, layer.radius, layer.thickness);
  const double half = std::numbers::pi * layer.radius;
  double top = layer.thickness;
  for (const double l : {std::min(layer.axis, half), std::min(layer.axis, 0.5 * half)})
    for (const double h : {0.0, layer.thickness}) {
      const Roll::Frame frame = roll.at(l);
      top = std::max(top, (frame.break_ + h * frame.up).y);
    }
  const double side = std::max(layer.axis, roll.at(layer.axis).break_.x);
  glm::dvec3 low(0.0), high(grid.dims - 1);
  double leastP = layer.halfLength, greatestP = -leastP;
  for (const glm::dvec3& corner : grid.corners()) {
    const double p = std::clamp(glm::dot(corner, layer.u) - layer.middleU, -layer.halfLength, layer.halfLength);
    leastP = std::min(leastP, p);
    greatestP = std::max(greatestP, p);
  }
  for (const double p : {leastP, greatestP})
    for (const double q : {-side, side})
      for (const double h : {0.0, top}) {
        const glm::dvec3 world =
            (layer.middleU + p) * layer.u + (layer.middleV + q) * layer.v + (layer.breakAt + h) * layer.a;
        const glm::dvec3 index(grid.indexFromWorld() * glm::dvec4(world, 1.0));
        low = glm::min(low, index);
        high = glm::max(high, index);
      }
  before = glm::ivec3(-glm::floor(low));
  Grid wider = grid;
  wider.dims = glm::ivec3(glm::ceil(high)) + before + 1;
  wider.origin = glm::dvec3(grid.worldFromIndex() * glm::dvec4(-glm::dvec3(before), 1.0));
  return wider;
}

/// One voxel of the peeled volume.
class PeeledVoxel {
 public:
  PeeledVoxel(const Scene& scene, const InFocus& inFocus, const Layer& layer, const Grid& wider, glm::ivec3 before)
      : grid_(scene.volume->grid), inFocus_(inFocus), layer_(layer), wider_(wider), before_(before) {}

  double value(glm::ivec3 voxel) const {
    const glm::ivec3 own = voxel - before_;
    if (inFocus_(own)) return inFocus_.voxels().value(own);
    glm::dvec3 source;
    std::set<int> parts{layer_.partAt(worldAt(glm::dvec3(voxel)), source)};
    for (const int z : {-1, 1})
      for (const int y : {-1, 1})
        for (const int x : {-1, 1})
          parts.insert(layer_.partAt(worldAt(glm::dvec3(voxel + glm::ivec3(x, y, z))), source));
    if (parts.size() == 1) return valueAt(glm::dvec3(voxel), own);
    double sum = 0.0;
    for (const double z : {-0.75, -0.25, 0.25, 0.75})
      for (const double y : {-0.75, -0.25, 0.25, 0.75})
        for (const double x : {-0.75, -0.25, 0.25, 0.75}) sum += valueAt(glm::dvec3(voxel) + glm::dvec3(x, y, z), own);
    return sum / 64.0;
  }

  std::uint16_t label(glm::ivec3 voxel, const LabelMap& labels) const {
    const glm::ivec3 own = voxel - before_;
    if (inFocus_(own)) return labels.value(own);
    glm::dvec3 source;
    const int part = layer_.partAt(worldAt(glm::dvec3(voxel)), source);
    if (part == 1) return 0;
    const glm::ivec3 from = part == 0 ? own : glm::ivec3(glm::floor(indexOf(source) + 0.5));
    return grid_.contains(from) && !inFocus_(from) ? labels.value(from) : std::uint16_t{0};
  }

 private:
  glm::dvec3 worldAt(glm::dvec3 index) const { return glm::dvec3(wider_.worldFromIndex() * glm::dvec4(index, 1.0)); }
  glm::dvec3 indexOf(glm::dvec3 world) const { return glm::dvec3(grid_.indexFromWorld() * glm::dvec4(world, 1.0)); }

  double valueAt(glm::dvec3 index, glm::ivec3 own) const {
    glm::dvec3 source;
    const int part = layer_.partAt(worldAt(index), source);
    const double air = inFocus_.voxels().air();
    if (part == 0) return grid_.contains(own) ? inFocus_.voxels().value(own) : air;
    if (part == 1) return air;
    const glm::dvec3 from = indexOf(source), beyond = glm::abs(from - 0.5 * glm::dvec3(grid_.dims - 1));
    if (glm::any(glm::greaterThan(beyond, 0.5 * glm::dvec3(grid_.dims)))) return air;
    return interpolated(grid_, from, [&](glm::ivec3 voxel) { return inFocus_.moved(voxel); });
  }

  const Grid& grid_;
  const InFocus& inFocus_;
  const Layer& layer_;
  const Grid& wider_;
  glm::ivec3 before_;
};

/// Calls use(voxel) for each voxel of a grid, on all cores.
template <class Use>
void forEachVoxel(const Grid& grid, const Use& use) {
  parallelFor(grid.voxelCount(), 64, [&](std::size_t begin, std::size_t end) {
    const auto x = static_cast<std::size_t>(grid.dims.x), y = static_cast<std::size_t>(grid.dims.y);
    for (std::size_t i = begin; i < end; ++i) use(i, glm::ivec3(i % x, i / x % y, i / (x * y)));
  });
}

std::shared_ptr<const LabelMap> peeledMap(const LabelMap& from, const PeeledVoxel& peeled, const Grid& grid) {
  auto map = std::make_shared<LabelMap>();
  map->grid = grid;
  map->labels = from.labels;
  map->voxels = Voxels(ScalarType::UInt16, grid.voxelCount());
  const auto into = map->voxels.as<std::uint16_t>();
  forEachVoxel(grid, [&](std::size_t i, glm::ivec3 voxel) { into[i] = peeled.label(voxel, from); });
  return map;
}

}  // namespace

std::optional<Scene> peeledScene(const Scene& scene) {
  const auto peel = peelOf(scene.look);
  if (!peel) return std::nullopt;
  const InFocus inFocus(scene);
  const Layer layer(*peel, scene, inFocus);
  Scene result = scene;
  result.look.method = {};
  result.look.cutaway.enabled = false;
  if (!(layer.thickness > 0.0 && layer.axis > 0.0)) return result;
  glm::ivec3 before;
  const Grid grid = around(scene.volume->grid, layer, before);
  const PeeledVoxel peeled(scene, inFocus, layer, grid, before);
  auto volume = std::make_shared<Volume>();
  const Volume& from = *scene.volume;
  volume->grid = grid;
  volume->slope = from.slope;
  volume->intercept = from.intercept;
  volume->range = from.range;
  volume->modality = from.modality;
  volume->unit = from.unit;
  volume->lowIsWhite = from.lowIsWhite;
  volume->windows = from.windows;
  volume->voxels = Voxels(from.voxels.type(), grid.voxelCount());
  from.voxels.visit([&](auto scalars) {
    using T = std::remove_const_t<typename decltype(scalars)::value_type>;
    const auto into = volume->voxels.as<T>();
    forEachVoxel(grid, [&](std::size_t i, glm::ivec3 voxel) {
      const double stored = (peeled.value(voxel) - from.intercept) / from.slope;
      into[i] = static_cast<T>(std::is_floating_point_v<T> ? stored : std::round(stored));
    });
  });
  result.volume = volume;
  if (scene.labels) result.labels = peeledMap(*scene.labels, peeled, grid);
  if (scene.structures) result.structures = peeledMap(*scene.structures, peeled, grid);
  result.table = nullptr;
  result.removed = nullptr;
  result.look.removals.clear();
  result.look.reconstruction = reconstructionOf(scene);
  for (LabelSetting& each : result.look.labels)
    if (std::binary_search(inFocus.shown().hidden.begin(), inFocus.shown().hidden.end(), each.label))
      each = {.label = each.label};
  // Faces of the crop box that clip nothing of the volume clip nothing of what stands out of it.
  CropBox& box = result.look.clipping.box;
  const CropFrame wide(grid);
  for (int axis = 0; axis < 3; ++axis) {
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    const auto clipsNothing = [&](double low, double high) {
      Clipping face;
      face.cropped = true;
      face.box = {glm::dvec3(-unbounded), glm::dvec3(unbounded)};
      face.box.low[axis] = low;
      face.box.high[axis] = high;
      return halfSpaces(face, from.grid).empty();
    };
    if (clipsNothing(box.low[axis], unbounded)) box.low[axis] = std::min(box.low[axis], wide.low[axis]);
    if (clipsNothing(-unbounded, box.high[axis])) box.high[axis] = std::max(box.high[axis], wide.high[axis]);
  }
  return result;
}

}  // namespace fenestra::reference
