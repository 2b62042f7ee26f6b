#pragma once
// A size by hand: a press and drag draws a ball around the pressed place, and the region that grows there does not
// leave it. Its ring shows in all views.
//
// Shift+left drag, while a click chooses the focus and no stroke mode has the button. A press without a drag is left to
// the view: it is a click.

#include <optional>

#include <QPointF>

#include "viewer/tools/Tool.h"

namespace fenestra::viewer {

class Canvas;
struct Workspace;

class RegionBallTool : public Tool {
 public:
  /// Both outlive this.
  RegionBallTool(Workspace& workspace, Canvas& canvas);

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void release(const QMouseEvent& event) override;
  bool wasClick() const override { return !drags_; }
  void leave() override;
  void draw(QPainter& painter, const QRectF& view) const override;

 private:
  Workspace& workspace_;
  Canvas& canvas_;
  QPointF pressed_;
  std::optional<glm::dvec3> centre_;  ///< the pressed place, world mm
  bool drags_ = false;                ///< the mouse has moved farther than in a click
};

}  // namespace fenestra::viewer
