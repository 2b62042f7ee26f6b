#pragma once
// An OpenGL 4.5 core context without a window or a display.

#include <memory>
#include <stdexcept>
#include <string>

namespace fenestra::egl {

/// OpenGL cannot start here; what() says why and what would help.
class EglError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Current on the thread that makes it, until it is destroyed. Tries each EGL device of a graphics card, then Mesa's
/// surfaceless platform, then the default display.
class EglContext {
 public:
  EglContext();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  /// GL_RENDERER and GL_VERSION, e.g. "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6".
  std::string description() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fenestra::egl
