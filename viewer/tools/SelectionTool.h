#pragma once
// Painting the region in focus in one view: turns mouse positions into a stroke of the document, which is one step to
// undo, and draws the brush's ball around the mouse.
//
// Left drag: add to the region; with Shift, take away. Other modifiers are left to the view.

#include <optional>

#include "rendering/settings/Focus.h"
#include "viewer/tools/Tool.h"

namespace fenestra::viewer {

class Canvas;
class Document;
class SelectionBrush;

class SelectionTool : public Tool {
 public:
  /// All outlive this.
  SelectionTool(SelectionBrush& brush, Document& document, Canvas& canvas);

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void release(const QMouseEvent& event) override;
  void hover(const QMouseEvent& event) override;
  void leave() override;
  std::optional<Qt::CursorShape> pointer(QPointF position) const override;
  /// The ball under the mouse, and the stroke so far.
  void draw(QPainter& painter, const QRectF& view) const override;

 private:
  bool isActive() const;
  void paintTo(QPointF position);

  SelectionBrush& brush_;
  Document& document_;
  Canvas& canvas_;
  std::optional<QPointF> mouse_;           ///< empty outside the view
  std::optional<glm::dvec3> under_;        ///< the point that the view shows there
  std::optional<SelectionStroke> stroke_;  ///< being painted
};

}  // namespace fenestra::viewer
