#pragma once
// Peeling: a layer of the context in front of the focus is cut in two, and its halves are rolled aside.
//
// After M. J. McGuffin, L. Tancau, R. Balakrishnan: Using deformations for browsing volumetric data, IEEE Visualization
// 2003, who peel layers off a volume, and C. D. Correa, D. Silver, M. Chen: Feature aligned volume manipulation for
// illustration and visualization, IEEE TVCG 12(5), 2006: a picture's point x shows the volume at x' = x + D(x), nothing
// shows where x' leaves what is deformed, and D = 0 in the focus. The roll below is the program's own.
//
// Frame: a is the unit direction of the side that the layer is peeled off, u the cut's, v = a × u across it. u is S of
// the patient, or P where a is S or I, turned around a. With the middle of the focus's extent along u and v as origin,
// and the break as h = 0, a place has coordinates p along u, w = |q| across, q along v, and h along a. The extents of
// the focus along the axes count the voxels whole, g is the half of a voxel's extent along a, and of the focus's
// [s0, s1] the break lies at
//
//   s1 + g - depth (s1 - s0 + 2 g)
//
// Without a focus, it counts as the middle of the volume. H is the layer's thickness: from the break to the front of
// the box around the body (bodyBox). L and W are half the extents of the focus along u and v, plus the margin, but no
// more than the volume reaches on either side of the origin; R = H + radius, and c = amount (W + R).
//
// Roll: of the layer 0 ≤ h ≤ H, |p| ≤ L, w ≤ c, each half is bent round the axis w = c, h = R, lengths on the break
// kept, and lies flat again from half a turn on. A point of the layer, l = c - w, goes to
//
//   w = c - (R - h) sin(l/R), h = R - (R - h) cos(l/R)     l ≤ π R
//   w = c + l - π R,          h = 2 R - h                  beyond
//
// This is one to one: sourceOf() is its inverse. Along each radius of the roll nothing is stretched; across, what lies
// at h is compressed to (R - h)/R of its length, H to radius/R. At amount 1 nothing of the layer has w < W.

#include <array>
#include <cstdint>
#include <optional>

#include "rendering/vocabulary/MethodStages.h"
#include "rendering/volume/Grid.h"

namespace fenestra {

struct Look;
class FocusVoxels;
struct ShownVolume;

/// How a look's pictures are peeled; empty where they are not, or the cutaway is off.
std::optional<MethodStages::Peel> peelOf(const Look& look);

/// The part of the volume's grid in which there is a body: values above -500 HU, or above a tenth of the volume's range
/// where there are no Hounsfield units, without slabs that hold next to none (visibleGrid).
Grid bodyBox(const ShownVolume& shown);

/// Where a peeled layer lies.
class Peel {
 public:
  /// `focus` may hold nothing.
  Peel(const MethodStages::Peel& peel, const FocusVoxels& focus, const Grid& grid, const Grid& body);

  /// There is a layer, and some of it is moved.
  bool movesAnything() const { return thickness_ > 0.0 && roll_ > 0.0; }

  /// What a picture shows at a place, whatever is in focus: what lies there, nothing, or what the half of the layer on
  /// v's negative or positive side brought there. Places within `hair` of a face of the opening lie outside of it.
  enum class Part : std::uint8_t { InPlace, Nothing, Negative, Positive };
  struct Source {
    Part part = Part::InPlace;
    glm::dvec3 world{0.0};  ///< x'; the place itself where nothing shows
  };
  Source sourceOf(glm::dvec3 world) const;
  /// Where a place of the volume that is not in focus is shown.
  glm::dvec3 shownAt(glm::dvec3 world) const;
  /// World positions around all that the rolled layer takes: corners of a box along u, v and a.
  std::array<glm::dvec3, 8> reach() const;

  static constexpr double hair = 1e-6;  ///< mm

  // For tests: mm, and the world directions.
  double thickness() const { return thickness_; }
  double radius() const { return radius_; }  ///< R
  double roll() const { return roll_; }      ///< c
  double halfWidth() const { return halfWidth_; }
  double halfLength() const { return halfLength_; }
  glm::dvec3 world(glm::dvec3 local) const { return origin_ + axes_ * local; }  ///< from (p, q, h)
  glm::dvec3 local(glm::dvec3 world) const { return glm::transpose(axes_) * (world - origin_); }

 private:
  glm::dmat3 axes_{1.0};  ///< columns: u, v, a
  glm::dvec3 origin_{0.0};
  double thickness_ = 0.0, radius_ = 1.0, roll_ = 0.0, halfWidth_ = 0.0, halfLength_ = 0.0;
  glm::dvec2 along_{0.0};  ///< the least and the greatest p of the volume in the layer
};

}  // namespace fenestra
