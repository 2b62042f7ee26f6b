#include "rendering/passes/FocusLayerPass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <vector>

#include "rendering/gpu/SceneBinding.h"
#include "rendering/scene/Fading.h"
#include "rendering/scene/Lighting.h"

namespace fenestra {

namespace {

/// Early ray termination: a ray ends where its transmittance falls below this. Its colour is then wrong by half of it
/// at most. The rest of a lit ray that keeps no bound is taken to look like its last segment; it may be wrong by all of
/// it, but rarely is.
double leastTransmittance(const FocusLayerPass::Sampling& sampling, bool lit) {
  if (sampling.maxError) return *sampling.maxError / 4.0;
  constexpr double most = 0.5;  // below 1, so that a ray that has met nothing goes on, whatever the tolerance
  return std::min(sampling.tolerance * (lit ? 3.0 : 1.0), most);
}

/// The share of the bound that the estimated errors of a ray's cells may sum to. The rest covers the ray's termination
/// (an eighth), rounding, and estimates that are too low.
constexpr double shareOfBound = 0.7;

/// Rays that one invocation follows side by side. On the software rasteriser each step of a ray waits for memory, and
/// another ray has work to do meanwhile; lit rays need too many registers for two.
int raysTogether(Schedule schedule, const FocusLayerPass::Sampling& sampling, bool lit) {
  return schedule == Schedule::Plain || sampling.maxError || lit ? 1 : 2;
}

/// As opposed to draft quality.
bool isNormalQuality(const FocusLayerPass::Sampling& sampling) {
  return !sampling.maxError && sampling.tolerance <= FocusLayerPass::Sampling().tolerance;
}

/// Whether normals in the focus follow the volume's exactly (shaders/lib/integral/FaceToFace.glsl): of a focus of
/// values, which has none of its own.
bool bendsNormals(const GpuScene& gpu, const FocusLayerPass::Sampling& sampling, bool lit) {
  return lit && isNormalQuality(sampling) && gpu.focusKind() == FocusIndex::Kind::Values;
}

/// Whether the integral reads all corners of each cell: for lit pictures. Unlit ones would take nearly twice as long.
/// Cells of a refined grid are small enough to be crossed from face to face. A picture within a bound has an integral
/// of its own.
bool readsWholeCells(const GpuScene& gpu, const FocusLayerPass::Sampling& sampling, bool lit) {
  return lit && !sampling.maxError && gpu.refinement() == 1;
}

/// The estimated error up to which a pixel is interpolated. Lit drafts vary in so many pixels that more is allowed.
/// Over larger squares the estimate is less certain, so less is allowed.
double toleranceOf(const FocusLayerPass::Sampling& sampling, bool lit, int halfSide) {
  return sampling.tolerance * (lit && !isNormalQuality(sampling) ? 1.5 : 1.0) / halfSide;
}

// shaders/lib/PixelList.glsl.
constexpr unsigned listBlock = 2;
constexpr std::array<std::uint32_t, 4> emptyList{16, 0, 1, 0};

/// The regions in units of boxes of `sides` pixels, counted from the picture's top left; a box counts when any of its
/// pixels does.
std::vector<gl::Region> inBoxes(std::span<const gl::Region> regions, glm::ivec2 sides) {
  std::vector<gl::Region> boxes;
  for (const gl::Region& region : regions) {
    const glm::ivec2 first = region.origin / sides, end = (region.origin + region.size + sides - 1) / sides;
    boxes.push_back({first, end - first});
  }
  return boxes;
}

/// Bytes of a list with room for two pixels of each 2×2 square, in whole groups of 8×8 squares.
std::size_t bytesOfList(std::span<const gl::Region> squares) {
  std::size_t groups = 0;
  for (const gl::Region& region : squares)
    groups += std::size_t(region.size.x + 7) / 8 * (std::size_t(region.size.y + 7) / 8);
  return sizeof emptyList + groups * 64 * 2 * sizeof(std::uint32_t);
}

/// Whether what the opening would remove is only ghosted.
bool isGhosted(const Look& look) {
  const std::optional<MethodStages::Fading> fading = fadingOf(look);
  return fading && fading->ghost;
}

}  // namespace

namespace {

/// What shaders/lib/integral/CellPath.glsl calls SHOWN.
int shownOf(const FocusLayerPass::ExplodedStretch* stretch, const gl::Texture* focusHits) {
  if (!stretch || !focusHits) return 0;
  return stretch->shown == FocusLayerPass::Stretch::InFocus ? 2 : 1;
}

}  // namespace

IntegralUniforms FocusLayerPass::integralUniforms(const GpuScene& gpu, const Sampling& sampling, bool lit) {
  const glm::dvec3 spacing = gpu.grid().spacing;
  return {static_cast<float>(leastTransmittance(sampling, lit)),
          static_cast<float>(shareOfBound * sampling.maxError.value_or(0.0)),
          static_cast<float>(lighting::wallDepthVoxels * std::min({spacing.x, spacing.y, spacing.z})),
          static_cast<float>(lighting::wallShare)};
}

gl::Choice FocusLayerPass::openingChoice(const Drawn& drawn) {
  if (!drawn.opening)
    return {"opening", drawn.rays.isClipped() ? "lib/opening/Capped.glsl" : "lib/opening/Closed.glsl"};
  return {"opening", isGhosted(drawn.look) ? "lib/opening/Ghosted.glsl" : "lib/opening/Open.glsl"};
}

gl::ShaderProgram& FocusLayerPass::program(bool listed, const Drawn& drawn) {
  const auto& [gpu, look, rays, opening, sampling, occlusion, stretch, focusHits, resumes] = drawn;
  const bool lit = look.shading.enabled, bounded = sampling.maxError.has_value();
  gl::Variant variant{{volumeDefine(gpu),
                       refinementDefine(gpu),
                       {"SAMPLED", !bounded},
                       {"ROUGH_STEPS", sampling.roughSteps},
                       tableDefine(),
                       segmentsDefine(),
                       faintDefine(gpu),
                       levelsDefine(gpu),
                       {"BENT_NORMALS", bendsNormals(gpu, sampling, lit)},
                       {"WHOLE_CELLS", readsWholeCells(gpu, sampling, lit)},
                       occlusionDefine(occlusion),
                       fadingDefine(fadingOf(look)),
                       {"EXPLODED", !stretch    ? 0
                                    : focusHits ? 2
                                                : 1},
                       {"SHOWN", shownOf(stretch, focusHits)},
                       {"LISTED", listed},
                       {"QUINCUNX", sampling.quincunx && !listed},
                       {"APART", opening && opening->hole},
                       rays.clipDefine(),
                       rays.scatterDefine(),
                       {"RAYS", raysTogether(gpu.schedule(), sampling, lit)}},
                      {scheduleChoice(gpu.schedule()), focusChoice(gpu), lightChoice(lit), openingChoice(drawn),
                       integralChoice(gpu, bounded)}};
  std::ranges::copy(focusDefines(gpu, lit), std::back_inserter(variant.defines));
  if (!bounded) std::ranges::copy(preIntegrationDefines(), std::back_inserter(variant.defines));
  return programs_.get(variant);
}

gl::ShaderProgram& FocusLayerPass::prepared(bool listed, const Drawn& drawn) {
  const auto& [gpu, look, rays, opening, sampling, occlusion, stretch, focusHits, resumes] = drawn;
  gl::ShaderProgram& program = this->program(listed, drawn);
  rays.setUniforms(program);
  bindVolume(gpu, program);
  if (sampling.maxError)
    bindTransferSegments(gpu, program);
  else
    bindPreIntegration(gpu, program);
  bindFaint(gpu, program);
  program.set(integralUniforms(gpu, sampling, look.shading.enabled));
  if (opening) {
    if (opening->hole) program.bind("hole", *opening->hole);
    program.bind("rayStart", opening->rayStart);
    program.bind("hitPoints", opening->hitPoints);
    if (opening->pixelStarts && !isGhosted(drawn.look)) program.bind("pixelStarts", *opening->pixelStarts);
  }
  if (stretch) {
    program.set("resumes", resumes ? 1 : 0);
    if (focusHits) {
      program.bind("hitPoints", *focusHits);
      program.set("fromHit", stretch->shown == Stretch::Before ? 0 : 1);
      program.set("fromPicture", static_cast<float>(stretch->fromPicture));
    }
  }
  if (look.shading.enabled) bindLight(gpu, program, rays.axes(), look.shading, occlusion);
  bindFading(gpu, program, rays.camera(), rays.distance(), fadingOf(look));
  bindFocusLook(gpu, program, look, sampling.maxError.has_value());
  return program;
}

void FocusLayerPass::drawBetween(const Layers& layers, int halfSide, bool centres, Regions squares,
                                 gl::Texture& focusLayer) {
  const Drawn& drawn = layers.front();
  const bool lit = drawn.look.shading.enabled;
  const std::size_t needed = bytesOfList(squares);
  if (list_.bytes() < needed) list_ = gl::Buffer::zeroed(needed);
  list_.write(std::as_bytes(std::span(emptyList)));
  list_.bind(listBlock);
  gl::ShaderProgram& between = between_.get({{{"CENTRES", centres},
                                              {"QUINCUNX", drawn.sampling.quincunx},
                                              {"RAYS", raysTogether(drawn.gpu.schedule(), drawn.sampling, lit)}},
                                             {}});
  between.set("pictureSize", drawn.rays.size());
  if (!drawn.sampling.quincunx) between.set("halfSide", halfSide);
  between.set("tolerance", static_cast<float>(toleranceOf(drawn.sampling, lit, halfSide)));
  between.bind("focusLayer", focusLayer, gl::Access::ReadWrite);
  between.dispatch(squares);
  for (const Drawn& each : layers) {
    gl::ShaderProgram& rest = prepared(true, each);
    rest.bind("focusLayer", focusLayer, each.stretch ? gl::Access::ReadWrite : gl::Access::Write);
    rest.dispatchIndirect(list_);
  }
}

void FocusLayerPass::run(Steps& steps, const GpuScene& gpu, const Look& look, const RayFrame& rays,
                         const std::optional<Opening>& opening, const Sampling& sampling, Regions regions,
                         gl::Texture& focusLayer, const gl::Texture* occlusion) {
  add(steps, {Drawn{gpu, look, rays, opening, sampling, occlusion}}, regions, focusLayer);
}

void FocusLayerPass::runExploded(Steps& steps, const GpuScene& gpu, const Look& look,
                                 const std::vector<ExplodedStretch>& stretches, const gl::Texture* focusHits,
                                 const Sampling& sampling, Regions regions, gl::Texture& focusLayer) {
  Layers layers;
  for (const ExplodedStretch& stretch : stretches)
    layers.push_back(Drawn{gpu, look, stretch.rays, {}, sampling, nullptr, &stretch, focusHits, !layers.empty()});
  add(steps, layers, regions, focusLayer);
}

void FocusLayerPass::add(Steps& steps, const Layers& layers, Regions regions, gl::Texture& focusLayer) {
  const Drawn& first = layers.front();
  const Sampling& sampling = first.sampling;
  const int together = raysTogether(first.gpu.schedule(), sampling, first.look.shading.enabled);
  const glm::ivec2 apart(sampling.pitch, sampling.quincunx ? 1 : sampling.pitch);
  steps.add(inBoxes(regions, apart * glm::ivec2(1, together)), [this, layers, &focusLayer](Regions tile) {
    for (const Drawn& drawn : layers) {
      gl::ShaderProgram& lattice = prepared(false, drawn);
      if (!drawn.sampling.quincunx) lattice.set("pitch", drawn.sampling.pitch);
      lattice.bind("focusLayer", focusLayer, drawn.stretch ? gl::Access::ReadWrite : gl::Access::Write);
      lattice.dispatch(tile);
    }
  });
  if (sampling.pitch == 1) list_ = {};
  for (int halfSide = sampling.pitch / 2; halfSide > 0; halfSide /= 2)
    for (const bool centres : {true, false}) {
      if (centres && sampling.quincunx) continue;  // they have their rays
      steps.add(inBoxes(regions, glm::ivec2(2 * halfSide)),
                [this, layers, halfSide, centres, &focusLayer](Regions tile) {
                  drawBetween(layers, halfSide, centres, tile, focusLayer);
                });
    }
}

}  // namespace fenestra
