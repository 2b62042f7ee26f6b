#include "rendering/volume/Outline.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace fenestra {
namespace {

/// Sides of a cell between four pixel centres: above, to the right, below, to the left.
enum CellSide : int { Top, Right, Bottom, Left };

/// From one side of a cell to another, with the inside on the same hand everywhere, so that the lines of neighbouring
/// cells meet head to tail.
struct Segment {
  int from = -1, to = -1;
};

/// The segments of a cell by its corners inside: bit 0 top left, 1 top right, 2 bottom right, 3 bottom left. Two
/// corners across stay apart.
constexpr std::array<std::array<Segment, 2>, 16> cellSegments{{
    {},
    {{{Left, Top}, {}}},
    {{{Top, Right}, {}}},
    {{{Left, Right}, {}}},
    {{{Right, Bottom}, {}}},
    {{{Left, Top}, {Right, Bottom}}},
    {{{Top, Bottom}, {}}},
    {{{Left, Bottom}, {}}},
    {{{Bottom, Left}, {}}},
    {{{Bottom, Top}, {}}},
    {{{Top, Right}, {Bottom, Left}}},
    {{{Bottom, Right}, {}}},
    {{{Right, Left}, {}}},
    {{{Right, Top}, {}}},
    {{{Top, Left}, {}}},
    {},
}};

/// Crossings of the mask's edge with the lines between neighbouring pixel centres, a frame of outside pixels included.
class Crossings {
 public:
  Crossings(const std::vector<char>& inside, int width, int height)
      : width_(width), height_(height), next_(std::size_t{2} * columns() * rows(), -1) {
    std::vector<char> above(columns(), 0), below(columns(), 0);  // rows of pixels with one outside at either end
    for (int y = -1; y < height; ++y) {
      std::swap(above, below);
      if (y + 1 < height)
        std::copy_n(inside.begin() + static_cast<std::ptrdiff_t>(y + 1) * width, width, below.begin() + 1);
      else
        std::fill(below.begin(), below.end(), char{0});
      for (std::size_t column = 0; column <= static_cast<std::size_t>(width); ++column) {
        const int corners = above[column] | above[column + 1] << 1 | below[column + 1] << 2 | below[column] << 3;
        if (corners == 0 || corners == 15) continue;
        const int x = static_cast<int>(column) - 1;
        for (const Segment& segment : cellSegments[static_cast<std::size_t>(corners)])
          if (segment.from >= 0) next_[index(x, y, segment.from)] = static_cast<std::int32_t>(index(x, y, segment.to));
      }
    }
  }

  std::vector<std::vector<glm::dvec2>> takeLoops() {
    std::vector<std::vector<glm::dvec2>> loops;
    for (std::size_t start = 0; start < next_.size(); ++start) {
      if (next_[start] < 0) continue;
      std::vector<glm::dvec2>& loop = loops.emplace_back();
      for (std::size_t now = start; next_[now] >= 0;) {
        loop.push_back(place(now));
        const std::int32_t next = next_[now];
        next_[now] = -1;
        now = static_cast<std::size_t>(next);
      }
    }
    return loops;
  }

 private:
  std::size_t columns() const { return static_cast<std::size_t>(width_) + 2; }
  std::size_t rows() const { return static_cast<std::size_t>(height_) + 2; }
  /// Number of a side of the cell whose top left corner is pixel (x, y): twice the number of the pixel at which the
  /// side starts, plus one where the side runs down.
  std::size_t index(int x, int y, int side) const {
    const auto column = static_cast<std::size_t>(x + 1 + (side == Right)),
               row = static_cast<std::size_t>(y + 1 + (side == Bottom));
    return 2 * (row * columns() + column) + (side == Left || side == Right);
  }
  glm::dvec2 place(std::size_t index) const {
    const std::size_t pixel = index / 2;
    const glm::dvec2 start(static_cast<double>(pixel % columns()) - 1.0, static_cast<double>(pixel / columns()) - 1.0);
    return start + (index % 2 ? glm::dvec2(0.0, 0.5) : glm::dvec2(0.5, 0.0));
  }

  int width_, height_;
  std::vector<std::int32_t> next_;  ///< the crossing after each; -1: none
};

/// Moves every point towards the middle of its neighbours by a share; a negative share moves it away.
void relax(std::vector<glm::dvec2>& loop, double share, std::vector<glm::dvec2>& scratch) {
  const std::size_t count = loop.size();
  scratch.resize(count);
  glm::dvec2 before = loop.back();
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec2 middle = 0.5 * (before + loop[i + 1 < count ? i + 1 : 0]);
    scratch[i] = loop[i] + share * (middle - loop[i]);
    before = loop[i];
  }
  loop.swap(scratch);
}

void smooth(std::vector<glm::dvec2>& loop) {
  // Pass band and gain as Taubin proposes (k = 0.1): steps of a few pixels go, bends of ten stay.
  constexpr double towards = 0.5, away = -0.526;
  constexpr int rounds = 8;
  constexpr double most = 0.5;  // pixels
  const std::vector<glm::dvec2> from = loop;
  std::vector<glm::dvec2> scratch;
  for (int round = 0; round < rounds; ++round) {
    relax(loop, towards, scratch);
    relax(loop, away, scratch);
  }
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const glm::dvec2 moved = loop[i] - from[i];
    const double length = glm::length(moved);
    if (length > most) loop[i] = from[i] + moved * (most / length);
  }
}

}  // namespace

std::vector<std::vector<glm::dvec2>> smoothOutlines(const std::vector<char>& inside, int width, int height) {
  std::vector<std::vector<glm::dvec2>> loops = Crossings(inside, width, height).takeLoops();
  for (std::vector<glm::dvec2>& loop : loops) smooth(loop);
  return loops;
}

}  // namespace fenestra
