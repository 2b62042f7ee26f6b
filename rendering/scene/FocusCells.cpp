#include "rendering/scene/FocusCells.h"

#include <algorithm>
#include <type_traits>

#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

constexpr std::uint8_t inactive = 0, kept = 1, unvisited = 2, dropped = 3;

/// What a cell asks of its corners.
enum Corner : std::uint8_t { notAbove = 1, notBelow = 2, isGone = 4 };

/// Corner flags of each voxel.
std::vector<std::uint8_t> cornersOf(const ShownVolume& shown, ValueRange range) {
  const Volume& volume = *shown.volume;
  const Grid& grid = volume.grid;
  std::vector<std::uint8_t> corners(grid.voxelCount());
  const ShownVoxels voxels(shown);
  const bool avoidsGone = shown.removed && voxels.air() >= range.low && voxels.air() <= range.high;
  volume.voxels.visit([&](auto scalars) {
    using Stored = std::remove_const_t<typename decltype(scalars)::element_type>;
    parallelFor(static_cast<std::size_t>(grid.dims.z), 1, [&](std::size_t begin, std::size_t end) {
      std::vector<Stored> buffer;
      for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
        for (int y = 0; y < grid.dims.y; ++y) {
          const Stored* stored = voxels.row(y, z, buffer);
          std::uint8_t* row = corners.data() + grid.offset({0, y, z});
          for (int x = 0; x < grid.dims.x; ++x) {
            const double value = realValue(volume, stored[x]);
            row[x] = static_cast<std::uint8_t>(static_cast<int>(value <= range.high) * notAbove |
                                               static_cast<int>(value >= range.low) * notBelow);
          }
          if (avoidsGone)
            shown.removed->forEachIn(y, z, [&](int x, std::uint8_t coverage) {
              if (RemovedVoxels::isGone(coverage)) row[x] |= isGone;
            });
        }
    });
  });
  return corners;
}

std::vector<std::uint8_t> activeCells(const ShownVolume& shown, ValueRange range, const Grid& cells) {
  const Grid& grid = shown.volume->grid;
  const glm::ivec3 last = grid.dims - 1;
  const std::vector<std::uint8_t> corners = cornersOf(shown, range);
  std::vector<std::uint8_t> state(cells.voxelCount(), inactive);
  constexpr int wanted = notAbove | notBelow;
  parallelFor(static_cast<std::size_t>(cells.dims.z), 1, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint8_t> columns(static_cast<std::size_t>(grid.dims.x));  // flags of four corners side by side
    for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
      for (int y = 0; y < cells.dims.y; ++y) {
        const int above = std::min(y + 1, last.y), behind = std::min(z + 1, last.z);
        const std::uint8_t* rows[4] = {
            corners.data() + grid.offset({0, y, z}), corners.data() + grid.offset({0, above, z}),
            corners.data() + grid.offset({0, y, behind}), corners.data() + grid.offset({0, above, behind})};
        for (std::size_t x = 0; x < columns.size(); ++x)
          columns[x] = static_cast<std::uint8_t>(rows[0][x] | rows[1][x] | rows[2][x] | rows[3][x]);
        std::uint8_t* row = state.data() + cells.offset({0, y, z});
        for (int x = 0; x < cells.dims.x; ++x) {
          const int any =
              columns[static_cast<std::size_t>(x)] | columns[static_cast<std::size_t>(std::min(x + 1, last.x))];
          if ((any & (wanted | isGone)) == wanted) row[x] = unvisited;
        }
      }
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
  const auto across = static_cast<std::size_t>(cells.dims.x), down = static_cast<std::size_t>(cells.dims.y);
  for (std::size_t at = 0; at < state.size(); ++at) {
    if (state[at] != unvisited) continue;
    component.clear();
    visit({at % across, at / across % down, at / (across * down)});
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
