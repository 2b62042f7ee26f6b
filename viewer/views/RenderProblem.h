#pragma once
// Why a picture cannot be drawn, as the user reads it.

#include <exception>

#include <QString>

namespace fenestra::viewer {

/// One line: what failed and what would help. It names a shader that the driver refuses, without the driver's log.
QString describeRenderProblem(const std::exception& error);

}  // namespace fenestra::viewer
