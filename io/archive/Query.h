#pragma once
// Questions to an archive: does it answer, and what does it hold (C-ECHO, C-FIND: PS3.4 annexes A and C).

#include <chrono>

#include "io/archive/Records.h"
#include "io/archive/Server.h"
#include "io/base/Reading.h"

namespace fenestra::io::archive {

/// How long the server took to answer. Throws the Error that says in one sentence what is wrong; Cancelled.
std::chrono::milliseconds echo(const Server& server, const Progress& progress = {});

/// Answers in the server's order. Where keys do not name the study (and series), those that match are found first.
/// Throws Error, Cancelled.
Answers find(const Server& server, const Query& query, const Progress& progress = {});

}  // namespace fenestra::io::archive
