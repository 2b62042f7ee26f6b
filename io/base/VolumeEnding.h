#pragma once
// How files that hold a volume are named.

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "io/base/Text.h"

namespace fenestra::io {

/// Endings of the formats that hold a volume in one or two files, in lower case. Reading goes by content; endings serve
/// file dialogs, dropped files and messages.
inline constexpr std::array<std::string_view, 10> volumeEndings{".nii",  ".nii.gz", ".hdr", ".img", ".nrrd",
                                                                ".nhdr", ".mha",    ".mhd", ".mgh", ".mgz"};

/// The one of them that a file's name ends in, whatever the case; empty when there is none.
inline std::string_view volumeEnding(const std::filesystem::path& path) {
  const std::string name = lowered(path.filename().string());
  const auto at = std::find_if(volumeEndings.begin(), volumeEndings.end(),
                               [&](std::string_view ending) { return name.ends_with(ending); });
  return at == volumeEndings.end() ? std::string_view() : *at;
}

/// Whether a name is that of a TIFF file, whose pages may be slices or a whole stack.
inline bool isTiffName(const std::filesystem::path& path) {
  const std::string ending = lowered(path.extension().string());
  return ending == ".tif" || ending == ".tiff";
}

}  // namespace fenestra::io
