#pragma once
// --crop, --clip-plane and what else clips pictures (rendering/settings/Clipping.h).

#include "app/options/Options.h"
#include "io/study/StudyRequest.h"
#include "rendering/settings/Clipping.h"

namespace fenestra::app {

/// Adds --crop, --clip-plane, --clip-exempt and --clip-grey. What needs no data goes into `clipping` while parsing.
void addClipping(Command command, io::ClipChanges& changes, Clipping& clipping);

}  // namespace fenestra::app
