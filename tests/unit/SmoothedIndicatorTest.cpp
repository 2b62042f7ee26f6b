#include "rendering/scene/SmoothedIndicator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "rendering/volume/Threads.h"
#include "tests/unit/SampledIndicator.h"

namespace fenestra::tests::smoothedIndicatorTest {
namespace {

constexpr std::array<LabelSmoothing, 2> strengths{LabelSmoothing::Light, LabelSmoothing::Strong};

/// Random blobs: where smooth noise, a few voxels wide, is positive, away from the map's border.
std::vector<char> blobs(glm::ivec3 dims, unsigned seed, double waves) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  std::array<glm::dvec4, 12> terms;
  for (glm::dvec4& term : terms) term = glm::dvec4(any(random), any(random), any(random), 3.0 * any(random));
  std::vector<char> inside;
  forEachVoxel(dims, [&](glm::ivec3 at) {
    double sum = 0.3 * any(random);
    for (const glm::dvec4& term : terms) sum += std::sin(waves * glm::dot(glm::dvec3(term), glm::dvec3(at)) + term.w);
    const bool far = glm::all(glm::greaterThan(at, glm::ivec3(3))) && glm::all(glm::lessThan(at, dims - 4));
    inside.push_back(far && sum > 0.5);
  });
  return inside;
}

/// The farthest that a point of `from` is from the nearest of `to`, where that is less than two cells.
double farthest(const std::vector<glm::dvec3>& from, const std::vector<glm::dvec3>& to, glm::ivec3 dims) {
  const Grid box = gridOf(dims);
  std::vector<std::vector<glm::dvec3>> byCell(box.voxelCount());
  for (const glm::dvec3& point : to) byCell[box.offset(glm::ivec3(point))].push_back(point);
  double most = 0.0;
  for (const glm::dvec3& point : from) {
    double least = 2.0;
    forEachVoxel(glm::ivec3(5), [&](glm::ivec3 step) {
      const glm::ivec3 cell = glm::ivec3(point) + step - 2;
      if (!box.contains(cell)) return;
      for (const glm::dvec3& other : byCell[box.offset(cell)]) least = std::min(least, glm::distance(point, other));
    });
    most = std::max(most, least);
  }
  return most;
}

TEST(SmoothedIndicator, KeepsVoxelsOnTheirSide) {
  const glm::ivec3 dims(43, 38, 29);
  for (const double waves : {0.15, 0.6, 2.0}) {
    const std::vector<char> inside = blobs(dims, 11, waves);
    const Grid box = gridOf(dims);
    for (const LabelSmoothing strength : strengths) {
      const SampledIndicator smoothed(
          dims, [&](glm::ivec3 at) { return inside[box.offset(at)] != 0; }, strength);
      forEachVoxel(dims, [&](glm::ivec3 at) {
        // Not on the level either: 512 of 65535 away from it.
        ASSERT_GE(std::abs(smoothed.at(at) - 0.5), 0.0078);
        ASSERT_EQ(smoothed.at(at) > 0.5, inside[box.offset(at)] != 0);
      });
    }
  }
}

TEST(SmoothedIndicator, Thorough_MovesTheSurfaceByLessThanAVoxel) {
  const glm::ivec3 dims(28, 31, 26);
  const Grid box = gridOf(dims);
  for (const double waves : {0.15, 0.6, 2.0})
    for (const LabelSmoothing strength : strengths) {
      const std::vector<char> inside = blobs(dims, 5, waves);
      const auto insideAt = [&](glm::ivec3 at) { return inside[box.offset(at)] != 0; };
      const std::vector<glm::dvec3> before = SampledIndicator(dims, insideAt, LabelSmoothing::Off).points(3);
      const std::vector<glm::dvec3> after = SampledIndicator(dims, insideAt, strength).points(3);
      ASSERT_GT(before.size(), 1000u);
      // Points lie a third of a voxel apart, so that either distance is too large by 0.25 voxels at most.
      const double moved = std::max(farthest(after, before, dims), farthest(before, after, dims));
      std::cout << "waves " << waves << ", strength " << int(strength) << ": moved by " << moved << " voxels\n";
      EXPECT_LT(moved, 1.0);
      EXPECT_GT(moved, 0.2);  // it does move
    }
}

TEST(SmoothedIndicator, Thorough_KeepsStructuresOneVoxelThick) {
  struct Shape {
    const char* name;
    std::function<bool(glm::ivec3)> isInside;
  };
  const glm::ivec3 dims(30);
  const std::array<Shape, 6> shapes{{
      {"plate", [](glm::ivec3 p) { return p.z == 14 && glm::distance(glm::dvec3(p), glm::dvec3(14)) < 10.0; }},
      {"oblique plate",
       [](glm::ivec3 p) { return p.z == 14 + (p.x - 14) / 3 && glm::distance(glm::dvec3(p), glm::dvec3(14)) < 10.0; }},
      {"line", [](glm::ivec3 p) { return p.x == 13 && p.y == 16 && p.z > 4 && p.z < 25; }},
      {"oblique line", [](glm::ivec3 p) { return p.x == 4 + p.z / 2 && p.y == 16 && p.z > 4 && p.z < 25; }},
      {"voxel", [](glm::ivec3 p) { return p == glm::ivec3(14); }},
      {"two voxels", [](glm::ivec3 p) { return p == glm::ivec3(9) || p == glm::ivec3(20, 9, 9); }},
  }};
  for (const Shape& shape : shapes)
    for (const LabelSmoothing strength : strengths) {
      const double before = SampledIndicator(dims, shape.isInside, LabelSmoothing::Off).volume(24);
      const double after = SampledIndicator(dims, shape.isInside, strength).volume(24);
      std::cout << shape.name << ", strength " << int(strength) << ": " << before << " -> " << after << '\n';
      EXPECT_NEAR(after / before, 1.0, 0.01) << shape.name;
    }
}

TEST(SmoothedIndicator, Thorough_KeepsTheVolume) {
  for (const double radius : {2.3, 4.0, 9.5})
    for (const LabelSmoothing strength : strengths) {
      const glm::ivec3 dims(2 * static_cast<int>(radius) + 12);
      const auto ball = [&](glm::ivec3 p) {
        return glm::distance(glm::dvec3(p), glm::dvec3(0.5 * dims.x - 0.3)) < radius;
      };
      const double before = SampledIndicator(dims, ball, LabelSmoothing::Off).volume(10);
      const double after = SampledIndicator(dims, ball, strength).volume(10);
      std::cout << "ball of " << radius << ", strength " << int(strength) << ": " << after / before
                << " of the volume, " << after / (4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3))
                << " of the true one\n";
      EXPECT_NEAR(after / before, 1.0, 0.01);
    }
  const glm::ivec3 dims(31, 28, 25);
  const Grid box = gridOf(dims);
  for (const double waves : {0.15, 0.6, 2.0})
    for (const LabelSmoothing strength : strengths) {
      const std::vector<char> inside = blobs(dims, 3, waves);
      const auto insideAt = [&](glm::ivec3 at) { return inside[box.offset(at)] != 0; };
      const double ratio = SampledIndicator(dims, insideAt, strength).volume(10) /
                           SampledIndicator(dims, insideAt, LabelSmoothing::Off).volume(10);
      std::cout << "blobs of waves " << waves << ", strength " << int(strength) << ": " << ratio << '\n';
      EXPECT_NEAR(ratio, 1.0, 0.01);
    }
}

/// Mean angle in degrees between the surface's normals and the truth, and RMS distance from it in voxels.
struct SurfaceError {
  double angle = 0.0, distance = 0.0;
};
/// `normalAt` and `distanceAt`: of the true surface at a point near it; outwards.
template <class NormalAt, class DistanceAt>
SurfaceError errorOf(const SampledIndicator& sampled, NormalAt normalAt, DistanceAt distanceAt) {
  SurfaceError error;
  double count = 0.0;
  for (const glm::dvec3& point : sampled.points(3)) {
    if (glm::any(glm::lessThan(point, glm::dvec3(10.0))) ||
        glm::any(glm::greaterThan(point, glm::dvec3(sampled.dims()) - 11.0)))
      continue;  // the border's edge is no part of it
    const double cosine = -glm::dot(glm::normalize(sampled.gradient(point)), normalAt(point));
    error.angle += glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
    error.distance += std::pow(distanceAt(point), 2.0);
    ++count;
  }
  error.angle /= count;
  error.distance = std::sqrt(error.distance / count);
  return error;
}

TEST(SmoothedIndicator, ABallAndASlopeAreNearerToTheTruth) {
  const glm::dvec3 middle(29.3, 29.6, 30.1), upwards = glm::normalize(glm::dvec3(-1.0, -2.0, 13.0));
  const double radius = 15.0;
  std::array<SurfaceError, 3> ball, slope;
  for (std::size_t i = 0; i < ball.size(); ++i) {
    const auto strength = static_cast<LabelSmoothing>(i);
    const auto toBall = [&](glm::dvec3 p) { return glm::distance(p, middle) - radius; };
    const auto toSlope = [&](glm::dvec3 p) { return glm::dot(p - middle, upwards); };
    ball[i] = errorOf(
        SampledIndicator(
            glm::ivec3(60), [&](glm::ivec3 p) { return toBall(glm::dvec3(p)) < 0.0; }, strength),
        [&](glm::dvec3 p) { return glm::normalize(p - middle); }, toBall);
    slope[i] = errorOf(
        SampledIndicator(
            glm::ivec3(60), [&](glm::ivec3 p) { return toSlope(glm::dvec3(p)) < 0.0; }, strength),
        [&](glm::dvec3) { return upwards; }, toSlope);
    std::cout << "strength " << i << ": normals of a ball are off by " << ball[i].angle << "°, its surface by "
              << ball[i].distance << " voxels RMS; of a slope " << slope[i].angle << "° and " << slope[i].distance
              << '\n';
  }
  // A trilinear function's gradient jumps from cell to cell: on a ball of 15 voxels by 4°.
  EXPECT_LT(ball[1].angle, 0.15 * ball[0].angle);
  EXPECT_LT(ball[2].angle, 0.15 * ball[0].angle);
  EXPECT_LT(ball[1].distance, 0.5 * ball[0].distance);
  EXPECT_LT(ball[2].distance, 0.5 * ball[0].distance);
  // A slope has terraces as wide as it is flat, which the strong one takes away.
  EXPECT_LT(slope[1].angle, 0.5 * slope[0].angle);
  EXPECT_LT(slope[2].angle, 0.5 * slope[1].angle);
  EXPECT_LT(slope[2].distance, 0.3 * slope[0].distance);
}

TEST(SmoothedIndicator, DoesNotDependOnWhereTilesBegin) {
  const glm::ivec3 dims(48);
  const auto shape = [](glm::ivec3 p) {
    return p.x + p.y / 4 > 20 && glm::distance(glm::dvec3(p), glm::dvec3(21)) < 11;
  };
  for (const LabelSmoothing strength : strengths) {
    const SampledIndicator here(dims, shape, strength);
    const auto differenceAfter = [&](glm::ivec3 shift) {
      const SampledIndicator there(
          dims, [&](glm::ivec3 p) { return shape(p - shift); }, strength);
      double worst = 0.0;
      forEachVoxel(dims - 16, [&](glm::ivec3 at) {
        if (here.isCut(at + 8) || here.isCut(at + 7))
          worst = std::max(worst, std::abs(here.at(at + 8) - there.at(at + 8 + shift)));
      });
      return worst;
    };
    const double byBlocks = differenceAfter({4, 8, 4}), byVoxels = differenceAfter({3, 5, 2});
    std::cout << "strength " << int(strength) << ": up to " << byBlocks << " and " << byVoxels << '\n';
    // Values stay 0 or 1 at least a tile away from the surface.
    EXPECT_LT(byBlocks, 1e-3);
    // Volumes are held by blocks of four voxels, which then lie elsewhere in the shape. Values change by 0.14 and more
    // from voxel to voxel, so that the surface moves by a quarter of a voxel at most, at the shape's sharp edges.
    EXPECT_LT(byVoxels, 0.035);
  }
}

TEST(SmoothedIndicator, RepeatsTheEdgeAndTakesThinMaps) {
  for (const glm::ivec3 dims : {glm::ivec3(1), glm::ivec3(17, 1, 1), glm::ivec3(9, 20, 1), glm::ivec3(8, 16, 24)})
    for (const LabelSmoothing strength : strengths) {
      const SampledIndicator all(
          dims, [](glm::ivec3) { return true; }, strength);
      const SampledIndicator none(
          dims, [](glm::ivec3) { return false; }, strength);
      const auto halfAt = [](glm::ivec3 p) { return p.x < 5; };
      const SampledIndicator half(dims, halfAt, strength);
      forEachVoxel(dims, [&](glm::ivec3 at) {
        ASSERT_EQ(all.at(at), 1.0);
        ASSERT_EQ(none.at(at), 0.0);
        ASSERT_EQ(half.at(at) > 0.5, halfAt(at));
        // A plane across the map stays one up to its border.
        ASSERT_EQ(half.at(at), half.at(glm::ivec3(at.x, 0, 0)));
      });
      if (dims.x > 6) {  // it stays half way
        EXPECT_NEAR(half.at(glm::ivec3(4, 0, 0)) + half.at(glm::ivec3(5, 0, 0)), 1.0, 1e-3);
      }
    }
}

TEST(SmoothedIndicator, CanBeInterrupted) {
  const Grid grid = gridOf(glm::ivec3(64));
  const auto labels = labelsOf(grid, [](glm::ivec3 at) { return at.x > 30 ? 1 : 0; });
  const std::array<std::uint16_t, 1> one{1};
  const Interruptible interruptible([] { return false; });
  EXPECT_THROW(SmoothedIndicator(*labels, one, LabelSmoothing::Light), Interrupted);
}

}  // namespace
}  // namespace fenestra::tests::smoothedIndicatorTest
