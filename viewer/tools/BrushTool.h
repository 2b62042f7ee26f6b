#pragma once
// Painting in one 3-D view: from mouse positions to a stroke in the document, and the ring that shows where the brush
// is. Positions and radii are in device-independent pixels of the view.
//
// Left drag: paint. Shift or Alt with left drag up and down, or with the wheel: depth (amount where the mode has that).
// Ctrl+left drag stays the view's own rotation.

#include <functional>
#include <optional>

#include <QPainter>
#include <QPointF>

#include "rendering/scene/BrushStroke.h"

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

  /// These return true for what is the tool's; the view does nothing with it then.
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  void leave();

  bool isPainting() const { return stroke_.has_value(); }
  /// Ring, softness and depth under the mouse.
  void draw(QPainter& painter, const QRectF& view) const;
  /// What is under the mouse in the picture that was just drawn.
  void measure();

 private:
  void paintTo(QPointF position);
  void finish();

  Brush& brush_;
  Document& document_;
  Canvas canvas_;
  std::optional<QPointF> mouse_;       ///< over the view
  std::optional<BrushPoint> under_;    ///< what is there
  std::optional<BrushStroke> stroke_;  ///< being painted
  BrushStrokes before_;                ///< of the document when it began
  std::vector<std::uint8_t> picture_;  ///< likewise
  std::optional<QPointF> deepening_;   ///< last place of the mouse while it drags the depth
};

}  // namespace fenestra::viewer
