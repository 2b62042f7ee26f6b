#pragma once
// What views show of a surface, as an information channel from views V to elements Z of the surface (Feixas, Sbert,
// González: A unified information-theoretic framework for viewpoint selection and mesh saliency. ACM Transactions on
// Applied Perception 6(1), 2009).

#include <limits>
#include <vector>

namespace fenestra::placement {

/// What a view that sees nothing has in the place of a number.
inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// With a_z(v) the visible projected area of element z in view v and a(v) = Σ_z a_z(v):
///
///     p(v) = a(v) / Σ_w a(w)      p(z|v) = a_z(v) / a(v)      p(z) = Σ_v p(v) p(z|v)
///
/// Values are in bits. A view that sees nothing has p(v) = 0, and its values are NaN.
class ViewChannel {
 public:
  /// `areas[v][z]` ≥ 0, in any unit; all rows are equally long.
  explicit ViewChannel(std::vector<std::vector<double>> areas);

  std::size_t viewCount() const { return given_.size(); }
  std::size_t elementCount() const { return elementShares_.size(); }
  /// p(v).
  double viewShare(std::size_t view) const { return viewShares_[view]; }
  /// p(z|v); 0 for all elements of a view that sees nothing.
  double given(std::size_t view, std::size_t element) const { return given_[view][element]; }

  /// H(Z|v) = −Σ_z p(z|v) log₂ p(z|v), from 0 to the logarithm of the number of elements.
  double entropy(std::size_t view) const;
  /// I(v;Z) = Σ_z p(z|v) log₂(p(z|v) / p(z)) ≥ 0, 0 where the view shows what all views together show.
  double mutualInformation(std::size_t view) const;
  /// I2(v;Z) = H(Z) − H(Z|v); may be negative.
  double specificInformation(std::size_t view) const;
  /// The Jensen–Shannon divergence of two views, weighted by p(v), from 0 to 1; 0 where one of them sees nothing.
  double divergence(std::size_t a, std::size_t b) const;

 private:
  std::vector<std::vector<double>> given_;
  std::vector<double> viewShares_, elementShares_;
  double elementEntropy_ = 0.0;  ///< H(Z)
};

/// −Σ p log₂ p of `weights` over their sum, in bits; NaN where the sum is 0.
double entropyOf(const std::vector<double>& weights);

}  // namespace fenestra::placement
