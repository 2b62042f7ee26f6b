#include "viewer/model/HeldBytes.h"

#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>

#include "rendering/settings/Look.h"
#include "rendering/volume/SliceMeasure.h"

namespace fenestra::viewer {
namespace {

/// The sum over some values. Bytes of a value that can be copied bit by bit are its own; any other type needs a
/// function below. A struct is taken apart with a name for each of its members, so that it does not compile with one
/// more before this file counts that, too.
template <class... T>
std::size_t sum(const T&... values);

std::size_t held(const std::string& text) { return text.capacity(); }
std::size_t held(const std::filesystem::path& path) { return path.native().capacity(); }

template <class T>
std::size_t held(const std::vector<T>& values) {
  std::size_t bytes = values.capacity() * sizeof(T);
  if constexpr (!std::is_trivially_copyable_v<T>)
    for (const T& value : values) bytes += sum(value);
  return bytes;
}
template <class T>
std::size_t held(const std::optional<T>& value) {
  return value ? sum(*value) : 0;
}
template <class... T>
std::size_t held(const std::variant<T...>& value) {
  return std::visit([](const auto& present) { return sum(present); }, value);
}

std::size_t held(const TransferFunction& function) {
  const auto& [nodes] = function;
  return sum(nodes);
}
std::size_t held(const LabelFocus& focus) {
  const auto& [labels] = focus;
  return sum(labels);
}
std::size_t held(const SelectionStroke& stroke) {
  const auto& [anchors, radius, softness, adds] = stroke;
  return sum(anchors, radius, softness, adds);
}
std::size_t held(const RegionFocus& focus) {
  const auto& [inside, outside, tolerance, painted, rule, ball] = focus;
  return sum(inside, outside, tolerance, painted, rule, ball);
}
std::size_t held(const LabelSetting& setting) {
  const auto& [label, role, visible, opacity, colour, function, importance] = setting;
  return sum(label, role, visible, opacity, colour, function, importance);
}
std::size_t held(const FocusAppearance& appearance) {
  const auto& [colour, extinction, function] = appearance;
  return sum(colour, extinction, function);
}
std::size_t held(const ContextFunction& context) {
  const auto& [preset, file, function, shift] = context;
  return sum(preset, file, function, shift);
}
std::size_t held(const Clipping& clipping) {
  const auto& [cropped, box, planes, exempt, grey] = clipping;
  return sum(cropped, box, planes, exempt, grey);
}
std::size_t held(const BrushStroke& stroke) {
  const auto& [mode, anchors, radius, softness, depth, amount, toSurface, coversFocus, hidden, view] = stroke;
  return sum(mode, anchors, radius, softness, depth, amount, toSurface, coversFocus, hidden, view);
}
std::size_t held(const Removal& removal) {
  const auto& [shape, points, size, sides, direction, up, depth, extent, softness, bends] = removal;
  return sum(shape, points, size, sides, direction, up, depth, extent, softness, bends);
}
std::size_t held(const Measure& measure) {
  const auto& [kind, points, right, down, text] = measure;
  return sum(kind, points, right, down, text);
}
std::size_t held(const Look& look) {
  const auto& [focus, labels, focusAppearance, context, method, cutaway, contextLayer, shading, background, backdrop,
               backgroundTop, hideTable, reconstruction, labelSmoothing, edges, clipping, strokes, removals] = look;
  return sum(focus, labels, focusAppearance, context, method, cutaway, contextLayer, shading, background, backdrop,
             backgroundTop, hideTable, reconstruction, labelSmoothing, edges, clipping, strokes, removals);
}

template <class T>
std::size_t heldByOne(const T& value) {
  if constexpr (std::is_trivially_copyable_v<T>)
    return 0;
  else
    return held(value);
}

template <class... T>
std::size_t sum(const T&... values) {
  return (heldByOne(values) + ... + std::size_t{0});
}

}  // namespace

std::size_t heldBy(const Look& look) { return sum(look); }
std::size_t heldBy(const Focus& focus) { return sum(focus); }
std::size_t heldBy(const std::vector<Measure>& measures) { return sum(measures); }

}  // namespace fenestra::viewer
