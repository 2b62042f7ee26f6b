#pragma once
// The cameras chosen among measured candidates. Choosing costs no rendering, so another weight, region or C1 is
// answered at once.

#include <optional>
#include <string>
#include <vector>

#include "rendering/viewpoints/Placement.h"

namespace fenestra::placement {

/// Pixels across the model in a candidate's image.
inline constexpr int defaultImageSide = 128;

/// How candidates are spread.
struct Sampling {
  int count = 192;              ///< 12·nside²
  bool refined = false;         ///< instead: hierarchically from 48 to the resolution of 12 288
  int side = defaultImageSide;  ///< pixels across the model in a candidate's image, at least
  int surfacePoints = 1024;     ///< shares are known to about a hundredth by so many
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
  std::size_t coarser = 0;  ///< refined: the first ones, which only led the way
  /// Refined for these: by them choose() takes finest ones, as trying all would; by others, whatever is best.
  std::optional<Options> refinedFor;
  std::size_t spread = 0;  ///< how many of them are spread; the standard views serve comparisons and the joint search
  std::size_t surfacePoints = 0;
  double surfaceArea = 0.0;  ///< mm²
};

/// The paper's order: the best view, then the best of its region. `joint`: both at once (jointSearch), the standard
/// views among the candidates. Costs no rendering. A focus that looks the same from everywhere gets the first direction
/// and a note.
Placement choose(const Measured& measured, const Options& options, bool joint);
/// C2 for a C1 anywhere on the sphere.
Placement chooseDual(const Measured& measured, glm::dvec3 c1, const Options& options);

}  // namespace fenestra::placement
