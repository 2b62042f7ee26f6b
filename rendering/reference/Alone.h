#pragma once
// What a layer shows alone.

#include <cstdint>

namespace fenestra::reference {

/// What the stretches of rays in an exploded view show: the context without the focus, or the focus alone.
enum class Alone : std::uint8_t { OutsideFocus, InFocus };

}  // namespace fenestra::reference
