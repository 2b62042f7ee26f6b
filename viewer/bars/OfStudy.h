#pragma once
// Dialogs that say something of the open study. They close when another study opens, as all else does that is about
// the one before.

#include <QDialog>
#include <QList>

namespace fenestra::viewer {

inline constexpr const char* ofStudyKey = "ofStudy";

inline void markOfStudy(QDialog& dialog) { dialog.setProperty(ofStudyKey, true); }

inline void closeThoseOfStudy(const QWidget& window) {
  for (QDialog* dialog : window.findChildren<QDialog*>())
    if (dialog->property(ofStudyKey).toBool()) dialog->reject();
}

}  // namespace fenestra::viewer
