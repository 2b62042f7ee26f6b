#include "rendering/passes/OcclusionPass.h"

#include <vector>

#include "rendering/gpu/SceneBinding.h"

namespace fenestra {
namespace {

/// Storage blocks, as the shaders number them.
enum Block : unsigned { mediumBlock = 5, directionsBlock = 7 };

/// All of a pass's directions in cells per mm, as many as there are all around first.
std::vector<glm::vec4> directionsInCells(const Grid& grid, glm::ivec3 side, const Shading& shading, glm::dvec3 light,
                                         const occlusion::Directions& directions) {
  std::vector<glm::dvec3> all;
  if (shading.occlusion > 0.0) all = occlusion::allAround(directions.around);
  if (shading.shadow > 0.0)
    for (const glm::dvec3 each : occlusion::towards(light, occlusion::lightRadius, directions.towardsLight))
      all.push_back(each);
  const glm::dmat3 indexFromWorld(grid.indexFromWorld());
  std::vector<glm::vec4> result;
  for (const glm::dvec3 each : all)
    result.push_back(glm::vec4(glm::dvec4(indexFromWorld * each / glm::dvec3(side), 0.0)));
  return result;
}

OccludersBlock occludersBlock(const GpuScene& gpu, const RayFrame* rays) {
  const OccluderCells& cells = gpu.occluders().cells();
  const Grid& grid = gpu.grid();
  const double side = cells.sideLength(grid);
  OccludersBlock block;
  block.dims = cells.dims;
  block.side = glm::vec3(cells.side);
  // Half a cell lies around each of the eight points of a cell that are looked at.
  block.width = static_cast<float>(0.5 * side);
  if (!rays) return block;
  const Camera::Axes& axes = rays->axes();
  const glm::dmat3 viewFromWorld = glm::transpose(glm::dmat3(axes.right, axes.up, axes.forward));
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  const glm::dvec3 anchor = rays->camera().eye + axes.forward * rays->distance();
  const glm::dvec3 corner(worldFromIndex * glm::dvec4(glm::dvec3(-0.5), 1.0));
  glm::dmat3 worldFromCells(worldFromIndex);
  for (int axis = 0; axis < 3; ++axis) worldFromCells[axis] *= cells.side[axis];
  block.viewFromCells = Std140Mat3(glm::mat3(viewFromWorld * worldFromCells));
  block.offset = glm::vec3(viewFromWorld * (corner - anchor));
  block.perDepth = rays->perspective() ? static_cast<float>(1.0 / rays->distance()) : 0.0f;
  constexpr double nearest = 1e-3;  // of the way from the eye to the anchor plane
  block.nearest = static_cast<float>(rays->distance() * (rays->perspective() ? nearest - 1.0 : -1.0));
  return block;
}

OcclusionBlock occlusionBlock(const GpuScene& gpu, const Shading& shading, const occlusion::Directions& directions) {
  const OccluderCells& cells = gpu.occluders().cells();
  const occlusion::Weight weight = occlusion::nearWeight(cells.sideLength(gpu.grid()));
  return {cells.dims,
          shading.occlusion > 0.0 ? directions.around : 0,
          glm::vec2(weight.from, weight.to),
          glm::vec2(weight.fadeFrom, weight.fadeTo),
          glm::vec2(shading.occlusion, shading.shadow),
          shading.shadow > 0.0 ? directions.towardsLight : 0};
}

}  // namespace

void OcclusionPass::run(Steps& steps, const GpuScene& gpu, const Shading& shading, glm::dvec3 light, const Clip& clip,
                        const std::optional<Opening>& opening, const occlusion::Directions& directions,
                        gl::Buffer& nodes) {
  const OccluderCells& cells = gpu.occluders().cells();
  const std::size_t count = cells.extinction.size();
  if (medium_.bytes() != count * sizeof(float)) medium_ = gl::Buffer::zeroed(count * sizeof(float));
  if (nodes.bytes() != count * sizeof(std::uint32_t)) nodes = gl::Buffer::zeroed(count * sizeof(std::uint32_t));
  const std::vector<glm::vec4> inCells = directionsInCells(gpu.grid(), cells.side, shading, light, directions);
  directions_ = gl::Buffer(std::as_bytes(std::span(inCells)));
  const glm::ivec2 size(cells.dims.x, cells.dims.y * cells.dims.z);

  steps.add(size, [this, &gpu, clip, opening](Regions tile) {
    gl::ShaderProgram& program = occluders_.get(
        {{{"OPENED", opening.has_value()}, clip.define(), {"SCATTERED", 0}}, {scheduleChoice(gpu.schedule())}});
    if (opening) {
      opening->rays.setBlocks(program);
      program.bind("hitPoints", opening->hitPoints);
      program.bind("rayStart", opening->rayStart);
    }
    // In cells of the voxels' own grid.
    if (!clip.kept.empty()) program.set(clip.block(gpu.grid()));
    program.set(occludersBlock(gpu, opening ? &opening->rays : nullptr));
    gpu.occluders().bind();
    medium_.bind(mediumBlock);
    program.dispatch(tile);
  });
  steps.add(size, [this, &gpu, block = occlusionBlock(gpu, shading, directions), &nodes](Regions tile) {
    gl::ShaderProgram& program = nodes_.get({{}, {scheduleChoice(gpu.schedule())}});
    program.set(block);
    medium_.bind(mediumBlock);
    directions_.bind(directionsBlock);
    nodes.bind(occlusionNodesBinding);
    program.dispatch(tile);
  });
}

}  // namespace fenestra
