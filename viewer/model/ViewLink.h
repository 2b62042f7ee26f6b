#pragma once
// The two cameras, C1 and C2, and what ties them: while linked, a rotation of one turns the other by the same world
// rotation, so that the pair keeps its relation. Zoom and pan belong to one view.

#include <array>

#include <QObject>
#include <QVariantAnimation>

#include "rendering/scene/Camera.h"

namespace fenestra::viewer {

class ViewLink : public QObject {
  Q_OBJECT
 public:
  static constexpr int count = 2;

  using Pair = std::array<Camera, count>;
  /// Where both cameras are, and where reset() takes them.
  struct Pose {
    Pair cameras, home;
    bool operator==(const Pose&) const = default;
  };

  explicit ViewLink(QObject* parent = nullptr);

  const Camera& camera(int view) const { return cameras_[static_cast<std::size_t>(view)]; }
  bool isLinked() const { return linked_; }
  void setLinked(bool linked);

  /// Places C1, and C2 a quarter turn to C1's right with the patient upright: for an anterior C1 it looks from the
  /// patient's left.
  void place(const Camera& first);
  /// Back to what was last placed.
  void reset();

  /// In flight, of its end.
  Pose pose() const { return {isFlying() ? to_ : cameras_, placed_}; }
  /// At once.
  void setPose(const Pose& pose);

  /// Flies both cameras there, over some frames; reset() then goes to `home`. Whatever else moves a camera ends the
  /// flight.
  void flyTo(const Pair& cameras, const Pair& home);
  bool isFlying() const { return flight_.state() == QAbstractAnimation::Running; }
  /// One camera, at once, whatever the link.
  void show(int view, const Camera& camera);

  /// Turns a view by a world rotation about its target.
  void rotate(int view, const glm::dmat3& worldRotation);
  /// Turns a view by angles in radians about its own up and right axes (Camera::orbited).
  void orbit(int view, double yaw, double pitch);
  /// Turns a view to look from a side of the patient.
  void face(int view, StandardView side);
  void zoom(int view, double factor);
  void pan(int view, double rightMm, double upMm);
  /// Changes both views' projection; what lies at the target keeps its size on screen.
  void setProjection(Projection projection);
  Projection projection() const { return cameras_[0].projection; }

 Q_SIGNALS:
  void changed(int view);
  /// A view was turned by hand; its linked partner has turned too.
  void turned(int view);
  void landed();
  void linkedChanged(bool linked);
  void projectionChanged(Projection projection);

 private:
  void set(int view, const Camera& camera);

  Pair cameras_, placed_, from_, to_;  ///< from_ and to_: of the flight
  QVariantAnimation flight_;
  bool linked_ = true;
};

/// A camera on the way from one to another, part 0…1 of it done: it turns evenly, on the shortest way over the sphere.
Camera between(const Camera& from, const Camera& to, double part);
/// `camera` looking at its target from another direction (unit, towards the eye) and as far, the patient upright.
Camera facing(Camera camera, glm::dvec3 towardsEye);
/// Where a camera looks from: the unit vector from its target towards the eye.
glm::dvec3 directionOf(const Camera& camera);

}  // namespace fenestra::viewer
