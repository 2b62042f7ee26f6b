#pragma once
// Painting in one 3-D view: turns mouse positions into a stroke of the document, and draws the ring around the mouse.
// Positions and radii are in device-independent pixels of the view.
//
// Left drag: paint. Shift or Alt with left drag up and down, or with the wheel: depth, or amount in modes without
// depth. The view rotates on Ctrl+left drag. Where a stroke can have no effect, the text at the ring says why, and
// Space applies the remedy.

#include <cstdint>
#include <optional>
#include <vector>

#include "rendering/settings/BrushStroke.h"
#include "viewer/model/BrushObstacle.h"
#include "viewer/tools/Tool.h"

namespace fenestra::viewer {

class Brush;
class Document;
class PictureCanvas;

class BrushTool : public Tool {
 public:
  /// All outlive this.
  BrushTool(Brush& brush, Document& document, PictureCanvas& canvas);

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void release(const QMouseEvent& event) override;
  void hover(const QMouseEvent& event) override;
  void leave() override;
  bool wheel(const QWheelEvent& event) override;
  bool key(const QKeyEvent& event) override;
  /// Finds what the picture shows under the mouse.
  void refresh() override;
  std::optional<Qt::CursorShape> pointer(QPointF position) const override;
  /// Ring, softness and depth under the mouse.
  void draw(QPainter& painter, const QRectF& view) const override;

  /// Why a stroke at the mouse would not change the picture.
  std::optional<BrushObstacle> obstacle() const { return obstacle_; }

 private:
  bool isPainting() const { return stroke_.has_value(); }
  void paintTo(QPointF position);
  QStringList hint() const;
  void finish();

  Brush& brush_;
  Document& document_;
  PictureCanvas& canvas_;
  std::optional<QPointF> mouse_;     ///< position; empty outside the view
  std::optional<BrushPoint> under_;  ///< what the picture shows at mouse_
  std::optional<BrushObstacle> obstacle_;
  std::optional<BrushStroke> stroke_;  ///< being painted
  BrushStrokes before_;                ///< the document's strokes when stroke_ began
  std::vector<std::uint8_t> picture_;  ///< the view's picture when stroke_ began
  std::optional<QPointF> deepening_;   ///< last place of the mouse while it drags the depth
};

}  // namespace fenestra::viewer
