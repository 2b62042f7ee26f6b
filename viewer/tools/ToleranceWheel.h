#pragma once
// Alt+wheel over a picture changes the tolerance of the region in focus. Notches in quick succession are one step of
// the history.

#include <QObject>
#include <QTimer>

class QWheelEvent;

namespace fenestra::viewer {

class Document;

class ToleranceWheel : public QObject {
  Q_OBJECT
 public:
  explicit ToleranceWheel(Document& document, QObject* parent = nullptr);

  /// True: the event was for the tolerance.
  bool wheel(const QWheelEvent& event);

 private:
  Document& document_;
  QTimer pause_;        ///< runs out when the turning has ended
  double angle_ = 0.0;  ///< that is not yet a whole step, in eighths of a degree
};

}  // namespace fenestra::viewer
