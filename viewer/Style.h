#pragma once
// One calm, dark look: pictures are the brightest thing on screen.

class QApplication;

namespace fenestra::viewer {

void applyStyle(QApplication& application);

}  // namespace fenestra::viewer
