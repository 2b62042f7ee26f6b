#pragma once
// The members of a look and of its parts in JSON, for sessions and for files of strokes and looks. Settings come from
// their tables in rendering/settings/Settings.h and rendering/methods. Private to io/session.

#include <algorithm>
#include <cmath>
#include <functional>

#include "io/session/JsonSchema.h"
#include "rendering/settings/Settings.h"

// Found by argument-dependent lookup, hence the scene's own namespace.
namespace fenestra {

/// A user's stroke has a few hundred. Each line of a stroke may lie in all of a volume.
inline constexpr std::size_t mostRemovalPoints = 100'000;

/// All settings of a struct.
template <class Object>
void settings(auto& io, Object& object) {
  forEachSetting<std::remove_const_t<Object>>([&](const auto& setting) {
    // A colour's channels are its numbers.
    const bool isColour = std::same_as<std::remove_cvref_t<decltype(object.*setting.member)>, glm::dvec3>;
    io(setting.key, object.*setting.member, isColour ? fraction : setting.range, {setting.description, setting.unit});
  });
}

/// The method that is chosen, and the parameters of all of them.
void members(auto& io, io::json::Is<Method> auto& method) {
  settings(io, method);
  forEachMethod([&]<class M>() { settings(io, method.template of<M>()); });
}
void members(auto& io, io::json::Is<Cutaway> auto& cutaway) { settings(io, cutaway); }
void members(auto& io, io::json::Is<ContextLayer> auto& layer) { settings(io, layer); }
void members(auto& io, io::json::Is<Shading> auto& shading) { settings(io, shading); }
void members(auto& io, io::json::Is<BrushStroke> auto& stroke) {
  io("anchors", stroke.anchors, millimetres, {"Points on what was seen, in the patient's mm (LPS); one is a dab"});
  settings(io, stroke);
}

void members(auto& io, io::json::Is<Bend> auto& bend) {
  io.required("point", bend.point, millimetres, {"In the patient's mm (LPS)"});
  io("distance", bend.distance, millimetres, {"Along the plane's normal, towards what it removes", "mm"});
  io("radius", bend.radius, positiveMillimetres, {"Of the sphere of influence", "mm"});
}

void members(auto& io, io::json::Is<Removal> auto& removal) {
  io.required("shape", removal.shape);
  io("points", removal.points, millimetres,
     {"In the patient's mm (LPS). Ball: along the lines between them; box: at each; saw: along the lines between them, "
      "and all that they enclose where the last is the first; plane: the stroke that it is laid through"});
  io("size", removal.size, positiveMillimetres, {"Ball: radius; saw: thickness of its blade", "mm"});
  io("sides", removal.sides, positiveMillimetres, {"Of a box: across, along up, along direction", "mm"});
  io("direction", removal.direction, millimetres,
     {"Vector (LPS). Saw: where it is pushed; plane: towards what it removes; box: of one of its sides"});
  io("up", removal.up, millimetres, {"Vector (LPS), of a box: of another side, made square to direction"});
  io("depth", removal.depth, millimetresFromZero, {"Of saw and plane, from their points; 0: without an end", "mm"});
  io("extent", removal.extent, millimetresFromZero, {"Of a plane: half its side; 0: without an end", "mm"});
  io("softness", removal.softness, millimetresFromZero, {"Across which the rim fades", "mm"});
  io.optional("bends", removal.bends, !removal.bends.empty(), {}, {"Of a plane, in the order they were made"});
}

void members(auto& io, io::json::Is<Camera> auto& camera) {
  io("projection", camera.projection);
  io("eye", camera.eye, millimetres);
  io("target", camera.target, millimetres, {"The point that orbiting turns around"});
  io("up", camera.up, millimetres, {"Need not be unit nor orthogonal to the view"});
  io("vertical_fov", camera.verticalFov, {1e-6, 180.0 - 1e-6}, {"Field of view of a perspective camera", "degrees"});
  io("orthographic_height", camera.orthographicHeight, positiveMillimetres,
     {"From the bottom to the top of a parallel camera's picture", "mm"});
}

void members(auto& io, io::json::Is<LabelFocus> auto& focus) {
  io.required("labels", focus.labels, {1.0, 65535.0}, {"Label values, ascending, each once"});
}

void members(auto& io, io::json::Is<ValueFocus> auto& focus) {
  io.required("low", focus.values.low);
  io.required("high", focus.values.high);
  settings(io, focus);
}

void members(auto& io, io::json::Is<SelectionStroke> auto& stroke) {
  io.required("anchors", stroke.anchors, millimetres,
              {"Points of a line in space, in the patient's mm (LPS); one is a dab"});
  io("radius", stroke.radius, positiveMillimetres, {"Of the ball that follows the line", "mm"});
  io("softness", stroke.softness, fraction,
     {"Share of the radius, from the rim, in which only values like those within belong to the stroke"});
  io("adds", stroke.adds, {}, {"To the region; else it takes away"});
}

void members(auto& io, io::json::Is<RegionFocus> auto& focus) {
  io.required("inside", focus.inside, millimetres,
              {"Seeds in the structure, in the patient's mm (LPS); none where the region is only painted"});
  io("outside", focus.outside, millimetres, {"Seeds in structures that the region must not enter"});
  io("painted", focus.painted, {}, {"Strokes over what grows, in the order they were painted"});
  io("rule", focus.rule, {},
     {"Which voxels join: those whose own values lie near the seeds', or those that belong to a seed's tissue more "
      "than "
      "to others of the volume"});
  io("ball", focus.ball, io::json::nonNegative,
     {"No voxel farther from the first inside seed grows; 0: any may", "mm"});
  io.optional("tolerance", focus.tolerance, focus.tolerance.has_value(), io::json::nonNegative,
              {"How far values may lie below the seed's, in the volume's unit; without it, chosen from the plateaus"});
}

void members(auto& io, io::json::Is<TransferFunction::Node> auto& node) {
  io("value", node.value);
  io("colour", node.properties.colour, fraction);
  io("extinction", node.properties.extinction, io::json::nonNegative, {"", "1/mm"});
}

/// Nodes in order; a Reader refuses others.
void nodesMember(auto& io, io::json::Is<TransferFunction> auto& function, const char* description) {
  io.required("nodes", function.nodes, {}, {description});
  if constexpr (requires { io.fail(""); })
    if (!std::is_sorted(function.nodes.begin(), function.nodes.end(),
                        [](const auto& a, const auto& b) { return a.value < b.value; }))
      io.fail("has a transfer function whose nodes are not in order");
}

void members(auto& io, io::json::Is<TransferFunction> auto& function) { nodesMember(io, function, "Ascending"); }

void members(auto& io, io::json::Is<FocusAppearance> auto& appearance) {
  settings(io, appearance);
  io.optional("function", appearance.function, appearance.function.has_value(), {},
              {"Of a focus of values or a grown region: by value, in place of colour and extinction"});
}

void members(auto& io, io::json::Is<ContextFunction> auto& context) {
  auto& [preset, file, function, shift] = context;
  io.optional("preset", preset, !preset.empty(), {}, {"Id of the built-in preset that the nodes are"});
  io.optional("file", file, !file.empty(), {}, {"File that the nodes were read from"});
  nodesMember(io, function, "Before the shift, ascending");
  settings(io, context);
}

// A focus is an object of one of two kinds, or missing.
inline void focusMember(io::json::Writer& io, const Focus& focus) {
  if (const auto* labels = std::get_if<LabelFocus>(&focus))
    io("focus", *labels);
  else if (const auto* values = std::get_if<ValueFocus>(&focus))
    io("focus", *values);
  else if (const auto* region = std::get_if<RegionFocus>(&focus))
    io("focus", *region);
}
inline void focusMember(const io::json::Reader& io, Focus& focus) {
  if (io["focus"].is_null()) return;
  if (io["focus"].contains("labels"))
    io("focus", focus.emplace<LabelFocus>());
  else if (io["focus"].contains("inside"))
    io("focus", focus.emplace<RegionFocus>());
  else
    io("focus", focus.emplace<ValueFocus>());
}
inline void focusMember(io::json::SchemaWriter& io, const Focus&) {
  io.oneOf<LabelFocus, ValueFocus, RegionFocus>(
      "focus", {"What the view opens to; without it, nothing. Either labels, or the "
                "values from low to high, or the region grown from seeds and painted"});
}

void members(auto& io, io::json::Is<LabelSetting> auto& setting) {
  io.required("label", setting.label, {1.0, 65535.0}, {"Its value in the label map"});
  io("role", setting.role, {},
     {"Of a label that is not in focus: part of the context, left out of 3-D pictures, or never cut away"});
  io("visible", setting.visible, {},
     {"Whether slices tint it, and 3-D pictures draw it in focus and keep it from being cut away"});
  io("opacity", setting.opacity, fraction,
     {"Of its surface, and of its tint on slices; outside the focus, 0 hides it"});
  io.optional("colour", setting.colour, setting.colour.has_value(), fraction, {"In place of the label map's"});
  io.optional("function", setting.function, setting.function.has_value(), {},
              {"Of it in focus: by value, in place of one colour and extinction"});
  io.optional("importance", setting.importance, setting.importance.has_value(), {0.0, double{mostImportant}},
              {"Level of importance, of the method importance: what hides a more important label gives way to it. By "
               "default the highest in focus, else 0"});
}

void members(auto& io, io::json::Is<CropBox> auto& box) {
  io.required("low", box.low, millimetres,
              {"Along the volume's axes nearest to L, P and S, from the world's origin", "mm"});
  io.required("high", box.high, millimetres, {"The same of the other ends", "mm"});
}

void members(auto& io, io::json::Is<HalfSpace> auto& plane) {
  io.required("normal", plane.normal, {-1.0, 1.0}, {"Unit vector (LPS) towards what is kept"});
  io.required("offset", plane.offset, millimetres, {"Of the plane from the world's origin along it", "mm"});
  if constexpr (requires { io.fail(""); })
    if (!(std::abs(glm::length(plane.normal) - 1.0) < 1e-6)) io.fail("has a normal whose length is not 1");
}

void members(auto& io, io::json::Is<Clipping> auto& clipping) {
  io("cropped", clipping.cropped, {}, {"Whether the box is in use"});
  io("box", clipping.box, {}, {"What lies outside is left out"});
  io("planes", clipping.planes, {}, {"What lies behind any of them is left out; three at most"});
  io("exempt", clipping.exempt, {1.0, 65535.0}, {"Labels that are never clipped, ascending, each once"});
  io.optional("grey", clipping.grey, clipping.grey.has_value(), {},
              {"Capped faces show values in grey with this window; without it, what the transfer function shows"});
  if constexpr (requires { io.fail(""); }) {
    if (clipping.planes.size() > Clipping::mostPlanes) io.fail("has more than three planes");
    if (std::adjacent_find(clipping.exempt.begin(), clipping.exempt.end(), std::greater_equal<>()) !=
        clipping.exempt.end())
      io.fail("has exempt labels that are not in order");
  }
}

/// What the files of sessions and of presets share.
void partMembers(auto& io, io::json::Is<Look> auto& look) {
  io("method", look.method);
  io("cutaway", look.cutaway);
  io("context_layer", look.contextLayer);
  io("shading", look.shading);
  settings(io, look);  // background, table, reconstruction, smoothing of labels and edges
}

void members(auto& io, io::json::Is<Look> auto& look) {
  auto& [focus, labels, focusAppearance, context, method, cutaway, contextLayer, shading, background, backdrop,
         backgroundTop, hideTable, reconstruction, labelSmoothing, edges, clipping, strokes, removals] = look;
  focusMember(io, focus);
  io.optional("label_settings", labels, !labels.empty(), {},
              {"How labels of the label map are shown, ascending by label; those that are shown as they come are left "
               "out"});
  io("focus_appearance", focusAppearance);
  io.required("context", context, {}, {"The transfer function of everything but the focus"});
  partMembers(io, look);
  io.optional("clipping", clipping, !(clipping == Clipping()), {}, {"What 3-D pictures leave out of the volume"});
  io("strokes", strokes, {}, {"Brush strokes, in the order they were painted"});
  io.optional("removals", removals, !removals.empty(), {}, {"What is carved out of the volume in 3-D pictures"});
  if constexpr (requires { io.fail(""); }) {
    std::size_t points = 0;
    for (const Removal& removal : removals) points += removal.points.size() + removal.bends.size();
    if (points > mostRemovalPoints) io.fail("has more points of removals than can be carved in a useful time");
  }
}

void members(auto& io, io::json::Is<WindowLevel> auto& window) {
  io("width", window.width, io::json::positive);
  io("level", window.level);
}

}  // namespace fenestra
