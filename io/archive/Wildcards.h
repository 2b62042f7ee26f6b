#pragma once
// Whether a text matches a key with wildcards (PS3.4 C.2.2.2.4), for servers that do not read all keys. Private to
// io/archive.

#include <string>
#include <string_view>

namespace fenestra::io::archive {

/// `*` stands for any text and `?` for one character of UTF-8; ASCII letters match in either case. A person's name
/// matches as a whole or by one of its groups, which "=" parts.
bool matches(std::string_view pattern, std::string_view text);

}  // namespace fenestra::io::archive
