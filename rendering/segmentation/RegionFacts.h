#pragma once
// What a grown region is, in numbers: its size and values, how clear its border is, and where it would leak next.

#include <cstdint>
#include <optional>
#include <vector>

#include "rendering/segmentation/RegionGrowing.h"

namespace fenestra::segmentation {

/// A region with a larger share of the body is hardly the structure that was meant: nothing opens to it by itself.
inline constexpr double largeShareOfBody = 0.15;

/// The region's volume over the body's; empty where the growth knows no body.
std::optional<double> shareOfBody(const Growth& growth, int step);

/// Whether the air around the body, or within it, was clicked.
bool isAir(const Volume& volume, glm::ivec3 voxel);

/// How sure a region is: `Clear` lies on a plateau of tolerances, which hardly change it, and on a strong edge,
/// `Fair` on one of the two. A ragged region needs a stronger edge. A region that nearly any other tolerance makes half
/// as large again or less than that is doubtful, however strong its edge is: it is a stage of a leak. So is one of more
/// than a hundredth of the body that half an octave of tolerance changes as much, or that is hardly clearer than
/// another region at the click, and one that goes on from a thin part at the click into thicker ones. A tube is
/// doubtful where it is flat, a bone where its neighbours with it are much clearer. Nothing opens to a doubtful region
/// by itself.
enum class Border : std::uint8_t { Doubtful, Fair, Clear };

struct RegionFacts {
  double volume = 0.0;                 ///< mm³
  double mean = 0.0, deviation = 0.0;  ///< real values: mean and standard deviation of the voxels
  double contrast = 0.0;               ///< real values: how far they change across the border, on average
  std::optional<Border> border;        ///< empty where the region is only painted
  bool isPassing = false;              ///< nearly any other tolerance makes it half as large again, or less than that
  bool isRivalled = false;             ///< another region at the click, of another size, is nearly as clear
  bool sprawls = false;                ///< it goes on from a thin part at the click into thicker ones
  bool isFlat = false;                 ///< it is a tube that is no round vessel, but wide and thin
  /// The next cliff of the curve.
  struct Leak {
    double tolerance = 0.0;   ///< real values: the least that leaks
    double volume = 0.0;      ///< mm³: the region's then
    glm::dvec3 towards{0.0};  ///< unit vector, world, to the middle of what joins; 0: on all sides
  };
  std::optional<Leak> leak;
};

/// Sums over the voxels of each step of a growth: what any of its tolerances holds follows from them at once.
class GrowthFacts {
 public:
  /// Reads the growth's box once, on all cores.
  GrowthFacts(const Volume& volume, const Growth& growth);

  RegionFacts at(const Growth& growth, int step) const;

 private:
  struct Sums {
    double voxels = 0.0, value = 0.0, square = 0.0;  ///< values less reference_
    glm::dvec3 place{0.0};                           ///< sum of index positions
    void add(const Sums& other);
  };
  /// The sums over the voxels that join in steps (after, upTo].
  Sums between(int after, int upTo) const;
  std::optional<RegionFacts::Leak> leakAfter(const Growth& growth, int step) const;

  Grid grid_;
  double reference_ = 0.0;
  std::vector<Sums> sums_;  ///< by step
};

}  // namespace fenestra::segmentation
