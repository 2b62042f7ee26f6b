#pragma once
// The two cameras, C1 and C2, and their link: while linked, a rotation of one turns the other by the same world
// rotation, so that the angle between them stays, and both zoom by the same factor. Pan acts on one view.

#include <array>
#include <optional>

#include <QObject>
#include <QVariantAnimation>

#include "rendering/scene/View.h"
#include "rendering/settings/Camera.h"

namespace fenestra::viewer {

class ViewLink : public QObject {
  Q_OBJECT
 public:
  static constexpr int count = 2;

  using Pair = std::array<Camera, count>;
  /// What each view's opening is frozen for; see View::frozen.
  using Frozen = std::array<std::optional<OpeningView>, count>;
  /// Where both cameras are, and where reset() takes them.
  struct Pose {
    Pair cameras, home;
    bool operator==(const Pose&) const = default;
  };

  explicit ViewLink(QObject* parent = nullptr);

  const Camera& camera(int view) const { return cameras_[static_cast<std::size_t>(view)]; }
  bool isLinked() const { return linked_; }
  void setLinked(bool linked);

  /// Puts both cameras there at once; reset() then goes to them.
  void place(const Pair& cameras);
  /// Moves both cameras back to where they were last placed.
  void reset();

  /// During a flight, the pose at its end.
  Pose pose() const { return {isFlying() ? to_ : cameras_, placed_}; }
  /// Without a flight.
  void setPose(const Pose& pose);

  /// Flies both cameras to a pose over 0.3 s, or moves them there at once when they are not animated; reset() then goes
  /// to `home`. Any other camera move ends the flight.
  void flyTo(const Pair& cameras, const Pair& home);
  /// Ends a flight where it leads to.
  void finishFlight();
  bool isAnimated() const { return animated_; }
  /// Off: flights end at once, also one that is under way.
  void setAnimated(bool animated);
  bool isFlying() const { return flight_.state() == QAbstractAnimation::Running; }

  const Frozen& frozen() const { return frozen_; }
  bool isFrozen() const { return frozen_ != Frozen(); }
  void setFrozen(const Frozen& frozen);

  /// Turns a view by a world rotation about its target.
  void rotate(int view, const glm::dmat3& worldRotation);
  /// Turns a view by angles in radians about its own up and right axes (Camera::orbited).
  void orbit(int view, double yaw, double pitch);
  /// Turns a view to look from a side of the patient.
  void face(int view, StandardView side);
  /// Brings a view, and its linked partner, `factor` times nearer.
  void zoom(int view, double factor);
  void pan(int view, double rightMm, double upMm);
  /// Turns a view to look as `like` does, a millimetre at its target as large; its own target stays, and so does its
  /// partner. Ends a flight.
  void lookAs(int view, const Camera& like);
  /// A drag of a view has ended: its cameras stay where they are.
  void release() { Q_EMIT released(); }
  /// Changes the projection of both views. Objects at the target keep their size on screen.
  void setProjection(Projection projection);
  Projection projection() const { return cameras_[0].projection; }

 Q_SIGNALS:
  void changed(int view);
  /// A view was turned by hand; its linked partner has turned too.
  void turned(int view);
  void landed();
  void released();
  void frozenChanged();
  void linkedChanged(bool linked);
  void projectionChanged(Projection projection);

 private:
  void set(int view, const Camera& camera);

  Pair cameras_, placed_, from_, to_;  ///< from_ and to_: start and end of the flight
  Frozen frozen_;
  QVariantAnimation flight_;
  bool linked_ = true, animated_ = true;
};

/// The camera at `part` (0…1) of the way from one to another, along the shortest rotation at constant angular speed.
Camera between(const Camera& from, const Camera& to, double part);
/// `camera` with the patient upright, looking at its target from another direction (unit, towards the eye) at the same
/// distance.
Camera facing(Camera camera, glm::dvec3 towardsEye);
/// Where a camera looks from: the unit vector from its target towards the eye.
glm::dvec3 directionOf(const Camera& camera);

}  // namespace fenestra::viewer
