#pragma once
// Keeps the index of a label focus up to date while labels join and leave the focus: only bricks that hold one of them
// are looked at again. The tolerance of a grown region is such a change, because its steps are labels.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "rendering/gpu/FocusIndex.h"
#include "rendering/volume/LabelMap.h"

namespace fenestra {

class LabelIndexer {
 public:
  /// Reads the whole map, on all cores. Takes four bytes a brick for it.
  explicit LabelIndexer(std::shared_ptr<const LabelMap> map);

  const std::shared_ptr<const LabelMap>& map() const { return map_; }

  /// What an update has changed. Bricks are offsets, see brickOffset().
  struct Change {
    std::vector<std::size_t> bricks;           ///< those with other cells, ascending
    std::vector<std::size_t> filled, emptied;  ///< of them, those that hold some of the focus now, and no more
    int firstLayer = 0, lastLayer = -1;        ///< layers of bricks along z with other entries of `slots`
  };
  /// Makes `index`, which is empty at the first call and the last call's result later, that of `labels`. It equals one
  /// made from scratch but for the order of its slots. Runs on all cores.
  Change update(FocusIndex& index, const std::vector<std::uint16_t>& labels);

 private:
  /// Labels other than 0 at the corners of a brick's cells; least > greatest: none.
  struct Range {
    std::uint16_t least = 65535, greatest = 0;
  };
  static constexpr std::size_t wordsPerBrick = cellsPerBrick / 4;
  /// A brick with what its cells are now.
  struct Found {
    std::size_t brick = 0;
    std::uint32_t kind = 0;  ///< 0 none of it is in the focus, 1 all, 2 see `cells`
    std::array<std::uint32_t, wordsPerBrick> cells{};
  };

  glm::ivec3 brickAt(std::size_t offset) const;
  template <class T>
  void readRanges(std::span<const T> labels);
  template <class T>
  Found lookAt(glm::ivec3 brick, std::span<const T> labels) const;
  /// The bricks that hold labels which have joined or left the focus; entry i of `changedUpTo` counts those below i.
  std::vector<std::size_t> concernedBricks(const std::vector<std::uint32_t>& changedUpTo) const;
  /// The bricks among `concerned` whose cells have changed.
  std::vector<Found> changedBricks(const FocusIndex& index, const std::vector<std::size_t>& concerned) const;
  void apply(FocusIndex& index, const std::vector<Found>& found, Change& change);
  std::optional<IndexBox> boxOf(const FocusIndex& index) const;

  std::shared_ptr<const LabelMap> map_;
  glm::ivec3 bricks_;
  std::vector<Range> ranges_;
  std::vector<std::uint8_t> wanted_;  ///< by label: in the focus
  std::vector<std::size_t> owners_;   ///< by slot: its brick
};

}  // namespace fenestra
