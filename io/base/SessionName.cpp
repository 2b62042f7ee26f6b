#include "io/base/SessionName.h"

#include "io/base/Text.h"

namespace fenestra::io {

bool isSession(const std::filesystem::path& path) { return lowered(path.extension().string()) == sessionEnding; }

}  // namespace fenestra::io
