#pragma once
// An OpenGL driver that fails: epoxy calls OpenGL through pointers, and these classes replace one of them while they
// live.

#include <utility>

#include <epoxy/gl.h>

#include "rendering/gl/Texture.h"

namespace fenestra::viewer {

/// Refuses every shader that it is given, and says nothing about why.
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

/// Has no memory left when a pixel is read.
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
