#pragma once
// Differences between a picture's colours and the truth, and distributions of numbers.

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

namespace fenestra::bench {

/// Numbers whose percentiles are asked for. Anything that is no number counts as infinite.
class Distribution {
 public:
  void add(double value);
  void add(const Distribution& other);
  std::size_t count() const { return values_.size(); }
  /// `percent` 0..100, the nearest rank above; 0 of nothing.
  double percentile(double percent) const;
  double median() const { return percentile(50.0); }
  double max() const { return percentile(100.0); }
  std::size_t countAbove(double limit) const;
  double rms() const;

 private:
  mutable std::vector<double> values_;
  mutable bool sorted_ = true;
};

/// Errors of a picture's pixels. Those where neither picture shows anything would only dilute the percentiles: they are
/// left out.
struct ColourErrors {
  Distribution channel;  ///< the worst channel of each pixel, in 1/255
  Distribution squares;  ///< root mean square over the three channels of each pixel, in 1/255
  Distribution deltaE;   ///< ΔE*ab (CIE 1976) of each pixel, its colours taken for sRGB

  /// Premultiplied RGBA over `background`.
  void add(glm::dvec4 here, glm::dvec4 truth, glm::dvec3 background);
  void add(const ColourErrors& other);
};

}  // namespace fenestra::bench
