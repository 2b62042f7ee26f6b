#pragma once
// Whether a grid can be that of a scanned object. Damaged headers hold any number, and what follows computes with them.

#include <filesystem>
#include <optional>
#include <string>

#include "rendering/volume/Grid.h"

namespace fenestra::io {

/// What is wrong with a grid's geometry, in one clause; empty when it is plausible: finite, with three independent
/// axes, voxels from 1 nm to 1 m, no side over 100 m and nothing further than 1 km from the origin of the world.
std::optional<std::string> implausibility(const Grid& grid);
/// Whether unit vectors span the space, as far as the single precision in headers can tell.
bool areIndependent(const glm::dmat3& axes);
/// Throws Error naming `path` when the geometry is not plausible.
void checkGeometry(const std::filesystem::path& path, const Grid& grid);

}  // namespace fenestra::io
