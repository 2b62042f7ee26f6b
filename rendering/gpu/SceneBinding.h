#pragma once
// Binds what several passes read of a GpuScene; the units and names are those of shaders/lib.

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gpu/GpuScene.h"

namespace fenestra {

/// Image units below this one are a pass's own outputs' (0, 1) and bindVolume's and bindFocus's; what else a pass reads
/// as images starts here. OpenGL promises eight.
inline constexpr unsigned firstFreeImage = 4;

/// The volume; `program` was compiled with volumeDefine(scene).
void bindVolume(const GpuScene& scene, gl::ShaderProgram& program);
gl::Define volumeDefine(const GpuScene& scene);
/// The focus index; `program` was compiled with FOCUS_KIND = scene.focusKind().
void bindFocus(const GpuScene& scene, gl::ShaderProgram& program);
/// What rays that look for first hits skip and leave (shaders/lib/FirstHit.glsl); with bindVolume and bindFocus.
void bindFirstHit(const GpuScene& scene, gl::ShaderProgram& program);
gl::Define focusDefine(const GpuScene& scene);
/// A pass's own texture under `name` at `unit`.
void bindTexture(gl::ShaderProgram& program, const char* name, unsigned unit, const gl::Texture& texture);
/// The same for one that the shader reads texel by texel, at an image unit.
void bindImage(gl::ShaderProgram& program, const char* name, unsigned unit, const gl::Texture& texture);
/// Light as Lighting.h describes it, for a view with these axes.
void setLight(gl::ShaderProgram& program, const Camera::Axes& axes, const Shading& shading);

}  // namespace fenestra
