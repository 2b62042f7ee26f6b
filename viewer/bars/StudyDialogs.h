#pragma once
// Dialogs that say something of the open study. They close when another study opens, as all else does that is about
// the one before.

#include <QDialog>
#include <QList>

namespace fenestra::viewer {

inline constexpr const char* studyDialogKey = "studyDialog";

inline void markAsStudyDialog(QDialog& dialog) { dialog.setProperty(studyDialogKey, true); }

inline void closeStudyDialogs(const QWidget& window) {
  for (QDialog* dialog : window.findChildren<QDialog*>())
    if (dialog->property(studyDialogKey).toBool()) dialog->reject();
}

}  // namespace fenestra::viewer
