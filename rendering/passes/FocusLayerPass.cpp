#include "rendering/passes/FocusLayerPass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "rendering/gpu/SceneBinding.h"
#include "rendering/scene/Lighting.h"

namespace fenestra {

namespace {

/// A ray ends where less than this is left of its light, and is then off by half of it at most.
double leastTransmittance(const FocusLayerPass::Sampling& sampling) {
  return sampling.maxError ? *sampling.maxError / 4.0 : sampling.tolerance;
}

/// What the cells of a ray may seem to be wrong by together, of the bound; the rest is for the ray's end, and for what
/// is estimated too low.
constexpr double shareOfBound = 0.4;

/// From this bound on two pieces of a cell, each as if all of its mean material, are as good a beginning as three that
/// know what they hide of themselves: on the ten scenes of tests/bench/results their errors stay below it.
constexpr double coarseBound = 4.0 / 255.0;

/// What interpolated pixels may seem to be off by. Lit pictures are wrong by more from face to face. Where less is
/// known, less is trusted: over squares of more than two pixels it is as much less.
double toleranceOf(const FocusLayerPass::Sampling& sampling, bool lit, int halfSide) {
  return sampling.tolerance * (lit ? 1.5 : 1.0) / halfSide;
}

/// Rays that one invocation follows side by side: what one waits for, from voxel to colour, leaves a processor time for
/// another. With lighting one has enough to do, and two have too much to keep at hand.
int raysTogether(const FocusLayerPass::Sampling& sampling, bool lit) { return sampling.maxError || lit ? 1 : 2; }

// shaders/lib/PixelList.glsl.
constexpr unsigned listBlock = 2;
constexpr std::array<std::uint32_t, 4> emptyList{16, 0, 1, 0};

/// Boxes of so many pixels, counted from the picture's top left, that the regions lie in.
std::vector<gl::Region> inBoxes(std::span<const gl::Region> regions, glm::ivec2 sides) {
  std::vector<gl::Region> boxes;
  for (const gl::Region& region : regions) {
    const glm::ivec2 first = region.origin / sides, end = (region.origin + region.size + sides - 1) / sides;
    boxes.push_back({first, end - first});
  }
  return boxes;
}

/// With room for two pixels of each square of two, in whole groups of 8×8 squares.
std::size_t bytesOfList(std::span<const gl::Region> squares) {
  std::size_t groups = 0;
  for (const gl::Region& region : squares)
    groups += std::size_t(region.size.x + 7) / 8 * (std::size_t(region.size.y + 7) / 8);
  return sizeof emptyList + groups * 64 * 2 * sizeof(std::uint32_t);
}

}  // namespace

gl::ShaderProgram& FocusLayerPass::prepared(bool listed, const GpuScene& gpu, const Scene& scene, const RayFrame& rays,
                                            const std::optional<Opening>& opening, const Sampling& sampling) {
  const bool shading = scene.look.shading.enabled;
  const bool palette = static_cast<bool>(gpu.focusPaletteIndex());
  gl::ShaderProgram& program = programs_.get({volumeDefine(gpu),
                                              focusDefine(gpu),
                                              {"SHADING", shading},
                                              {"FOCUS_PALETTE", palette},
                                              {"HAS_RAY_START", opening.has_value()},
                                              {"CELL_BY_CELL", sampling.maxError.has_value()},
                                              {"LISTED", listed},
                                              {"RAYS", raysTogether(sampling, shading)},
                                              {"FINE", sampling.maxError && *sampling.maxError < coarseBound},
                                              {"TABLE_SIZE", GpuScene::tableSize}});
  rays.setUniforms(program);
  bindVolume(gpu, program);
  bindFocus(gpu, program);
  unsigned image = firstFreeImage, unit = 0;
  bindImage(program, "occupiedSkip", image++, gpu.occupiedSkip());
  bindImage(program, "transferTables", image++, gpu.transferTables());
  program.set("transferMap", gpu.transferMap());
  program.set("firstMaterial", gpu.firstMaterial());
  program.set("lastMaterial", gpu.lastMaterial());
  program.set("visibleEntries", gpu.visibleEntries());
  program.set("leastTransmittance", static_cast<float>(leastTransmittance(sampling)));
  if (sampling.maxError) program.set("maxError", static_cast<float>(shareOfBound * *sampling.maxError));
  if (opening) {
    bindImage(program, "rayStart", 1, opening->rayStart);
    bindTexture(program, "hitPoints", unit++, opening->hitPoints);
    const glm::dvec3 spacing = gpu.grid().spacing;
    program.set("wallDepth",
                static_cast<float>(lighting::wallDepthVoxels * std::min({spacing.x, spacing.y, spacing.z})));
    program.set("wallShare", static_cast<float>(lighting::wallShare));
  }
  program.set("focusProperties",
              glm::vec4(glm::vec3(gpu.focusColour()), static_cast<float>(scene.look.focusAppearance.extinction)));
  if (palette) {
    bindTexture(program, "focusPaletteIndex", unit++, gpu.focusPaletteIndex());
    bindTexture(program, "focusPalette", unit++, gpu.focusPalette());
    program.set("focusOrigin", gpu.focusOrigin());
  }
  setLight(program, rays.axes(), scene.look.shading);
  if (shading) {
    bindImage(program, "gradientTexels", image++, gpu.gradient());
    program.set("gradientOrigin", gpu.gradientOrigin());
    program.set("certainLength", static_cast<float>(lighting::certainLength));
    program.set("meanIncidence", static_cast<float>(lighting::meanIncidence));
    if (gpu.focusSmooth()) {
      bindTexture(program, "focusSmooth", unit++, gpu.focusSmooth());
      if (sampling.maxError) bindImage(program, "focusSmoothTexels", image++, gpu.focusSmooth());
      // A texel spans half a voxel around its centre, and the cell frame is index + 1.
      program.set("focusSmoothOrigin", glm::vec3(gpu.focusSmoothOrigin()) + 0.5f);
      program.set("worldFromIndexGradient", glm::mat3(glm::transpose(glm::dmat3(gpu.grid().indexFromWorld()))));
    }
  }
  program.set("pitch", sampling.pitch);
  return program;
}

void FocusLayerPass::run(const GpuScene& gpu, const Scene& scene, const RayFrame& rays,
                         const std::optional<Opening>& opening, const Sampling& sampling,
                         std::span<const gl::Region> regions, gl::Texture& focusLayer) {
  const bool lit = scene.look.shading.enabled;
  const int together = raysTogether(sampling, lit);
  gl::ShaderProgram& lattice = prepared(false, gpu, scene, rays, opening, sampling);
  focusLayer.bindImage(0, gl::Access::Write);
  lattice.dispatch(inBoxes(regions, sampling.pitch * glm::ivec2(1, together)));
  if (sampling.pitch == 1) {
    list_ = {};
    return;
  }
  const std::size_t needed = bytesOfList(inBoxes(regions, glm::ivec2(2)));
  if (list_.bytes() < needed) list_ = gl::Buffer::zeroed(needed);
  list_.bind(listBlock);
  gl::ShaderProgram& rest = prepared(true, gpu, scene, rays, opening, sampling);
  for (int halfSide = sampling.pitch / 2; halfSide > 0; halfSide /= 2)
    for (const bool centres : {true, false}) {
      list_.write(emptyList);
      gl::ShaderProgram& between = between_.get({{"CENTRES", centres}, {"RAYS", together}});
      between.set("pictureSize", rays.size());
      between.set("halfSide", halfSide);
      between.set("tolerance", static_cast<float>(toleranceOf(sampling, lit, halfSide)));
      focusLayer.bindImage(0, gl::Access::ReadWrite);
      between.dispatch(inBoxes(regions, glm::ivec2(2 * halfSide)));
      focusLayer.bindImage(0, gl::Access::Write);
      rest.dispatchIndirect(list_);
    }
}

}  // namespace fenestra
