#include "rendering/gpu/SceneBinding.h"

#include "rendering/scene/Lighting.h"

namespace fenestra {
namespace {
/// Image units; a pass writes its own images at those before them.
enum Unit : unsigned { volumeUnit = 2, focusBricksUnit };
enum Block : unsigned { focusCellsBlock = 0, gapsBlock = 1 };
}  // namespace

void bindTexture(gl::ShaderProgram& program, const char* name, unsigned unit, const gl::Texture& texture) {
  texture.bind(unit);
  program.set(name, static_cast<int>(unit));
}

void bindImage(gl::ShaderProgram& program, const char* name, unsigned unit, const gl::Texture& texture) {
  texture.bindImage(unit, gl::Access::Read);
  program.set(name, static_cast<int>(unit));
}

void bindVolume(const GpuScene& scene, gl::ShaderProgram& program) {
  bindImage(program, "volumeTexels", volumeUnit, scene.volume().texture);
  program.set("texelScale", scene.volume().texelScale);
}

void bindFocus(const GpuScene& scene, gl::ShaderProgram& program) {
  if (scene.focusKind() == FocusIndex::Kind::None) return;
  bindImage(program, "focusBricks", focusBricksUnit, scene.focusBricks());
  scene.focusCells().bind(focusCellsBlock);
  if (scene.focusKind() != FocusIndex::Kind::Values) return;
  const ValueRange coded = scene.volume().codedFromReal(scene.focusValues());
  program.set("focusLow", static_cast<float>(coded.low));
  program.set("focusHigh", static_cast<float>(coded.high));
}

void bindFirstHit(const GpuScene& scene, gl::ShaderProgram& program) {
  bindImage(program, "contextSkip", firstFreeImage, scene.contextSkip());
  if (scene.focusKind() != FocusIndex::Kind::None)
    bindImage(program, "focusSkip", firstFreeImage + 1, scene.focusSkip());
  scene.gaps().bind(gapsBlock);
  program.set("gapCount", scene.gapCount());
}

gl::Define volumeDefine(const GpuScene& scene) {
  return {"VOLUME_BYTES", static_cast<int>(gl::bytesPerTexel(scene.volume().texture.format()))};
}

gl::Define focusDefine(const GpuScene& scene) { return {"FOCUS_KIND", static_cast<int>(scene.focusKind())}; }

void setLight(gl::ShaderProgram& program, const Camera::Axes& axes, const Shading& shading) {
  program.set("lightDirection", glm::vec3(lightDirection(axes, shading)));
  program.set("lighting", glm::vec4(shading.ambient, shading.diffuse, shading.specular, shading.shininess));
}

}  // namespace fenestra
