#include "rendering/scene/PeeledScene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

/// A box of voxels that is added to a grid: voxel `shift` of the larger one is voxel 0.
struct Wider {
  Grid grid;
  glm::ivec3 shift{0};
};

Wider widened(const Grid& grid, const Peel& peel) {
  glm::dvec3 low(0.0), high(grid.dims - 1);
  const glm::dmat4 indexFromWorld = grid.indexFromWorld();
  for (const glm::dvec3& corner : peel.reach()) {
    const glm::dvec3 index(indexFromWorld * glm::dvec4(corner, 1.0));
    low = glm::min(low, index);
    high = glm::max(high, index);
  }
  // Nothing is brought from beyond the volume, so that only what stands out along the side's axis is needed; but an
  // oblique grid has that along all of its axes.
  const glm::ivec3 before(-glm::floor(low)), last(glm::ceil(high));
  Wider wider{grid, before};
  wider.grid.dims = last + before + 1;
  wider.grid.origin = glm::dvec3(grid.worldFromIndex() * glm::dvec4(-glm::dvec3(before), 1.0));
  return wider;
}

using Part = Peel::Part;

/// Calls use(voxel of the wider grid, its part) for each voxel; the part is empty where the voxel and those that touch
/// its corners belong to several.
template <class Use>
void forEachVoxel(const Wider& to, const Peel& peel, const Use& use) {
  const glm::ivec3 dims = to.grid.dims, around = dims + 2;  // and a voxel beyond each side
  const glm::dmat4 worldFromIndex = to.grid.worldFromIndex();
  const auto width = static_cast<std::size_t>(around.x);
  const auto findParts = [&](int z, std::vector<Part>& parts) {
    for (int y = 0; y < around.y; ++y)
      for (int x = 0; x < around.x; ++x)
        parts[width * static_cast<std::size_t>(y) + static_cast<std::size_t>(x)] =
            peel.sourceOf(glm::dvec3(worldFromIndex * glm::dvec4(x - 1, y - 1, z, 1.0))).part;
  };
  parallelFor(static_cast<std::size_t>(dims.z), 1, [&](std::size_t begin, std::size_t end) {
    std::vector<Part> below(width * static_cast<std::size_t>(around.y)), own(below.size()), above(below.size());
    findParts(static_cast<int>(begin) - 1, own);
    findParts(static_cast<int>(begin), above);
    glm::ivec3 voxel;
    for (voxel.z = static_cast<int>(begin); voxel.z < static_cast<int>(end); ++voxel.z) {
      interruptionPoint();
      std::swap(below, own);
      std::swap(own, above);
      findParts(voxel.z + 1, above);
      for (voxel.y = 0; voxel.y < dims.y; ++voxel.y)
        for (voxel.x = 0; voxel.x < dims.x; ++voxel.x) {
          const std::size_t corner = width * static_cast<std::size_t>(voxel.y) + static_cast<std::size_t>(voxel.x);
          const Part part = own[corner + width + 1];
          const auto isAround = [&](const std::vector<Part>& slice) {
            return slice[corner] == part && slice[corner + 2] == part && slice[corner + 2 * width] == part &&
                   slice[corner + 2 * width + 2] == part;
          };
          use(voxel, isAround(below) && isAround(above) ? std::optional(part) : std::nullopt);
        }
    }
  });
}

/// Reads a scene's volume as a peeled one shows it.
template <class T>
class Resampling {
 public:
  Resampling(const ShownVolume& shown, const FocusVoxels& focus, const Peel& peel, const Wider& to)
      : voxels_(shown),
        grid_(shown.volume->grid),
        stored_(shown.volume->voxels.template as<T>()),
        focus_(focus),
        peel_(peel),
        to_(to),
        worldFromIndex_(to.grid.worldFromIndex()),
        indexFromWorld_(grid_.indexFromWorld()),
        air_((voxels_.air() - shown.volume->intercept) / shown.volume->slope) {}

  T at(glm::ivec3 voxel, std::optional<Part> part) const {
    const glm::ivec3 own = voxel - to_.shift;
    const bool isInside = grid_.contains(own);
    if (isInside && (part == Part::InPlace || focus_.holds(own))) return voxels_.shown(stored_[grid_.offset(own)], own);
    if (part == Part::InPlace || part == Part::Nothing) return rounded(air_);
    const glm::dvec3 centre(voxel);
    if (part) return rounded(valueFrom(peel_.sourceOf(worldAt(centre)), own, isInside));
    return rounded(meanAround(centre, own, isInside));
  }

 private:
  glm::dvec3 worldAt(glm::dvec3 index) const { return glm::dvec3(worldFromIndex_ * glm::dvec4(index, 1.0)); }

  double valueFrom(const Peel::Source& source, glm::ivec3 own, bool isInside) const {
    if (source.part == Part::Nothing) return air_;
    if (source.part == Part::InPlace)
      return isInside ? static_cast<double>(voxels_.shown(stored_[grid_.offset(own)], own)) : air_;
    const glm::dvec3 index(indexFromWorld_ * glm::dvec4(source.world, 1.0));
    if (glm::any(glm::lessThan(index, glm::dvec3(-0.5))) ||
        glm::any(glm::greaterThan(index, glm::dvec3(grid_.dims) - 0.5)))
      return air_;
    return interpolated(grid_, index, [&](glm::ivec3 corner) {
      return focus_.holds(corner) ? air_ : static_cast<double>(voxels_.shown(stored_[grid_.offset(corner)], corner));
    });
  }

  double meanAround(glm::dvec3 centre, glm::ivec3 own, bool isInside) const {
    constexpr int side = 4;
    double sum = 0.0;
    for (int i = 0; i < side * side * side; ++i) {
      const glm::dvec3 place(i % side, i / side % side, i / (side * side));
      sum += valueFrom(peel_.sourceOf(worldAt(centre + 0.5 * place - 0.75)), own, isInside);
    }
    return sum / (side * side * side);
  }

  static T rounded(double stored) { return static_cast<T>(std::is_floating_point_v<T> ? stored : std::round(stored)); }

  const ShownVoxels voxels_;
  const Grid& grid_;
  std::span<const T> stored_;
  const FocusVoxels& focus_;
  const Peel& peel_;
  const Wider& to_;
  glm::dmat4 worldFromIndex_, indexFromWorld_;
  double air_;  ///< stored
};

std::shared_ptr<const Volume> peeledVolume(const ShownVolume& shown, const FocusVoxels& focus, const Peel& peel,
                                           const Wider& to) {
  const Volume& from = *shown.volume;
  auto volume = std::make_shared<Volume>();
  volume->grid = to.grid;
  volume->voxels = Voxels(from.voxels.type(), to.grid.voxelCount());
  volume->slope = from.slope;
  volume->intercept = from.intercept;
  volume->range = from.range;  // so that values are coded alike; no peeled one lies outside
  volume->modality = from.modality;
  volume->unit = from.unit;
  volume->lowIsWhite = from.lowIsWhite;
  volume->windows = from.windows;
  from.voxels.visit([&](auto scalars) {
    using T = std::remove_const_t<typename decltype(scalars)::value_type>;
    const Resampling<T> resampling(shown, focus, peel, to);
    const auto into = volume->voxels.template as<T>();
    forEachVoxel(to, peel, [&](glm::ivec3 voxel, std::optional<Part> part) {
      into[to.grid.offset(voxel)] = resampling.at(voxel, part);
    });
  });
  return volume;
}

std::shared_ptr<const LabelMap> peeledLabels(const LabelMap& from, const FocusVoxels& focus, const Peel& peel,
                                             const Wider& to) {
  auto map = std::make_shared<LabelMap>();
  map->grid = to.grid;
  map->labels = from.labels;
  map->voxels = Voxels(from.voxels.type(), to.grid.voxelCount());
  const glm::dmat4 worldFromIndex = to.grid.worldFromIndex(), indexFromWorld = from.grid.indexFromWorld();
  from.voxels.visit([&](auto labels) {
    using T = std::remove_const_t<typename decltype(labels)::value_type>;
    const auto into = map->voxels.template as<T>();
    const auto labelAt = [&](glm::ivec3 voxel) {
      const glm::ivec3 own = voxel - to.shift;
      const bool isInside = from.grid.contains(own);
      if (isInside && focus.holds(own)) return labels[from.grid.offset(own)];
      const Peel::Source source = peel.sourceOf(glm::dvec3(worldFromIndex * glm::dvec4(glm::dvec3(voxel), 1.0)));
      if (source.part == Part::InPlace) return isInside ? labels[from.grid.offset(own)] : T{0};
      if (source.part == Part::Nothing) return T{0};
      const glm::ivec3 nearest(glm::floor(glm::dvec3(indexFromWorld * glm::dvec4(source.world, 1.0)) + 0.5));
      const bool isMoved = from.grid.contains(nearest) && !focus.holds(nearest);
      return isMoved ? labels[from.grid.offset(nearest)] : T{0};
    };
    parallelFor(static_cast<std::size_t>(to.grid.dims.z), 1, [&](std::size_t begin, std::size_t end) {
      glm::ivec3 voxel;
      for (voxel.z = static_cast<int>(begin); voxel.z < static_cast<int>(end); ++voxel.z)
        for (voxel.y = 0; voxel.y < to.grid.dims.y; ++voxel.y) {
          interruptionPoint();
          for (voxel.x = 0; voxel.x < to.grid.dims.x; ++voxel.x) into[to.grid.offset(voxel)] = labelAt(voxel);
        }
    });
  });
  return map;
}

/// A crop box's faces on the volume's own ends clip nothing; they are moved to those of the wider one.
void widenCrop(Clipping& clipping, const Grid& from, const Grid& to) {
  if (!clipping.cropped) return;
  const CropFrame before(from), after(to);
  for (int axis = 0; axis < 3; ++axis) {
    const double slack = 1e-6 * (before.high[axis] - before.low[axis]);  // as halfSpaces() has it
    double &low = clipping.box.low[axis], &high = clipping.box.high[axis];
    if (low <= before.low[axis] + slack) low = std::min(low, after.low[axis]);
    if (high >= before.high[axis] - slack) high = std::max(high, after.high[axis]);
  }
}

}  // namespace

glm::ivec3 PeeledScene::voxelAt(glm::dvec3 world) const {
  // Clamped before it is rounded: a far position has no int.
  const glm::dvec3 index(grid.indexFromWorld() * glm::dvec4(world, 1.0));
  return glm::ivec3(glm::floor(glm::clamp(index + 0.5, glm::dvec3(-1.0), glm::dvec3(grid.dims))));
}

bool PeeledScene::isInFocus(glm::dvec3 world) const { return focus->holds(voxelAt(world)); }

glm::dvec3 PeeledScene::shownAt(glm::dvec3 world) const { return isInFocus(world) ? world : peel.shownAt(world); }

std::optional<glm::dvec3> PeeledScene::sourceOf(glm::dvec3 world) const {
  if (isInFocus(world)) return world;
  const Peel::Source source = peel.sourceOf(world);
  if (source.part == Part::Nothing || !grid.contains(voxelAt(source.world)) || isInFocus(source.world))
    return std::nullopt;
  return source.world;
}

Peeler::Source Peeler::sourceOf(const Scene& scene) { return {shownVolume(scene), scene.labels, scene.look.focus}; }

bool Peeler::knows(const Scene& scene) const {
  const auto wanted = peelOf(scene.look);
  return !wanted || (wanted == settings_ && scene.structures == structuresOf_ && sourceOf(scene) == source_);
}

std::shared_ptr<const PeeledScene> Peeler::of(const Scene& scene) {
  if (!peelOf(scene.look)) {
    *this = {};
    return nullptr;
  }
  if (!knows(scene)) resample(scene);
  return known(scene);
}

std::shared_ptr<const PeeledScene> Peeler::known(const Scene& scene) const {
  if (!volume_ || !peelOf(scene.look)) return nullptr;
  Scene peeled{volume_, labels_, scene.look};
  peeled.structures = structures_;
  Look& look = peeled.look;
  look.method = {};
  look.cutaway.enabled = false;
  look.reconstruction = source_.shown.reconstruction;
  // What is hidden is air already.
  std::erase_if(look.labels, [&](const LabelSetting& each) {
    return std::binary_search(source_.shown.hidden.begin(), source_.shown.hidden.end(), each.label);
  });
  widenCrop(look.clipping, scene.volume->grid, volume_->grid);
  return std::make_shared<PeeledScene>(PeeledScene{std::move(peeled), *peel_, focus_, scene.volume->grid});
}

void Peeler::resample(const Scene& scene) {
  const Source source = sourceOf(scene);
  if (!focus_ || source != source_) {
    *this = {};
    focus_ = std::make_shared<FocusVoxels>(scene);
    body_ = bodyBox(source.shown);
    source_ = source;
  }
  settings_.reset();  // until all is there, should this be interrupted
  volume_ = nullptr;
  labels_ = structures_ = nullptr;
  const MethodStages::Peel settings = *peelOf(scene.look);
  peel_.emplace(settings, *focus_, scene.volume->grid, body_);
  if (peel_->movesAnything()) {
    const Wider to = widened(scene.volume->grid, *peel_);
    if (scene.labels) labels_ = peeledLabels(*scene.labels, *focus_, *peel_, to);
    if (scene.structures)
      structures_ = scene.structures == scene.labels ? labels_ : peeledLabels(*scene.structures, *focus_, *peel_, to);
    volume_ = peeledVolume(source_.shown, *focus_, *peel_, to);
  }
  structuresOf_ = scene.structures;
  settings_ = settings;
}

}  // namespace fenestra
