#pragma once
// What readers of label maps share: which label a voxel keeps where structures overlap, and what to say about a map
// that does not lie on the volume's grid.

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "io/base/Reading.h"

namespace fenestra::io {

inline constexpr std::uint16_t greatestLabel = 65535;
/// The colour of a label whose file gives it none: openLabels() chooses one by the name.
inline constexpr glm::dvec3 noColour{-1.0};

/// Labels as a reader gives them: one a voxel of the target grid, x fastest, and what is known about them.
struct LabelsOnGrid {
  std::vector<std::uint16_t> values;
  std::vector<Label> labels;  ///< may list absent ones, miss ones that are present, and have noColour
  std::vector<Warning> warnings;
};

/// One label a voxel, although structures overlap: the smaller structure stays. An overlap takes the same number of
/// voxels from whichever structure loses, which is the smaller share of the larger one; and a structure inside another,
/// such as a lesion in an organ or everything in the body's outline, stays visible whatever the order in the file.
class LabelOverlap {
 public:
  LabelOverlap() = default;
  LabelOverlap(const LabelOverlap&) = delete;
  LabelOverlap& operator=(const LabelOverlap&) = delete;

  /// The structures in the file's order, with their numbers of voxels; of equal sizes the later one stays.
  void add(std::uint16_t label, std::uint64_t voxels);
  /// The label of a voxel that had `present` and is also in `added`; counts. 0 is background.
  std::uint16_t keep(std::uint16_t present, std::uint16_t added);
  /// A sentence with counts and names when something was hidden.
  void warn(const std::filesystem::path& file, const std::vector<Label>& labels, std::vector<Warning>& warnings) const;

 private:
  std::vector<std::size_t> rank_ = std::vector<std::size_t>(greatestLabel + 1u, 0);
  std::vector<std::pair<std::uint64_t, std::uint16_t>> structures_;
  bool ranked_ = false;
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::uint64_t> hidden_;  ///< by (kept, hidden)
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::uint64_t>::iterator last_ = hidden_.end();
};

/// Number of voxels of a label map that are not background.
std::uint64_t labelledVoxels(std::span<const std::uint16_t> values);
/// Says when labels moved on their way to the target grid: `before` and `after` are the labelled voxels of both.
void warnOfPlacement(const std::filesystem::path& file, std::uint64_t before, std::uint64_t after, bool sameLattice,
                     std::vector<Warning>& warnings);
/// Whether `index` is the centre of a voxel within a twentieth of one: headers store single precision, whose rounding
/// adds up to hundredths over a long axis.
bool isVoxelCentre(const glm::dvec3& index);

}  // namespace fenestra::io
