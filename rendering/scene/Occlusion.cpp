#include "rendering/scene/Occlusion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "rendering/scene/Explosion.h"
#include "rendering/scene/Fading.h"
#include "rendering/scene/FaintLabels.h"
#include "rendering/scene/FocusCells.h"
#include "rendering/scene/Importance.h"
#include "rendering/scene/Maximum.h"
#include "rendering/volume/Threads.h"

namespace fenestra {

bool hasOcclusion(const Look& look) {
  const Shading& shading = look.shading;
  return shading.enabled && (shading.occlusion > 0.0 || shading.shadow > 0.0) && !fadingOf(look) &&
         !explosionOf(look) && !maximumOf(look);
}

namespace occlusion {
namespace {

/// Point i of `count` spread evenly over the part of the unit sphere with 1 ≥ z ≥ least (Vogel's spiral).
glm::dvec3 spiral(int i, int count, double least) {
  constexpr double golden = std::numbers::pi * (3.0 - 2.23606797749978969641);
  const double z = 1.0 - (1.0 - least) * (i + 0.5) / count, r = std::sqrt(std::max(0.0, 1.0 - z * z));
  return {r * std::cos(golden * i), r * std::sin(golden * i), z};
}

}  // namespace

std::vector<glm::dvec3> allAround(int count) {
  std::vector<glm::dvec3> directions;
  for (int i = 0; i < count; ++i) directions.push_back(spiral(i, count, -1.0));
  return directions;
}

std::vector<glm::dvec3> towards(glm::dvec3 direction, double radius, int count) {
  const glm::dvec3 aside = std::abs(direction.x) < 0.7 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 u = glm::normalize(glm::cross(direction, aside)), v = glm::cross(direction, u);
  std::vector<glm::dvec3> directions;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 at = spiral(i, count, std::cos(glm::radians(radius)));
    directions.push_back(at.x * u + at.y * v + at.z * direction);
  }
  return directions;
}

double Weight::ramp(double s, double from, double to) {
  const double u = std::clamp((s - from) / (to - from), 0.0, 1.0);
  return 0.5 * (to - from) * u * u + std::max(s - to, 0.0);
}

Weight nearWeight(double side) { return {begin * side, full * side, fade * side, end * side}; }
Weight farWeight(double side) { return {begin * side, full * side, nowhere, 2.0 * nowhere}; }

glm::dvec3 pointInCell(int i) {
  return glm::dvec3(0.2637, 0.2289, 0.2673) + 0.5 * glm::dvec3(i & 1, (i >> 1) & 1, i >> 2);
}

double visibleShare(double at, double start, double context, double width) {
  const double open = std::clamp((start - context) / width, 0.0, 1.0);
  return 1.0 - open * std::clamp((start - at) / width + 0.5, 0.0, 1.0);
}

double clippedShare(double distance, double width) { return std::clamp(distance / width + 0.5, 0.0, 1.0); }

}  // namespace occlusion

namespace {

/// Extinctions of a function of values, tabulated.
class ExtinctionTable {
 public:
  explicit ExtinctionTable(const TransferFunction& function) {
    if (function.nodes.empty()) return;
    const double first = function.nodes.front().value, last = function.nodes.back().value;
    const double margin = std::max(1e-6 * std::max(std::abs(first), 1e-6), (last - first) / steps);
    low_ = first - margin;
    perValue_ = steps / (last + margin - low_);
    for (int i = 0; i <= steps; ++i)
      entries_[static_cast<std::size_t>(i)] = static_cast<float>(function.evaluate(low_ + i / perValue_).extinction);
  }

  float at(double value) const {
    return entries_[static_cast<std::size_t>(std::clamp((value - low_) * perValue_ + 0.5, 0.0, double{steps}))];
  }

 private:
  static constexpr int steps = 4096;
  double low_ = 0.0, perValue_ = 0.0;
  std::vector<float> entries_ = std::vector<float>(steps + 1, 0.0f);
};

/// The labels of a map, voxel by voxel; 0 where there is no map.
class Labels {
 public:
  explicit Labels(const LabelMap* map) {
    if (!map) return;
    if (map->voxels.type() == ScalarType::UInt8)
      bytes_ = map->voxels.as<std::uint8_t>().data();
    else
      words_ = map->voxels.as<std::uint16_t>().data();
  }
  std::uint16_t at(std::size_t voxel) const { return bytes_ ? bytes_[voxel] : words_ ? words_[voxel] : 0; }

 private:
  const std::uint8_t* bytes_ = nullptr;
  const std::uint16_t* words_ = nullptr;
};

constexpr std::size_t labelCount = std::size_t{1} << 16;

/// What a scene's voxels absorb, as the cells' three extinctions.
class Absorber {
 public:
  Absorber(const Scene& scene, KeepsCell keeps)
      : grid_(scene.volume->grid),
        structures_(structuresOf(scene).get()),
        focusLabels_(std::holds_alternative<LabelFocus>(scene.look.focus) ? scene.labels.get() : nullptr),
        keeps_(std::move(keeps)) {
    const FaintLabels faint = faintLabels(scene);
    for (const TransferFunction& function : contextFunctions(scene, faint)) context_.emplace_back(function);
    if (faint.any()) number_ = faint.numberOfLabel();
    role_.assign(labelCount, 0);
    if (structuresOf(scene)) {
      for (const std::uint16_t label : labelsWith(LabelRole::Protected, scene)) mark(label, isProtected);
      for (const std::uint16_t label : scene.look.clipping.exempt) mark(label, isExempt);
    }
    addFocus(scene);
  }

  void add(OccluderCells::Extinction& sum, glm::ivec3 voxel, double value) const {
    const std::size_t offset = grid_.offset(voxel);
    std::size_t number = 0;
    std::uint8_t role = 0;
    if (hasRoles_ || !number_.empty()) {
      const std::uint16_t label = structures_.at(offset);
      if (!number_.empty()) number = number_[label];
      role = role_[label];
    }
    const float context = context_[number].at(value);
    if (role & isExempt) sum.exempt += context;
    if (const Material* held = focusAt(offset, voxel, value))
      (held->givesWay ? sum.context : sum.kept) += extinctionOf(*held, value);
    else
      (role & isProtected ? sum.kept : sum.context) += context;
  }

 private:
  static constexpr std::uint8_t isProtected = 1, isExempt = 2;
  static constexpr int none = -1;

  void mark(std::uint16_t label, std::uint8_t role) {
    role_[label] = static_cast<std::uint8_t>(role_[label] | role);
    hasRoles_ = true;
  }

  void addFocus(const Scene& scene) {
    if (const auto* labels = std::get_if<LabelFocus>(&scene.look.focus); labels && scene.labels) {
      ofLabel_.assign(labelCount, none);
      const auto levels = importanceLevels(scene);
      for (const std::uint16_t label : labels->labels) {
        ofLabel_[label] = static_cast<int>(materials_.size());
        const auto function = focusFunction(scene, label);
        materials_.push_back({static_cast<float>(focusMaterial(scene, label).extinction), none});
        materials_.back().givesWay =
            !levels.empty() && !std::binary_search(levels.back().begin(), levels.back().end(), label);
        if (!function) continue;
        materials_.back().table = static_cast<int>(tables_.size());
        tables_.emplace_back(*function);
      }
    } else if (const auto* values = std::get_if<ValueFocus>(&scene.look.focus)) {
      range_ = values->values;
      isOfValues_ = true;
      if (!keeps_)
        keeps_ = [cells = focusCells(shownVolume(scene), *values)](glm::ivec3 cell) { return cells.contains(cell); };
      materials_.push_back({static_cast<float>(scene.look.focusAppearance.extinction), none});
      if (const auto& function = focusFunction(scene)) {
        materials_.back().table = 0;
        tables_.emplace_back(*function);
      }
    }
  }

  /// Whether some cell around a voxel is kept.
  bool inKeptCell(glm::ivec3 voxel) const {
    for (int i = 0; i < 8; ++i)
      if (keeps_(voxel - glm::ivec3(i & 1, (i >> 1) & 1, i >> 2))) return true;
    return false;
  }

  struct Material {
    float extinction = 0.0f;
    int table = none;       ///< in place of it
    bool givesWay = false;  ///< to labels in focus that are more important
  };

  /// Material of the focus at a voxel; null where the voxel is not in focus.
  const Material* focusAt(std::size_t offset, glm::ivec3 voxel, double value) const {
    int material = none;
    if (!ofLabel_.empty()) material = ofLabel_[focusLabels_.at(offset)];
    if (isOfValues_ && value >= range_.low && value <= range_.high && inKeptCell(voxel)) material = 0;
    return material == none ? nullptr : &materials_[static_cast<std::size_t>(material)];
  }
  float extinctionOf(const Material& held, double value) const {
    return held.table == none ? held.extinction : tables_[static_cast<std::size_t>(held.table)].at(value);
  }

  const Grid& grid_;
  Labels structures_, focusLabels_;
  std::vector<ExtinctionTable> context_, tables_;
  std::vector<std::uint8_t> number_;  ///< of the context's function, by label; empty where there is one
  std::vector<std::uint8_t> role_;    ///< by label
  bool hasRoles_ = false;
  std::vector<int> ofLabel_;  ///< its material, by label in focus; empty unless labels are
  std::vector<Material> materials_;
  ValueRange range_;
  bool isOfValues_ = false;  ///< the focus
  KeepsCell keeps_;
};

/// The voxels of a cell along an axis that are looked at, from its first one.
std::vector<int> samplesAlong(int side) {
  constexpr int most = 4;
  std::vector<int> samples;
  const int count = std::min(side, most);
  for (int i = 0; i < count; ++i) samples.push_back((2 * i + 1) * side / (2 * count));
  return samples;
}

}  // namespace

glm::ivec3 occluderSide(const Grid& grid) {
  const glm::dvec3 size = glm::dvec3(grid.dims) * grid.spacing;
  const double target = std::max({size.x, size.y, size.z}) / occlusion::mostCells;
  return glm::max(glm::ivec3(glm::ceil(target / grid.spacing - 1e-6)), 1);
}

double OccluderCells::sideLength(const Grid& grid) const {
  return std::cbrt(grid.voxelVolume() * side.x * side.y * side.z);
}

OccluderCells occluderCells(const Scene& scene, KeepsCell keeps) {
  const Grid& grid = scene.volume->grid;
  OccluderCells cells;
  cells.side = occluderSide(grid);
  cells.dims = (grid.dims + cells.side - 1) / cells.side;
  Grid lattice;
  lattice.dims = cells.dims;
  cells.extinction.resize(lattice.voxelCount());
  const Absorber absorber(scene, std::move(keeps));
  const std::vector<int> xs = samplesAlong(cells.side.x), ys = samplesAlong(cells.side.y),
                         zs = samplesAlong(cells.side.z);
  const float perSample = 1.0f / static_cast<float>(xs.size() * ys.size() * zs.size());
  const auto most = static_cast<float>(occlusion::mostDepth / cells.sideLength(grid));
  const ShownVolume shown = shownVolume(scene);
  withValues(shown, [&](auto valueAt) {
    parallelFor(static_cast<std::size_t>(cells.dims.z), 1, [&](std::size_t begin, std::size_t end) {
      glm::ivec3 cell;
      for (cell.z = static_cast<int>(begin); cell.z < static_cast<int>(end); ++cell.z)
        for (cell.y = 0; cell.y < cells.dims.y; ++cell.y)
          for (cell.x = 0; cell.x < cells.dims.x; ++cell.x) {
            OccluderCells::Extinction sum;
            for (const int z : zs)
              for (const int y : ys)
                for (const int x : xs) {
                  const glm::ivec3 voxel = cell * cells.side + glm::ivec3(x, y, z);
                  if (grid.contains(voxel)) absorber.add(sum, voxel, valueAt(voxel));
                }
            const auto mean = [&](float of) { return std::min(of * perSample, most); };
            cells.extinction[lattice.offset(cell)] = {mean(sum.context), mean(sum.kept), mean(sum.exempt), 0.0f};
          }
    });
  });
  return cells;
}

}  // namespace fenestra
