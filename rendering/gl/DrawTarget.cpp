#include "rendering/gl/DrawTarget.h"

#include <epoxy/gl.h>

#include "rendering/gl/Texture.h"

namespace fenestra::gl {

DrawTarget::DrawTarget(std::uint32_t framebuffer, glm::ivec4 rectangle)
    : blend_(glIsEnabled(GL_BLEND)),
      depth_(glIsEnabled(GL_DEPTH_TEST)),
      scissor_(glIsEnabled(GL_SCISSOR_TEST)),
      cull_(glIsEnabled(GL_CULL_FACE)) {
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer_);
  glGetIntegerv(GL_CURRENT_PROGRAM, &program_);
  glGetIntegerv(GL_VIEWPORT, viewport_.data());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  glViewport(rectangle.x, rectangle.y, rectangle.z, rectangle.w);
  for (const GLenum capability : {GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_CULL_FACE}) glDisable(capability);
}

DrawTarget::DrawTarget(const Texture& texture) : DrawTarget(0, {0, 0, texture.size().x, texture.size().y}) {
  glCreateFramebuffers(1, &own_);
  glNamedFramebufferTexture(own_, GL_COLOR_ATTACHMENT0, texture.name(), 0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, own_);
}

DrawTarget::~DrawTarget() {
  const auto restore = [](GLenum capability, bool on) { on ? glEnable(capability) : glDisable(capability); };
  restore(GL_BLEND, blend_);
  restore(GL_DEPTH_TEST, depth_);
  restore(GL_SCISSOR_TEST, scissor_);
  restore(GL_CULL_FACE, cull_);
  glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  glUseProgram(static_cast<GLuint>(program_));
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(framebuffer_));
  glDeleteFramebuffers(1, &own_);
}

}  // namespace fenestra::gl
