#include "rendering/passes/ConePass.h"

#include "rendering/gpu/Uniforms.h"

namespace fenestra {
namespace {

// shaders/lib/Cones.glsl.
constexpr unsigned depthsBinding = 0;
constexpr int topLevel = 8, topSide = 1 << topLevel;

ConeUniforms uniformsOf(const RayFrame& rays, const gl::Region& around, double slope) {
  ConeUniforms uniforms;
  uniforms.origin = around.origin;
  // One square at least, so that the shaders need not ask whether there is any.
  uniforms.tops = glm::max((around.size + topSide - 1) / topSide, 1);
  uniforms.slope = static_cast<float>(slope * rays.pixelSize(rays.distance()));
  uniforms.perDepth = rays.perspective() ? static_cast<float>(1.0 / rays.distance()) : 0.0f;
  return uniforms;
}

}  // namespace

void ConePass::run(Steps& steps, Schedule schedule, const RayFrame& rays, const gl::Texture& hitPoints,
                   const gl::Region& around, const Cones& cones, gl::Texture& starts,
                   const std::optional<Level>& level) {
  const ConeUniforms uniforms = uniformsOf(rays, around, cones.slope);
  std::size_t squares = 0;
  for (int below = 0; below <= topLevel; ++below)
    squares += static_cast<std::size_t>(uniforms.tops.x << below) * static_cast<std::size_t>(uniforms.tops.y << below);
  if (depths_.bytes() != squares * sizeof(float)) depths_ = gl::Buffer::zeroed(squares * sizeof(float));

  steps.add(uniforms.tops << topLevel, [this, schedule, &rays, &hitPoints, uniforms, cones](Regions tile) {
    gl::ShaderProgram& program = depthsProgram_.get(
        gl::Variant{{{"SILHOUETTE", cones.onSilhouette}}, {scheduleChoice(schedule)}} + rays.variant());
    rays.setUniforms(program);
    program.set(uniforms);
    program.bind("hitPoints", hitPoints);
    depths_.bind(depthsBinding);
    program.dispatch(tile);
  });
  for (int below = topLevel - 1; below >= 0; --below)
    steps.add(uniforms.tops << below, [this, schedule, uniforms, below](Regions tile) {
      gl::ShaderProgram& program = levelProgram_.get({{}, {scheduleChoice(schedule)}});
      program.set(uniforms);
      program.set("below", below);
      depths_.bind(depthsBinding);
      program.dispatch(tile);
    });
  steps.add(rays.size(), [this, schedule, &rays, &hitPoints, uniforms, &starts, level](Regions tile) {
    const gl::Choice choice{"level", !level            ? "lib/level/Only.glsl"
                                     : level->isLowest ? "lib/level/Lowest.glsl"
                                                       : "lib/level/Higher.glsl"};
    gl::ShaderProgram& program =
        startProgram_.get(gl::Variant{{}, {scheduleChoice(schedule), choice}} + rays.variant());
    rays.setUniforms(program);
    program.set(uniforms);
    program.bind("hitPoints", hitPoints);
    const gl::Access access = level && !level->isLowest ? gl::Access::ReadWrite : gl::Access::Write;
    program.bind("coneStart", starts, access);
    if (level) program.bind("openedHits", level->opened, access);
    depths_.bind(depthsBinding);
    program.dispatch(tile);
  });
}

}  // namespace fenestra
