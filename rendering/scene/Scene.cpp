#include "rendering/scene/Scene.h"

#include <algorithm>
#include <type_traits>
#include <utility>

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
  const glm::dvec3 spacing = grid.spacing;
  const double widest = std::max({spacing.x, spacing.y, spacing.z});
  if (!(widest > pixel) || grid.voxelCount() > mostSplineVoxels) return Reconstruction::Linear;
  const bool isSharp =
      scene.volume->isInHounsfieldUnits() || widest > thickSlices * std::min({spacing.x, spacing.y, spacing.z});
  return isSharp && widest > pixelsOfTerraces * pixel ? Reconstruction::Smoother : Reconstruction::Smooth;
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

DrawnInFocus drawnInFocus(const Scene& scene, std::uint16_t label) {
  const bool isStructure = focusesStructures(scene);
  LabelSetting setting = isStructure ? settingFor(scene.look.labels, label) : LabelSetting{.label = label};
  const Label* known = scene.labels->find(label);
  const glm::dvec3 own = known ? known->colour : defaultLabelColour(label);
  return {.material = {setting.colour.value_or(own), scene.look.focusAppearance.extinction},
          .function = isStructure ? std::move(setting.function) : scene.look.focusAppearance.function,
          .opacity = setting.visible ? setting.opacity : 0.0};
}

OpticalProperties focusMaterial(const Scene& scene, std::uint16_t label) {
  const DrawnInFocus drawn = drawnInFocus(scene, label);
  return {drawn.material.colour, opticalExtinction(drawn.material.extinction, drawn.opacity)};
}

std::optional<TransferFunction> focusFunction(const Scene& scene, std::uint16_t label) {
  DrawnInFocus drawn = drawnInFocus(scene, label);
  if (!drawn.function) return {};
  return drawn.opacity < 1.0 ? atOpacity(std::move(*drawn.function), drawn.opacity) : std::move(drawn.function);
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

Scene Sculptor::of(Scene scene) {
  if (scene.look.removals.empty()) {
    removed_ = nullptr;
    removals_.clear();
  } else if (removals_ != scene.look.removals || grid_ != scene.volume->grid) {
    removed_ = removedVoxels(scene.look.removals, scene.volume->grid, removed_);
    removals_ = scene.look.removals;
    grid_ = scene.volume->grid;
  }
  if (!removed_) {
    labels_ = structures_ = {};
    return scene;
  }
  scene.removed = removed_;
  const bool areOne = scene.structures == scene.labels;
  scene.labels = carved(labels_, scene.labels);
  scene.structures = areOne ? scene.labels : carved(structures_, scene.structures);
  return scene;
}

Sculptor::Map Sculptor::carved(Carved& kept, const Map& source) const {
  if (kept.source == source && kept.removed == removed_) return kept.carved;
  kept = {source, source, removed_};
  if (!source) return nullptr;
  const auto forEachGone = [&](const auto& use) {
    for (int z = removed_->low.z; z < removed_->low.z + removed_->size.z; ++z)
      for (int y = removed_->low.y; y < removed_->low.y + removed_->size.y; ++y)
        removed_->forEachIn(y, z, [&](int x, std::uint8_t coverage) {
          if (RemovedVoxels::isGone(coverage)) use(source->grid.offset({x, y, z}));
        });
  };
  source->voxels.visit([&](auto labels) {
    using T = std::remove_const_t<typename decltype(labels)::element_type>;
    bool losesAny = false;
    forEachGone([&](std::size_t at) { losesAny = losesAny || labels[at] != T{}; });
    if (!losesAny) return;  // the map itself will do
    auto without = std::make_shared<LabelMap>();
    without->grid = source->grid;
    without->labels = source->labels;
    without->voxels = Voxels(source->voxels.type(), labels.size());
    const auto to = without->voxels.as<T>();
    std::copy(labels.begin(), labels.end(), to.begin());
    forEachGone([&](std::size_t at) { to[at] = T{}; });
    kept.carved = std::move(without);
  });
  return kept.carved;
}

}  // namespace fenestra
