#pragma once
// The crop box and the clip planes over a picture, with handles to drag: in 3-D views and on slices. Positions are in
// device-independent pixels of the view.
//
// Each face of the box has a handle; each plane has one to move it and one, at the tip of its arrow, to tilt it. The
// arrow points to what is kept. A drag is one step to undo. They show while ViewOptions::clipHandles() is on; in a 3-D
// view, not while a stroke mode is active.

#include <cstdint>
#include <optional>
#include <vector>

#include <QPointF>

#include "rendering/settings/Clipping.h"
#include "viewer/tools/Tool.h"

namespace fenestra::viewer {

class ActiveTool;
class Canvas;
class Document;
class ViewOptions;

class ClipTool : public Tool {
 public:
  struct Handle {
    enum class Kind : std::uint8_t { Face, Move, Tilt } kind;
    int which;            ///< Face: 2·axis, and 1 more for the high end; Move and Tilt: the plane's place
    glm::dvec3 at;        ///< world
    glm::dvec3 along;     ///< unit, world: the way that a drag moves it; Tilt: the arrow's
    glm::dvec3 foot{at};  ///< Tilt: what it turns about
  };

  /// All outlive this.
  ClipTool(Document& document, const ViewOptions& options, const ActiveTool& active, const Canvas& canvas);

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void release(const QMouseEvent& event) override;
  std::optional<Qt::CursorShape> pointer(QPointF position) const override;
  void draw(QPainter& painter, const QRectF& view) const override;

  /// None while they do not show.
  std::vector<Handle> handles() const;

 private:
  std::optional<Handle> handleAt(QPointF position) const;
  void addFaces(std::vector<Handle>& handles) const;
  void addPlanes(std::vector<Handle>& handles) const;
  void drawBox(QPainter& painter) const;
  void drawPlane(QPainter& painter, std::size_t which) const;
  void drawLine(QPainter& painter, glm::dvec3 from, glm::dvec3 to, const QColor& colour) const;
  /// mm along the handle's way that the mouse has moved since the press.
  double draggedBy(QPointF moved) const;
  void dragFace(QPointF moved);
  void dragPlane(QPointF moved);
  void tiltPlane(QPointF moved);

  Document& document_;
  const ViewOptions& options_;
  const ActiveTool& active_;
  const Canvas& canvas_;
  std::optional<Handle> grip_;  ///< being dragged
  Clipping before_;             ///< at the press
  Clipping held_;               ///< after the press or the last move
  QPointF pressed_;
};

}  // namespace fenestra::viewer
