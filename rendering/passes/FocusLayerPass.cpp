#include "rendering/passes/FocusLayerPass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "rendering/gpu/SceneBinding.h"
#include "rendering/scene/Fading.h"
#include "rendering/scene/Lighting.h"
#include "rendering/scene/Maximum.h"

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

/// Whether the integral reads all corners of each cell: for lit pictures of normal quality. Unlit ones would take
/// nearly twice as long; lit drafts would take a fifth longer, and at half the resolution leave 0.1 to 2 % less error.
/// Cells of a refined grid are small enough to be crossed from face to face. A picture within a bound has an integral
/// of its own.
bool readsWholeCells(const GpuScene& gpu, const FocusLayerPass::Sampling& sampling, bool lit) {
  return lit && isNormalQuality(sampling) && gpu.refinement() == 1;
}

/// The estimated error up to which a pixel is interpolated. Lit drafts vary in so many pixels that more is allowed.
/// Over larger squares the estimate is less certain, so less is allowed.
double toleranceOf(const FocusLayerPass::Sampling& sampling, bool lit, int halfSide) {
  return sampling.tolerance * (lit && !isNormalQuality(sampling) ? 1.5 : 1.0) / halfSide;
}

// shaders/lib/PixelList.glsl.
constexpr unsigned listBlock = 2;
constexpr std::array<std::uint32_t, 4> noBorders{16, 0, 1, 0};

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
  return sizeof noBorders + groups * 64 * 2 * sizeof(std::uint32_t);
}

/// Whether what the opening would remove is only ghosted.
bool isGhosted(const Look& look) {
  const std::optional<MethodStages::Fading> fading = fadingOf(look);
  return fading && fading->ghost;
}

}  // namespace

IntegralUniforms FocusLayerPass::integralUniforms(const GpuScene& gpu, const Sampling& sampling, bool lit) {
  const glm::dvec3 spacing = gpu.grid().spacing;
  return {static_cast<float>(leastTransmittance(sampling, lit)),
          static_cast<float>(shareOfBound * sampling.maxError.value_or(0.0)),
          static_cast<float>(lighting::wallDepthVoxels * std::min({spacing.x, spacing.y, spacing.z})),
          static_cast<float>(lighting::wallShare),
          static_cast<float>(1.0 / std::min({spacing.x, spacing.y, spacing.z}))};
}

IntegralKind FocusLayerPass::kindOf(const Drawn& drawn) {
  const GpuScene& gpu = drawn.gpu;
  const Sampling& sampling = drawn.sampling;
  IntegralKind kind{.lit = drawn.look.shading.enabled,
                    .bounded = sampling.maxError.has_value(),
                    .occlusion = drawn.occlusion,
                    .hasLevels = !gpu.importance().empty(),
                    .fading = fadingOf(drawn.look),
                    .roughSteps = sampling.roughSteps};
  kind.wholeCells = readsWholeCells(gpu, sampling, kind.lit);
  kind.bentNormals = bendsNormals(gpu, sampling, kind.lit);
  if (maximumOf(drawn.look)) kind.shown = IntegralKind::Shown::FocusAlone;
  // Where a view is exploded around its focus, a stretch shows that or a part of the context.
  if (drawn.stretch && drawn.focusHits)
    kind.shown =
        drawn.stretch->shown == Stretch::InFocus ? IntegralKind::Shown::FocusAlone : IntegralKind::Shown::ContextAlone;
  return kind;
}

gl::ShaderProgram& FocusLayerPass::program(bool listed, const Drawn& drawn) {
  const auto& [gpu, look, rays, opening, sampling, occlusion, stretch, focusHits, resumes] = drawn;
  const gl::Choice pixels{"pixels", listed              ? "lib/pixels/Listed.glsl"
                                    : sampling.quincunx ? "lib/pixels/Quincunx.glsl"
                                                        : "lib/pixels/Lattice.glsl"};
  const gl::Variant variant = gl::Variant{{{"RAYS", raysTogether(gpu.schedule(), sampling, look.shading.enabled)}},
                                          {scheduleChoice(gpu.schedule()), pixels}} +
                              integralVariant(gpu, kindOf(drawn)) + rays.variant();
  const gl::Choice unopened{"opening", rays.isClipped() ? "lib/opening/Capped.glsl" : "lib/opening/Closed.glsl"};
  if (stretch) {
    const gl::Choice choice{"stretch", focusHits ? "lib/stretch/AtHit.glsl" : "lib/stretch/Whole.glsl"};
    return exploded_.get(variant + gl::Variant{{}, {unopened, choice}});
  }
  if (!opening) return programs_.get(variant + gl::Variant{{}, {unopened}});
  const gl::Choice hole{"hole", opening->hole ? "lib/hole/Apart.glsl" : "lib/hole/None.glsl"};
  if (isGhosted(look)) return programs_.get(variant + gl::Variant{{}, {{"opening", "lib/opening/Ghosted.glsl"}, hole}});
  return (opening->hole ? apart_ : programs_)
      .get(variant + gl::Variant{{}, {{"opening", "lib/opening/Open.glsl"}, hole}});
}

gl::ShaderProgram& FocusLayerPass::prepared(bool listed, const Drawn& drawn) {
  const auto& [gpu, look, rays, opening, sampling, occlusion, stretch, focusHits, resumes] = drawn;
  gl::ShaderProgram& program = this->program(listed, drawn);
  rays.setUniforms(program);
  bindIntegral(gpu, program, sampling.maxError.has_value());
  bindFaint(gpu, gpu.faint(), program);
  bindFaintOpacities(gpu, gpu.faint(), program);
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
  if (look.shading.enabled) bindLight(gpu, program, rays.axes(), look.shading, kindOf(drawn));
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
  list_.write(std::as_bytes(std::span(noBorders)));
  list_.bind(listBlock);
  gl::ShaderVariants& programs = drawn.sampling.quincunx ? quincunxBetween_ : centres ? centresBetween_ : sidesBetween_;
  gl::ShaderProgram& between = programs.get({{{"RAYS", raysTogether(drawn.gpu.schedule(), drawn.sampling, lit)}}, {}});
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
                         const std::optional<RayStarts>& opening, const Sampling& sampling, Regions regions,
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
