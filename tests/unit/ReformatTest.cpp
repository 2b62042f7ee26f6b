// Curves, straightened pictures and centre lines, against a helix whose length and radius are known.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "io/LabelReader.h"
#include "io/VolumeReader.h"
#include "rendering/reformat/CentreLine.h"
#include "rendering/reformat/Straighten.h"
#include "rendering/volume/Threads.h"
#include "tests/support/Scenes.h"
#include "tests/support/TestData.h"

namespace fenestra::reformat_test {
namespace {

using namespace reformat;
using tests::labelsOf;
using tests::volumeOf;

constexpr double pi = std::numbers::pi;

struct Helix {
  double radius = 25.0, rise = 45.0, turns = 1.6;  ///< mm, mm a turn
  glm::dvec3 centre{40.0, -30.0, 500.0};

  glm::dvec3 at(double turn) const {
    return centre + glm::dvec3(radius * std::cos(2 * pi * turn), radius * std::sin(2 * pi * turn), rise * turn);
  }
  double length() const { return turns * std::hypot(2 * pi * radius, rise); }
  /// How far a point is from it, and from which turn; those of its ends do not count as nearest.
  struct Nearest {
    double distance, turn;
  };
  Nearest nearest(glm::dvec3 point) const {
    const auto squared = [&](double turn) {
      const glm::dvec3 away = at(turn) - point;
      return glm::dot(away, away);
    };
    double best = 0.0;
    for (double turn = -0.1; turn <= turns + 0.1; turn += 0.025)
      if (squared(turn) < squared(best)) best = turn;
    for (double step = 0.0125; step > 1e-7; step *= 0.5)
      for (const double turn : {best - step, best + step})
        if (squared(turn) < squared(best)) best = turn;
    return {std::sqrt(squared(best)), best};
  }
  std::vector<glm::dvec3> points(int count) const {
    std::vector<glm::dvec3> list;
    for (int i = 0; i < count; ++i) list.push_back(at(turns * i / (count - 1)));
    return list;
  }
};

constexpr double tubeRadius = 6.0;

/// A grid about the helix, turned, of anisotropic voxels.
Grid gridAround(const Helix& helix) {
  Grid grid = tests::obliqueGrid({84, 84, 92});
  grid.spacing = {1.1, 1.1, 1.4};
  grid.origin = glm::dvec3(0.0);
  grid.origin = helix.centre + glm::dvec3(0.0, 0.0, 0.5 * helix.rise * helix.turns) - grid.centre();
  return grid;
}

/// A tube about the helix that ends flat.
std::shared_ptr<LabelMap> tubeLabels(const Helix& helix) {
  const Grid grid = gridAround(helix);
  const glm::dmat4 toWorld = grid.worldFromIndex();
  return labelsOf(grid, [&](glm::ivec3 index) {
    const auto [distance, turn] = helix.nearest(glm::dvec3(toWorld * glm::dvec4(index, 1.0)));
    return distance <= tubeRadius && turn >= 0.0 && turn <= helix.turns ? 3 : 0;
  });
}

TEST(PathCurve, AHelixHasItsLength) {
  const Helix helix;
  // Points 24° apart, as a hand would click them.
  const PathCurve curve(helix.points(25));
  EXPECT_NEAR(curve.length(), helix.length(), 0.005 * helix.length());
  for (double mm = 0.0; mm <= curve.length(); mm += 0.7)
    EXPECT_LT(helix.nearest(curve.place(mm).point).distance, 0.1) << mm;
  EXPECT_LT(glm::distance(curve.place(-5.0).point, helix.at(0.0)), 1e-9);
  EXPECT_LT(glm::distance(curve.place(1e9).point, helix.at(helix.turns)), 1e-9);
}

TEST(PathCurve, FramesNeitherFlipNorTurnAboutTheCurve) {
  const Helix helix;
  // A straight piece, a bend, and one the other way, where frames of Frenet flip.
  std::vector<glm::dvec3> snake;
  for (int i = 0; i < 12; ++i) snake.push_back({10.0 * i, i < 4 ? 0.0 : 15.0 * std::sin(0.8 * (i - 3)), 0.2 * i * i});
  for (const std::vector<glm::dvec3>& points : {helix.points(25), snake}) {
    const PathCurve curve(points);
    double turned = 0.0;
    const double step = 0.05;
    for (double mm = 0.0; mm + step < curve.length(); mm += step) {
      const PathPlace a = curve.place(mm), b = curve.place(mm + step);
      for (const auto& [one, other] : {std::pair(b.along, b.right), {b.right, b.up}, {b.up, b.along}})
        EXPECT_NEAR(glm::dot(one, other), 0.0, 1e-9);
      EXPECT_NEAR(glm::dot(glm::cross(b.along, b.right), b.up), 1.0, 1e-9);
      EXPECT_GT(glm::dot(a.right, b.right), 0.999);
      turned += glm::dot(b.right - a.right, 0.5 * (a.up + b.up));
    }
    // The chords of polylines are rotated exactly; what is left is their difference from the curve. A frame of Frenet
    // would turn by the helix's torsion, 2π·1.6·0.28 = 2.7 radians.
    EXPECT_NEAR(turned, 0.0, 0.02);
  }
}

TEST(PathCurve, TooFewPointsHaveNoLength) {
  EXPECT_EQ(PathCurve(std::vector<glm::dvec3>{}).length(), 0.0);
  EXPECT_EQ(PathCurve(std::vector<glm::dvec3>{{1, 2, 3}, {1, 2, 3}}).length(), 0.0);
  EXPECT_NEAR(PathCurve(std::vector<glm::dvec3>{{1, 2, 3}, {1, 2, 3}, {1, 2, 8}}).length(), 5.0, 1e-9);
}

TEST(Straighten, Thorough_AHelicalTubeIsAStraightOne) {
  const Helix helix;
  const Grid grid = gridAround(helix);
  const glm::dmat4 toWorld = grid.worldFromIndex();
  // 1000 at the middle, falling by 100 a millimetre: 400 at the tube's wall.
  const auto volume = volumeOf<std::int16_t>(grid, [&](glm::ivec3 index) {
    return std::lround(1000.0 -
                       100.0 * std::min(helix.nearest(glm::dvec3(toWorld * glm::dvec4(index, 1.0))).distance, 9.0));
  });
  const PathCurve curve(helix.points(60));
  for (const double angle : {0.0, 0.9, 2.5}) {
    const StraightPicture picture = straightened(*volume, curve, 0.5, 24.0, angle);
    EXPECT_EQ(picture.width, 49);
    EXPECT_EQ(picture.height, static_cast<int>(curve.length() / 0.5) + 1);
    const int margin = 12;  // rows near the ends, where the nearest point of the curve is an end
    for (int row = margin; row < picture.height - margin; ++row) {
      const float* values = picture.values.data() + row * picture.width;
      for (int column = 0; column < picture.width; ++column) {
        const double away = std::abs(0.5 * (column - 24));
        if (away < 2.0 || away > 6.0) continue;
        // Trilinear interpolation rounds a cone off by at most h²/8 (1/r) · slope, 13 at 2 mm from its tip, and the
        // path is as far from the helix as the test above says: 10.
        EXPECT_NEAR(values[column], 1000.0 - 100.0 * away, 25.0) << row << ", " << column;
      }
    }
  }
}

TEST(Straighten, ACrossSectionLiesAcrossTheCurve) {
  const Helix helix;
  const PathCurve curve(helix.points(60));
  const SliceGeometry section = crossSection(curve, 100.0, 0.5, 30.0, 0.4);
  EXPECT_EQ(section.width, 61);
  const PathPlace place = curve.place(100.0);
  EXPECT_LT(glm::distance(section.worldFromPixel(30, 30, 0), place.point), 1e-9);
  EXPECT_NEAR(glm::dot(section.right, place.along), 0.0, 1e-9);
  EXPECT_NEAR(glm::dot(section.down, place.along), 0.0, 1e-9);
  EXPECT_NEAR(glm::dot(glm::cross(section.right, section.down), place.along), 0.25, 1e-9);
}

/// The areas across a line through the middles of a body sum up to the body's volume (Pappus).
double sumOfAreas(const VoxelRegion& region, const PathCurve& curve) {
  const int steps = static_cast<int>(curve.length() / 0.5);
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const std::optional<Section> section = sectionOf(region, curve.place(curve.length() * (i + 0.5) / steps), 1.0);
    if (section) sum += section->area * curve.length() / steps;
  }
  return sum;
}
double volumeOfRegion(const VoxelRegion& region) {
  return static_cast<double>(std::count(region.inside.begin(), region.inside.end(), 1)) * region.grid.voxelVolume();
}

TEST(CentreLine, Thorough_OfAHelicalTubeHasItsLengthAndRadius) {
  const Helix helix;
  const std::vector<std::uint16_t> values{3};
  const VoxelRegion region = regionOf(*tubeLabels(helix), values);
  const CentreLine line = centreLineOf(region);
  const PathCurve curve(line.points);
  EXPECT_NEAR(curve.length(), helix.length(), 0.005 * helix.length());
  EXPECT_GT(line.points.front().z, line.points.back().z);
  const double halfVoxel = 0.5 * 1.1;
  int measured = 0;
  for (double mm = 0.0; mm <= curve.length(); mm += 2.0) {
    const PathPlace place = curve.place(mm);
    EXPECT_LT(helix.nearest(place.point).distance, halfVoxel) << mm;
    if (mm < tubeRadius || mm > curve.length() - tubeRadius) continue;
    const std::optional<Section> section = sectionOf(region, place, 1.0);
    ASSERT_TRUE(section) << mm;
    ++measured;
    EXPECT_NEAR(section->radius(), tubeRadius, halfVoxel) << mm;
  }
  EXPECT_GT(measured, 100);
  EXPECT_NEAR(sumOfAreas(region, curve), volumeOfRegion(region), 0.02 * volumeOfRegion(region));
}

TEST(CentreLine, OfTheAortaAgreesWithItsVolumeAndItsSlices) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "labelled/totalsegmentator-torso");
  const auto volume = io::openVolume(folder / "example_ct.nii.gz").volume;
  const auto labels = io::openLabels(folder / "example_seg_fast_force_split.nii.gz", volume->grid).labels;
  const std::vector<std::uint16_t> aorta{52};
  const VoxelRegion region = regionOf(*labels, aorta);
  const CentreLine line = centreLineOf(region);
  const PathCurve curve(line.points);
  // Sections lose a little of the round ends.
  EXPECT_NEAR(sumOfAreas(region, curve), volumeOfRegion(region), 0.03 * volumeOfRegion(region));

  // It runs down the torso, so that the middles of its axial slices lie on it, too. Each is known to some tenths of a
  // voxel of 3 mm, so that a path through them is a little longer than the aorta: half a percent, which lengths of
  // paths may be off, holds nevertheless.
  std::vector<glm::dvec3> middles;
  for (int z = 0; z < region.grid.dims.z; ++z) {
    glm::dvec3 sum(0.0);
    int count = 0;
    for (int y = 0; y < region.grid.dims.y; ++y)
      for (int x = 0; x < region.grid.dims.x; ++x)
        if (region.inside[region.grid.offset({x, y, z})]) {
          sum += glm::dvec3(x, y, z);
          ++count;
        }
    if (count == 0) continue;
    middles.push_back(glm::dvec3(region.grid.worldFromIndex() * glm::dvec4(sum / static_cast<double>(count), 1.0)));
  }
  double length = region.grid.spacing.z;  // half a voxel at both ends
  for (std::size_t i = 1; i < middles.size(); ++i) length += glm::distance(middles[i - 1], middles[i]);
  EXPECT_NEAR(curve.length(), length, 0.005 * length);
  for (std::size_t i = 3; i + 3 < middles.size(); ++i) {
    double nearest = 1e9;
    for (double mm = 0.0; mm < curve.length(); mm += 0.5)
      nearest = std::min(nearest, glm::distance(curve.place(mm).point, middles[i]));
    EXPECT_LT(nearest, 0.5 * region.grid.spacing.z) << i;
  }
  // A frame that minimises rotation turns no more than its curve does, which may bend sharply at a vessel's ends.
  // Places between samples are interpolated; that leaves less than a degree.
  const auto turned = [](glm::dvec3 from, glm::dvec3 to) {
    return glm::degrees(std::atan2(glm::length(glm::cross(from, to)), glm::dot(from, to)));
  };
  for (double mm = 0.0; mm + 0.5 < curve.length(); mm += 0.5) {
    const reformat::PathPlace here = curve.place(mm), next = curve.place(mm + 0.5);
    EXPECT_LE(turned(here.right, next.right), turned(here.along, next.along) + 1.0) << mm;
  }
}

TEST(CentreLine, OfWhatIsNoTubeIsEmpty) {
  const Grid grid = tests::gridOf({20, 20, 20});
  const std::vector<std::uint16_t> values{1};
  const auto lineOf = [&](auto&& inside) { return centreLineOf(regionOf(*labelsOf(grid, inside), values)).points; };
  EXPECT_TRUE(lineOf([](glm::ivec3) { return 0; }).empty());
  EXPECT_TRUE(lineOf([](glm::ivec3 i) { return i == glm::ivec3(4, 5, 6); }).empty());
  EXPECT_TRUE(lineOf([](glm::ivec3 i) { return glm::distance(glm::dvec3(i), glm::dvec3(10.0)) < 7.0; }).empty());
  // A ball with a cube taken out of it is long for its depth, but its cross-sections' middles follow no line.
  const Grid large = tests::gridOf({48, 48, 48});
  const auto notched = labelsOf(large, [](glm::ivec3 i) {
    const glm::dvec3 away = glm::abs(glm::dvec3(i) - glm::dvec3(32.0, 15.0, 32.0));
    return glm::distance(glm::dvec3(i), glm::dvec3(23.5)) < 22.0 && std::max({away.x, away.y, away.z}) >= 3.5;
  });
  EXPECT_TRUE(centreLineOf(regionOf(*notched, values)).points.empty());
}

TEST(CentreLine, ReadingItsRegionCanBeStopped) {
  const auto labels = labelsOf(tests::gridOf({20, 20, 20}), [](glm::ivec3) { return 1; });
  const std::vector<std::uint16_t> values{1};
  int asked = 0, most = 0;
  const auto read = [&] {
    asked = 0;
    const Interruptible work([&] { return ++asked <= most; });
    regionOf(*labels, values);
  };
  most = 1'000'000;
  read();
  ASSERT_GT(asked, 2);
  // Wherever it is: in its first look at the voxels, in the middle, and at its end.
  const int all = asked;
  for (most = 0; most < all; most += std::max(1, all / 7)) EXPECT_THROW(read(), Interrupted) << most << " of " << all;
}

TEST(CentreLine, OfAStraightTubeThatLeavesTheVolume) {
  // The volume's border is no surface: the line goes on to it.
  const auto labels =
      labelsOf(tests::gridOf({21, 21, 60}), [](glm::ivec3 i) { return std::hypot(i.x - 10, i.y - 10) <= 5.0; });
  const std::vector<std::uint16_t> values{1};
  const VoxelRegion region = regionOf(*labels, values);
  const PathCurve curve(centreLineOf(region).points);
  EXPECT_NEAR(curve.length(), 60.0, 0.3);
  for (double mm = 0.0; mm < curve.length(); mm += 1.0) {
    const glm::dvec3 point = curve.place(mm).point;
    EXPECT_LT(std::hypot(point.x - 10.0, point.y - 10.0), 0.25) << mm;
  }
  const std::optional<Section> section = sectionOf(region, curve.place(30.0), 1.0);
  ASSERT_TRUE(section);
  // 81 voxels of the disc; the surface of ½ between their centres cuts corners off and fills others.
  EXPECT_NEAR(section->area, 81.0, 4.0);
}

TEST(ReformatRegion, KeepsTheLargestPart) {
  const auto labels = labelsOf(tests::gridOf({10, 10, 10}), [](glm::ivec3 i) { return i.x < 3 ? 2 : i.x > 5 ? 7 : 0; });
  const std::vector<std::uint16_t> both{2, 7};
  const VoxelRegion region = regionOf(*labels, both);
  EXPECT_EQ(std::count(region.inside.begin(), region.inside.end(), 1), 400);
  EXPECT_EQ(region.at({8.0, 5.0, 5.0}), 1.0);
  EXPECT_EQ(region.at({1.0, 5.0, 5.0}), 0.0);
  const std::vector<std::uint16_t> none{5};
  EXPECT_TRUE(regionOf(*labels, none).isEmpty());
}

}  // namespace
}  // namespace fenestra::reformat_test
