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
  /// Moves along a plane's normal by whole slices; stops at the first and last.
  void step(const SliceGeometry& geometry, int slices);

 Q_SIGNALS:
  void moved();

 private:
  Grid grid_;
  glm::dvec3 position_{0.0};
};

}  // namespace fenestra::viewer
