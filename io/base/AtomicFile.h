#pragma once
// Files written beside and renamed: the old file or the new one, never half of one.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <string>
#include <utility>

namespace fenestra::io {

/// Runs `write(temporary path)` and renames the result to `path`; removes the temporary when it throws. A device
/// or a pipe is written to as it is. Throws Error.
void writeAtomically(const std::filesystem::path& path, const std::function<void(const std::filesystem::path&)>& write);
/// `text` as the whole of a file.
void writeText(const std::filesystem::path& path, const std::string& text);

/// The pieces one after the other into a file; for use within writeAtomically. Throws Error.
void writeBytes(const std::filesystem::path& path, std::initializer_list<std::pair<const void*, std::size_t>> pieces);
/// Throws the Error of a file that cannot be written, with the system's words for the last failed call.
[[noreturn]] void failToWrite(const std::filesystem::path& path);

}  // namespace fenestra::io
