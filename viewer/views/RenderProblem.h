#pragma once
// Why a picture cannot be drawn, as the user reads it.

#include <exception>

#include <QString>

namespace fenestra::viewer {

/// One line: what failed and what would help. Of a shader that the driver refuses only the name is given, not the log.
QString describeRenderProblem(const std::exception& error);

}  // namespace fenestra::viewer
