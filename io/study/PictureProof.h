#pragma once
// A certificate (rendering/reference/Certificate.h) together with what it is about, as the text of a PNG.

#include "io/ImageWriter.h"
#include "io/session/Session.h"
#include "rendering/reference/Certificate.h"

namespace fenestra::io {

/// One JSON object, ASCII. `session`: of the picture, with its data's contents (noteContents). Its paths, which may
/// name a patient, do not enter, not even the hash of the scene.
PngText proofOf(const reference::Certificate& certificate, Session session);

}  // namespace fenestra::io
