#pragma once
// Reads a study while OpenGL starts: both take some time, and neither waits for the other.

#include <optional>

#include "io/study/ReadStudy.h"
#include "rendering/egl/EglContext.h"

namespace fenestra::cli {

/// Reads on another thread, with progress on the terminal, and makes the context on this one. Throws what readStudy()
/// throws, or else EglError.
io::Study readBesideContext(const io::StudyRequest& request, std::optional<egl::EglContext>& context);

}  // namespace fenestra::cli
