#pragma once
// Phantoms from their descriptions in resources/phantoms.

#include <string>
#include <string_view>
#include <vector>

#include "io/Error.h"
#include "rendering/scene/Phantom.h"

namespace fenestra::io {

/// Names of the built-in phantoms: "torso", "head".
std::vector<std::string> phantomNames();
/// A built-in phantom. Throws Error naming the phantoms there are.
Phantom loadPhantom(const std::string& name);
/// Parses a description; `source` names it in errors. Throws Error.
Phantom parsePhantom(std::string_view json, const std::string& source);

}  // namespace fenestra::io
