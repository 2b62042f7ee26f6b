#include "io/dicom/ContourFill.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fenestra::io {

void ContourFill::add(std::span<const glm::dvec2> polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) edges_.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
}

std::size_t ContourFill::bandOf(double v) const {
  const double band = std::floor((v - low_) / bandHeight_);
  return static_cast<std::size_t>(std::clamp(band, 0.0, static_cast<double>(starts_.size() - 2)));
}

void ContourFill::finish() {
  if (edges_.empty()) return;
  low_ = edges_.front().from.y;
  double high = low_, heights = 0.0;
  for (const Edge& edge : edges_) {
    low_ = std::min(low_, edge.from.y);
    high = std::max(high, edge.from.y);
    heights += std::abs(edge.to.y - edge.from.y) + 2.0 * tolerance_;
  }
  low_ -= tolerance_;
  high += tolerance_;
  // As many bands as leave an edge in two of them on average, so that memory is bounded by the number of edges.
  const double most = static_cast<double>(edges_.size()) * (high - low_) / heights;
  const auto bands = static_cast<std::size_t>(std::clamp(most, 1.0, static_cast<double>(edges_.size())));
  bandHeight_ = (high - low_) / static_cast<double>(bands);
  starts_.assign(bands + 1, 0);
  const auto forEachBand = [&](auto&& visit) {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const auto [least, greatest] = std::minmax(edges_[i].from.y, edges_[i].to.y);
      for (std::size_t band = bandOf(least - tolerance_); band <= bandOf(greatest + tolerance_); ++band) visit(band, i);
    }
  };
  forEachBand([&](std::size_t band, std::size_t) { ++starts_[band + 1]; });
  for (std::size_t band = 0; band < bands; ++band) starts_[band + 1] += starts_[band];
  members_.resize(starts_.back());
  std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
  forEachBand([&](std::size_t band, std::size_t edge) { members_[next[band]++] = edge; });
}

void ContourFill::stretches(double v, std::vector<Stretch>& into) const {
  into.clear();
  if (edges_.empty() || v < low_ || v > low_ + bandHeight_ * static_cast<double>(starts_.size() - 1)) return;
  thread_local std::vector<double> crossings;
  crossings.clear();
  const std::size_t band = bandOf(v);
  for (std::size_t i = starts_[band]; i < starts_[band + 1]; ++i) {
    // Not a structured binding: Clang captures none in lambdas before version 16.
    const glm::dvec2 from = edges_[members_[i]].from, to = edges_[members_[i]].to;
    const auto at = [&](double height) { return from.x + (height - from.y) / (to.y - from.y) * (to.x - from.x); };
    // Half open: a vertex on the line counts once.
    if ((from.y <= v) != (to.y <= v)) crossings.push_back(at(v));
    // The part of the edge that lies on the line, give or take the tolerance.
    const auto [least, greatest] = std::minmax(from.y, to.y);
    const double bottom = std::max(least, v - tolerance_), top = std::min(greatest, v + tolerance_);
    if (bottom > top) continue;
    const bool level = greatest - least <= 0.0;
    const double a = level ? from.x : at(bottom), b = level ? to.x : at(top);
    into.push_back({std::min(a, b) - tolerance_, std::max(a, b) + tolerance_});
  }
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) into.push_back({crossings[i], crossings[i + 1]});
  std::sort(into.begin(), into.end(), [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
  std::size_t last = 0;
  for (std::size_t i = 1; i < into.size(); ++i) {
    if (into[i].begin <= into[last].end)
      into[last].end = std::max(into[last].end, into[i].end);
    else
      into[++last] = into[i];
  }
  if (!into.empty()) into.resize(last + 1);
}

double ContourFill::edgesPerLine() const {
  return starts_.size() < 2 ? 0.0 : static_cast<double>(members_.size()) / static_cast<double>(starts_.size() - 1);
}

}  // namespace fenestra::io
