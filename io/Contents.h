#pragma once
// Whether files still hold what they held: a SHA-256 of all of their bytes, so nothing that changes is missed. At about
// 2 GB/s on a processor with instructions for it (0.5 GB/s without) it is a small part of reading a volume.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/VolumeReader.h"

namespace fenestra::io {

/// What a file held, or a set of files whatever their names.
struct Contents {
  std::string hash;  ///< "sha256:HEX"; empty: not known
  std::uint64_t bytes = 0, files = 0;
  bool operator==(const Contents&) const = default;
};

/// Of one file, `hash` is what sha256sum prints; of several, the SHA-256 of their sorted hashes in hexadecimal, a line
/// each. Reads on all cores. Throws Error, Cancelled.
Contents contentsOf(const std::vector<std::filesystem::path>& files, const Progress& progress = {});

/// "sha256:HEX" of a text.
std::string hashOf(std::string_view text);

}  // namespace fenestra::io
