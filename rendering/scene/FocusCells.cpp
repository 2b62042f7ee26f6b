#include "rendering/scene/FocusCells.h"

#include <algorithm>

#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

constexpr std::uint8_t inactive = 0, kept = 1, unvisited = 2, dropped = 3;

std::vector<std::uint8_t> activeCells(const ShownVolume& shown, ValueRange range, const Grid& cells) {
  const glm::ivec3 last = shown.volume->grid.dims - 1;
  std::vector<std::uint8_t> state(cells.voxelCount(), inactive);
  const ShownVoxels voxels(shown);
  const bool avoidsGone = shown.removed && voxels.air() >= range.low && voxels.air() <= range.high;
  withValues(shown, [&](auto valueAt) {
    parallelFor(static_cast<std::size_t>(cells.dims.z), 1, [&](std::size_t begin, std::size_t end) {
      for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
        for (int y = 0; y < cells.dims.y; ++y)
          for (int x = 0; x < cells.dims.x; ++x) {
            double least = valueAt({x, y, z}), greatest = least;
            bool isWhole = true;
            for (int corner = 0; corner < 8; ++corner) {
              const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
              const glm::ivec3 voxel = glm::min(glm::ivec3(x, y, z) + step, last);
              const double value = valueAt(voxel);
              least = std::min(least, value);
              greatest = std::max(greatest, value);
              isWhole = isWhole && !(avoidsGone && voxels.isGone(voxel));
            }
            if (isWhole && least <= range.high && greatest >= range.low) state[cells.offset({x, y, z})] = unvisited;
          }
    });
  });
  return state;
}

/// Keeps the inactive neighbours of kept cells, too.
void widen(std::vector<std::uint8_t>& state, const Grid& cells) {
  const std::vector<std::uint8_t> before = state;
  const auto isKept = [&](glm::ivec3 cell) { return cells.contains(cell) && before[cells.offset(cell)] == kept; };
  glm::ivec3 cell;
  for (cell.z = 0; cell.z < cells.dims.z; ++cell.z)
    for (cell.y = 0; cell.y < cells.dims.y; ++cell.y)
      for (cell.x = 0; cell.x < cells.dims.x; ++cell.x) {
        std::uint8_t& own = state[cells.offset(cell)];
        for (int n = 0; own == inactive && n < 27; ++n)
          if (isKept(cell + glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1)) own = kept;
      }
}

}  // namespace

bool FocusCells::contains(glm::ivec3 cell) const {
  const glm::ivec3 nearest = glm::clamp(cell, glm::ivec3(0), dims - 1);
  Grid lattice;
  lattice.dims = dims;
  return kept[lattice.offset(nearest)] != 0;
}

FocusCells focusCells(const ShownVolume& shown, const ValueFocus& focus) {
  const Grid& grid = shown.volume->grid;
  Grid cells;
  cells.dims = glm::max(grid.dims - 1, 1);
  if (!(focus.values.low <= focus.values.high)) return {cells.dims, std::vector<std::uint8_t>(cells.voxelCount(), 0)};
  std::vector<std::uint8_t> state = activeCells(shown, focus.values, cells);
  const double cellVolume = grid.voxelVolume();

  std::vector<glm::ivec3> component;
  const auto visit = [&](glm::ivec3 cell) {
    if (!cells.contains(cell) || state[cells.offset(cell)] != unvisited) return;
    state[cells.offset(cell)] = kept;
    component.push_back(cell);
  };
  glm::ivec3 seed;
  for (seed.z = 0; seed.z < cells.dims.z; ++seed.z)
    for (seed.y = 0; seed.y < cells.dims.y; ++seed.y)
      for (seed.x = 0; seed.x < cells.dims.x; ++seed.x) {
        component.clear();
        visit(seed);
        for (std::size_t next = 0; next < component.size(); ++next) {
          const glm::ivec3 cell = component[next];
          for (int z = -1; z <= 1; ++z)
            for (int y = -1; y <= 1; ++y)
              for (int x = -1; x <= 1; ++x) visit(cell + glm::ivec3(x, y, z));
        }
        if (static_cast<double>(component.size()) * cellVolume < focus.minimumComponent)
          for (const glm::ivec3& cell : component) state[cells.offset(cell)] = dropped;
      }
  if (shown.reconstruction != Reconstruction::Linear) widen(state, cells);
  std::replace(state.begin(), state.end(), dropped, inactive);
  return {cells.dims, std::move(state)};
}

}  // namespace fenestra
