#pragma once
// Painting the region in focus in one view: turns mouse positions into a stroke of the document, which is one step to
// undo, and draws the brush's ball around the mouse. Positions are in device-independent pixels of the view.
//
// Left drag: add to the region; with Shift, take away. Other modifiers are left to the view.

#include <functional>
#include <optional>
#include <vector>

#include <QPainter>
#include <QPointF>

#include "rendering/scene/Focus.h"

class QMouseEvent;

namespace fenestra::viewer {

class Document;
class SelectionBrush;

class SelectionTool {
 public:
  /// What the tool needs of its view.
  struct Canvas {
    /// The place in the world that the view shows at a position; empty where it shows nothing.
    std::function<std::optional<glm::dvec3>(QPointF)> pick;
    std::function<std::optional<QPointF>(glm::dvec3)> widgetFromWorld;
    std::function<double(glm::dvec3)> pixelsPerMm;  ///< at a place in the world
    std::function<void()> redraw;
  };

  SelectionTool(SelectionBrush& brush, Document& document, Canvas canvas);

  /// Handle an event. True: the tool has taken it, and the view must ignore it.
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  void leave();

  bool isActive() const;
  /// The ball under the mouse, and the stroke so far.
  void draw(QPainter& painter) const;

 private:
  void paintTo(QPointF position);

  SelectionBrush& brush_;
  Document& document_;
  Canvas canvas_;
  std::optional<QPointF> mouse_;           ///< empty outside the view
  std::optional<glm::dvec3> under_;        ///< what the view shows there
  std::optional<SelectionStroke> stroke_;  ///< being painted
};

}  // namespace fenestra::viewer
