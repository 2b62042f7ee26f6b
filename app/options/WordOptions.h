#pragma once
// Options that take the words of an enumeration (rendering/vocabulary/Word.h).

#include <string>

#include "app/options/Options.h"
#include "rendering/vocabulary/Word.h"

namespace fenestra::app {

/// "first|second|…"
template <class E>
std::string formOf() {
  std::string form;
  for (const Word<E>& each : wordsOf(E{})) form.append(form.empty() ? "" : "|").append(each.word);
  return form;
}

/// False, and `target` unchanged, where `text` is none of the words. `Target` is E or optional.
template <class E, class Target>
bool takeWord(const std::string& text, Target& target) {
  for (const Word<E>& each : wordsOf(E{}))
    if (text == each.word) {
      target = each.value;
      return true;
    }
  return false;
}

/// An option that takes one of the words of E.
template <class E, class Target>
Option addWords(Command command, const std::string& name, const std::string& description, Target& target) {
  return command.add(name, formOf<E>(), description,
                     [&target](const std::string& text) { return takeWord<E>(text, target); });
}

}  // namespace fenestra::app
