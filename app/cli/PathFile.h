#pragma once
// Paths as files: {"points": [[l, p, s], …]}, mm.

#include <filesystem>
#include <vector>

#include <glm/glm.hpp>

namespace fenestra::cli {

/// The points of the file, at least two that differ. Throws io::Error.
std::vector<glm::dvec3> readPath(const std::filesystem::path& file);

}  // namespace fenestra::cli
