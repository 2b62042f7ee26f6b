#pragma once
// One scene in every kind of use, from a plain volume to all features at once, to measure what a feature costs, and
// that it costs nothing while it is off.

#include <string>
#include <vector>

#include "rendering/scene/Scene.h"

namespace fenestra::tests {

struct FeatureScene {
  std::string name;
  Scene scene;
};

/// `base` has a focus of two labels or more, of different colours; `values` is the focus of the kinds that have one by
/// value.
inline std::vector<FeatureScene> featureScenes(const Scene& base, const ValueFocus& values) {
  const auto firstLabels = [&](std::ptrdiff_t count) {
    const std::vector<std::uint16_t>& all = std::get<LabelFocus>(base.look.focus).labels;
    return LabelFocus{{all.begin(), all.begin() + count}};
  };
  std::vector<FeatureScene> kinds;
  const auto add = [&](const std::string& name, auto&& change) {
    Scene scene = base;
    scene.look.focus = firstLabels(1);
    scene.look.strokes.clear();
    scene.look.contextLayer.strength = 0.0;
    scene.look.cutaway.borderWidth = 0.0;
    scene.look.cutaway.enabled = true;
    scene.look.shading.enabled = true;
    scene.look.shading.occlusion = scene.look.shading.shadow = 0.0;
    change(scene);
    kinds.push_back({name, std::move(scene)});
  };
  const auto plain = [](Scene& scene) {
    scene.look.focus = {};
    scene.labels = nullptr;
  };
  add("plain, unlit", [&](Scene& scene) {
    plain(scene);
    scene.look.shading.enabled = false;
  });
  add("plain", plain);
  add("plain, occlusion", [&](Scene& scene) {
    plain(scene);
    scene.look.shading.occlusion = 0.6;
    scene.look.shading.shadow = 0.6;
  });
  add("labels, no cutaway", [](Scene& scene) { scene.look.cutaway.enabled = false; });
  add("cutaway by value", [&](Scene& scene) {
    scene.look.focus = values;
    scene.labels = nullptr;
  });
  add("cutaway by a label", [](Scene&) {});
  add("cutaway by two labels", [&](Scene& scene) { scene.look.focus = firstLabels(2); });
  add("with a border", [](Scene& scene) { scene.look.cutaway.borderWidth = 2.0; });
  add("with the context layer", [](Scene& scene) {
    scene.look.cutaway.borderWidth = 2.0;
    scene.look.contextLayer.strength = 0.7;
  });
  add("with occlusion", [](Scene& scene) { scene.look.shading.occlusion = 0.6; });
  add("with a brush stroke", [](Scene& scene) {
    const Grid& grid = scene.volume->grid;
    BrushStroke stroke;
    stroke.anchors = {grid.centre()};
    stroke.radius = 0.1 * grid.boundingRadius();
    scene.look.cutaway.borderWidth = 2.0;
    scene.look.contextLayer.strength = 0.7;
    scene.look.strokes = {stroke};
  });
  return kinds;
}

}  // namespace fenestra::tests
