#include "rendering/segmentation/LabelEdit.h"

#include <algorithm>
#include <limits>

namespace fenestra::segmentation {
namespace {

LabelEdit::Side sideOf(const LabelMap* map) {
  return map ? LabelEdit::Side{true, map->voxels.type(), map->labels} : LabelEdit::Side{};
}

/// Calls visit(std::span of the labels' type); the voxels are UInt8 or UInt16.
template <class Visit>
void withLabels(Voxels& voxels, Visit visit) {
  if (voxels.type() == ScalarType::UInt8)
    visit(voxels.as<std::uint8_t>());
  else
    visit(voxels.as<std::uint16_t>());
}

/// The labels of `map` in voxels of another type, all 0 without a map.
Voxels copyOf(const LabelMap* map, ScalarType type, std::size_t count) {
  Voxels copy(type, count);
  withLabels(copy, [&](auto to) {
    using T = typename decltype(to)::value_type;
    if (!map)
      std::fill(to.begin(), to.end(), T{0});
    else
      map->voxels.visit([&](auto from) {
        std::transform(from.begin(), from.end(), to.begin(), [](auto value) { return static_cast<T>(value); });
      });
  });
  return copy;
}

}  // namespace

std::size_t LabelEdit::bytes() const {
  std::size_t sum = sizeof(*this) + runs.capacity() * sizeof(LabelRun);
  for (const Side* side : {&before, &after})
    for (const Label& label : side->labels) sum += sizeof(label) + label.name.capacity();
  return sum;
}

std::shared_ptr<const LabelMap> LabelEdit::changed(const LabelMap* map, bool forward) const {
  const Side& side = forward ? after : before;
  if (!side.exists) return nullptr;
  auto result = std::make_shared<LabelMap>();
  result->grid = grid;
  result->labels = side.labels;
  // A value of the map before may not fit into the type of the map after; the runs replace all such values.
  result->voxels = copyOf(map, side.type, grid.voxelCount());
  withLabels(result->voxels, [&](auto to) {
    using T = typename decltype(to)::value_type;
    for (const LabelRun& run : runs)
      std::fill_n(to.begin() + static_cast<std::ptrdiff_t>(run.begin), run.length,
                  static_cast<T>(forward ? run.after : run.before));
  });
  return result;
}

LabelEdit relabel(const LabelMap* map, const Mask& mask, const Label& label, Overlap overlap) {
  LabelEdit edit;
  edit.grid = mask.grid;
  edit.before = edit.after = sideOf(map);
  edit.after.exists = true;
  if (label.value > std::numeric_limits<std::uint8_t>::max()) edit.after.type = ScalarType::UInt16;
  std::vector<Label>& labels = edit.after.labels;
  const auto at = std::lower_bound(labels.begin(), labels.end(), label.value,
                                   [](const Label& each, std::uint16_t wanted) { return each.value < wanted; });
  if (at != labels.end() && at->value == label.value)
    *at = label;
  else
    labels.insert(at, label);

  const auto compare = [&](auto valueAt) {
    for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
      const std::uint16_t now = valueAt(i);
      std::uint16_t wanted = now;
      if (mask.voxels[i])
        wanted = now == 0 || overlap == Overlap::Take ? label.value : now;
      else if (now == label.value)
        wanted = 0;
      if (wanted == now) continue;
      const bool goesOn = !edit.runs.empty() && edit.runs.back().begin + edit.runs.back().length == i &&
                          edit.runs.back().before == now && edit.runs.back().after == wanted &&
                          edit.runs.back().length < std::numeric_limits<std::uint32_t>::max();
      if (goesOn)
        ++edit.runs.back().length;
      else
        edit.runs.push_back({i, 1, now, wanted});
    }
  };
  if (!map)
    compare([](std::size_t) { return std::uint16_t{0}; });
  else
    map->voxels.visit(
        [&](auto values) { compare([values](std::size_t i) { return static_cast<std::uint16_t>(values[i]); }); });
  edit.runs.shrink_to_fit();
  return edit;
}

LabelEdit renamed(const LabelMap& map, std::uint16_t label, const std::string& name) {
  LabelEdit edit;
  edit.grid = map.grid;
  edit.before = edit.after = sideOf(&map);
  for (Label& each : edit.after.labels)
    if (each.value == label) each.name = name;
  return edit;
}

std::uint16_t freeLabel(const LabelMap* map) {
  std::uint16_t value = 1;
  if (map)
    for (const Label& label : map->labels)
      if (label.value == value) ++value;
  return value;
}

}  // namespace fenestra::segmentation
