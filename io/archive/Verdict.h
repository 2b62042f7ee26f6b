#pragma once
// What a server says of one object that it was asked to keep (PS3.4 J.3.3).

#include <cstdint>
#include <string>

namespace fenestra::io::archive {

struct Commitment {
  enum class Verdict : std::uint8_t { Kept, NotKept, Unsaid };
  Verdict verdict = Verdict::Unsaid;
  std::string text;  ///< why it is not kept, as a clause
};

}  // namespace fenestra::io::archive
