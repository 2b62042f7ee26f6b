#pragma once
// Binds what several passes read of a GpuScene; the units and names are those of shaders/lib.

#include "rendering/gl/ShaderProgram.h"
#include "rendering/passes/GpuScene.h"

namespace fenestra {

/// Texture units below this one are taken by bindVolume and bindFocus; a pass's own textures start here.
inline constexpr unsigned firstFreeUnit = 4;

void bindVolume(const GpuScene& scene, gl::ShaderProgram& program);
/// The focus index; `program` was compiled with FOCUS_KIND = scene.focusKind().
void bindFocus(const GpuScene& scene, gl::ShaderProgram& program);
gl::Define focusDefine(const GpuScene& scene);
/// A pass's own texture under `name` at `unit`.
void bindTexture(gl::ShaderProgram& program, const char* name, unsigned unit, const gl::Texture& texture);
/// Light from the upper left behind the viewer, fixed to the camera.
void setLight(gl::ShaderProgram& program, const Camera::Axes& axes, const Shading& shading);

}  // namespace fenestra
