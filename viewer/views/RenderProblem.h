#pragma once
// Why a picture cannot be drawn, as the user reads it.

#include <exception>

#include <QString>

namespace fenestra::viewer {

/// A sentence or two: what failed and what would help. A driver's log of a shader is left out but for its first line.
QString describeRenderProblem(const std::exception& error);

}  // namespace fenestra::viewer
