#pragma once
// What a dialog shows of long work with many objects: how far it is, a sentence of how it ended, and the answer of each
// object; below, its button to start and one to close.

#include <QString>

class QDialog;
class QDialogButtonBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace fenestra::viewer {

class SentAnswers;

/// All belong to the dialog whose layout they are in.
struct OutcomeRows {
  QProgressBar* progress;  ///< 0 to 1000; hidden
  QLabel* status;
  SentAnswers* answers;
  QPushButton* start;
  QDialogButtonBox* buttons;
};

/// Adds them to the end of a column. `name` begins the object names of status and answers. *Close* rejects the dialog.
OutcomeRows addOutcomeRows(QVBoxLayout& column, QDialog& dialog, const QString& start, const QString& name);

}  // namespace fenestra::viewer
