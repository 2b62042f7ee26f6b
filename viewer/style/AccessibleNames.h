#pragma once
// What screen readers and other assistive programs are told of the window's controls: names of those that have no text
// of their own, and the role of the views and plots that the program draws itself.

#include <QString>

class QWidget;

namespace fenestra::viewer {

/// From here on, every control of the application that shows without a name gets controlName(), and what the keyboard
/// can reach among the program's own drawings counts as a graphic. Names that are set by hand stay. Once is enough.
void nameControls();

/// The label of its row in a form, with the tool tip's first line where it is not the row's first control; else that
/// line; else the text of an empty field; else the title of its panel. Without mnemonics.
QString controlName(const QWidget& control);

}  // namespace fenestra::viewer
