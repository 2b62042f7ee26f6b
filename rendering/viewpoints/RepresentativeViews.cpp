#include "rendering/viewpoints/RepresentativeViews.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>

namespace fenestra::placement {
namespace {

double angleBetween(glm::dvec3 a, glm::dvec3 b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

/// What a view adds to those that see the elements in `seen`.
double gainOf(const ViewChannel& channel, std::size_t view, const std::vector<bool>& seen) {
  double gain = 0.0;
  for (std::size_t z = 0; z < seen.size(); ++z)
    if (const double p = channel.given(view, z); p > 0.0 && !seen[z]) gain -= p * std::log2(p);
  return gain;
}

double countOf(const std::vector<bool>& seen) {
  return static_cast<double>(std::count(seen.begin(), seen.end(), true));
}

void see(const ViewChannel& channel, std::size_t view, std::vector<bool>& seen) {
  for (std::size_t z = 0; z < seen.size(); ++z) seen[z] = seen[z] || channel.given(view, z) > 0.0;
}

}  // namespace

RepresentativeViews representativeViews(const ViewChannel& channel, double enough, std::size_t most) {
  std::vector<bool> seen(channel.elementCount(), false), visible = seen;
  for (std::size_t view = 0; view < channel.viewCount(); ++view) see(channel, view, visible);
  RepresentativeViews chosen;
  while (chosen.views.size() < most && (chosen.views.empty() || countOf(seen) < enough * countOf(visible))) {
    std::optional<std::size_t> best;
    double greatest = 0.0;
    for (std::size_t view = 0; view < channel.viewCount(); ++view)
      if (const double gain = gainOf(channel, view, seen); gain > greatest) {
        best = view;
        greatest = gain;
      }
    if (!best) break;
    see(channel, *best, seen);
    chosen.views.push_back(*best);
    chosen.shares.push_back(countOf(seen) / static_cast<double>(seen.size()));
  }
  return chosen;
}

Tour shortestTour(const std::vector<glm::dvec3>& directions) {
  assert(directions.size() <= mostRepresentativeViews);
  Tour best;
  best.order.resize(directions.size());
  std::iota(best.order.begin(), best.order.end(), std::size_t{0});
  if (directions.size() < 2) return best;
  const auto lengthOf = [&](const std::vector<std::size_t>& order) {
    double length = 0.0;
    for (std::size_t i = 0; i < order.size(); ++i)
      length += angleBetween(directions[order[i]], directions[order[(i + 1) % order.size()]]);
    return length;
  };
  std::vector<std::size_t> order = best.order;
  best.length = lengthOf(order);
  constexpr double rounding = 1e-12;  // the same tour backwards is as long
  while (std::next_permutation(order.begin() + 1, order.end()))
    if (const double length = lengthOf(order); length < best.length - rounding) best = {order, length};
  return best;
}

}  // namespace fenestra::placement
