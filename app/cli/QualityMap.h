#pragma once
// The quality of the candidate cameras over the sphere of directions, as a picture.

#include <filesystem>

#include "rendering/placement/Placer.h"

namespace fenestra::cli {

/// PNG, equirectangular: azimuth 0 (anterior) in the middle, the patient's left to the right, superior on top. From
/// dark (worst) to bright (best); grey where the focus is not seen. C1 is a filled mark, C2 an open one. Throws
/// io::Error.
void writeQualityMap(const std::filesystem::path& path, const placement::Measured& measured,
                     const placement::Options& options, const placement::Placement& placement);

}  // namespace fenestra::cli
