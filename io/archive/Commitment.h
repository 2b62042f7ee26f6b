#pragma once
// Whether a server keeps what it took (storage commitment push model, PS3.4 annex J). A server that accepts an object
// may still lose it before it is safe; one that commits to it takes over its safekeeping.

#include <map>
#include <string>
#include <vector>

#include "io/archive/Send.h"
#include "io/archive/Server.h"
#include "io/archive/Verdict.h"
#include "io/base/Reading.h"

namespace fenestra::io::archive {

/// Asks the server to commit to what it accepted of `sent`, and waits for its answer, at most Limits::commitment: over
/// our connection or, where Server::ownPort is set, one that the server opens to us. Only the server's AE title is let
/// in meanwhile, for this one transaction. The verdicts are by SOP Instance UID, one for each object accepted. Throws
/// Error where the server offers no such service, refuses it or gives no answer; Cancelled.
std::map<std::string, Commitment> commit(const Server& server, const std::vector<Sent>& sent,
                                         const Progress& progress = {});

}  // namespace fenestra::io::archive
