#pragma once
// What readers say of data, in the language of the window. Readers know no Qt and say it in English.

#include <span>

#include <QString>

namespace fenestra::viewer {

/// The texts that are translated, with places (%1, %2 …) where readers put a number, a name, or another of these texts.
std::span<const char* const> readerTexts();

/// A text of a reader: the translation of the first of readerTexts() that it is of, with what stands in its places
/// translated in turn and numbers written as the language writes them. Any other text as it is.
QString readerText(const QString& text);

}  // namespace fenestra::viewer
