#pragma once
// Parallel planes at uneven distances, each of which stands for the slab around it.

#include <vector>

namespace fenestra::io {

/// A slab reaches half a step to each side of its plane, but not beyond the middle to the next plane. Gaps of up to one
/// and a half steps are unevenness and closed; wider ones are planes that hold nothing and were left out.
class Slabs {
 public:
  /// `positions` along the normal in mm, ascending; `step` > 0 is the usual distance in mm.
  Slabs(std::vector<double> positions, double step);
  /// Index of the plane whose slab holds the position, or -1.
  int at(double position) const;

 private:
  std::vector<double> positions_, low_, high_;
};

/// The middle one of the distances between neighbours; 0 for fewer than two positions, which must ascend.
double usualGap(const std::vector<double>& positions);

}  // namespace fenestra::io
