// Preloaded into a program, makes its OpenGL driver fail: epoxy calls OpenGL through pointers, and this replaces some.
// FENESTRA_FAILING_DRIVER=shaders refuses every shader; =memory has none for images.

#include <cstdlib>
#include <string_view>

#include <epoxy/gl.h>

namespace {

bool outOfMemory = false;

void refuse(GLuint, GLenum, GLint* value) { *value = GL_FALSE; }

void storeNothing2D(GLuint, GLsizei, GLenum, GLsizei, GLsizei) { outOfMemory = true; }

void storeNothing3D(GLuint, GLsizei, GLenum, GLsizei, GLsizei, GLsizei) { outOfMemory = true; }

GLenum error() {
  const GLenum now = outOfMemory ? GL_OUT_OF_MEMORY : GL_NO_ERROR;
  outOfMemory = false;
  return now;
}

[[gnu::constructor]] void replace() {
  const char* what = std::getenv("FENESTRA_FAILING_DRIVER");
  if (!what) return;
  if (what == std::string_view("shaders")) epoxy_glGetShaderiv = refuse;
  if (what != std::string_view("memory")) return;
  epoxy_glTextureStorage2D = storeNothing2D;
  epoxy_glTextureStorage3D = storeNothing3D;
  epoxy_glGetError = error;
}

}  // namespace
