#include "rendering/viewpoints/Choice.h"

#include <algorithm>
#include <cmath>

namespace fenestra::placement {
namespace {

/// Relative differences of quality below this are noise of the images' pixels.
constexpr double indistinct = 1e-3;

/// The spread candidates from `first` on.
std::vector<Candidate> spreadOf(const Measured& measured, std::size_t first) {
  const auto begin = measured.candidates.begin();
  return {begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(measured.spread)};
}

double shareOf(const Measured& measured, const Placement& placement) {
  const Candidate& first = measured.candidates[*placement.c1];
  return seenShare(first, placement.c2 ? measured.candidates[*placement.c2] : first, measured.surfacePoints);
}

}  // namespace

Placement chooseDual(const Measured& measured, glm::dvec3 c1, const Options& options) {
  Placement placement;
  placement.c2 = dualView(spreadOf(measured, 0), c1, options);
  if (!placement.c2) placement.note = "no candidate in the region of C1 sees the focus";
  return placement;
}

Placement choose(const Measured& measured, const Options& options, bool joint) {
  Placement placement;
  const std::size_t first = measured.refinedFor == options ? measured.coarser : 0;
  const std::vector<Candidate> eligible = spreadOf(measured, first);
  placement.c1 = bestView(eligible, options);
  if (!placement.c1) {
    placement.note = "no candidate sees the focus: it is empty";
    return placement;
  }
  *placement.c1 += first;
  if (joint) {
    if (const auto pair = jointSearch(measured.candidates, measured.surfacePoints, options)) {
      placement.c1 = pair->c1;
      placement.c2 = pair->c2;
    }
  } else {
    placement.c2 = dualView(eligible, measured.candidates[*placement.c1].direction, options);
    if (placement.c2) *placement.c2 += first;
  }
  if (!placement.c2) placement.note = "no candidate in the region of C1 sees the focus";
  placement.share = shareOf(measured, placement);

  double least = 1e300, greatest = -1e300;
  Weights ofFocus = options.weights;
  ofFocus.orientation = 0.0;  // which breaks ties, but is the same for every focus
  for (std::size_t i = 0; i < measured.spread; ++i) {
    const double q = quality(measured.candidates[i].descriptors, ofFocus);
    least = std::min(least, q);
    greatest = std::max(greatest, q);
  }
  if (greatest - least <= indistinct * std::max(std::abs(greatest), std::abs(least)))
    placement.note = "the focus looks the same from everywhere: no direction shows more than another";
  else if (measured.surfacePoints == 0 && placement.c2)
    placement.note = "the focus fills the volume: it has no surface of which a share could be seen";
  return placement;
}

}  // namespace fenestra::placement
