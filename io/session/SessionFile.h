#pragma once
// Sessions as JSON, `.fenestra`. The form is published in resources/session/fenestra-session.schema.json.
//
// A version is raised only when an older program would misread the file; then the older form is brought to the newer
// one on reading (migrations). What a file holds that this version does not know is kept and written back. Paths are
// relative to the session's file and never absolute. They may lead out of its folder with "..", because data seldom lie
// below it; openSession uses what lies there only where its contents are those that the session names.

#include <filesystem>
#include <string>

#include "io/SessionName.h"
#include "io/session/Session.h"

namespace fenestra::io {

inline constexpr int sessionVersion = 2;

/// Does not look at the data. What it takes is bounded, whatever the file. Throws Error.
Session readSession(const std::filesystem::path& file);

/// What writeSession writes. Throws Error for a path that is not UTF-8, std::invalid_argument for a number that is not
/// finite.
std::string textOf(const Session& session, const std::filesystem::path& file);
/// Written beside, brought to the disk and renamed: a crash leaves the old file or the new one. Saving what was read
/// gives the same bytes. Throws Error.
void writeSession(const std::filesystem::path& file, const Session& session);

}  // namespace fenestra::io
