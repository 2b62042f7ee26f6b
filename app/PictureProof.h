#pragma once
// A certificate (rendering/reference/Certificate.h) together with what it is about, as JSON for standard output and for
// the text of a PNG.

#include <nlohmann/json_fwd.hpp>

#include "io/session/Session.h"
#include "rendering/reference/Certificate.h"

namespace fenestra::app {

/// Keyword of the PNG's text.
inline constexpr const char* proofKeyword = "Fenestra certificate";

/// `session`: of the picture, with its data's contents (io::noteContents). Its paths, which may name a patient, do not
/// enter, not even the hash of the scene.
nlohmann::ordered_json proofJson(const reference::Certificate& certificate, io::Session session);

}  // namespace fenestra::app
