#include "rendering/viewpoints/ViewChannel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace fenestra::placement {
namespace {

/// p log₂(p / q), which is 0 at p = 0.
double informationOf(double p, double q) { return p > 0.0 ? p * std::log2(p / q) : 0.0; }

}  // namespace

double entropyOf(const std::vector<double>& weights) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (!(sum > 0.0)) return undefined;
  double entropy = 0.0;
  for (const double weight : weights) entropy -= informationOf(weight / sum, 1.0);
  return std::max(entropy, 0.0);  // of a single element, it is not -0
}

ViewChannel::ViewChannel(std::vector<std::vector<double>> areas)
    : given_(std::move(areas)), elementShares_(given_.empty() ? 0 : given_.front().size(), 0.0) {
  double all = 0.0;
  for (std::vector<double>& row : given_) {
    const double area = std::accumulate(row.begin(), row.end(), 0.0);
    viewShares_.push_back(area);
    all += area;
    for (std::size_t z = 0; z < row.size(); ++z) elementShares_[z] += row[z];
    if (area > 0.0)
      for (double& share : row) share /= area;
  }
  if (!(all > 0.0)) return;
  for (double& share : viewShares_) share /= all;
  for (double& share : elementShares_) share /= all;
  elementEntropy_ = entropyOf(elementShares_);
}

double ViewChannel::entropy(std::size_t view) const { return entropyOf(given_[view]); }

double ViewChannel::mutualInformation(std::size_t view) const {
  if (!(viewShares_[view] > 0.0)) return undefined;
  double information = 0.0;
  for (std::size_t z = 0; z < elementCount(); ++z) information += informationOf(given_[view][z], elementShares_[z]);
  return information;
}

double ViewChannel::specificInformation(std::size_t view) const { return elementEntropy_ - entropy(view); }

double ViewChannel::divergence(std::size_t a, std::size_t b) const {
  const double both = viewShares_[a] + viewShares_[b];
  if (!(viewShares_[a] > 0.0) || !(viewShares_[b] > 0.0)) return 0.0;
  const double ofA = viewShares_[a] / both, ofB = viewShares_[b] / both;
  double divergence = 0.0;
  for (std::size_t z = 0; z < elementCount(); ++z) {
    const double inA = given_[a][z], inB = given_[b][z], mixed = ofA * inA + ofB * inB;
    divergence += ofA * informationOf(inA, mixed) + ofB * informationOf(inB, mixed);
  }
  return std::clamp(divergence, 0.0, 1.0);
}

}  // namespace fenestra::placement
