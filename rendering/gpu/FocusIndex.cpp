#include "rendering/gpu/FocusIndex.h"

#include <algorithm>
#include <array>

#include "rendering/volume/Threads.h"

namespace fenestra {

bool FocusIndex::holds(glm::ivec3 cell) const {
  const std::uint32_t slot = slots[brickOffset(bricks, cell / brickSide)];
  if (slot < 2) return slot != 0;
  const std::size_t place = (slot - 2) * cellsPerBrick + cellInBrick(cell);
  return kind == Kind::Labels ? (cells[place / 4] >> (8 * (place % 4)) & 255u) != 0
                              : (cells[place / 32] >> place % 32 & 1u) != 0;
}

bool FocusIndex::holdsAny(const IndexBox& cellBox) const {
  const glm::ivec3 firstBrick = cellBox.low / brickSide, lastBrick = cellBox.high / brickSide;
  glm::ivec3 brick, cell;
  for (brick.z = firstBrick.z; brick.z <= lastBrick.z; ++brick.z)
    for (brick.y = firstBrick.y; brick.y <= lastBrick.y; ++brick.y)
      for (brick.x = firstBrick.x; brick.x <= lastBrick.x; ++brick.x) {
        const std::uint32_t slot = slots[brickOffset(bricks, brick)];
        if (slot == 0) continue;
        if (slot == 1) return true;
        const glm::ivec3 low = glm::max(cellBox.low, brick * brickSide);
        const glm::ivec3 high = glm::min(cellBox.high, brick * brickSide + (brickSide - 1));
        for (cell.z = low.z; cell.z <= high.z; ++cell.z)
          for (cell.y = low.y; cell.y <= high.y; ++cell.y)
            for (cell.x = low.x; cell.x <= high.x; ++cell.x)
              if (holds(cell)) return true;
      }
  return false;
}

std::vector<std::uint8_t> FocusIndex::occupied() const {
  std::vector<std::uint8_t> occupied(slots.size());
  std::transform(slots.begin(), slots.end(), occupied.begin(),
                 [](std::uint32_t slot) { return static_cast<std::uint8_t>(slot != 0); });
  return occupied;
}

std::vector<std::uint32_t> FocusIndex::smoothedCells() const {
  constexpr int corners = brickSide + 1;
  std::size_t slotCount = 0;
  for (const std::uint32_t slot : slots) slotCount += slot >= 2;
  std::vector<std::uint32_t> words(slotCount * smoothedWordsPerBrick);
  parallelFor(static_cast<std::size_t>(bricks.z), 1, [&](std::size_t begin, std::size_t end) {
    std::array<std::uint16_t, std::size_t{corners} * corners * corners> block;
    for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
      for (int y = 0; y < bricks.y; ++y)
        for (int x = 0; x < bricks.x; ++x) {
          const std::uint32_t slot = slots[brickOffset(bricks, {x, y, z})];
          if (slot < 2) continue;
          smoothed->read(glm::ivec3(x, y, z) * brickSide - 1, glm::ivec3(corners), block.data());
          std::uint32_t* word = words.data() + (slot - 2) * smoothedWordsPerBrick;
          for (std::size_t row = 0; row < std::size_t{corners} * corners; ++row)
            for (std::size_t column = 0; column < std::size_t{brickSide}; ++column) {
              const std::uint16_t* pair = block.data() + row * corners + column;
              *word++ = pair[0] | static_cast<std::uint32_t>(pair[1]) << 16;
            }
        }
  });
  return words;
}

std::optional<glm::dvec3> FocusIndex::centre(const Grid& grid) const {
  if (!box) return std::nullopt;
  const glm::dvec3 index = 0.5 * (glm::dvec3(box->low) + glm::dvec3(box->high));
  return glm::dvec3(grid.worldFromIndex() * glm::dvec4(index, 1.0));
}

}  // namespace fenestra
