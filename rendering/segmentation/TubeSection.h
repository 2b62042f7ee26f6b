#pragma once
// The cross-section of a tube (a vessel, a duct) in a plane: where its wall is, and how clearly.
//
// Rays leave a point of the plane to all sides. The wall on each ray is where the values leave the tube's own the most,
// no matter to which side: blood borders on fat and on bone. All walls are found at once as the closed contour with the
// greatest sum of such rises less a price for uneven radii (dynamic programming round the circle), so that where the
// tube touches tissue of its own density the contour goes straight on between the walls on both sides. That the
// evidence is gathered from the whole circle is the idea of medialness: K. Krissian, G. Malandain, N. Ayache et al.,
// Model-based detection of tubular structures in 3D images, Computer Vision and Image Understanding 80(2), 2000; S. R.
// Aylward, E. Bullitt, Initialization, noise, singularities, and scale in height ridge traversal for tubular object
// centerline extraction, IEEE Transactions on Medical Imaging 21(2), 2002. The formulas are the program's own.

#include <array>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "rendering/segmentation/Smoothing.h"
#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

/// Positions and lengths are mm in the world.
struct TubeSection {
  static constexpr int rays = 32;
  using Radii = std::array<double, rays>;

  glm::dvec3 centre{0.0};
  glm::dvec3 normal{0.0, 0.0, 1.0}, right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0};  ///< unit vectors; ray 0 goes right
  Radii contour{};       ///< where the evidence for a wall is greatest
  Radii wall{};          ///< half-way between the values on both sides of it: what the tube holds
  double support = 0.0;  ///< the share of rays whose wall is seen
  double rise = 0.0;     ///< the mean rise at the walls, units of the noise, 0 … SectionFinder::mostRise
  double unlike = 0.0;   ///< the mean difference of the values within from the tube's own, in the same units

  double area() const;    ///< mm²
  double radius() const;  ///< of the circle of that area
  glm::dvec3 middle() const;
  /// The long axis of what the wall encloses over its short one, from its second moments (Green's
  /// theorem): 1 of a circle, infinite of a line.
  double aspect() const;
  /// The contour as seen from another point of the plane, nearby.
  Radii contourFrom(glm::dvec3 point) const;
  /// Turned to look along -normal.
  TubeSection reversed() const;
  /// In the plane through `centre` across the unit vector `normal`, with the rays turned as little as can be.
  TubeSection movedTo(glm::dvec3 centre, glm::dvec3 normal) const;
};

/// Finds cross-sections of the tube at a seed.
class SectionFinder {
 public:
  static constexpr double mostRise = 4.0;  ///< units of the noise: a sharper edge is no better

  /// `seed` lies in the volume, which outlives this.
  SectionFinder(const Volume& volume, const Noise& noise, glm::ivec3 seed);

  /// The section in the plane of `plane`, about its centre. `expected`: radii that it should not differ from much,
  /// which limits how fast a tube may widen; null without any.
  TubeSection find(const TubeSection& plane, const TubeSection::Radii* expected = nullptr);
  /// The section about its own middle, which is looked for from the centre of `plane`.
  TubeSection centred(const TubeSection& plane, const TubeSection::Radii* expected, int rounds);

  bool contains(glm::dvec3 point) const;  ///< whether a point of the world lies in the volume
  double side() const { return side_; }   ///< mm: voxelSide() of the volume
  double largestRadius() const { return step_ * most_; }

 private:
  void sample(const TubeSection& plane, const TubeSection::Radii* expected);
  void rate(const TubeSection::Radii* expected);
  std::array<int, TubeSection::rays> bestContour();
  double wallAt(int ray, int place) const;
  float& score(int ray, int place) { return scores_[static_cast<std::size_t>(ray * count_ + place)]; }
  double apart(int ray, int place) const { return apart_[static_cast<std::size_t>(ray * count_ + place)]; }
  double radiusAt(int place) const { return (place + 1) * step_; }

  const Volume& volume_;
  glm::dmat4 toIndex_;
  double side_, step_;         ///< mm; samples lie at (i + ½) · step_ on a ray, and walls at (i + 1) · step_
  int most_, count_;           ///< samples on a ray: at most, and in this section
  int window_;                 ///< samples on either side of a wall that are compared
  double own_ = 0.0;           ///< the tube's value, real
  double unit_ = 1.0;          ///< of differences: the noise, real values
  std::vector<float> apart_;   ///< by ray and sample: difference from the tube's value, units of the noise
  std::vector<float> rises_;   ///< by ray and wall
  std::vector<float> scores_;  ///< by ray and wall
  std::vector<float> sums_, next_;
  std::vector<signed char> origins_;
};

}  // namespace fenestra::segmentation
