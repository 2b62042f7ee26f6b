#pragma once
// Painting the region in focus in one view: turns mouse positions into a stroke of the document, which is one step to
// undo, and draws the brush's ball around the mouse.
//
// Left drag: add to the region; with Shift, take away. Other modifiers are left to the view.

#include <optional>
#include <vector>

#include <QPainter>
#include <QPointF>

#include "rendering/scene/Focus.h"
#include "viewer/tools/SpaceCanvas.h"

class QMouseEvent;

namespace fenestra::viewer {

class Document;
class SelectionBrush;

class SelectionTool {
 public:
  SelectionTool(SelectionBrush& brush, Document& document, SpaceCanvas canvas);

  /// Handle an event. True: the tool has taken it, and the view must ignore it.
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  void leave();

  bool isPainting() const { return stroke_.has_value(); }
  /// The ball under the mouse, and the stroke so far.
  void draw(QPainter& painter) const;

 private:
  bool isActive() const;
  void paintTo(QPointF position);

  SelectionBrush& brush_;
  Document& document_;
  SpaceCanvas canvas_;
  std::optional<QPointF> mouse_;           ///< empty outside the view
  std::optional<glm::dvec3> under_;        ///< what the view shows there
  std::optional<SelectionStroke> stroke_;  ///< being painted
};

}  // namespace fenestra::viewer
