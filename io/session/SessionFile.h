#pragma once
// Sessions as JSON, `.fenestra`. The form is published in resources/session/fenestra-session.schema.json.
//
// A version is raised only when an older program would misread the file; then the older form is brought to the newer
// one on reading (migrations). Unknown members of a file are kept and written back. Paths are
// relative to the session's file and never absolute. They may lead out of its folder with "..", because data seldom lie
// below it; openSession uses data there only when their contents match the session's.

#include <filesystem>
#include <string>

#include "io/base/SessionName.h"
#include "io/session/Session.h"

namespace fenestra::io {

inline constexpr int sessionVersion = 4;

/// Does not open the data. Time and memory are bounded for any file. Throws Error.
Session readSession(const std::filesystem::path& file);

/// The text that writeSession writes. Throws Error for a path that is not UTF-8, std::invalid_argument for a number
/// that is not finite.
std::string textOf(const Session& session, const std::filesystem::path& file);
/// Writes a temporary file beside `file`, flushes it to the disk and renames it: a crash leaves the old file or the new
/// one. Writing a session that was read gives the same bytes. Throws Error.
void writeSession(const std::filesystem::path& file, const Session& session);

}  // namespace fenestra::io
