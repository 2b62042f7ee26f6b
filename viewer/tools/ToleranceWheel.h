#pragma once
// Alt+wheel over a picture changes the tolerance of the region in focus. Notches in quick succession are one step of
// the history.

#include <QTimer>

#include "viewer/tools/Tool.h"

namespace fenestra::viewer {

class Document;

class ToleranceWheel : public Tool {
 public:
  /// `document` outlives this.
  explicit ToleranceWheel(Document& document);

  bool wheel(const QWheelEvent& event) override;

 private:
  Document& document_;
  QTimer pause_;        ///< runs out when the turning has ended
  double angle_ = 0.0;  ///< turned by, less whole steps; eighths of a degree
};

}  // namespace fenestra::viewer
