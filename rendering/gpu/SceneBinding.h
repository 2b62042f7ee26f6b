#pragma once
// Binds what several passes read of a GpuScene; the names are those of shaders/lib. Which files there a program has
// says SceneVariant.h.

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/gpu/SceneVariant.h"
#include "rendering/gpu/Uniforms.h"

namespace fenestra {

/// For programs of volumeVariant(scene).
void bindVolume(const GpuScene& scene, gl::ShaderProgram& program);

/// The focus's index; nothing without a focus. `uniforms` holds what passes that show the focus read besides.
void bindFocus(const GpuScene& scene, gl::ShaderProgram& program, FocusUniforms uniforms = {});

/// How the focus looks, for passes that show it; with its index. For programs of integralVariant() with the scene's
/// focus.
void bindFocusLook(const GpuScene& scene, gl::ShaderProgram& program, const Look& look, bool bounded);

/// The index of labels that pictures keep, in place of a focus.
void bindLabels(const KeptLabels& labels, gl::ShaderProgram& program);
/// The index of labels for rays that look for their first hits; labels without a voxel are none. For programs of
/// searchVariant(scene) and focusChoice(labels).
void bindLabelHits(const GpuScene& scene, const KeptLabels& labels, gl::ShaderProgram& program);

/// What rays that look for first hits skip and leave (lib/FirstHit.glsl), with volume and focus. Without bindFaint()
/// no label is translucent. `surface`: the program's.
void bindFirstHit(const GpuScene& scene, gl::ShaderProgram& program, HitSurface surface = HitSurface::Exact);

/// What rays that look for the context skip and leave (lib/Search.glsl), with the volume's texels and the function's
/// segments (lib/TransferSegments.glsl). For programs of sampledVariant(scene).
void bindContextValues(const GpuScene& scene, gl::ShaderProgram& program);

/// For programs of translucentChoice(faint).
void bindFaint(const GpuScene& scene, const FaintIndex& faint, gl::ShaderProgram& program);
/// For those of them that show the labels.
void bindFaintOpacities(const GpuScene& scene, const FaintIndex& faint, gl::ShaderProgram& program);

/// lib/Transfer.glsl and lib/TransferTables.glsl.
void bindTransfer(const GpuScene& scene, gl::ShaderProgram& program);
/// Volume and transfer function, for programs of integralVariant(scene).
void bindIntegral(const GpuScene& scene, gl::ShaderProgram& program, bool bounded);

/// lib/Curvature.glsl, for programs of derivativeChoice(scene) and gridVariant(scene). The scene readsContextSurface().
void bindDerivative(const GpuScene& scene, gl::ShaderProgram& program);

/// Light for a view with these axes, for programs of integralVariant(scene) that are lit.
void bindLight(const GpuScene& scene, gl::ShaderProgram& program, const Camera::Axes& axes, const Shading& shading,
               const IntegralKind& kind);
/// Storage block of lib/fading/FocalDistance.glsl.
inline constexpr unsigned focalDistancesBinding = 5;
/// For programs of fadingChoice(fading). `distance`: of RayFrame.
void bindFading(const GpuScene& scene, gl::ShaderProgram& program, const Camera& camera, double distance,
                const std::optional<MethodStages::Fading>& fading);
/// Light as Lighting.h describes it, for a view with these axes.
LightUniforms lightUniforms(const Camera::Axes& axes, const Shading& shading);

}  // namespace fenestra
