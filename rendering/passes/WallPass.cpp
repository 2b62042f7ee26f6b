#include "rendering/passes/WallPass.h"

#include <algorithm>

#include "rendering/gpu/Uniforms.h"

namespace fenestra {
namespace {

glm::vec4 rowOf(const glm::dmat4& matrix, int row) {
  return {matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]};
}

WallUniforms uniformsOf(const std::vector<Wall>& walls, const Grid& grid, const RayFrame& rays) {
  WallUniforms uniforms;
  for (auto* rows : {&uniforms.plane, &uniforms.across, &uniforms.down}) rows->fill(glm::vec4(0.0f));
  uniforms.extent.fill(glm::vec4(0.0f));
  uniforms.metric.fill(glm::vec4(1.0f));
  const glm::dmat4 worldFromCells = rays.worldFromCells();
  const std::vector<int> rows = WallImages::firstRows(walls);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const Wall& wall = walls[i];
    const glm::dmat3 linear =
        glm::inverse(glm::dmat3(wall.right, wall.down, glm::normalize(glm::cross(wall.right, wall.down))));
    glm::dmat4 placeFromCells(linear * glm::dmat3(worldFromCells));
    // Subtracting the origins first keeps the precision where both are metres away.
    placeFromCells[3] = glm::dvec4(linear * (glm::dvec3(worldFromCells[3]) - wall.origin), 1.0);
    uniforms.across[i] = rowOf(placeFromCells, 0);
    uniforms.down[i] = rowOf(placeFromCells, 1);
    uniforms.plane[i] = rowOf(placeFromCells, 2);
    const glm::dmat2 mm = wall.mmFromPlace();
    uniforms.extent[i] = glm::vec4(wall.size, rows[i], 0.0f);
    uniforms.metric[i] = glm::vec4(mm[0].x, mm[1].x, mm[1].y, lineWidth(wall, grid));
  }
  return uniforms;
}

}  // namespace

void WallPass::run(Steps& steps, const GpuScene& gpu, const Scene& scene, const ShownSlices& slices,
                   const RayFrame& rays, const std::optional<OpenedSpace>& opening, const gl::Texture& picture,
                   Regions regions, const Outputs& outputs) {
  const MethodStages::Walls which = *wallsOf(scene.look);
  const Grid& grid = scene.volume->grid;
  const std::vector<Wall> walls = wallsAt(which, grid, slices, rays.camera());
  images_.update(scene, walls, which, slices);
  const WallUniforms uniforms = uniformsOf(walls, grid, rays);
  steps.add(regions, [this, &gpu, uniforms, &rays, opening, &picture, outputs](Regions tile) {
    // Walls stand also where the volume is clipped.
    gl::ShaderProgram& program =
        programs_.get({{},
                       {scheduleChoice(gpu.schedule()),
                        Clip().choice(),
                        rays.placesChoice(),
                        {"walls", opening ? "lib/walls/Inside.glsl" : "lib/walls/Around.glsl"}}});
    rays.setUniforms(program);
    program.set(uniforms);
    images_.bindLines();
    program.bind("greys", images_.greys());
    program.bind("picture", picture);
    if (opening) {
      program.bind("hitPoints", opening->hitPoints);
      program.bind("rayStart", opening->rayStart);
    }
    program.bind("wallLayer", outputs.layer, gl::Access::Write);
    program.bind("walled", outputs.picture, gl::Access::Write);
    program.dispatch(tile);
  });
}

}  // namespace fenestra
