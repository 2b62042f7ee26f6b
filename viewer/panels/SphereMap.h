#pragma once
// The sphere of viewpoints as a map (model/Mollweide.h), coloured by quality, with both cameras on it. A click asks to
// look from there.

#include <optional>
#include <vector>

#include <QImage>
#include <QWidget>

#include <glm/glm.hpp>

namespace fenestra::viewer {

class PlacementController;
class ViewLink;

class SphereMap : public QWidget {
  Q_OBJECT
 public:
  SphereMap(ViewLink& cameras, PlacementController& placement, QWidget* parent = nullptr);

  QPointF widgetFromDirection(glm::dvec3 direction) const;
  std::optional<glm::dvec3> directionFromWidget(QPointF position) const;

  QSize sizeHint() const override { return {260, 138}; }
  QSize minimumSizeHint() const override { return {160, 90}; }

 Q_SIGNALS:
  void clicked(glm::dvec3 direction);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  /// The ellipse, in the widget.
  QRectF frame() const;
  void findNearest();
  void colour();

  ViewLink& cameras_;
  PlacementController& placement_;
  QImage picture_;            ///< fills the ellipse's box
  std::vector<int> nearest_;  ///< nearest candidate of each pixel of picture_
};

}  // namespace fenestra::viewer
