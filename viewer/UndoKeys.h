#pragma once
// Lets Ctrl+Z and Ctrl+Shift+Z reach the window's history while a number box has the keyboard focus: the box would take
// them for its text, which is a value of the history as soon as it is entered.

#include <QObject>

namespace fenestra::viewer {

class UndoKeys : public QObject {
  Q_OBJECT
 public:
  /// Filters the events of the whole application.
  explicit UndoKeys(QObject* parent);

  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace fenestra::viewer
