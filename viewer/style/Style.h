#pragma once
// The programs' dark style, in which the pictures are the brightest thing on screen.

#include <QIcon>

class QApplication;

namespace fenestra::viewer {

void applyStyle(QApplication& application);
/// An icon of resources/icons, by the name of its file without the ending.
QIcon icon(const char* name);

}  // namespace fenestra::viewer
