#include "rendering/passes/OcclusionPass.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "rendering/gpu/SceneBinding.h"

namespace fenestra {
namespace {

/// A cell that a ray goes through, counted from the one in whose centre it begins, and its weight in mm; as a texel.
using Step = glm::vec4;

/// The steps of a ray in a direction (cells per mm), as far as the weight or a medium of `dims` cells reaches. The last
/// one has a weight of 0.
std::vector<Step> stepsAlong(glm::dvec3 direction, const occlusion::Weight& weight, glm::ivec3 dims) {
  std::vector<Step> steps;
  glm::ivec3 at(0);
  double s = 0.0;
  while (s < weight.fadeTo && glm::all(glm::lessThan(glm::abs(at), dims))) {
    double next = std::numeric_limits<double>::infinity();
    int crossed = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (direction[axis] == 0.0) continue;
      const double face = (at[axis] + (direction[axis] > 0.0 ? 0.5 : -0.5)) / direction[axis];
      if (face >= next) continue;
      next = face;
      crossed = axis;
    }
    const double to = std::clamp(next, s, weight.fadeTo), weighted = weight.upTo(to) - weight.upTo(s);
    if (weighted > 0.0) steps.push_back(Step(glm::dvec4(at, weighted)));
    s = to;
    at[crossed] += direction[crossed] > 0.0 ? 1 : -1;
  }
  steps.push_back(Step(0.0f));
  return steps;
}

/// Steps in all of a pass's directions, a row each: those all around first.
gl::Texture stepsOf(const GpuScene& gpu, const Shading& shading, glm::dvec3 light,
                    const occlusion::Directions& directions) {
  const OccluderCells& cells = gpu.occluders().cells();
  const glm::dmat3 indexFromWorld(gpu.grid().indexFromWorld());
  const double side = cells.sideLength(gpu.grid());
  std::vector<std::vector<Step>> rows;
  const auto add = [&](const std::vector<glm::dvec3>& each, const occlusion::Weight& weight) {
    for (const glm::dvec3 direction : each)
      rows.push_back(stepsAlong(indexFromWorld * direction / glm::dvec3(cells.side), weight, cells.dims));
  };
  if (shading.occlusion > 0.0) add(occlusion::allAround(directions.around), occlusion::nearWeight(side));
  if (shading.shadow > 0.0)
    add(occlusion::towards(light, occlusion::lightRadius, directions.towardsLight), occlusion::farWeight(side));
  std::size_t longest = 0;
  for (const std::vector<Step>& row : rows) longest = std::max(longest, row.size());
  std::vector<Step> texels;
  for (std::vector<Step>& row : rows) {
    row.resize(longest, Step(0.0f));
    texels.insert(texels.end(), row.begin(), row.end());
  }
  gl::Texture steps = gl::Texture::make2D(gl::Format::RGBA32F, glm::ivec2(longest, rows.size()));
  steps.upload<Step>(texels);
  return steps;
}

OccludersUniforms occludersUniforms(const GpuScene& gpu, const RayFrame* rays) {
  const OccluderCells& cells = gpu.occluders().cells();
  const Grid& grid = gpu.grid();
  const double side = cells.sideLength(grid);
  OccludersUniforms uniforms;
  uniforms.dims = cells.dims;
  uniforms.side = glm::vec3(cells.side);
  // Half a cell lies around each of the eight points of a cell that are looked at.
  uniforms.width = static_cast<float>(0.5 * side);
  if (!rays) return uniforms;
  const Camera::Axes& axes = rays->axes();
  const glm::dmat3 viewFromWorld = glm::transpose(glm::dmat3(axes.right, axes.up, axes.forward));
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  const glm::dvec3 anchor = rays->camera().eye + axes.forward * rays->distance();
  const glm::dvec3 corner(worldFromIndex * glm::dvec4(glm::dvec3(-0.5), 1.0));
  glm::dmat3 worldFromCells(worldFromIndex);
  for (int axis = 0; axis < 3; ++axis) worldFromCells[axis] *= cells.side[axis];
  uniforms.viewFromCells = Std140Mat3(glm::mat3(viewFromWorld * worldFromCells));
  uniforms.offset = glm::vec3(viewFromWorld * (corner - anchor));
  uniforms.perDepth = rays->perspective() ? static_cast<float>(1.0 / rays->distance()) : 0.0f;
  constexpr double nearest = 1e-3;  // of the way from the eye to the anchor plane
  uniforms.nearest = static_cast<float>(rays->distance() * (rays->perspective() ? nearest - 1.0 : -1.0));
  return uniforms;
}

OcclusionUniforms occlusionUniforms(const GpuScene& gpu, const Shading& shading,
                                    const occlusion::Directions& directions) {
  return {gpu.occluders().cells().dims, shading.occlusion > 0.0 ? directions.around : 0,
          glm::vec2(shading.occlusion, shading.shadow), shading.shadow > 0.0 ? directions.towardsLight : 0};
}

}  // namespace

void OcclusionPass::run(Steps& steps, const GpuScene& gpu, const Shading& shading, glm::dvec3 light, const Clip& clip,
                        const std::optional<CutRays>& opening, const occlusion::Directions& directions,
                        gl::Texture& nodes) {
  const OccluderCells& cells = gpu.occluders().cells();
  steps_ = stepsOf(gpu, shading, light, directions);
  const glm::ivec2 size(cells.dims.x, cells.dims.y * cells.dims.z);
  if (glm::ivec2(medium_.size()) != size) {
    medium_ = gl::Texture::make2D(gl::Format::R32F, size);
    nodeValues_ = gl::Texture::make2D(gl::Format::R32UI, size);
  }
  if (glm::ivec2(nodes.size()) != size) nodes = gl::Texture::make2D(gl::Format::RGBA32UI, size);

  steps.add(size, [this, &gpu, clip, opening](Regions tile) {
    gl::Variant variant{{}, {scheduleChoice(gpu.schedule()), clip.choice()}};
    variant.choices.push_back({"occluders", opening ? "lib/occluders/Opened.glsl" : "lib/occluders/Closed.glsl"});
    if (opening) variant.choices.push_back(opening->rays.placesChoice());
    gl::ShaderProgram& program = occluders_.get(variant);
    if (opening) {
      opening->rays.setUniforms(program);
      program.bind("hitPoints", opening->hitPoints);
      program.bind("rayStart", opening->rayStart);
    }
    // In cells of the voxels' own grid.
    if (!clip.kept.empty()) program.set(clip.uniforms(gpu.grid()));
    program.set(occludersUniforms(gpu, opening ? &opening->rays : nullptr));
    gpu.occluders().bind();
    program.bind("medium", medium_, gl::Access::Write);
    program.dispatch(tile);
  });
  constexpr int cellsTogether = 4;
  const int layers = (cells.dims.z + cellsTogether - 1) / cellsTogether;
  steps.add(
      glm::ivec2(cells.dims.x, cells.dims.y * layers),
      [this, &gpu, uniforms = occlusionUniforms(gpu, shading, directions)](Regions tile) {
        gl::ShaderProgram& program = occlusion_.get({{{"CELLS", cellsTogether}}, {scheduleChoice(gpu.schedule())}});
        program.set(uniforms);
        program.bind("medium", medium_);
        program.bind("steps", steps_);
        program.bind("nodeValues", nodeValues_, gl::Access::Write);
        program.dispatch(tile);
      });
  steps.add(size, [this, &gpu, uniforms = occlusionUniforms(gpu, shading, directions), &nodes](Regions tile) {
    gl::ShaderProgram& program = nodes_.get({{}, {scheduleChoice(gpu.schedule())}});
    program.set(uniforms);
    program.bind("nodeValues", nodeValues_);
    program.bind("occlusionNodes", nodes, gl::Access::Write);
    program.dispatch(tile);
  });
}

}  // namespace fenestra
