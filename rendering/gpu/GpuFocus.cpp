#include "rendering/gpu/GpuFocus.h"

#include <algorithm>
#include <span>
#include <utility>

#include "rendering/gpu/FocusIndexing.h"
#include "rendering/volume/Threads.h"

namespace fenestra {

GpuFocus::Change GpuFocus::update(const Scene& scene, const BrickRanges& bricks) {
  const auto* focus = std::get_if<LabelFocus>(&scene.look.focus);
  std::optional<LabelIndexer> indexer = std::exchange(indexer_, std::nullopt);  // lost where something below fails
  if (!focus || !scene.labels || !indexer || indexer->map() != scene.labels) {
    release();
    indexer.reset();
  }
  if (!focus || !scene.labels) {
    index_ = buildFocusIndex(scene, bricks);
    if (index_.kind == FocusIndex::Kind::None) return {.isNew = true, .flipped = {}};
    bricks_ = gl::Texture::make3D(gl::Format::R32UI, index_.bricks);
    bricks_.upload(std::span<const std::uint32_t>(index_.slots));
    cells_ = gl::Buffer(std::as_bytes(std::span(index_.cells)));
    return {.isNew = true, .flipped = {}};
  }

  const bool isNew = !indexer;
  if (isNew) indexer.emplace(scene.labels);
  LabelIndexer::Change change = indexer->update(index_, focus->labels);
  if (isNew) {
    bricks_ = gl::Texture::make3D(gl::Format::R32UI, index_.bricks);
    bricks_.upload(std::span<const std::uint32_t>(index_.slots));
  } else if (change.firstLayer <= change.lastLayer) {
    const std::size_t first = brickOffset(index_.bricks, {0, 0, change.firstLayer});
    const std::size_t end = brickOffset(index_.bricks, {0, 0, change.lastLayer + 1});
    bricks_.upload({0, 0, change.firstLayer},
                   {index_.bricks.x, index_.bricks.y, change.lastLayer + 1 - change.firstLayer},
                   std::as_bytes(std::span(index_.slots).subspan(first, end - first)));
  }
  const bool changed = isNew || !change.bricks.empty() || scene.look.labelSmoothing != smoothing_;
  smoothing_ = scene.look.labelSmoothing;
  if (changed) {
    index_.smoothed = smoothedIndicator(scene);
    uploadCells();
  }
  if (smooth_) stale_.insert(stale_.end(), change.bricks.begin(), change.bricks.end());
  indexer_ = std::move(indexer);
  change.filled.insert(change.filled.end(), change.emptied.begin(), change.emptied.end());
  return {isNew, std::move(change.filled)};
}

void GpuFocus::uploadCells() {
  std::vector<std::uint32_t> smoothed;
  if (index_.smoothed) smoothed = index_.smoothedCells();
  const auto bytes = std::as_bytes(std::span(index_.smoothed ? smoothed : index_.cells));
  if (cells_ && bytes.size() == cells_.bytes())
    cells_.write(bytes);
  else
    cells_ = gl::Buffer(bytes);
}

void GpuFocus::updateSmooth(bool wanted) {
  if (!wanted || index_.kind != FocusIndex::Kind::Labels || !index_.box) {
    smooth_ = {};
    smoothBox_ = {};
    smoothOf_ = {};
    stale_.clear();
    return;
  }
  const FocusSmooth source(index_, indexer_->map()->grid.dims);
  if (smooth_ && source.box() == smoothBox_ && smoothOf_ == index_.smoothed) {
    if (!stale_.empty()) uploadSmooth(source, source.tilesNear(stale_));
  } else {
    smooth_ = {};
    smooth_ = gl::Texture::make3D(gl::Format::R16, source.box().size, gl::Filter::Linear);
    smooth_.clear();
    smoothBox_ = source.box();
    smoothOf_ = index_.smoothed;
    uploadSmooth(source, source.tiles());
  }
  stale_.clear();
}

void GpuFocus::uploadSmooth(const FocusSmooth& source, const std::vector<glm::ivec3>& tiles) {
  constexpr std::size_t batch = 256;  // two megabytes
  std::vector<FocusSmooth::Tile> made(std::min(batch, tiles.size()));
  for (std::size_t first = 0; first < tiles.size(); first += batch) {
    const std::size_t count = std::min(batch, tiles.size() - first);
    parallelFor(count, 8, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) source.make(tiles[first + i], made[i]);
    });
    for (std::size_t i = 0; i < count; ++i)
      smooth_.upload(tiles[first + i] - smoothBox_.origin, glm::ivec3(FocusSmooth::tileSide),
                     std::as_bytes(std::span(made[i])));
  }
}

void GpuFocus::release() {
  index_ = {};
  indexer_.reset();
  bricks_ = {};
  cells_ = {};
  smoothing_ = LabelSmoothing::Off;
  smooth_ = {};
  smoothBox_ = {};
  smoothOf_ = {};
  stale_.clear();
}

}  // namespace fenestra
