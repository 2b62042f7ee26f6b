#pragma once
// The tools of one view in a fixed order. The first that takes a press has the mouse until the left button is let go;
// earlier tools are drawn over later ones.

#include <vector>

#include <QPainter>
#include <QPointF>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace fenestra::viewer {

class Tool;

class ViewTools {
 public:
  /// They outlive this.
  explicit ViewTools(std::vector<Tool*> tools);

  /// Pass an event on. True: a tool has handled it, and the view must ignore it.
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  bool key(const QKeyEvent& event);
  void leave();
  void refresh();
  /// The tool that has the mouse loses it, and what it was about to do is not done.
  void abandon();

  /// A tool has the mouse.
  bool isBusy() const { return holder_ != nullptr; }
  /// The pointer's shape over a position; an arrow where no tool does anything.
  Qt::CursorShape pointer(QPointF position) const;
  void draw(QPainter& painter, const QRectF& view) const;

 private:
  std::vector<Tool*> tools_;
  Tool* holder_ = nullptr;  ///< has the mouse
};

}  // namespace fenestra::viewer
