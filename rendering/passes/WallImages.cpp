#include "rendering/passes/WallImages.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fenestra {
namespace {

/// Storage blocks of shaders/Walls.comp.
constexpr unsigned cellsBinding = 0, piecesBinding = 1;

/// A piece of a line as the shader reads it: its ends in mm on the wall, its colour, and a number that only pieces of
/// the same line share.
struct Piece {
  glm::vec4 ends;
  glm::vec4 colourAndLine;
};

glm::ivec2 atlasSize(const std::vector<Wall>& walls) {
  glm::ivec2 size(1, 0);
  for (const Wall& wall : walls) size = {std::max(size.x, wall.size.x), size.y + wall.size.y};
  return glm::max(size, 1);
}

/// The voxels of a slice, by their centres, that a piece comes within `reach` mm of, or a few more.
template <class Visit>
void forEachNear(const WallLine::Piece& piece, const Wall& wall, double reach, const Visit& visit) {
  // mm between neighbouring lines of places of one u, and of one v.
  const glm::dmat2 mm = wall.mmFromPlace();
  const double area = mm[0].x * mm[1].y;
  const glm::dvec2 apart(area / glm::length(mm[1]), area / glm::length(mm[0]));
  const glm::dvec2 beyond = reach / apart + 0.5;  // a cell reaches half a voxel around its centre
  const glm::dvec2 low = glm::min(piece.from, piece.to) - beyond, high = glm::max(piece.from, piece.to) + beyond;
  const glm::ivec2 first = glm::max(glm::ivec2(glm::ceil(low)), 0),
                   last = glm::min(glm::ivec2(glm::floor(high)), wall.size - 1);
  for (int v = first.y; v <= last.y; ++v)
    for (int u = first.x; u <= last.x; ++u) visit(glm::ivec2(u, v));
}

}  // namespace

std::vector<int> WallImages::firstRows(const std::vector<Wall>& walls) {
  std::vector<int> rows;
  int next = 0;
  for (const Wall& wall : walls) {
    rows.push_back(next);
    next += wall.size.y;
  }
  return rows;
}

std::vector<WallImages::Slice> WallImages::slicesOf(const std::vector<Wall>& walls) {
  std::vector<Slice> slices;
  for (const Wall& wall : walls) slices.push_back({wall.axis, wall.slice});
  return slices;
}

void WallImages::update(const Scene& scene, const std::vector<Wall>& walls, const MethodStages::Walls& which,
                        const ShownSlices& slices) {
  GreyKey grey{scene.volume, slicesOf(walls), slices.window, slices.inverted};
  if (greyKey_ != grey) {
    greyKey_.reset();
    uploadGreys(scene.volume, walls, slices);
    greyKey_ = std::move(grey);
  }
  LineKey line{which.outlines ? scene.labels : nullptr,
               which.outlines ? structuresOf(scene) : nullptr,
               which.outlines ? scene.look.labels : LabelSettings(),
               scene.volume->grid,
               slicesOf(walls),
               {},
               which.outlines};
  if (which.placement == WallPlacement::Around)
    for (const Wall& wall : walls) line.crossings.push_back(crossingOn(wall, scene.volume->grid, slices));
  if (lineKey_ != line) {
    lineKey_.reset();
    uploadLines(scene, walls, which, slices);
    lineKey_ = std::move(line);
  }
}

void WallImages::uploadGreys(const std::shared_ptr<const Volume>& shown, const std::vector<Wall>& walls,
                             const ShownSlices& slices) {
  const Volume& volume = *shown;
  const WindowLevel window = slices.window ? *slices.window : volume.defaultWindow();
  const double perValue = 1.0 / window.width, low = window.level - 0.5 * window.width;
  const bool turned = volume.lowIsWhite != slices.inverted;
  const glm::ivec2 size = atlasSize(walls);
  std::vector<float> greys(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  int row = 0;
  withValues(ShownVolume{shown}, [&](const auto& valueAt) {
    for (const Wall& wall : walls)
      for (int v = 0; v < wall.size.y; ++v, ++row)
        for (int u = 0; u < wall.size.x; ++u) {
          const double grey = (valueAt(glm::ivec3(wall.indexFromPlace({u, v}))) - low) * perValue;
          greys[static_cast<std::size_t>(row) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(u)] =
              std::clamp(static_cast<float>(turned ? 1.0 - grey : grey), -greatestGrey, greatestGrey);
        }
  });
  if (!greys_ || glm::ivec2(greys_.size()) != size) greys_ = gl::Texture::make2D(gl::Format::R32F, size);
  greys_.upload(std::span<const float>(greys));
}

void WallImages::uploadLines(const Scene& scene, const std::vector<Wall>& walls, const MethodStages::Walls& which,
                             const ShownSlices& slices) {
  const glm::ivec2 size = atlasSize(walls);
  const std::size_t cellCount = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  std::vector<std::vector<WallLine>> lines;
  for (const Wall& wall : walls) lines.push_back(linesOn(wall, which, scene, slices));
  const std::vector<int> rows = firstRows(walls);
  // Calls visit(cell, wall, line, piece) for all pieces, in the order of the lines.
  const auto forEach = [&](const auto& visit) {
    for (std::size_t w = 0; w < walls.size(); ++w) {
      const double reach = lineWidth(walls[w], scene.volume->grid);  // half of it, and half a pixel of at most it
      for (std::size_t l = 0; l < lines[w].size(); ++l)
        for (const WallLine::Piece& piece : lines[w][l].pieces)
          forEachNear(piece, walls[w], reach, [&](glm::ivec2 at) {
            visit(static_cast<std::size_t>(rows[w] + at.y) * static_cast<std::size_t>(size.x) +
                      static_cast<std::size_t>(at.x),
                  w, l, piece);
          });
    }
  };
  std::vector<std::uint32_t> firsts(cellCount + 1, 0);
  forEach([&](std::size_t cell, std::size_t, std::size_t, const WallLine::Piece&) { ++firsts[cell + 1]; });
  for (std::size_t cell = 0; cell < cellCount; ++cell) firsts[cell + 1] += firsts[cell];
  std::vector<Piece> pieces(firsts.back());
  std::vector<std::uint32_t> next(firsts.begin(), firsts.end() - 1);
  forEach([&](std::size_t cell, std::size_t w, std::size_t l, const WallLine::Piece& piece) {
    const glm::dmat2 mm = walls[w].mmFromPlace();
    pieces[next[cell]++] = {glm::vec4(glm::vec2(mm * piece.from), glm::vec2(mm * piece.to)),
                            glm::vec4(glm::vec3(lines[w][l].colour), static_cast<float>(l))};
  });
  cells_ = gl::Buffer(std::as_bytes(std::span(firsts)));
  pieces_ = gl::Buffer(std::as_bytes(std::span(pieces)));
}

void WallImages::bindLines() const {
  cells_.bind(cellsBinding);
  pieces_.bind(piecesBinding);
}

std::size_t WallImages::bytes() const { return (greys_ ? greys_.bytes() : 0) + cells_.bytes() + pieces_.bytes(); }

}  // namespace fenestra
