// Outlines of masks: closed, smooth, and where the mask's edge is.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include "rendering/volume/Outline.h"

namespace fenestra::outlineTest {
namespace {

using Loops = std::vector<std::vector<glm::dvec2>>;

template <class F>
Loops outlinesOf(int width, int height, F&& isInside) {
  std::vector<char> inside;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) inside.push_back(isInside(glm::dvec2(x, y)));
  return smoothOutlines(inside, width, height);
}

double areaOf(const std::vector<glm::dvec2>& loop) {
  double twice = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const glm::dvec2 a = loop[i], b = loop[(i + 1) % loop.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

TEST(Outline, ADiscsOutlineIsACircle) {
  const glm::dvec2 centre(30.3, 29.6);
  for (const double radius : {6.2, 14.7, 25.1}) {
    const Loops loops = outlinesOf(64, 60, [&](glm::dvec2 pixel) { return glm::distance(pixel, centre) <= radius; });
    ASSERT_EQ(loops.size(), 1u);
    double greatest = 0.0, sharpest = 0.0;
    const auto& loop = loops[0];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      greatest = std::max(greatest, std::abs(glm::distance(loop[i], centre) - radius));
      const glm::dvec2 a = loop[(i + 1) % loop.size()] - loop[i];
      const glm::dvec2 b = loop[(i + 2) % loop.size()] - loop[(i + 1) % loop.size()];
      sharpest = std::max(sharpest, std::acos(std::clamp(glm::dot(a, b) / glm::length(a) / glm::length(b), -1.0, 1.0)));
    }
    // The pixels' own edges are up to 0.7 off, and turn by 90°. A circle of this radius turns by up to 57° / radius
    // from one point to the next.
    EXPECT_LT(greatest, 0.55) << radius;
    EXPECT_LT(glm::degrees(sharpest), 30.0) << radius;
    EXPECT_NEAR(std::abs(areaOf(loop)), glm::pi<double>() * radius * radius,
                0.03 * glm::pi<double>() * radius * radius);
  }
}

TEST(Outline, AStraightEdgeIsStraight) {
  // A slope of one in four: steps of four pixels.
  const Loops loops = outlinesOf(80, 60, [](glm::dvec2 pixel) { return pixel.y > 20.0 + 0.25 * pixel.x; });
  ASSERT_EQ(loops.size(), 1u);
  double least = 1.0, greatest = -1.0;
  for (const glm::dvec2 point : loops[0])
    if (point.x > 10.0 && point.x < 70.0 && point.y < 45.0) {
      const double off = (point.y - 20.0 - 0.25 * point.x) / std::hypot(1.0, 0.25);
      least = std::min(least, off);
      greatest = std::max(greatest, off);
    }
  EXPECT_GT(greatest, least);
  EXPECT_LT(greatest - least, 0.35) << "steps of a whole pixel before";
}

TEST(Outline, EveryPartAndHoleHasItsLine) {
  EXPECT_TRUE(outlinesOf(9, 9, [](glm::dvec2) { return false; }).empty());
  EXPECT_EQ(outlinesOf(9, 9, [](glm::dvec2) { return true; }).size(), 1u) << "around the whole picture";
  EXPECT_EQ(outlinesOf(9, 9, [](glm::dvec2 p) { return p == glm::dvec2(4, 4); }).size(), 1u) << "a pixel";
  EXPECT_EQ(outlinesOf(9, 9, [](glm::dvec2 p) { return p == glm::dvec2(4, 4) || p == glm::dvec2(5, 5); }).size(), 2u);
  const Loops ring = outlinesOf(30, 30, [](glm::dvec2 p) {
    const double from = glm::distance(p, glm::dvec2(15.0));
    return from > 6.0 && from < 11.0;
  });
  ASSERT_EQ(ring.size(), 2u);
  EXPECT_LT(areaOf(ring[0]) * areaOf(ring[1]), 0.0) << "a hole runs the other way round";
}

TEST(Outline, AThinPartStays) {
  const Loops loops = outlinesOf(40, 9, [](glm::dvec2 p) { return p.y == 4.0 && p.x >= 5.0 && p.x <= 30.0; });
  ASSERT_EQ(loops.size(), 1u);
  // One pixel high and 26 wide; only the ends are rounded.
  EXPECT_NEAR(std::abs(areaOf(loops[0])), 26.0, 2.0);
}

}  // namespace
}  // namespace fenestra::outlineTest
