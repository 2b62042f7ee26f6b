#pragma once
// The names of session files: readers of folders skip them, because sessions often lie beside the data that they show.

#include <filesystem>

namespace fenestra::io {

inline constexpr const char* sessionEnding = ".fenestra";

/// By the ending of its name, in lower or upper case.
bool isSession(const std::filesystem::path& path);

}  // namespace fenestra::io
