#include "rendering/passes/ContextLinesPass.h"

#include <array>

#include "rendering/gpu/SceneBinding.h"
#include "rendering/scene/ContextLines.h"

namespace fenestra {
namespace {

constexpr unsigned countsBinding = 0;  // of ContextLines.comp
using Counts = std::array<std::uint32_t, 1 + lines::bins>;

}  // namespace

ContextLayerUniforms uniformsOf(const ContextLayer& layer, const DerivativeVolume& derivative, double leastStrength) {
  return {glm::vec3(layer.colour),
          static_cast<float>(layer.strength),
          static_cast<float>(layer.curvatureWeight),
          static_cast<float>(layer.silhouetteWeight),
          static_cast<float>(layer.illuminationWeight),
          static_cast<float>(layer.valueWeight),
          static_cast<float>(derivative.spacing),
          static_cast<float>(layer.saturation),
          static_cast<float>(leastStrength)};
}

void ContextLinesPass::run(Steps& steps, const GpuScene& gpu, const ContextLayer& look, const gl::Texture& hitPoints,
                           const gl::Texture& contextLayer, const gl::Texture& silhouette, Regions regions) {
  steps.then([this] {
    if (!counts_) counts_ = gl::Buffer::zeroed(sizeof(Counts));
    const Counts none{};
    counts_.write(std::as_bytes(std::span(none)));
  });
  steps.add(regions, [this, &gpu, &look, &hitPoints, &contextLayer, &silhouette](Regions tile) {
    gl::ShaderProgram& program = programs_.get({{}, {scheduleChoice(gpu.schedule())}});
    program.bind("hitPoints", hitPoints);
    program.bind("contextLayer", contextLayer);
    program.bind("silhouette", silhouette);
    program.set("pictureSize", glm::ivec2(hitPoints.size()));
    program.set(uniformsOf(look, gpu.derivative(), lines::all));
    counts_.bind(countsBinding);
    program.dispatch(tile);
  });
  steps.then([this, share = look.share] {
    Counts counts;
    counts_.read(std::as_writable_bytes(std::span(counts)));
    leastStrength_ = lines::leastStrength(std::span(counts).subspan<1>(), counts[0], share);
  });
}

}  // namespace fenestra
