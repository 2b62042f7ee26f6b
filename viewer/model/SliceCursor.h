#pragma once
// The point that all five views share: the crosshair.

#include <QObject>

#include "rendering/volume/Slice.h"

namespace fenestra::viewer {

class SliceCursor : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// The volume that the cursor stays inside; the cursor moves to its centre.
  void setGrid(const Grid& grid);

  glm::dvec3 position() const { return position_; }  ///< world (LPS), mm
  /// Moves there, or to the nearest point of the volume's box.
  void moveTo(glm::dvec3 world);
  /// The slice of a plane that the cursor lies on.
  int slice(const SliceGeometry& geometry) const;
  /// Moves along a plane's normal by whole slices; stops at the first and last. Where that would leave the volume, it
  /// stays on a turned plane as near to there as possible.
  void step(const SliceGeometry& geometry, int slices);

 Q_SIGNALS:
  void moved();

 private:
  /// A point near `point` that lies in the volume, and on the plane through `point` along a geometry's slices.
  glm::dvec3 nearestOnPlane(glm::dvec3 point, const SliceGeometry& geometry) const;

  Grid grid_;
  glm::dvec3 position_{0.0};
};

}  // namespace fenestra::viewer
