#include "rendering/passes/DistanceMapPass.h"

#include "rendering/gpu/SceneBinding.h"

namespace fenestra {

void DistanceMapPass::run(const gl::Texture& hitPoints, int range, gl::Texture& distances) {
  const glm::ivec2 size(hitPoints.size());
  if (!rows_ || glm::ivec2(rows_.size()) != size) {
    mask_ = gl::Texture::make2D(gl::Format::R32UI, {(size.x + 31) / 32, size.y});
    tiles_ = gl::Texture::make2D(gl::Format::R8UI, (size + 31) / 32);
    rows_ = gl::Texture::make2D(gl::Format::R16UI, size);
  }
  gl::ShaderProgram& mask = maskProgram_.get();
  bindImage(mask, "hitPoints", 1, hitPoints);
  mask_.bindImage(0, gl::Access::Write);
  mask.dispatch(glm::ivec2(mask_.size()));

  gl::ShaderProgram& tiles = tileProgram_.get();
  bindImage(tiles, "focusMask", 1, mask_);
  tiles.set("reach", (range + 31) / 32);
  tiles_.bindImage(0, gl::Access::Write);
  tiles.dispatch(glm::ivec2(tiles_.size()));

  gl::ShaderProgram& rows = rowProgram_.get();
  bindImage(rows, "focusMask", 1, mask_);
  bindImage(rows, "focusTiles", 2, tiles_);
  rows.set("range", range);
  rows_.bindImage(0, gl::Access::Write);
  rows.dispatch(size);

  gl::ShaderProgram& columns = columnProgram_.get();
  bindImage(columns, "rowDistance", 1, rows_);
  bindImage(columns, "focusTiles", 2, tiles_);
  columns.set("range", range);
  distances.bindImage(0, gl::Access::Write);
  columns.dispatch(size);
}

}  // namespace fenestra
