#pragma once
// The view descriptors that placement is compared with, measured on the structures of PlacementSubjects.

#include <filesystem>
#include <string>

namespace fenestra::bench {

/// Writes descriptors.md: rank correlations, and the views that each descriptor would choose; for the structures whose
/// names hold `part`. Needs a current context; `gl` describes it. The page is written again after each structure.
void writeDescriptorsPage(const std::filesystem::path& folder, const std::string& part, const std::string& gl);

}  // namespace fenestra::bench
