#pragma once
// What tools need of the view that they work in. Positions are in device-independent pixels of the view, points in
// world mm.

#include <cstdint>
#include <optional>
#include <vector>

#include <QPointF>
#include <QRectF>

#include "rendering/settings/BrushStroke.h"
#include "rendering/settings/Camera.h"
#include "rendering/volume/Slice.h"

namespace fenestra::viewer {

class Canvas {
 public:
  virtual ~Canvas() = default;

  /// Where a point lies in the view; empty behind the eye.
  virtual std::optional<QPointF> widgetFromWorld(glm::dvec3 world) const = 0;
  /// Unit vectors of the picture: right, up, and forward, away from the eye.
  virtual Camera::Axes axes() const = 0;
  /// As axes(), with forward along the line of sight at a point.
  virtual Camera::Axes axesAt(glm::dvec3) const { return axes(); }
  /// What the view shows at a position: the point of the surface, or of the slice; empty where there is nothing.
  virtual std::optional<glm::dvec3> pickSurface(QPointF position) const = 0;
  /// As pickSurface(), but a point within the voxel that is seen first.
  virtual std::optional<glm::dvec3> pickVoxel(QPointF position) const { return pickSurface(position); }
  /// As pickSurface(), but a point within the structure that a click there is about.
  virtual std::optional<glm::dvec3> pickStructure(QPointF position) const { return pickSurface(position); }
  virtual void redraw() const = 0;

  /// The plane of a slice; empty in 3-D.
  struct Section {
    glm::dvec3 point, normal;  ///< any point of it, and its unit normal
  };
  virtual std::optional<Section> section() const { return std::nullopt; }

  /// How far a position moves with 1 mm along a unit vector from a point; 0 behind the eye.
  QPointF pixelsPerMm(glm::dvec3 at, glm::dvec3 along) const;
  /// Pixels of a length in mm across the view at a point; 0 behind the eye.
  double pixelsOf(double mm, glm::dvec3 at) const;
};

/// A 3-D view.
class PictureCanvas : public Canvas {
 public:
  /// The camera's place: 0 for C1, 1 for C2.
  virtual int camera() const = 0;
  /// Renderer::pickBrush() at a position.
  virtual std::optional<BrushPoint> pickBrush(QPointF position, BrushMode mode,
                                              std::optional<glm::dvec3> before) const = 0;
  /// The picture of the document as it is now, at full quality; empty where there is none.
  virtual std::vector<std::uint8_t> picture() const = 0;
};

/// A slice view.
class SliceCanvas : public Canvas {
 public:
  virtual const SliceGeometry& geometry() const = 0;
  virtual int slice() const = 0;    ///< the number of the slice that is shown
  virtual QRectF view() const = 0;  ///< all of the view
  /// World directions of the view's right and down; those of the slice, unless it is mirrored or turned.
  virtual glm::dvec3 right() const { return geometry().right; }
  virtual glm::dvec3 down() const { return geometry().down; }
  /// The point of that slice at a position, also beside the picture.
  virtual glm::dvec3 worldFromWidget(QPointF position) const = 0;

  std::optional<QPointF> widgetFromWorld(glm::dvec3 world) const final { return onSlice(world); }
  /// Where a point lies in the view when projected onto the slice.
  virtual QPointF onSlice(glm::dvec3 world) const = 0;
  Camera::Axes axes() const final;
  std::optional<Section> section() const final;
};

}  // namespace fenestra::viewer
