#pragma once
// OpenGL drivers that fail: epoxy calls OpenGL through function pointers, and each class replaces one of them for its
// lifetime.

#include <utility>

#include <epoxy/gl.h>

#include "rendering/gl/Texture.h"

namespace fenestra::viewer {

/// Refuses every shader, with an empty log.
class RefusingDriver {
 public:
  RefusingDriver() : replaced_(std::exchange(epoxy_glGetShaderiv, &answer)) {}
  ~RefusingDriver() { epoxy_glGetShaderiv = replaced_; }
  RefusingDriver(const RefusingDriver&) = delete;
  RefusingDriver& operator=(const RefusingDriver&) = delete;

 private:
  static void answer(GLuint, GLenum, GLint* value) { *value = GL_FALSE; }
  PFNGLGETSHADERIVPROC replaced_;
};

/// Runs out of memory when a pixel is read.
class ForgetfulDriver {
 public:
  ForgetfulDriver() : replaced_(std::exchange(epoxy_glGetTextureSubImage, &fail)) {}
  ~ForgetfulDriver() { epoxy_glGetTextureSubImage = replaced_; }
  ForgetfulDriver(const ForgetfulDriver&) = delete;
  ForgetfulDriver& operator=(const ForgetfulDriver&) = delete;

 private:
  static void fail(GLuint, GLint, GLint, GLint, GLint, GLsizei, GLsizei, GLsizei, GLenum, GLenum, GLsizei, void*) {
    throw gl::AllocationError("no graphics memory for a pixel");
  }
  PFNGLGETTEXTURESUBIMAGEPROC replaced_;
};

}  // namespace fenestra::viewer
