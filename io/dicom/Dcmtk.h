#pragma once
// DCMTK set up once: codecs registered, its log silent. Include in .cpp files alone.

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace fenestra::io {

/// Call before any use of DCMTK; thread-safe.
void prepareDcmtk();

}  // namespace fenestra::io
