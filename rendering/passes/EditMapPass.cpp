#include "rendering/passes/EditMapPass.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace fenestra {
namespace {

// The shader's blocks (EditMap.comp), std430.
enum Block : unsigned { strokesBlock, linesBlock, tilesBlock };
struct GpuStroke {
  std::uint32_t mode, coversFocus;
  float radius, softness, effect;
  std::uint32_t toSurface;
  std::array<float, 2> unused;
};
struct GpuLine {
  StrokeLine line;
  std::array<std::uint32_t, 4> stroke;
};

/// Pixels a side of the tiles that keep lists of the lines that reach them; larger for pictures of more than mostTiles.
constexpr int leastTile = 16, mostTiles = 16384;

struct TileGrid {
  int size = leastTile;
  glm::ivec2 count{0};
  explicit TileGrid(glm::ivec2 picture) {
    for (;; size *= 2) {
      count = (picture + size - 1) / size;
      if (count.x * count.y <= mostTiles) return;
    }
  }
};

/// Where each tile's list begins, then the lists.
std::vector<std::uint32_t> tileLists(const std::vector<GpuLine>& lines, const TileGrid& grid) {
  const auto tiles = static_cast<std::size_t>(grid.count.x * grid.count.y);
  std::vector<std::vector<std::uint32_t>> lists(tiles);
  for (std::size_t index = 0; index < lines.size(); ++index)
    forEachTileReached(lines[index].line, grid.size, grid.count, 0.0f, [&](int i, int j) {
      lists[static_cast<std::size_t>(j * grid.count.x + i)].push_back(static_cast<std::uint32_t>(index));
    });
  std::vector<std::uint32_t> packed(tiles + 1);
  for (std::size_t tile = 0; tile < tiles; ++tile)
    packed[tile + 1] = packed[tile] + static_cast<std::uint32_t>(lists[tile].size());
  packed.reserve(packed.size() + packed.back());
  for (const auto& list : lists) packed.insert(packed.end(), list.begin(), list.end());
  return packed;
}

}  // namespace

void EditMapPass::run(Steps& steps, Schedule schedule, const RayFrame& rays, const RayStartPass::Inputs& inputs,
                      const ProjectedStrokes& strokes, Regions regions, gl::Texture& editMap) {
  std::vector<GpuStroke> gpuStrokes;
  std::vector<GpuLine> gpuLines;
  for (const ProjectedStroke& stroke : strokes) {
    const auto index = static_cast<std::uint32_t>(gpuStrokes.size());
    for (const StrokeLine& line : stroke.lines) gpuLines.push_back({line, {index, 0, 0, 0}});
    gpuStrokes.push_back({static_cast<std::uint32_t>(stroke.mode),
                          stroke.coversFocus,
                          stroke.radius,
                          stroke.softness,
                          stroke.effect,
                          stroke.toSurface,
                          {}});
  }
  const TileGrid grid(rays.size());
  strokes_ = gl::Buffer(std::as_bytes(std::span(gpuStrokes)));
  lines_ = gl::Buffer(std::as_bytes(std::span(gpuLines)));
  const std::vector<std::uint32_t> tiles = tileLists(gpuLines, grid);
  tiles_ = gl::Buffer(std::as_bytes(std::span(tiles)));

  steps.add(regions, [this, schedule, &rays, inputs, grid, &editMap](Regions tile) {
    gl::ShaderProgram& program =
        programs_.get(gl::Variant{{}, {scheduleChoice(schedule), inputs.choice(rays)}} + rays.variant());
    rays.setUniforms(program);
    inputs.bind(program, rays);
    strokes_.bind(strokesBlock);
    lines_.bind(linesBlock);
    tiles_.bind(tilesBlock);
    program.set("tileSize", grid.size);
    program.set("tilesAcross", grid.count.x);
    program.set("tileCount", grid.count.x * grid.count.y);
    program.bind("editMap", editMap, gl::Access::Write);
    program.dispatch(tile);
  });
}

}  // namespace fenestra
