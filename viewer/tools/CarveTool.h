#pragma once
// Carving in one view, in 3-D or on a slice: turns mouse positions into a removal of the document, and draws what will
// be removed. Positions are in device-independent pixels of the view.
//
// Left drag: what lies along it is removed when the button is let go, as one step to undo. Shift with left drag bends
// the plane that was laid last. Ctrl+left drag is left to the view.

#include <optional>
#include <vector>

#include <QPainter>
#include <QPointF>

#include "viewer/tools/SpaceCanvas.h"

class QMouseEvent;

namespace fenestra::viewer {

class Document;

class CarveTool {
 public:
  CarveTool(Carving& carving, Document& document, SpaceCanvas canvas);

  /// Handle an event. True: the tool has taken it, and the view must ignore it.
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  void leave();

  bool isCarving() const { return !stroke_.empty(); }
  /// The stroke, or the ring under the mouse.
  void draw(QPainter& painter) const;

 private:
  void extendTo(QPointF position);
  void finish(QPointF position);
  void bend(QPointF position);
  /// The document's last removal, where it is a plane.
  const Removal* lastPlane() const;

  Carving& carving_;
  Document& document_;
  SpaceCanvas canvas_;
  std::optional<QPointF> mouse_;     ///< position; empty outside the view
  std::optional<glm::dvec3> under_;  ///< what is seen there
  std::vector<glm::dvec3> stroke_;   ///< being drawn
  std::optional<QPointF> bentFrom_;  ///< where a drag of the plane began; stroke_ holds the point there
};

}  // namespace fenestra::viewer
