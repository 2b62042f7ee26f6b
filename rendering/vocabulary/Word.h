#pragma once
// The words of an enumeration: that of each value in files and on the command line, and its name and meaning in the
// window. Each enumeration has a function wordsOf() in its own namespace, by which templates find them.

#include <array>

namespace fenestra {

/// One value of an enumeration.
template <class E>
struct Word {
  E value;
  const char* word;              ///< in files and on the command line
  const char* name = word;       ///< in the window
  const char* description = "";  ///< as in Declaration (Setting.h)
};

/// The entry of wordsOf() for a value.
template <class E>
constexpr Word<E> wordOf(E value) {
  for (const Word<E>& word : wordsOf(value))
    if (word.value == value) return word;
  return {value, ""};
}

}  // namespace fenestra
