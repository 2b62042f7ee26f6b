#pragma once
// Where a picture is taken from.

#include <cstdint>
#include <optional>

#include <glm/glm.hpp>

#include "rendering/settings/Framing.h"
#include "rendering/volume/Grid.h"

namespace fenestra {

enum class Projection : std::uint8_t { Perspective, Orthographic };
/// The camera stands on that side of the patient and looks at it; A is the face.
enum class StandardView : std::uint8_t { Anterior, Posterior, Left, Right, Superior, Inferior };

/// The up vector with which a camera on that side (unit vector from the patient towards the eye) shows the patient
/// upright: superior, or anterior within 15° of the body's axis, where the side that superior points to would turn with
/// every small move.
glm::dvec3 uprightFrom(glm::dvec3 towardsEye);

/// A pinhole or parallel camera. Rays: pixel (i,j) of a W×H picture, j from the top, has NDC x = 2(i+½)/W - 1,
/// y = 1 - 2(j+½)/H; t is in mm along the unit direction from the eye (perspective) or from the plane through the eye
/// (orthographic, where the near plane is that plane).
struct Camera {
  Projection projection = Projection::Perspective;
  glm::dvec3 eye{0.0, -1.0, 0.0};   ///< world, mm
  glm::dvec3 target{0.0};           ///< world, mm; the point that orbiting turns around
  glm::dvec3 up{0.0, 0.0, 1.0};     ///< world; need not be unit nor orthogonal to the view, may even be parallel to it
  double verticalFov = 30.0;        ///< degrees, perspective
  double orthographicHeight = 1.0;  ///< mm from the bottom to the top of the picture

  /// Orthonormal view axes in world space; defined even where `up` is parallel to the view or eye equals target.
  struct Axes {
    glm::dvec3 right, up, forward;
  };
  Axes axes() const;
  glm::dmat4 viewFromWorld() const;
  /// Near and far enclose `grid`'s bounding sphere (perspective: near stays positive).
  glm::dmat4 clipFromView(double aspect, const Grid& grid) const;
  glm::dmat4 clipFromWorld(double aspect, const Grid& grid) const;

  /// Turn by angles in radians around the target: `yaw` about the view's up axis, `pitch` about its right axis.
  Camera orbited(double yaw, double pitch) const;
  /// Rotate eye and up around the target by a world-space rotation (how a linked view follows its partner).
  Camera rotated(const glm::dmat3& worldRotation) const;
  /// Bring the eye `factor` times nearer (> 1 is closer), or scale the orthographic height down.
  Camera zoomed(double factor) const;
  /// Move eye and target together by `right` and `up` mm in the view plane.
  Camera panned(double right, double up) const;

  /// This camera with `point` (world) in the middle of the picture, from the same eye, or in the same direction where
  /// rays are parallel; empty where it does not lie before the eye.
  std::optional<Camera> aimedAt(glm::dvec3 point) const;

  /// This camera for a picture of `to` pixels whose first ones, from the top left, are those of this one's picture of
  /// `from`, a pixel or two smaller. In perspective it turns by half of what is added, which shifts pixels at the
  /// border by a tenth of one.
  Camera widened(glm::ivec2 from, glm::ivec2 to) const;

  /// The second camera of a pair: a quarter turn to this one's right, the patient upright. For an anterior view it
  /// looks from the patient's left.
  Camera beside() const;
  /// This camera for a picture of `aspect`, width over height. A picture higher than wide gets a wider field of view,
  /// so that it shows everything that a square one does.
  Camera fittedTo(double aspect) const;

  static Camera standard(StandardView view, const Framing& framing, Projection projection = Projection::Perspective);
  /// From a unit direction (towards the eye), with all of `framing` in the picture, the patient upright.
  static Camera fromDirection(glm::dvec3 towardsEye, const Framing& framing,
                              Projection projection = Projection::Perspective);
  /// Azimuth and elevation in degrees: azimuth 0 looks from anterior, 90 from the patient's left; elevation 90 from
  /// above.
  static Camera fromAngles(double azimuth, double elevation, const Framing& framing,
                           Projection projection = Projection::Perspective);

  bool operator==(const Camera&) const = default;
};

}  // namespace fenestra
