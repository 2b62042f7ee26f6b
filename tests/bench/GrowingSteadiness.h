#pragma once
// How regions change with the voxel that was clicked, in noise and in thick slices.

#include <filesystem>
#include <string>

namespace fenestra::bench {

/// Writes growing-steadiness.md to `folder`: of the structures in Hounsfield units whose names hold `part`, with
/// `seeds` seeds each, a fifth of that in large volumes.
void writeSteadiness(const std::filesystem::path& folder, const std::string& part, int seeds);

}  // namespace fenestra::bench
