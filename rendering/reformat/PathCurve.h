#pragma once
// A smooth curve through points of the patient, with frames that turn about it no more than they must.
//
// The curve is a centripetal Catmull-Rom spline (P. J. Schneider's parametrisation as in C. Yuksel, S. Schaefer, J.
// Keyser: Parameterization and applications of Catmull-Rom curves, Computer-Aided Design 43(7), 2011), which goes
// through all points without loops or cusps between them. The frames are rotation-minimising, by double reflection (W.
// Wang, B. Jüttler, D. Zheng, Y. Liu: Computation of rotation minimizing frames, ACM Transactions on Graphics 27(1),
// 2008): unlike those of Frenet, they do not flip where the curve is straight or bends the other way.

#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace fenestra::reformat {

/// A place of a curve; unit vectors in the patient (LPS), each perpendicular to the others.
struct PathPlace {
  glm::dvec3 point{0.0};            ///< mm
  glm::dvec3 along{0.0, 0.0, 1.0};  ///< towards the curve's end
  glm::dvec3 right{1.0, 0.0, 0.0};  ///< turns no more than the curve does
  glm::dvec3 up{0.0, 1.0, 0.0};     ///< along × right
};

class PathCurve {
 public:
  /// Through `points`, LPS in mm. Those within a micrometre of the one before are left out; two must remain, or the
  /// curve has the length 0. The frame begins with the patient's left as its right, or with posterior where the curve
  /// begins along left.
  explicit PathCurve(std::span<const glm::dvec3> points);

  double length() const { return samples_.empty() ? 0.0 : samples_.back().at; }  ///< mm
  /// `mm` from the beginning, held to the curve.
  PathPlace place(double mm) const;

 private:
  struct Sample {
    double at;  ///< mm from the beginning
    PathPlace place;
  };
  std::vector<Sample> samples_;
};

}  // namespace fenestra::reformat
