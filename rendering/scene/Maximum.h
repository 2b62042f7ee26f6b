#pragma once
// Whether pictures show the context by the greatest of its values (rendering/passes/MaximumPass.h).

#include <optional>

#include "rendering/vocabulary/MethodStages.h"

namespace fenestra {

struct Look;

/// How a look's pictures show the greatest value of the context; empty where they do not, or the cutaway is off.
std::optional<MethodStages::Maximum> maximumOf(const Look& look);

}  // namespace fenestra
