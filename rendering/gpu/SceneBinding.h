#pragma once
// Binds what several passes read of a GpuScene; the names are those of shaders/lib.

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/gpu/Uniforms.h"

namespace fenestra {

/// lib/Volume.glsl; `program` was compiled with volumeDefine(scene).
void bindVolume(const GpuScene& scene, gl::ShaderProgram& program);
gl::Define volumeDefine(const GpuScene& scene);
/// Cells of the drawn grid along the side of a voxel, for lib/Grid.glsl.
gl::Define refinementDefine(const GpuScene& scene);

/// What `#include <integral>` stands for. `bounded`: a picture within a bound on its error.
gl::Choice integralChoice(const GpuScene& scene, bool bounded);

/// What `#include <focus>` stands for.
gl::Choice focusChoice(const GpuScene& scene);
/// The focus's index; nothing without a focus. `uniforms` holds what passes that show the focus read besides.
void bindFocus(const GpuScene& scene, gl::ShaderProgram& program, FocusUniforms uniforms = {});

/// How the focus looks, for passes that show it; with its index. `program` was compiled with focusDefines() and has the
/// integral of integralChoice(scene, bounded).
void bindFocusLook(const GpuScene& scene, gl::ShaderProgram& program, const Look& look, bool bounded);
std::vector<gl::Define> focusDefines(const GpuScene& scene, bool lit);

/// The index of labels that pictures keep, in place of a focus.
void bindLabels(const KeptLabels& labels, gl::ShaderProgram& program);
/// The same for rays that look for their first hits; labels without a voxel are none. With `program` of
/// importanceChoice().
void bindLabelHits(const GpuScene& scene, const KeptLabels& labels, gl::ShaderProgram& program);
gl::Choice importanceChoice(const KeptLabels& labels);
/// Whether labels of other levels of importance than the focus's are opened to (lib/integral/Settings.glsl).
gl::Define levelsDefine(const GpuScene& scene);

/// What rays that look for first hits skip and leave (lib/FirstHit.glsl), with volume and focus. Without bindFaint()
/// the context is the volume's function everywhere.
void bindFirstHit(const GpuScene& scene, gl::ShaderProgram& program);

/// lib/FaintLabels.glsl; `program` was compiled with faintDefine(scene).
void bindFaint(const GpuScene& scene, gl::ShaderProgram& program);
gl::Define faintDefine(const GpuScene& scene);

/// lib/Transfer.glsl; `program` was compiled with tableDefine().
void bindTransfer(const GpuScene& scene, gl::ShaderProgram& program);
/// The same with lib/TransferSegments.glsl; compiled with segmentsDefine() too.
void bindTransferSegments(const GpuScene& scene, gl::ShaderProgram& program);
gl::Define tableDefine();
gl::Define segmentsDefine();
/// The same with lib/PreIntegration.glsl; compiled with preIntegrationDefines() too.
void bindPreIntegration(const GpuScene& scene, gl::ShaderProgram& program);
std::vector<gl::Define> preIntegrationDefines();

/// lib/Curvature.glsl; `program` was compiled with derivativeDefine(scene) and refinementDefine(scene). The scene
/// readsContextSurface().
void bindDerivative(const GpuScene& scene, gl::ShaderProgram& program);
gl::Define derivativeDefine(const GpuScene& scene);

/// What `#include <light>` stands for.
gl::Choice lightChoice(bool lit);
/// lib/light/Lit.glsl, for a view with these axes, and of lib/light/Occlusion.glsl what OcclusionPass has written:
/// `nodes` is null in pictures without ambient occlusion and shadows, and `program` was compiled with
/// occlusionDefine(nodes).
void bindLight(const GpuScene& scene, gl::ShaderProgram& program, const Camera::Axes& axes, const Shading& shading,
               const gl::Texture* nodes);
gl::Define occlusionDefine(const gl::Texture* nodes);
/// That of lib/FocalDistance.glsl.
inline constexpr unsigned focalDistancesBinding = 5;
/// lib/Fading.glsl, and of a focal region lib/FocalRegion.glsl or lib/FocalDistance.glsl, or of a ghost
/// lib/Ghosting.glsl, where a context fades;
/// `program` was compiled with fadingDefine() of the same. `distance`: of RayFrame.
void bindFading(const GpuScene& scene, gl::ShaderProgram& program, const Camera& camera, double distance,
                const std::optional<MethodStages::Fading>& fading);
gl::Define fadingDefine(const std::optional<MethodStages::Fading>& fading);
/// Light as Lighting.h describes it, for a view with these axes.
LightUniforms lightUniforms(const Camera::Axes& axes, const Shading& shading);

}  // namespace fenestra
