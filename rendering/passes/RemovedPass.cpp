#include "rendering/passes/RemovedPass.h"

namespace fenestra {

void RemovedPass::run(Steps& steps, Schedule schedule, const RayFrame& rays, const gl::Texture& hitPoints,
                      const CutImages& opening, bool holes, double voxel, gl::Texture& faces, const Outputs& outputs) {
  steps.add(opening.rays.size(), [this, schedule, opening, &faces](Regions tile) {
    gl::ShaderProgram& program = faces_.get(gl::Variant{{}, {scheduleChoice(schedule)}} + opening.rays.variant());
    opening.rays.setUniforms(program);
    program.bind("hitPoints", opening.hitPoints);
    program.bind("rayStart", opening.rayStart);
    program.bind("focusFilled", opening.focusFilled);
    program.bind("distances", opening.distances);
    program.set("reach", static_cast<float>(opening.reach));
    program.bind("faces", faces, gl::Access::Write);
    program.dispatch(tile);
  });
  runParts(steps, schedule, rays, hitPoints, opening, holes, voxel, faces, {glm::ivec2(0), rays.size()}, outputs);
}

void RemovedPass::runParts(Steps& steps, Schedule schedule, const RayFrame& rays, const gl::Texture& hitPoints,
                           const CutImages& opening, bool holes, double voxel, const gl::Texture& faces,
                           const gl::Region& region, const Outputs& outputs) {
  steps.add(
      Regions(&region, 1), [this, schedule, &rays, &hitPoints, opening, holes, voxel, &faces, outputs](Regions tile) {
        const gl::Choice removed{"removed", opening.editMap ? "lib/removed/Edited.glsl" : "lib/removed/Unedited.glsl"};
        gl::ShaderProgram& program = parts_.get(gl::Variant{{}, {scheduleChoice(schedule), removed}} + rays.variant());
        rays.setUniforms(program);
        program.set(opening.rays.seenFrom(rays));
        program.set("firstHole", holes ? -1e30f : 1e30f);
        program.set("voxel", static_cast<float>(voxel));
        program.bind("hitPoints", hitPoints);
        program.bind("faces", faces);
        program.bind("rayStart", outputs.rayStart, gl::Access::Write);
        program.bind("hole", outputs.hole, gl::Access::Write);
        program.bind("distances", outputs.distances, gl::Access::Write);
        if (opening.editMap) {
          program.bind("openingEdits", *opening.editMap);
          program.bind("editMap", *outputs.editMap, gl::Access::Write);
        }
        program.dispatch(tile);
      });
}

}  // namespace fenestra
