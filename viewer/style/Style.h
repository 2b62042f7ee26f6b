#pragma once
// The program's two themes: dark, in which the pictures are the brightest thing on screen, and light. Pictures look the
// same in both.

#include <cstdint>

#include <vector>

#include <QColor>
#include <QIcon>

class QApplication;

namespace fenestra::viewer {

enum class Theme : std::uint8_t { Dark, Light };

/// At the start, and again to change the theme of a running program.
void applyStyle(QApplication& application, Theme theme = Theme::Dark);
/// A colour of texts, what they stand on, and where that is.
struct TextColours {
  const char* where;
  QColor text, ground;
};
/// All that a theme has, but for what is switched off.
std::vector<TextColours> textColours(Theme theme);
/// An icon of resources/icons, by the name of its file without the ending, in the colour of the theme's text.
QIcon icon(const char* name);

}  // namespace fenestra::viewer
