#pragma once
// What the members of a scene's parts are called in JSON, for sessions and for files of strokes. Private to io/session.

#include "io/session/Json.h"
#include "rendering/scene/Quality.h"
#include "rendering/scene/Scene.h"

// Found by argument-dependent lookup, hence the scene's own namespace.
namespace fenestra {

inline io::json::Words<BrushMode> wordsOf(BrushMode) {
  return {{"restore", BrushMode::Restore},
          {"open", BrushMode::Open},
          {"fade", BrushMode::Fade},
          {"strengthen", BrushMode::Strengthen}};
}
inline io::json::Words<Projection> wordsOf(Projection) {
  return {{"perspective", Projection::Perspective}, {"orthographic", Projection::Orthographic}};
}
inline io::json::Words<WidthUnit> wordsOf(WidthUnit) {
  return {{"px", WidthUnit::Pixel}, {"mm", WidthUnit::Millimetre}};
}
inline io::json::Words<Quality> wordsOf(Quality) {
  return {{"draft", Quality::Draft}, {"normal", Quality::Normal}, {"high", Quality::High}};
}

void members(auto& io, io::json::Is<BrushStroke> auto& stroke) {
  io("mode", stroke.mode);
  io("anchors", stroke.anchors, io::json::millimetres);
  io("radius", stroke.radius, io::json::positiveMillimetres);
  io("softness", stroke.softness, io::json::fraction);
  io("depth", stroke.depth, io::json::Range{0.0, 1e9});
  io("amount", stroke.amount, io::json::fraction);
  io("covers_focus", stroke.coversFocus);
  io("hidden", stroke.hidden);
  io("view", stroke.view, io::json::Range{-1.0, 1.0});
}

void members(auto& io, io::json::Is<Camera> auto& camera) {
  io("projection", camera.projection);
  io("eye", camera.eye, io::json::millimetres);
  io("target", camera.target, io::json::millimetres);
  io("up", camera.up, io::json::millimetres);
  io("vertical_fov", camera.verticalFov, io::json::Range{1e-6, 180.0 - 1e-6});
  io("orthographic_height", camera.orthographicHeight, io::json::positiveMillimetres);
}

void members(auto& io, io::json::Is<Cutaway> auto& cutaway) {
  io("enabled", cutaway.enabled);
  io("open_width", cutaway.openWidth, io::json::Range{0.0, 1e5});
  io("border_width", cutaway.borderWidth, io::json::Range{0.0, 1e5});
  io("unit", cutaway.unit);
  io("border_colour", cutaway.borderColour, io::json::fraction);
}

void members(auto& io, io::json::Is<ContextLayer> auto& layer) {
  io("strength", layer.strength, io::json::fraction);
  io("curvature_weight", layer.curvatureWeight, io::json::nonNegative);
  io("silhouette_weight", layer.silhouetteWeight, io::json::nonNegative);
  io("illumination_weight", layer.illuminationWeight, io::json::fraction);
  io("value_weight", layer.valueWeight, io::json::fraction);
  io("colour", layer.colour, io::json::fraction);
}

void members(auto& io, io::json::Is<Shading> auto& shading) {
  io("enabled", shading.enabled);
  io("ambient", shading.ambient, io::json::nonNegative);
  io("diffuse", shading.diffuse, io::json::nonNegative);
  io("specular", shading.specular, io::json::nonNegative);
  io("shininess", shading.shininess, io::json::nonNegative);
}

void members(auto& io, io::json::Is<FocusAppearance> auto& appearance) {
  io("colour", appearance.colour, io::json::fraction);
  io("extinction", appearance.extinction, io::json::nonNegative);
}

void members(auto& io, io::json::Is<TransferFunction::Node> auto& node) {
  io("value", node.value);
  io("colour", node.properties.colour, io::json::fraction);
  io("extinction", node.properties.extinction, io::json::nonNegative);
}

void members(auto& io, io::json::Is<ContextFunction> auto& context) {
  io::json::optional(io, "preset", context.preset, !context.preset.empty());
  io::json::optional(io, "file", context.file, !context.file.empty());
  io.required("nodes", context.function.nodes);
  io("shift", context.shift);
}

void members(auto& io, io::json::Is<WindowLevel> auto& window) {
  io("width", window.width, io::json::positive);
  io("level", window.level);
}

}  // namespace fenestra
