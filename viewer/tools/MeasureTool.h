#pragma once
// Drawing, moving and selecting measures on one slice view. Positions are in device-independent pixels of the view.
//
// While a kind is chosen (MeasureMode), a drag or two clicks draw a distance, a region or an arrow; an angle takes a
// third point, and a text one. A left drag on a handle moves it, one on the line moves the measure; both are one step
// to undo. A press on a measure selects it, one beside it deselects.

#include <optional>
#include <vector>

#include <QPointF>

#include "rendering/volume/SliceMeasure.h"
#include "viewer/style/MeasureDrawing.h"
#include "viewer/tools/Tool.h"

namespace fenestra::viewer {

class Document;
class MeasureMode;
class SliceCanvas;
class ViewOptions;

class MeasureTool : public Tool {
 public:
  /// All outlive this.
  MeasureTool(MeasureMode& mode, Document& document, const ViewOptions& options, const SliceCanvas& canvas);

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void release(const QMouseEvent& event) override;
  void hover(const QMouseEvent& event) override;
  /// Over a measure, or while one can be drawn.
  std::optional<Qt::CursorShape> pointer(QPointF position) const override;
  /// All measures of the shown slice, and the one being drawn.
  void draw(QPainter& painter, const QRectF& view) const override;

  /// The measure at a place in the view, if any.
  std::optional<std::size_t> measureAt(QPointF position) const;
  /// A measure as this view shows it; empty when it lies on another slice.
  std::optional<ShownMeasure> shown(const Measure& measure, const MeasureValues& values) const;

 private:
  struct Grip {
    std::size_t measure;
    std::optional<std::size_t> handle;  ///< unset: the line
  };
  std::optional<Grip> gripAt(QPointF position) const;
  bool liesHere(const Measure& measure) const;
  bool isDrawing() const;
  void moveGrip(glm::dvec3 to);

  MeasureMode& mode_;
  Document& document_;
  const ViewOptions& options_;
  const SliceCanvas& canvas_;
  std::optional<Grip> grip_;   ///< being dragged
  std::vector<Measure> held_;  ///< all measures after the press or the last move
  glm::dvec3 gripped_{0.0};    ///< where the mouse was last, world
  bool dragging_ = false;      ///< has moved since the press
  QPointF pressed_;
};

}  // namespace fenestra::viewer
