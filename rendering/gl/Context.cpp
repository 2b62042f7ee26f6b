#include "rendering/gl/Context.h"

#include <unistd.h>
#include <algorithm>
#include <array>
#include <utility>

#include <epoxy/gl.h>

namespace fenestra::gl {
namespace {
thread_local std::string firstError;  // the first since takeError()
}

TimerQuery::TimerQuery() {
  glCreateQueries(GL_TIMESTAMP, 2, names_.data());
  glQueryCounter(names_[0], GL_TIMESTAMP);
}

TimerQuery::~TimerQuery() { glDeleteQueries(2, names_.data()); }

double TimerQuery::elapsedMilliseconds() {
  glQueryCounter(names_[1], GL_TIMESTAMP);
  GLuint64 begin = 0, end = 0;
  glGetQueryObjectui64v(names_[0], GL_QUERY_RESULT, &begin);
  glGetQueryObjectui64v(names_[1], GL_QUERY_RESULT, &end);
  return static_cast<double>(end - begin) * 1e-6;
}

void finish() { glFinish(); }

void noteErrors() {
  for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError()) {
    if (!firstError.empty()) continue;
    switch (error) {
      case GL_INVALID_ENUM:
        firstError = "GL_INVALID_ENUM";
        break;
      case GL_INVALID_VALUE:
        firstError = "GL_INVALID_VALUE";
        break;
      case GL_INVALID_OPERATION:
        firstError = "GL_INVALID_OPERATION";
        break;
      case GL_INVALID_FRAMEBUFFER_OPERATION:
        firstError = "GL_INVALID_FRAMEBUFFER_OPERATION";
        break;
      case GL_OUT_OF_MEMORY:
        firstError = "GL_OUT_OF_MEMORY";
        break;
      default:
        firstError = "GL error " + std::to_string(error);
    }
  }
}

std::string takeError() {
  noteErrors();
  return std::exchange(firstError, {});
}

std::string description() {
  const auto text = [](GLenum what) {
    const auto* s = reinterpret_cast<const char*>(glGetString(what));
    return std::string(s ? s : "unknown");
  };
  return text(GL_RENDERER) + ", " + text(GL_VERSION);
}

bool isSoftwareRasteriser() {
  const std::string name = description();
  return std::ranges::any_of(std::array{"llvmpipe", "softpipe", "swrast", "SWR", "SwiftShader"},
                             [&](const char* part) { return name.find(part) != std::string::npos; });
}

std::string unsupportedReason() {
  const int version = epoxy_gl_version();
  if (!epoxy_is_desktop_gl() || version < 45)
    return "3-D needs OpenGL 4.5, this machine offers " + description() +
           "; update the graphics driver, or install Mesa's software driver";
  return {};
}

std::optional<std::size_t> freeTextureMemory() {
  constexpr std::size_t kibibyte = 1024;
  std::array<GLint, 4> kibibytes{};
  if (epoxy_has_gl_extension("GL_NVX_gpu_memory_info"))
    glGetIntegerv(GL_GPU_MEMORY_INFO_CURRENT_AVAILABLE_VIDMEM_NVX, kibibytes.data());
  else if (epoxy_has_gl_extension("GL_ATI_meminfo"))
    glGetIntegerv(GL_TEXTURE_FREE_MEMORY_ATI, kibibytes.data());
  // Software drivers may report the machine's memory there, of which they take no more than half here.
  if (isSoftwareRasteriser())
    return static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) / 2;
  if (kibibytes[0] <= 0) return std::nullopt;
  return static_cast<std::size_t>(kibibytes[0]) * kibibyte;
}

int maxTextureSize3D() {
  GLint size = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &size);
  return size;
}

}  // namespace fenestra::gl
