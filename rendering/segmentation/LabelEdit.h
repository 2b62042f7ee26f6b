#pragma once
// Changes of a label map that can be undone: what differs between two maps, as runs of voxels.

#include <cstdint>
#include <memory>
#include <vector>

#include "rendering/segmentation/Mask.h"

namespace fenestra::segmentation {

/// Consecutive voxels whose label changes from one value to another.
struct LabelRun {
  std::size_t begin = 0;
  std::uint32_t length = 0;
  std::uint16_t before = 0, after = 0;
};

/// From one label map to another on the same grid.
struct LabelEdit {
  /// One side's list of labels and type of voxels; `exists` is false where there is no label map at all.
  struct Side {
    bool exists = false;
    ScalarType type = ScalarType::UInt8;
    std::vector<Label> labels;
  };
  Grid grid;
  Side before, after;
  std::vector<LabelRun> runs;

  /// Bytes that this holds.
  std::size_t bytes() const;
  /// The other side's map, made from one side's; null where there is none. The result equals the map that the edit was
  /// made from, voxel for voxel.
  std::shared_ptr<const LabelMap> applied(const LabelMap* map) const { return changed(map, true); }
  std::shared_ptr<const LabelMap> reverted(const LabelMap* map) const { return changed(map, false); }

 private:
  std::shared_ptr<const LabelMap> changed(const LabelMap* map, bool forward) const;
};

/// What becomes of the voxels of other labels where the mask lies over them.
enum class Overlap : std::uint8_t { Take, Leave };

/// The edit after which `label` has exactly the voxels of the mask, apart from those that it leaves to others. A label
/// of that value that is there already gets the new name and colour. `map` is null or on the mask's grid.
LabelEdit relabel(const LabelMap* map, const Mask& mask, const Label& label, Overlap overlap);

/// The edit that gives a label of the map another name.
LabelEdit renamed(const LabelMap& map, std::uint16_t label, const std::string& name);

/// The least label value that `map`, which may be null, does not use; 0 where all are used.
std::uint16_t freeLabel(const LabelMap* map);

}  // namespace fenestra::segmentation
