#pragma once
// What the mouse does in a view, as one of ViewTools. Events come in device-independent pixels of the view.

#include <optional>

#include <QPainter>
#include <QPointF>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace fenestra::viewer {

/// Device-independent pixels that a click may move between press and release.
inline constexpr double clickSlack = 4.0;

class Tool {
 public:
  virtual ~Tool() = default;

  /// The left button is pressed. True: the tool has the mouse until the button is let go.
  virtual bool press(const QMouseEvent&) { return false; }
  /// The mouse moves, and the tool has it.
  virtual void drag(const QMouseEvent&) {}
  /// The left button is let go, and the tool had the mouse.
  virtual void release(const QMouseEvent&) {}
  /// Asked before release(): the mouse has done nothing yet, so that the view has the press back as a click.
  virtual bool wasClick() const { return false; }
  /// The mouse moves, and the tool does not have it.
  virtual void hover(const QMouseEvent&) {}
  /// The mouse leaves the view.
  virtual void leave() {}
  /// True: the tool has handled the event.
  virtual bool wheel(const QWheelEvent&) { return false; }
  virtual bool key(const QKeyEvent&) { return false; }
  /// A stroke mode has changed, and with it perhaps what the tool would do at the mouse.
  virtual void refresh() {}

  /// The pointer's shape over a position; empty: the tool would do nothing there.
  virtual std::optional<Qt::CursorShape> pointer(QPointF) const { return std::nullopt; }
  /// Draws what belongs to the tool over the view's picture.
  virtual void draw(QPainter&, const QRectF& /*view*/) const {}
};

}  // namespace fenestra::viewer
