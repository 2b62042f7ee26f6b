#pragma once
// Painting in one 3-D view: turns mouse positions into a stroke of the document, and draws the ring around the mouse.
// Positions and radii are in device-independent pixels of the view.
//
// Left drag: paint. Shift or Alt with left drag up and down, or with the wheel: depth, or amount in modes without
// depth. Ctrl+left drag is left to the view, which rotates. Where a stroke can have no effect, the text at the ring
// says why, and Space does what would let it.

#include <functional>
#include <optional>

#include <QPainter>
#include <QPointF>

#include "rendering/scene/BrushStroke.h"
#include "viewer/model/BrushObstacle.h"

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace fenestra::viewer {

class Brush;
class Document;

class BrushTool {
 public:
  /// What the tool needs of its view. All may be called at any time.
  struct Canvas {
    int view;  ///< the camera's place
    /// Renderer::pickBrush() at a place in the view.
    std::function<std::optional<BrushPoint>(QPointF, BrushMode, std::optional<glm::dvec3> before)> pick;
    /// The picture of the document as it is now, at full quality; empty where there is none.
    std::function<std::vector<std::uint8_t>()> picture;
    std::function<void()> redraw;
  };

  BrushTool(Brush& brush, Document& document, Canvas canvas);

  /// Handle an event. True: the tool has taken it, and the view must ignore it.
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  bool key(const QKeyEvent& event);
  void leave();

  bool isPainting() const { return stroke_.has_value(); }
  /// What keeps a stroke at the mouse from changing the picture.
  std::optional<BrushObstacle> obstacle() const { return obstacle_; }
  /// Ring, softness and depth under the mouse.
  void draw(QPainter& painter, const QRectF& view) const;
  /// Finds what the picture shows under the mouse; to be called after the picture has changed.
  void measure();

 private:
  void paintTo(QPointF position);
  QStringList hint() const;
  void finish();

  Brush& brush_;
  Document& document_;
  Canvas canvas_;
  std::optional<QPointF> mouse_;     ///< position; empty outside the view
  std::optional<BrushPoint> under_;  ///< what the picture shows at mouse_
  std::optional<BrushObstacle> obstacle_;
  std::optional<BrushStroke> stroke_;  ///< being painted
  BrushStrokes before_;                ///< the document's strokes when stroke_ began
  std::vector<std::uint8_t> picture_;  ///< the view's picture when stroke_ began
  std::optional<QPointF> deepening_;   ///< last place of the mouse while it drags the depth
};

}  // namespace fenestra::viewer
