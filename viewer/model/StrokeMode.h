#pragma once
// A way to draw strokes in the views: while it is active, the left button draws them in place of what it usually does.
// At most one is active in a window, see ActiveTool.

#include <QObject>

namespace fenestra::viewer {

class StrokeMode : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  bool isActive() const { return active_; }
  /// Has no effect while the mode cannot be used.
  void setActive(bool on);

 Q_SIGNALS:
  /// It is active or no longer so, or its settings are others.
  void changed();
  void activeChanged(bool active);

 private:
  /// Whether the mode can be used on what is open.
  virtual bool canBeUsed() const { return true; }

  bool active_ = false;
};

}  // namespace fenestra::viewer
