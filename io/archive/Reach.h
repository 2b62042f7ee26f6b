#pragma once
// Whether a machine answers at a port, found out before DCMTK connects: DCMTK's own attempt can neither be cancelled
// nor says why it failed. Private to io/archive.

#include <string>

#include "io/archive/Server.h"
#include "io/archive/Task.h"

namespace fenestra::io::archive {

/// The name or address of the server's host for DCMTK, which tries the first address of a name alone: the one that
/// answers. Throws the Error of a host that is not known, does not answer or refuses; Cancelled.
std::string reach(const Server& server, Task& task);

}  // namespace fenestra::io::archive
