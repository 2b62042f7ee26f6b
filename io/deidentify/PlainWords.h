#pragma once
// Texts that keep only words which cannot name a person (PS3.15 E.3.5 and E.3.3).

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace fenestra::io::deidentify {

/// Words that name the patient or other people of an object, in small letters.
using Names = std::set<std::string, std::less<>>;

/// The words of `text` that the list of harmless ones (resources/deidentify/words.txt) holds, and numbers of up to
/// three digits before the point, with or without a unit; between single blanks. A word that is one of `names` goes,
/// although the list holds it: people are called Hand and Head.
std::string plainWords(std::string_view text, const Names& names);
/// ASCII letters and digits in a row, in small letters; other bytes part words, but those beyond ASCII belong to them.
std::vector<std::string> wordsIn(std::string_view text);

}  // namespace fenestra::io::deidentify
