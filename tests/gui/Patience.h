// How long tests of the window wait for a condition.
#pragma once

namespace fenestra::viewer {

/// ms; reached only when something hangs. Sanitizers on a busy machine are a hundred times slower than a release build.
constexpr int patience = 600000;

}  // namespace fenestra::viewer
