#pragma once
// OpenGL drivers that fail: epoxy calls OpenGL through function pointers, and each class replaces one of them for its
// lifetime.

#include <utility>

#include <epoxy/gl.h>

#include <QOpenGLContext>

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

/// Holds 3-D textures of 32 texels a side.
class SmallDriver {
 public:
  SmallDriver() : replaced_(std::exchange(epoxy_glGetIntegerv, &answer)) {}
  ~SmallDriver() { epoxy_glGetIntegerv = replaced_; }
  SmallDriver(const SmallDriver&) = delete;
  SmallDriver& operator=(const SmallDriver&) = delete;

 private:
  static void answer(GLenum name, GLint* value) {
    // The real function, not the pointer that was replaced: before its first call that is epoxy's resolver, which would
    // come back here.
    static const auto real =
        reinterpret_cast<PFNGLGETINTEGERVPROC>(QOpenGLContext::currentContext()->getProcAddress("glGetIntegerv"));
    if (name == GL_MAX_3D_TEXTURE_SIZE)
      *value = 32;
    else
      real(name, value);
  }
  PFNGLGETINTEGERVPROC replaced_;
};

}  // namespace fenestra::viewer
