#pragma once
// The crop box and the clip planes over a picture, with handles to drag: in 3-D views and on slices. Positions are in
// device-independent pixels of the view.
//
// Of the box each face has a handle; of a plane one to move it and one, at the tip of its arrow, to tilt it. The arrow
// points to what is kept. A drag is one step to undo. They show while ViewOptions::clipHandles() is on.

#include <functional>
#include <optional>
#include <vector>

#include <QPainter>
#include <QPointF>

#include "rendering/scene/Clipping.h"

class QMouseEvent;

namespace fenestra::viewer {

class Document;

class ClipTool {
 public:
  /// What the tool needs of its view.
  struct Canvas {
    /// Empty behind the eye.
    std::function<std::optional<QPointF>(glm::dvec3)> widgetFromWorld;
    /// Unit vectors along the picture, world: to the right and up.
    std::function<std::array<glm::dvec3, 2>()> axes;
    /// The plane of a slice view: any point of it and its unit normal; empty in 3-D.
    struct Section {
      glm::dvec3 point, normal;
    };
    std::function<std::optional<Section>()> section;
    std::function<bool()> shows;
  };
  struct Handle {
    enum class Kind : std::uint8_t { Face, Move, Tilt } kind;
    int which;            ///< of a face: 2·axis, and 1 more for the high end; else the plane's place
    glm::dvec3 at;        ///< world
    glm::dvec3 along;     ///< unit, world: the way that a drag moves it; of Tilt the arrow's
    glm::dvec3 foot{at};  ///< of Tilt: what it turns about
  };

  ClipTool(Document& document, Canvas canvas);

  /// Handle an event. True: the tool has taken it, and the view must ignore it.
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);

  /// Over a handle, the pointer's shape.
  std::optional<Qt::CursorShape> pointer(QPointF position) const;
  std::vector<Handle> handles() const;
  void draw(QPainter& painter) const;

 private:
  std::optional<Handle> handleAt(QPointF position) const;
  void addFaces(std::vector<Handle>& handles) const;
  void addPlanes(std::vector<Handle>& handles) const;
  void drawBox(QPainter& painter) const;
  void drawPlane(QPainter& painter, std::size_t which) const;
  void drawLine(QPainter& painter, glm::dvec3 from, glm::dvec3 to, const QColor& colour) const;
  /// Pixels from a world point by 1 mm along a unit vector.
  QPointF pixelsPerMm(glm::dvec3 at, glm::dvec3 along) const;
  /// mm along the handle's way that the mouse has moved since the press.
  double draggedBy(QPointF moved) const;
  void dragFace(QPointF moved);
  void dragPlane(QPointF moved);
  void tiltPlane(QPointF moved);

  Document& document_;
  Canvas canvas_;
  std::optional<Handle> grip_;  ///< being dragged
  Clipping before_;             ///< at the press
  Clipping held_;               ///< as the press or the drag's last move left it
  QPointF pressed_;
};

}  // namespace fenestra::viewer
