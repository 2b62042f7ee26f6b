#include "rendering/scene/Scene.h"

#include <algorithm>
#include <array>
#include <mutex>

#include "rendering/scene/Parallel.h"
#include "rendering/scene/VisibleValues.h"

namespace fenestra {
namespace {

/// Role in which a label outside the focus is shown: at opacity 0 it is hidden.
LabelRole shownRole(const LabelSetting& setting) { return setting.opacity > 0.0 ? setting.role : LabelRole::Hidden; }

/// Whether a label of structuresOf(scene) is in focus.
bool isInFocus(const Scene& scene, std::uint16_t label) {
  const auto* focus = focusesStructures(scene) ? std::get_if<LabelFocus>(&scene.look.focus) : nullptr;
  return focus && std::binary_search(focus->labels.begin(), focus->labels.end(), label);
}

}  // namespace

bool hasCutaway(const Scene& scene) {
  return scene.look.cutaway.enabled && stagesOf(scene.look.method).start != MethodStages::Start::Entry &&
         (std::holds_alternative<LabelFocus>(scene.look.focus) || std::holds_alternative<ValueFocus>(scene.look.focus));
}

bool readsContextSurface(const Scene& scene) {
  return hasCutaway(scene) && (scene.look.contextLayer.strength > 0.0 || stagesOf(scene.look.method).lens);
}

ShownVolume shownVolume(const Scene& scene) {
  ShownVolume shown{scene.volume};
  if (scene.look.hideTable && scene.table && scene.table->count > 0) shown.table = scene.table;
  shown.hidden = labelsWith(LabelRole::Hidden, scene);
  if (!shown.hidden.empty()) shown.labels = structuresOf(scene);
  shown.reconstruction = reconstructionOf(scene);
  shown.removed = scene.removed;
  return shown;
}

Reconstruction reconstructionOf(const Scene& scene) {
  if (scene.look.reconstruction != Reconstruction::Auto || !scene.volume) return scene.look.reconstruction;
  const Grid& grid = scene.volume->grid;
  const double pixel = 2.0 * grid.boundingRadius() / pixelsAcrossVolume;
  const bool coarse = std::max({grid.spacing.x, grid.spacing.y, grid.spacing.z}) > pixel;
  return coarse && grid.voxelCount() <= mostSplineVoxels ? Reconstruction::Smooth : Reconstruction::Linear;
}

const std::shared_ptr<const LabelMap>& structuresOf(const Scene& scene) {
  return scene.structures ? scene.structures : scene.labels;
}

bool focusesStructures(const Scene& scene) { return !scene.structures || scene.structures == scene.labels; }

std::vector<std::uint16_t> labelsWith(LabelRole role, const Scene& scene) {
  std::vector<std::uint16_t> found;
  if (!structuresOf(scene)) return found;
  for (const LabelSetting& each : scene.look.labels) {
    if (shownRole(each) != role || (role == LabelRole::Protected && !each.visible)) continue;
    if (!isInFocus(scene, each.label)) found.push_back(each.label);
  }
  return found;
}

bool isInContext(const Scene& scene, const LabelSetting& setting) {
  return structuresOf(scene) && shownRole(setting) != LabelRole::Hidden && !isInFocus(scene, setting.label);
}

OpticalProperties focusMaterial(const Scene& scene, std::uint16_t label) {
  const LabelSetting setting =
      focusesStructures(scene) ? settingFor(scene.look.labels, label) : LabelSetting{.label = label};
  const Label* known = scene.labels->find(label);
  const glm::dvec3 own = known ? known->colour : defaultLabelColour(label);
  return {setting.colour.value_or(own),
          setting.visible ? opticalExtinction(scene.look.focusAppearance.extinction, setting.opacity) : 0.0};
}

std::optional<TransferFunction> focusFunction(const Scene& scene, std::uint16_t label) {
  if (!focusesStructures(scene)) return scene.look.focusAppearance.function;
  LabelSetting setting = settingFor(scene.look.labels, label);
  if (!setting.function) return {};
  return atOpacity(std::move(*setting.function), setting.visible ? setting.opacity : 0.0);
}

const std::optional<TransferFunction>& focusFunction(const Scene& scene) { return scene.look.focusAppearance.function; }

bool hasFocusFunction(const Scene& scene) {
  if (std::holds_alternative<ValueFocus>(scene.look.focus)) return focusFunction(scene).has_value();
  const auto* focus = std::get_if<LabelFocus>(&scene.look.focus);
  if (!focus) return false;
  if (!focusesStructures(scene)) return scene.look.focusAppearance.function.has_value();
  return std::any_of(scene.look.labels.begin(), scene.look.labels.end(), [&](const LabelSetting& each) {
    return each.function && std::binary_search(focus->labels.begin(), focus->labels.end(), each.label);
  });
}

Grid visibleGrid(const ShownVolume& of, const TransferFunction& context) {
  constexpr double leastShare = 0.01;  // of the fullest slab
  ShownVolume shown = of;
  shown.removed = nullptr;  // cameras do not move with what is carved away
  const Volume& volume = *shown.volume;
  const Grid& grid = volume.grid;
  const ShownVoxels voxels(shown);
  std::array<std::vector<std::size_t>, 3> counts;
  for (int axis = 0; axis < 3; ++axis)
    counts[static_cast<std::size_t>(axis)].resize(static_cast<std::size_t>(grid.dims[axis]));
  std::mutex mutex;
  volume.voxels.visit([&](auto scalars) {
    using T = std::remove_const_t<typename decltype(scalars)::value_type>;
    const VisibleValues<T> shows(volume, context);
    parallelFor(static_cast<std::size_t>(grid.dims.z), 4, [&](std::size_t begin, std::size_t end) {
      auto local = counts;
      std::vector<T> buffer;
      for (auto& axis : local) std::fill(axis.begin(), axis.end(), std::size_t{0});
      // Every other row is enough to find the extent.
      for (std::size_t z = begin; z < end; ++z)
        for (int y = static_cast<int>(z % 2); y < grid.dims.y; y += 2) {
          const T* row = voxels.row(y, static_cast<int>(z), buffer);
          std::size_t inRow = 0;
          for (int x = 0; x < grid.dims.x; ++x) {
            const std::size_t count = shows(row[x]);
            local[0][static_cast<std::size_t>(x)] += count;
            inRow += count;
          }
          local[1][static_cast<std::size_t>(y)] += inRow;
          local[2][z] += inRow;
        }
      const std::scoped_lock lock(mutex);
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < counts[axis].size(); ++i) counts[axis][i] += local[axis][i];
    });
  });
  Grid visible = grid;
  glm::ivec3 first(0);
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<std::size_t>& slabs = counts[static_cast<std::size_t>(axis)];
    const double least = leastShare * static_cast<double>(*std::max_element(slabs.begin(), slabs.end()));
    const auto counted = [&](std::size_t count) { return count > 0 && static_cast<double>(count) >= least; };
    const auto low = std::find_if(slabs.begin(), slabs.end(), counted);
    if (low == slabs.end()) return grid;
    const auto high = std::find_if(slabs.rbegin(), slabs.rend(), counted);
    first[axis] = static_cast<int>(low - slabs.begin());
    visible.dims[axis] = static_cast<int>(slabs.rend() - high) - first[axis];
  }
  visible.origin = glm::dvec3(grid.worldFromIndex() * glm::dvec4(glm::dvec3(first), 1.0));
  return visible;
}

}  // namespace fenestra
