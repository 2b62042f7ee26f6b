#pragma once
// How the three slices lie: as the volume's own slices, turned about any axis, or facing one of the cameras; and how
// thick they are. A view's state, like the cameras' linking: it belongs to the study and to its session, and is no step
// to undo.
//
// A turned slice always passes through the crosshair, exactly; the volume's own slices are those nearest to it.

#include <array>
#include <optional>

#include <QObject>
#include <QTimer>

#include "io/session/Session.h"
#include "rendering/volume/ObliqueSlice.h"
#include "rendering/volume/Slab.h"

namespace fenestra::viewer {

class Document;
class SliceCursor;
class ViewLink;

using io::PlaneFollow;
using PlanePose = io::SessionPlane;

/// How far a slice is from the nearest anatomical plane.
struct PlaneTilt {
  double degrees = 0.0;
  SlicePlane from = SlicePlane::Axial;
};

class SlicePlanes : public QObject {
  Q_OBJECT
 public:
  static constexpr std::array all{SlicePlane::Axial, SlicePlane::Sagittal, SlicePlane::Coronal};
  /// The thicknesses that steps of the wheel go through, in mm.
  static constexpr std::array thicknesses{0.0, 1.0, 2.0, 3.0, 5.0, 7.0, 10.0, 15.0, 20.0, 30.0, 50.0, 70.0, 100.0};

  /// All outlive this. Another volume resets all, without a signal.
  SlicePlanes(const Document& document, const SliceCursor& cursor, const ViewLink& cameras);

  const PlanePose& pose(SlicePlane plane) const { return poses_[index(plane)]; }
  const std::array<PlanePose, 3>& poses() const { return poses_; }
  void setPoses(const std::array<PlanePose, 3>& poses);

  /// It is none of the volume's own slices.
  bool isTurned(SlicePlane plane) const { return pose(plane).axes.has_value(); }
  /// The directions of its pictures, also where it is not turned. There must be a volume.
  PlaneAxes axes(SlicePlane plane) const;
  /// Its slices; one of a turned plane's lies on the crosshair, and its pixels keep their places in the picture
  /// wherever the crosshair is. There must be a volume.
  SliceGeometry geometry(SlicePlane plane) const;
  /// Between its normal and the patient's axes.
  PlaneTilt tilt(SlicePlane plane) const;

  /// Lays a plane along axes; it follows no camera from then on.
  void setAxes(SlicePlane plane, const PlaneAxes& axes);
  /// None leaves it as it lies.
  void setFollow(SlicePlane plane, PlaneFollow follow);
  /// The volume's own slices again. Thickness stays.
  void reset(SlicePlane plane);
  void resetAll();

  /// The thickness is held to 0…io::mostSlab.
  void setSlab(SlicePlane plane, Slab slab);
  /// To the next of `thicknesses`, so many steps on.
  void stepSlab(SlicePlane plane, int steps);

  /// A handle of a slice is dragged, or the camera that a slice faces moves: its picture may be coarser meanwhile.
  bool isMoving(SlicePlane plane) const;
  void setDragged(bool dragged);

 Q_SIGNALS:
  /// A plane lies elsewhere, or has another thickness, or is to be shown at full quality.
  void changed(SlicePlane plane);

 private:
  static std::size_t index(SlicePlane plane) { return static_cast<std::size_t>(plane); }
  void change(SlicePlane plane, const PlanePose& pose);
  void followCamera(int camera);

  const Document& document_;
  const SliceCursor& cursor_;
  const ViewLink& cameras_;
  std::array<PlanePose, 3> poses_;
  bool dragged_ = false;
  QTimer rest_;  ///< runs while a followed camera moves
};

/// The directions of the picture that faces a camera: rows and columns as in the camera's own, slices counted away from
/// the eye.
PlaneAxes axesFacing(const Camera& camera);
/// `axes` turned by an angle in radians about a unit vector (world, right-handed).
PlaneAxes turned(const PlaneAxes& axes, glm::dvec3 about, double radians);

}  // namespace fenestra::viewer
