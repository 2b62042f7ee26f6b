#pragma once
// Questions to archives and their answers, as plain texts.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "rendering/vocabulary/Word.h"

namespace fenestra::io::archive {

/// What an answer is about, from the whole to its parts.
enum class Level : std::uint8_t { Patient, Study, Series, Image };

constexpr auto wordsOf(Level) {
  return std::to_array<Word<Level>>(
      {{Level::Patient, "patient"}, {Level::Study, "study"}, {Level::Series, "series"}, {Level::Image, "image"}});
}

/// Attributes by their keywords (PS3.6), such as "PatientName", as UTF-8; several values stand between backslashes.
using Attributes = std::map<std::string, std::string>;

/// What to find. A key's value is matched as PS3.4 C.2.2.2 says: `*` stands for any text and `?` for any character,
/// "20200101-20201231" for a range of dates or times, and UIDs between backslashes for any of them.
struct Query {
  Level level = Level::Study;
  Attributes keys;
};

struct Answers {
  std::vector<Attributes> records;  ///< what the level and those above it say, without empty values
  bool complete = true;             ///< false: there are more than Limits::answers
  bool ignoresKeys = false;         ///< the server says that it does not match by some of the keys
};

/// What is wrong with a key and its value; empty: nothing.
std::string problemOf(const std::string& keyword, const std::string& value);

/// The UID, ID or text of a record; empty when it has none.
std::string valueOf(const Attributes& record, const std::string& keyword);

}  // namespace fenestra::io::archive
