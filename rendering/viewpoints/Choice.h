#pragma once
// The cameras chosen among measured candidates. Choosing costs no rendering, so another weight, region or C1 is
// answered at once.

#include <optional>
#include <string>
#include <vector>

#include "rendering/viewpoints/Placement.h"
#include "rendering/viewpoints/ScanShape.h"

namespace fenestra::placement {

/// Pixels across the model in a candidate's image.
inline constexpr int defaultImageSide = 128;

/// How candidates are spread.
struct Sampling {
  int count = 192;              ///< 12·nside²
  bool refined = false;         ///< refine 48 directions to the resolution of 12 288 instead
  int side = defaultImageSide;  ///< pixels across the model in a candidate's image, at least
  int surfacePoints = 1024;     ///< gives shares to about a hundredth
  bool operator==(const Sampling&) const = default;
};

/// The cameras chosen among measured candidates; indices into Measured::candidates.
struct Placement {
  std::optional<std::size_t> c1, c2;
  double share = 0.0;  ///< of the focus's surface that at least one of the two sees
  std::string note;    ///< why there is no answer, or none that stands out; empty otherwise
};

/// The measured candidates of one focus: the spread ones, then the six standard views.
struct Measured {
  std::vector<Candidate> candidates;
  std::size_t coarser = 0;  ///< refined: how many at the front are of coarser levels
  /// The options that guided a refinement. By these choose() considers the finest level alone, as an exhaustive search
  /// would; by others, all candidates.
  std::optional<Options> refinedFor;
  std::size_t spread = 0;  ///< number of spread candidates; the standard views serve comparisons and the joint search
  std::size_t surfacePoints = 0;
  std::vector<std::uint16_t> pointLabels;  ///< of the surface points, where the focus is labels; else empty
  double surfaceArea = 0.0;                ///< mm²
  ScanShape scan;
};

/// In the paper's order: the best view, then the best view of its region. With `joint` both at once (jointSearch), the
/// standard views included. Needs no rendering. A focus that looks the same from everywhere gets a
/// note.
Placement choose(const Measured& measured, const Options& options, bool joint);
/// C2 for a C1 anywhere on the sphere.
Placement chooseDual(const Measured& measured, glm::dvec3 c1, const Options& options);

}  // namespace fenestra::placement
