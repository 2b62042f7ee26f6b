#pragma once
// OpenGL drivers that fail: epoxy calls OpenGL through function pointers, and each class replaces one of them for its
// lifetime.

#include <chrono>
#include <thread>
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

/// Takes a second and a half for each program that it links.
class SlowCompiler {
 public:
  SlowCompiler() : replaced_(std::exchange(epoxy_glLinkProgram, &answer)) {}
  ~SlowCompiler() { epoxy_glLinkProgram = replaced_; }
  SlowCompiler(const SlowCompiler&) = delete;
  SlowCompiler& operator=(const SlowCompiler&) = delete;

 private:
  static void answer(GLuint program) {
    static const auto real =
        reinterpret_cast<PFNGLLINKPROGRAMPROC>(QOpenGLContext::currentContext()->getProcAddress("glLinkProgram"));
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    real(program);
  }
  PFNGLLINKPROGRAMPROC replaced_;
};

/// Takes a quarter of a second for each 3-D texture that it makes room for.
class SlowDriver {
 public:
  SlowDriver() : replaced_(std::exchange(epoxy_glTextureStorage3D, &answer)) {}
  ~SlowDriver() { epoxy_glTextureStorage3D = replaced_; }
  SlowDriver(const SlowDriver&) = delete;
  SlowDriver& operator=(const SlowDriver&) = delete;

 private:
  static void answer(GLuint texture, GLsizei levels, GLenum format, GLsizei width, GLsizei height, GLsizei depth) {
    static const auto real = reinterpret_cast<PFNGLTEXTURESTORAGE3DPROC>(
        QOpenGLContext::currentContext()->getProcAddress("glTextureStorage3D"));
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
    real(texture, levels, format, width, height, depth);
  }
  PFNGLTEXTURESTORAGE3DPROC replaced_;
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
