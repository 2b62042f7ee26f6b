#include "rendering/passes/DistanceMapPass.h"

#include "rendering/passes/SceneBinding.h"

namespace fenestra {

void DistanceMapPass::run(const gl::Texture& hitPoints, int range, gl::Texture& distances) {
  const glm::ivec2 size(hitPoints.size());
  if (!rows_ || glm::ivec2(rows_.size()) != size) {
    mask_ = gl::Texture::make2D(gl::Format::R32UI, {(size.x + 31) / 32, size.y});
    tiles_ = gl::Texture::make2D(gl::Format::R8UI, (size + 31) / 32);
    rows_ = gl::Texture::make2D(gl::Format::R16UI, size);
  }
  gl::ShaderProgram& mask = maskProgram_.get();
  bindTexture(mask, "hitPoints", 0, hitPoints);
  mask_.bindImage(0, gl::Access::Write);
  mask.dispatch(glm::ivec2(mask_.size()));

  gl::ShaderProgram& tiles = tileProgram_.get();
  bindTexture(tiles, "focusMask", 0, mask_);
  tiles.set("reach", (range + 31) / 32);
  tiles_.bindImage(0, gl::Access::Write);
  tiles.dispatch(glm::ivec2(tiles_.size()));

  gl::ShaderProgram& rows = rowProgram_.get();
  bindTexture(rows, "focusMask", 0, mask_);
  bindTexture(rows, "focusTiles", 1, tiles_);
  rows.set("range", range);
  rows_.bindImage(0, gl::Access::Write);
  rows.dispatch(size);

  gl::ShaderProgram& columns = columnProgram_.get();
  bindTexture(columns, "rowDistance", 0, rows_);
  bindTexture(columns, "focusTiles", 1, tiles_);
  columns.set("range", range);
  distances.bindImage(0, gl::Access::Write);
  columns.dispatch(size);
}

}  // namespace fenestra
