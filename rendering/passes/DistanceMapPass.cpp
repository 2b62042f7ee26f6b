#include "rendering/passes/DistanceMapPass.h"

namespace fenestra {

void DistanceMapPass::run(Steps& steps, Schedule schedule, const gl::Texture& hitPoints, int range,
                          gl::Texture& distances, const gl::Texture* starts) {
  const glm::ivec2 size(hitPoints.size());
  if (!rows_ || glm::ivec2(rows_.size()) != size) {
    const glm::ivec2 tiles = gl::withoutPowersOfTwo((size + 31) / 32);
    mask_ = gl::Texture::make2D(gl::Format::R32UI, {tiles.x, size.y});
    tiles_ = gl::Texture::make2D(gl::Format::R8UI, tiles);
    rows_ = gl::Texture::make2D(gl::Format::R16UI, size);
  }
  const gl::Variant variant{{}, {scheduleChoice(schedule)}};
  steps.add(glm::ivec2(mask_.size()), [this, schedule, &hitPoints, starts](Regions tile) {
    const gl::Choice choice{"mask", starts ? "lib/mask/Opening.glsl" : "lib/mask/Projection.glsl"};
    gl::ShaderProgram& mask = maskProgram_.get({{}, {scheduleChoice(schedule), choice}});
    mask.bind("hitPoints", hitPoints);
    if (starts) mask.bind("starts", *starts);
    mask.bind("focusMask", mask_, gl::Access::Write);
    mask.dispatch(tile);
  });
  steps.add(glm::ivec2(tiles_.size()), [this, variant, range](Regions tile) {
    gl::ShaderProgram& tiles = tileProgram_.get(variant);
    tiles.bind("focusMask", mask_);
    tiles.set("reach", (range + 31) / 32);
    tiles.bind("focusTiles", tiles_, gl::Access::Write);
    tiles.dispatch(tile);
  });
  steps.add(size, [this, variant, range](Regions tile) {
    gl::ShaderProgram& rows = rowProgram_.get(variant);
    rows.bind("focusMask", mask_);
    rows.bind("focusTiles", tiles_);
    rows.set("range", range);
    rows.bind("rowDistance", rows_, gl::Access::Write);
    rows.dispatch(tile);
  });
  steps.add(size, [this, variant, range, &distances](Regions tile) {
    gl::ShaderProgram& columns = columnProgram_.get(variant);
    columns.bind("rowDistance", rows_);
    columns.bind("focusTiles", tiles_);
    columns.set("range", range);
    columns.bind("distances", distances, gl::Access::Write);
    columns.dispatch(tile);
  });
}

}  // namespace fenestra
