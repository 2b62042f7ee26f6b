#pragma once
// Labels as users name them.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "rendering/volume/LabelMap.h"

namespace fenestra::io {

/// Label values for `wanted` (values or names, case ignored) out of `labels`; sorted, unique. Throws Error with `file`
/// and the nearest names.
std::vector<std::uint16_t> resolveLabels(const LabelMap& labels, const std::vector<std::string>& wanted,
                                         const std::filesystem::path& file);

}  // namespace fenestra::io
