#pragma once
// One calm, dark look: pictures are the brightest thing on screen.

#include <QIcon>

class QApplication;

namespace fenestra::viewer {

void applyStyle(QApplication& application);
/// One of resources/icons, by its file's name without the ending.
QIcon icon(const char* name);

}  // namespace fenestra::viewer
