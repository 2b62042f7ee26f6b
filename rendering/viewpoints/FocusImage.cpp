#include "rendering/viewpoints/FocusImage.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "rendering/viewpoints/ViewChannel.h"

namespace fenestra::placement {
namespace {

using Outline = std::vector<glm::dvec2>;

/// Bins of the histogram of depths.
constexpr int depthBins = 32;

double lengthOf(const Outline& outline) {
  double length = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    length += glm::distance(outline[i], outline[(i + 1) % outline.size()]);
  return length;
}

/// Samples an outline anew, in equal steps of about a pixel.
Outline inEqualSteps(const Outline& outline, double length) {
  const auto count = static_cast<std::size_t>(std::lround(length));
  const double step = length / static_cast<double>(count);
  Outline even;
  double passed = 0.0;  // of the outline, before the present edge
  for (std::size_t i = 0; i < outline.size() && even.size() < count; ++i) {
    const glm::dvec2 from = outline[i], to = outline[(i + 1) % outline.size()];
    const double edge = glm::distance(from, to);
    for (double next = step * static_cast<double>(even.size()); next < passed + edge && even.size() < count;
         next = step * static_cast<double>(even.size()))
      even.push_back(glm::mix(from, to, (next - passed) / edge));
    passed += edge;
  }
  return even;
}

Outline smoothed(const Outline& outline, double smoothing) {
  const int reach = static_cast<int>(std::ceil(3.0 * smoothing)), count = static_cast<int>(outline.size());
  Outline smooth;
  for (int i = 0; i < count; ++i) {
    glm::dvec2 sum(0.0);
    double weights = 0.0;
    for (int away = -reach; away <= reach; ++away) {
      const double weight = std::exp(-0.5 * away * away / (smoothing * smoothing));
      sum += weight * outline[static_cast<std::size_t>(((i + away) % count + count) % count)];
      weights += weight;
    }
    smooth.push_back(sum / weights);
  }
  return smooth;
}

}  // namespace

bool FocusImage::sees(glm::ivec2 at) const { return !std::isnan(depth[offset(at)]); }

std::vector<Outline> outlinesOf(const FocusImage& image) {
  // Each crossed edge between two pixels, by its number: the edge at which the outline crosses next, with the pixels
  // that see the focus on one side. Edge 2·pixel runs to the right, 2·pixel + 1 down.
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> next(2 * image.depth.size(), none);
  constexpr std::array<glm::ivec2, 4> around{glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(1, 1), glm::ivec2(0, 1)};
  for (int y = 0; y + 1 < image.size.y; ++y)
    for (int x = 0; x + 1 < image.size.x; ++x) {
      const glm::ivec2 cell(x, y);
      std::array<bool, 4> sees;
      for (std::size_t i = 0; i < 4; ++i) sees[i] = image.sees(cell + around[i]);
      const auto edge = [&](std::size_t i) {  // from corner i to the next one; it belongs to its upper or left end
        return 2 * image.offset(cell + around[i < 2 ? i : (i + 1) % 4]) + i % 2;
      };
      for (std::size_t leaves = 0; leaves < 4; ++leaves) {
        if (!sees[leaves] || sees[(leaves + 1) % 4]) continue;
        std::size_t enters = (leaves + 1) % 4;
        while (sees[enters] || !sees[(enters + 1) % 4]) enters = (enters + 1) % 4;
        next[edge(leaves)] = edge(enters);
      }
    }
  const auto crossing = [&](std::size_t edge) {
    const std::size_t pixel = edge / 2, width = static_cast<std::size_t>(image.size.x);
    const glm::dvec2 from(static_cast<double>(pixel % width), static_cast<double>(pixel / width));
    return edge % 2 == 0 ? from + glm::dvec2(image.right[pixel], 0.0) : from + glm::dvec2(0.0, image.below[pixel]);
  };
  std::vector<Outline> outlines;
  for (std::size_t first = 0; first < next.size(); ++first) {
    if (next[first] == none) continue;
    Outline outline;
    for (std::size_t edge = first; next[edge] != none;) {
      outline.push_back(crossing(edge));
      const std::size_t following = next[edge];
      next[edge] = none;
      edge = following;
    }
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

double lengthOf(const std::vector<Outline>& outlines, double pixel) {
  double length = 0.0;
  for (const Outline& outline : outlines) length += pixel * lengthOf(outline);
  return length;
}

double turningOf(const std::vector<Outline>& outlines, double smoothing) {
  double turning = 0.0;
  for (const Outline& outline : outlines) {
    const double length = lengthOf(outline);
    if (length < 6.0 * smoothing) continue;
    const Outline smooth = smoothed(inEqualSteps(outline, length), smoothing);
    for (std::size_t i = 0; i < smooth.size(); ++i) {
      const glm::dvec2 at = smooth[(i + 1) % smooth.size()];
      const glm::dvec2 before = at - smooth[i], after = smooth[(i + 2) % smooth.size()] - at;
      turning += std::abs(std::atan2(before.x * after.y - before.y * after.x, glm::dot(before, after)));
    }
  }
  return turning;
}

double depthEntropy(const FocusImage& image, double nearest, double farthest) {
  std::vector<double> histogram(depthBins, 0.0);
  for (const float depth : image.depth) {
    if (std::isnan(depth)) continue;
    const double bin = farthest > nearest ? (depth - nearest) / (farthest - nearest) * depthBins : 0.0;
    histogram[static_cast<std::size_t>(std::clamp(bin, 0.0, depthBins - 1.0))] += 1.0;
  }
  return entropyOf(histogram);
}

}  // namespace fenestra::placement
