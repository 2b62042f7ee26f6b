#include "io/SessionName.h"

#include "io/Text.h"

namespace fenestra::io {

bool isSession(const std::filesystem::path& path) { return lowered(path.extension().string()) == sessionEnding; }

}  // namespace fenestra::io
