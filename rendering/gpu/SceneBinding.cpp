#include "rendering/gpu/SceneBinding.h"

#include <algorithm>

#include "rendering/gpu/PreIntegration.h"
#include "rendering/scene/Fading.h"
#include "rendering/scene/Lighting.h"

namespace fenestra {
namespace {
/// Storage blocks, as lib/focus/Index.glsl and lib/FirstHit.glsl number them.
enum Block : unsigned { focusCellsBlock = 0, gapsBlock = 1, segmentOfEntryBlock = 3 };
}  // namespace

void bindVolume(const GpuScene& scene, gl::ShaderProgram& program) {
  program.bind("volumeTexels", scene.volume().texture);
  if (scene.refinement() > 1) program.bind("splineTexels", scene.splineCoefficients());
  program.set(VolumeUniforms{scene.drawnGrid().dims});
}

gl::Define volumeDefine(const GpuScene& scene) {
  return {"VOLUME_BYTES", static_cast<int>(gl::bytesPerTexel(scene.volume().texture.format()))};
}

gl::Define refinementDefine(const GpuScene& scene) { return {"REFINEMENT", scene.refinement()}; }

gl::Choice integralChoice(const GpuScene& scene, bool bounded) {
  if (!bounded) return {"integral", "lib/integral/FaceToFace.glsl"};
  return {"integral", scene.refinement() > 1 ? "lib/integral/SplineByCell.glsl" : "lib/integral/CellByCell.glsl"};
}

gl::Choice focusChoice(const GpuScene& scene) {
  switch (scene.focusKind()) {
    case FocusIndex::Kind::Labels:
      return {"focus", scene.focusIsSmoothed() ? "lib/focus/SmoothLabels.glsl" : "lib/focus/Labels.glsl"};
    case FocusIndex::Kind::Values:
      return {"focus", "lib/focus/Values.glsl"};
    case FocusIndex::Kind::None:
      break;
  }
  return {"focus", "lib/focus/None.glsl"};
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
  FocusUniforms focus{.material = glm::vec4(glm::vec3(scene.focusMaterial()),
                                            look.focusAppearance.extinction * scene.focusMaterial().a),
                      .paletteOrigin = scene.focusOrigin(),
                      .table = scene.focusTable()};
  if (scene.focusPaletteIndex()) {
    program.bind("focusPaletteIndex", scene.focusPaletteIndex());
    program.bind("focusPalette", scene.focusPalette());
    focus.material.a = static_cast<float>(look.focusAppearance.extinction);
  }
  if (look.shading.enabled && scene.focusSmooth()) {
    program.bind("focusSmooth", scene.focusSmooth());
    if (bounded) program.bind("focusSmoothTexels", scene.focusSmooth());
    // A texel spans half a voxel around its centre, and the cell frame is index + 1.
    focus.smoothOrigin = glm::vec3(scene.focusSmoothOrigin()) + 0.5f;
    focus.worldFromIndexGradient = Std140Mat3(glm::mat3(glm::transpose(glm::dmat3(scene.grid().indexFromWorld()))));
  }
  bindFocus(scene, program, focus);
}

std::vector<gl::Define> focusDefines(const GpuScene& scene, bool lit) {
  return {{"FOCUS_PALETTE", static_cast<bool>(scene.focusPaletteIndex())},
          {"FOCUS_FUNCTIONS", scene.focusByValue()},
          {"FOCUS_SMOOTH", lit && scene.focusSmooth()}};
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

gl::Choice importanceChoice(const KeptLabels& labels) {
  return {"focus", !labels.any()     ? "lib/focus/None.glsl"
                   : labels.smoothed ? "lib/focus/SmoothLabels.glsl"
                                     : "lib/focus/Labels.glsl"};
}

gl::Define levelsDefine(const GpuScene& scene) { return {"IMPORTANCE_LEVELS", !scene.importance().empty()}; }

void bindLabels(const KeptLabels& labels, gl::ShaderProgram& program) {
  program.bind("focusBricks", labels.bricks);
  program.bind("occupiedSkip", labels.skip);
  labels.cells.bind(focusCellsBlock);
  program.set(FocusUniforms());
}

void bindFirstHit(const GpuScene& scene, gl::ShaderProgram& program) {
  bindVolume(scene, program);
  bindFocus(scene, program);
  program.bind("contextSkip", scene.contextSkip());
  if (scene.focusKind() != FocusIndex::Kind::None) program.bind("focusSkip", scene.focusSkip());
  scene.gaps().bind(gapsBlock);
  program.set("gapCount", scene.gapCount());
}

void bindFaint(const GpuScene& scene, gl::ShaderProgram& program) {
  const FaintIndex& faint = scene.faint();
  if (!faint.any()) return;
  program.bind("faintIndex", faint.texture());
  program.set("faintOrigin", faint.origin());
  program.set("faintSize", faint.texture().size());
  program.set("lastVoxel", scene.grid().dims - 1);
}

gl::Define faintDefine(const GpuScene& scene) { return {"FAINT_LABELS", scene.faint().any()}; }

void bindTransfer(const GpuScene& scene, gl::ShaderProgram& program) {
  program.bind("transferTables", scene.transferTables());
  program.set(TransferUniforms{scene.firstMaterial(), scene.lastMaterial(), scene.transferMap(), scene.visibleEntries(),
                               scene.preIntegrationLevel()});
}

void bindPreIntegration(const GpuScene& scene, gl::ShaderProgram& program) {
  program.bind("preIntegration", scene.preIntegration());  // first: it may be made here, and with it its level
  bindTransfer(scene, program);
}

std::vector<gl::Define> preIntegrationDefines() {
  return {{"PRE_INTEGRATION_LEVELS", PreIntegration::levels},
          {"PRE_INTEGRATION_MANTISSA", PreIntegration::mantissaBits},
          {"PRE_INTEGRATION_SPACING", PreIntegration::spacing}};
}

void bindTransferSegments(const GpuScene& scene, gl::ShaderProgram& program) {
  bindTransfer(scene, program);
  program.bind("transferSegments", scene.transferSegments());
  scene.segmentOfEntry().bind(segmentOfEntryBlock);
}

gl::Define tableDefine() { return {"TABLE_SIZE", GpuScene::tableSize}; }
gl::Define segmentsDefine() { return {"SEGMENTS_PER_ROW", GpuScene::segmentsPerRow}; }

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

gl::Define derivativeDefine(const GpuScene& scene) {
  return {"DERIVATIVE_BYTES", static_cast<int>(gl::bytesPerTexel(scene.derivative().texture.format()))};
}

gl::Choice lightChoice(bool lit) { return {"light", lit ? "lib/light/Lit.glsl" : "lib/light/Unlit.glsl"}; }

void bindLight(const GpuScene& scene, gl::ShaderProgram& program, const Camera::Axes& axes, const Shading& shading,
               const gl::Texture* nodes) {
  LightUniforms light = lightUniforms(axes, shading);
  light.gradientOrigin = scene.gradientOrigin();
  if (nodes) {
    const OccluderCells& cells = scene.occluders().cells();
    light.lastNode = cells.dims - 1;
    light.nodesPerVoxel = 1.0f / glm::vec3(cells.side);
    program.bind("occlusionNodes", *nodes);
  }
  program.set(light);
  program.bind("gradientTexels", scene.gradient());
  if (scene.refinement() > 1) program.bind("normalTexels", scene.normalCoefficients());
}

gl::Define occlusionDefine(const gl::Texture* nodes) { return {"OCCLUDED", nodes != nullptr}; }

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

gl::Define fadingDefine(const std::optional<MethodStages::Fading>& fading) {
  if (!fading) return {"FADING", 0};
  if (fading->followsLight()) return {"FADING", 1};
  if (!fading->region) return {"FADING", 3};
  return {"FADING", fading->region->shape == FocalShape::Distance ? 4 : 2};
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
