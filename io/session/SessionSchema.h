#pragma once
// The published form of sessions, as a JSON Schema (2020-12).

#include <string>

namespace fenestra::io {

/// What resources/session/fenestra-session.schema.json holds: made from the same list of members that reading and
/// writing use.
std::string sessionSchema();

}  // namespace fenestra::io
