#pragma once
// A query below the level of studies, asked from the top: servers answer for the series of one study and the images of
// one series (PS3.4 C.4.1.2.2). Private to io/archive.

#include <functional>
#include <vector>

#include "io/archive/Records.h"

namespace fenestra::io::archive {

/// Answers at a level to keys of that level, with the UIDs of what is above.
using Ask = std::function<std::vector<Attributes>(Level level, const Attributes& keys)>;

/// The answers to a query, each with what was said above it. Where the keys name a study or series by nothing but its
/// UID, it is not asked for first.
std::vector<Attributes> descend(const Query& query, const Ask& ask);

}  // namespace fenestra::io::archive
