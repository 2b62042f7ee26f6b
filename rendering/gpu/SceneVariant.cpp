#include "rendering/gpu/SceneVariant.h"

#include "rendering/gpu/PreIntegration.h"

namespace fenestra {
namespace {

gl::Choice voxelsChoice(const GpuScene& scene) {
  switch (gl::bytesPerTexel(scene.volume().texture.format())) {
    case 1:
      return {"voxels", "lib/voxels/Uint8.glsl"};
    case 2:
      return {"voxels", "lib/voxels/Uint16.glsl"};
    default:
      return {"voxels", "lib/voxels/Float32.glsl"};
  }
}

gl::Variant focusVariant(const GpuScene& scene, const IntegralKind& kind) {
  switch (kind.held) {
    case IntegralKind::Held::OfScene:
      break;
    case IntegralKind::Held::KeptLabels:
      return {{{"FOCUS_FUNCTIONS", 0}},
              {{"focus", "lib/focus/Labels.glsl"},
               {"colours", "lib/colours/One.glsl"},
               {"focusNormals", "lib/focusNormals/None.glsl"}}};
    case IntegralKind::Held::None:
      return {{{"FOCUS_FUNCTIONS", 0}},
              {noFocusChoice(), {"colours", "lib/colours/None.glsl"}, {"focusNormals", "lib/focusNormals/None.glsl"}}};
  }
  const bool ownNormals = kind.lit && scene.focusSmooth();
  return {{{"FOCUS_FUNCTIONS", scene.focusByValue()}},
          {focusChoice(scene),
           {"colours", scene.focusKind() == FocusIndex::Kind::None ? "lib/colours/None.glsl"
                       : scene.focusPaletteIndex()                 ? "lib/colours/Palette.glsl"
                                                                   : "lib/colours/One.glsl"},
           {"focusNormals", !ownNormals    ? "lib/focusNormals/None.glsl"
                            : kind.bounded ? "lib/focusNormals/SmoothedAlong.glsl"
                                           : "lib/focusNormals/Smoothed.glsl"}}};
}

gl::Variant lightVariant(const GpuScene& scene, const IntegralKind& kind) {
  if (!kind.lit)
    return {{},
            {{"light", "lib/light/Unlit.glsl"},
             {"normals", "lib/normals/None.glsl"},
             {"occlusion", "lib/occlusion/None.glsl"}}};
  const bool ofSpline = kind.bounded && scene.refinement() > 1;
  return {{},
          {{"light", "lib/light/Lit.glsl"},
           {"normals", ofSpline ? "lib/normals/Spline.glsl" : "lib/normals/Gradient.glsl"},
           {"occlusion", kind.occlusion ? "lib/occlusion/Nodes.glsl" : "lib/occlusion/None.glsl"}}};
}

gl::Choice fadingChoice(const std::optional<MethodStages::Fading>& fading) {
  if (!fading) return {"fading", "lib/fading/None.glsl"};
  if (fading->followsLight()) return {"fading", "lib/fading/ContextPreserving.glsl"};
  if (!fading->region) return {"fading", "lib/fading/Ghost.glsl"};
  return {"fading", fading->region->shape == FocalShape::Distance ? "lib/fading/FocalDistance.glsl"
                                                                  : "lib/fading/FocalRegion.glsl"};
}

gl::Choice shownChoice(IntegralKind::Shown shown) {
  switch (shown) {
    case IntegralKind::Shown::ContextAlone:
      return {"shown", "lib/shown/Context.glsl"};
    case IntegralKind::Shown::FocusAlone:
      return {"shown", "lib/shown/Focus.glsl"};
    case IntegralKind::Shown::All:
      break;
  }
  return {"shown", "lib/shown/All.glsl"};
}

gl::Variant boundedVariant(const GpuScene& scene, const IntegralKind& kind) {
  const gl::Choice integral{"integral",
                            scene.refinement() > 1 ? "lib/integral/SplineByCell.glsl" : "lib/integral/CellByCell.glsl"};
  return volumeVariant(scene) +
         gl::Variant{{{"SEGMENTS_PER_ROW", GpuScene::segmentsPerRow}, {"ROUGH_STEPS", kind.roughSteps}},
                     {integral, shownChoice(kind.shown), fadingChoice(kind.fading)}};
}

gl::Variant faceToFaceVariant(const GpuScene& scene, const IntegralKind& kind) {
  return sampledVariant(scene) +
         gl::Variant{{{"PRE_INTEGRATION_LEVELS", PreIntegration::levels},
                      {"PRE_INTEGRATION_MANTISSA", PreIntegration::mantissaBits},
                      {"PRE_INTEGRATION_SPACING", PreIntegration::spacing},
                      {"BENT_NORMALS", kind.bentNormals}},
                     {{"integral", "lib/integral/FaceToFace.glsl"},
                      {"segment", kind.wholeCells ? "lib/segment/Cells.glsl" : "lib/segment/Faces.glsl"}}};
}

}  // namespace

gl::Variant gridVariant(const GpuScene& scene) {
  if (scene.refinement() > 1) return {{{"REFINEMENT", scene.refinement()}}, {{"grid", "lib/grid/Refined.glsl"}}};
  return {{}, {{"grid", "lib/grid/Voxels.glsl"}}};
}

gl::Variant sampledVariant(const GpuScene& scene) {
  return gridVariant(scene) + gl::Variant{{}, {{"volume", "lib/volume/Trilinear.glsl"}, voxelsChoice(scene)}};
}

gl::Variant volumeVariant(const GpuScene& scene) {
  if (scene.refinement() == 1) return sampledVariant(scene);
  return gridVariant(scene) + gl::Variant{{}, {{"volume", "lib/volume/Spline.glsl"}}};
}

gl::Variant searchVariant(const GpuScene& scene, HitSurface surface) {
  if (surface == HitSurface::Samples) return sampledVariant(scene) + gl::Variant{{}, {{"look", "lib/look/Cell.glsl"}}};
  return volumeVariant(scene) +
         gl::Variant{{}, {{"look", scene.refinement() > 1 ? "lib/look/SplineCell.glsl" : "lib/look/Cell.glsl"}}};
}

gl::Choice derivativeChoice(const GpuScene& scene) {
  const bool isShort = gl::bytesPerTexel(scene.derivative().texture.format()) == 2;
  return {"derivative", isShort ? "lib/derivative/Uint16.glsl" : "lib/derivative/Float32.glsl"};
}

gl::Choice translucentChoice(const FaintIndex& faint) {
  return faint.any() ? gl::Choice{"translucent", "lib/translucent/Labels.glsl"} : opaqueChoice();
}

gl::Choice opaqueChoice() { return {"translucent", "lib/translucent/None.glsl"}; }

gl::Choice focusChoice(const GpuScene& scene) {
  switch (scene.focusKind()) {
    case FocusIndex::Kind::Labels:
      return {"focus", scene.focusIsSmoothed() ? "lib/focus/SmoothLabels.glsl" : "lib/focus/Labels.glsl"};
    case FocusIndex::Kind::Values:
      return {"focus", "lib/focus/Values.glsl"};
    case FocusIndex::Kind::None:
      break;
  }
  return noFocusChoice();
}

gl::Choice focusChoice(const KeptLabels& labels) {
  if (!labels.any()) return noFocusChoice();
  return {"focus", labels.smoothed ? "lib/focus/SmoothLabels.glsl" : "lib/focus/Labels.glsl"};
}

gl::Choice noFocusChoice() { return {"focus", "lib/focus/None.glsl"}; }

gl::Variant integralVariant(const GpuScene& scene, const IntegralKind& kind) {
  const gl::Choice importance{"importance", kind.hasLevels ? "lib/importance/Levels.glsl" : "lib/importance/One.glsl"};
  const FaintIndex& faint = kind.faint ? *kind.faint : scene.faint();
  const bool bodies = faint.any() || (kind.held == IntegralKind::Held::OfScene && scene.focusIsTranslucent());
  return gl::Variant{{tableDefine(), {"BODIES", bodies}}, {translucentChoice(faint), importance}} +
         focusVariant(scene, kind) + lightVariant(scene, kind) +
         (kind.bounded ? boundedVariant(scene, kind) : faceToFaceVariant(scene, kind));
}

gl::Define tableDefine() { return {"TABLE_SIZE", GpuScene::tableSize}; }

}  // namespace fenestra
