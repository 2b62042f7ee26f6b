#include "rendering/gpu/SceneBinding.h"

#include <algorithm>

#include "rendering/scene/Fading.h"
#include "rendering/scene/Lighting.h"

namespace fenestra {
namespace {
/// Storage blocks, as lib/focus/Index.glsl, lib/Search.glsl and lib/TransferSegments.glsl number them.
enum Block : unsigned { focusCellsBlock = 0, gapsBlock = 1, segmentOfEntryBlock = 3 };

/// Whether a program reads the spline itself, and not samples of it.
bool readsSpline(const GpuScene& scene, bool bounded) { return bounded && scene.refinement() > 1; }

void bindTexels(const GpuScene& scene, gl::ShaderProgram& program) {
  program.bind("volumeTexels", scene.volume().texture);
  program.set(VolumeUniforms{scene.drawnGrid().dims});
}

void setTransfer(const GpuScene& scene, gl::ShaderProgram& program) {
  program.set(TransferUniforms{scene.firstMaterial(), scene.lastMaterial(), scene.transferMap(), scene.visibleEntries(),
                               scene.preIntegrationLevel()});
}
}  // namespace

void bindVolume(const GpuScene& scene, gl::ShaderProgram& program) {
  if (!readsSpline(scene, true)) return bindTexels(scene, program);
  program.bind("splineTexels", scene.splineCoefficients());
  program.set(VolumeUniforms{scene.drawnGrid().dims});
}

void bindFocus(const GpuScene& scene, gl::ShaderProgram& program, FocusUniforms uniforms) {
  if (scene.focusKind() == FocusIndex::Kind::None) return;
  program.bind("focusBricks", scene.focusBricks());
  scene.focusCells().bind(focusCellsBlock);
  if (scene.focusKind() == FocusIndex::Kind::Values) {
    const ValueRange coded = scene.volume().codedFromReal(scene.focusValues());
    uniforms.range = glm::vec2(coded.low, coded.high);
  }
  program.set(uniforms);
}

void bindFocusLook(const GpuScene& scene, gl::ShaderProgram& program, const Look& look, bool bounded) {
  program.bind("occupiedSkip", scene.occupiedSkip());
  FocusUniforms focus{.material = glm::vec4(scene.focusColour(), look.focusAppearance.extinction),
                      .paletteOrigin = scene.focusOrigin(),
                      .table = scene.focusTable()};
  if (scene.focusPaletteIndex()) {
    program.bind("focusPaletteIndex", scene.focusPaletteIndex());
    program.bind("focusPalette", scene.focusPalette());
  }
  if (look.shading.enabled && scene.focusSmooth()) {
    program.bind(bounded ? "focusSmoothTexels" : "focusSmooth", scene.focusSmooth());
    // A texel spans half a voxel around its centre, and the cell frame is index + 1.
    focus.smoothOrigin = glm::vec3(scene.focusSmoothOrigin()) + 0.5f;
    focus.worldFromIndexGradient = Std140Mat3(glm::mat3(glm::transpose(glm::dmat3(scene.grid().indexFromWorld()))));
  }
  bindFocus(scene, program, focus);
}

void bindLabelHits(const GpuScene& scene, const KeptLabels& labels, gl::ShaderProgram& program) {
  bindVolume(scene, program);
  program.bind("contextSkip", scene.contextSkip());
  scene.gaps().bind(gapsBlock);
  program.set("gapCount", scene.gapCount());
  if (!labels.any()) return;
  program.bind("focusBricks", labels.bricks);
  program.bind("focusSkip", labels.skip);
  labels.cells.bind(focusCellsBlock);
  program.set(FocusUniforms());
}

void bindLabels(const KeptLabels& labels, gl::ShaderProgram& program) {
  program.bind("focusBricks", labels.bricks);
  program.bind("occupiedSkip", labels.skip);
  labels.cells.bind(focusCellsBlock);
  program.set(FocusUniforms());
}

void bindFirstHit(const GpuScene& scene, gl::ShaderProgram& program, HitSurface surface) {
  if (surface == HitSurface::Samples)
    bindTexels(scene, program);
  else
    bindVolume(scene, program);
  bindFocus(scene, program);
  program.bind("contextSkip", scene.contextSkip());
  if (scene.focusKind() != FocusIndex::Kind::None) program.bind("focusSkip", scene.focusSkip());
  scene.gaps().bind(gapsBlock);
  program.set("gapCount", scene.gapCount());
}

void bindContextValues(const GpuScene& scene, gl::ShaderProgram& program) {
  bindTexels(scene, program);
  program.bind("contextSkip", scene.contextSkip());
  scene.gaps().bind(gapsBlock);
  program.set("gapCount", scene.gapCount());
  program.bind("transferSegments", scene.transferSegments());
  scene.segmentOfEntry().bind(segmentOfEntryBlock);
  setTransfer(scene, program);
}

void bindFaint(const GpuScene& scene, const FaintIndex& faint, gl::ShaderProgram& program) {
  if (!faint.any()) return;
  program.bind("faintIndex", faint.texture());
  program.set("faintOrigin", faint.origin());
  program.set("faintSize", faint.texture().size());
  program.set("lastVoxel", scene.grid().dims - 1);
}

void bindFaintOpacities(const GpuScene& scene, const FaintIndex& faint, gl::ShaderProgram& program) {
  if (faint.any()) program.bind("faintOpacities", scene.faintOpacities());
}

void bindTransfer(const GpuScene& scene, gl::ShaderProgram& program) {
  program.bind("transferTables", scene.transferTables());
  setTransfer(scene, program);
}

void bindIntegral(const GpuScene& scene, gl::ShaderProgram& program, bool bounded) {
  if (bounded) {
    bindVolume(scene, program);
    program.bind("transferSegments", scene.transferSegments());
    scene.segmentOfEntry().bind(segmentOfEntryBlock);
    setTransfer(scene, program);
    return;
  }
  bindTexels(scene, program);
  program.bind("preIntegration", scene.preIntegration());  // first: it may be made here, and with it its level
  bindTransfer(scene, program);
}

void bindDerivative(const GpuScene& scene, gl::ShaderProgram& program) {
  const DerivativeVolume& derivative = scene.derivative();
  program.bind("derivativeVolume", derivative.texture);
  const glm::dvec3 factor(derivative.factor);
  const glm::dmat3 derivativeFromWorld =
      glm::dmat3(glm::dvec3(1.0 / factor.x, 0.0, 0.0), glm::dvec3(0.0, 1.0 / factor.y, 0.0),
                 glm::dvec3(0.0, 0.0, 1.0 / factor.z)) *
      glm::dmat3(scene.grid().indexFromWorld());
  program.set(DerivativeUniforms{Std140Mat3(glm::mat3(glm::transpose(derivativeFromWorld))), glm::vec3(factor),
                                 static_cast<float>(derivative.texelScale)});
  // A surface this near to the box's entry is where the scan ends; this near to the focus it is the focus's own.
  const glm::dvec3 spacing = scene.grid().spacing;
  program.set("contextMargin", static_cast<float>(0.5 * std::min({spacing.x, spacing.y, spacing.z})));
}

void bindLight(const GpuScene& scene, gl::ShaderProgram& program, const Camera::Axes& axes, const Shading& shading,
               const IntegralKind& kind) {
  LightUniforms light = lightUniforms(axes, shading);
  light.gradientOrigin = scene.gradientOrigin();
  if (kind.occlusion) {
    const OccluderCells& cells = scene.occluders().cells();
    light.lastNode = cells.dims - 1;
    light.nodesPerVoxel = 1.0f / glm::vec3(cells.side);
    program.bind("occlusionNodes", *kind.occlusion);
  }
  program.set(light);
  if (readsSpline(scene, kind.bounded))
    program.bind("normalTexels", scene.normalCoefficients());
  else
    program.bind("gradientTexels", scene.gradient());
}

void bindFading(const GpuScene& scene, gl::ShaderProgram& program, const Camera& camera, double distance,
                const std::optional<MethodStages::Fading>& fading) {
  if (!fading) return;
  const double unit = scene.steepestSlope();
  const glm::mat3 slopeFromIndex(glm::transpose(glm::dmat3(scene.grid().indexFromWorld())) *
                                 (unit > 0.0 ? scene.volume().slope / unit : 0.0));
  const EyeRange range = eyeRangeOf(camera, scene.grid());
  // 1 - d at s = t - distance: 1 everywhere where the whole volume lies behind the eye.
  const double extent = range.farthest - range.nearest, perMillimetre = extent > 0.0 ? 1.0 / extent : 0.0;
  program.set("slopeFromIndexX", slopeFromIndex[0]);
  program.set("slopeFromIndexY", slopeFromIndex[1]);
  program.set("slopeFromIndexZ", slopeFromIndex[2]);
  program.set("fadingNearness", glm::vec2(-perMillimetre, 1.0 - (distance - range.nearest) * perMillimetre));
  program.set("fadingReach", static_cast<float>(fading->reach));
  program.set("fadingSharpness", static_cast<float>(fading->sharpness));
  // The steepest slope is half of a gate's unit (Lighting.h).
  program.set("gradientGate", 2.0f * glm::vec2(lighting::gradientGateLow, lighting::gradientGateHigh));
  if (const auto& ghost = fading->ghost) {
    program.set("ghostStrength", static_cast<float>(ghost->strength));
    program.set("ghostEdgeSquare", static_cast<float>(ghost->edge * ghost->edge));
    program.set("ghostOutline", static_cast<float>(ghost->outline));
  }
  if (!fading->region) return;
  program.set("focalSize", static_cast<float>(fading->region->size));
  program.set("focalPerFallOff", static_cast<float>(1.0 / fading->region->fallOff));
  if (fading->region->shape == FocalShape::Distance) {
    const SampledLattice& lattice = scene.focalDistances().lattice();
    scene.focalDistances().bind(focalDistancesBinding);
    program.set("focalStep", lattice.step);
    program.set("focalPoints", lattice.points);
    program.set("focalDims", scene.grid().dims);
    return;
  }
  const glm::dvec3 middle = scene.focus().centre(scene.grid()).value_or(scene.grid().centre());
  program.set("focalMiddle", glm::vec3(middle - (camera.eye + distance * camera.axes().forward)));
  program.set("focalIsBox", fading->region->shape == FocalShape::Box ? 1 : 0);
}

LightUniforms lightUniforms(const Camera::Axes& axes, const Shading& shading) {
  return {glm::vec3(lightDirection(axes, shading)),
          static_cast<float>(shading.ambient),
          static_cast<float>(shading.diffuse),
          static_cast<float>(shading.specular),
          static_cast<float>(shading.shininess),
          static_cast<float>(lighting::meanIncidence),
          glm::ivec3(0),
          static_cast<float>(lighting::certainLength)};
}

}  // namespace fenestra
