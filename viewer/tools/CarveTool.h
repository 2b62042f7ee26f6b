#pragma once
// Carving in one view, in 3-D or on a slice: turns mouse positions into a removal of the document, and draws what will
// be removed. Positions are in device-independent pixels of the view.
//
// Left drag: what lies along it is removed when the button is let go, as one step to undo. Shift with left drag bends
// the plane that was laid last. Ctrl+left drag is left to the view.

#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "viewer/tools/Tool.h"

namespace fenestra {
struct Removal;
}

namespace fenestra::viewer {

class Canvas;
class Carving;
class Document;

class CarveTool : public Tool {
 public:
  /// All outlive this.
  CarveTool(Carving& carving, Document& document, Canvas& canvas);

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void release(const QMouseEvent& event) override;
  void hover(const QMouseEvent& event) override;
  void leave() override;
  std::optional<Qt::CursorShape> pointer(QPointF position) const override;
  /// The stroke, or the ring under the mouse.
  void draw(QPainter& painter, const QRectF& view) const override;

 private:
  void extendTo(QPointF position);
  void finish(QPointF position);
  void bend(QPointF position);
  /// The document's last removal, where it is a plane.
  const Removal* lastPlane() const;

  Carving& carving_;
  Document& document_;
  Canvas& canvas_;
  std::optional<QPointF> mouse_;     ///< position; empty outside the view
  std::optional<glm::dvec3> under_;  ///< the point that is seen there
  std::vector<glm::dvec3> stroke_;   ///< being drawn
  std::optional<QPointF> bentFrom_;  ///< where a drag of the plane began; stroke_ holds the point there
};

}  // namespace fenestra::viewer
