// Structure sets of known content: the pixels and slices that the even-odd rule fills, and the sets that are refused.

#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "io/LabelReader.h"
#include "io/VolumeReader.h"
#include "tests/io/IoTesting.h"
#include "tests/io/LabelFiles.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::rtStructTest {
namespace fs = std::filesystem;
using io::Warning;

namespace {

ContourSpec closed(std::vector<glm::dvec3> points) { return {std::move(points), "CLOSED_PLANAR", {}, {}}; }

io::OpenedLabels opened(const RtSpec& spec, const Grid& grid) {
  const fs::path path = scratchFolder() / "plan.dcm";
  writeRtStruct(path, spec);
  return io::openLabels(path, grid);
}

/// Rows of a slice as text, '.' for 0.
std::string picture(const LabelMap& map, int z) {
  std::string text;
  for (int y = 0; y < map.grid.dims.y; ++y) {
    for (int x = 0; x < map.grid.dims.x; ++x) {
      const int value = map.value({x, y, z});
      text += value == 0 ? '.' : static_cast<char>('0' + value);
    }
    text += '\n';
  }
  return text;
}

}  // namespace

TEST(RtStruct, FillsHolesIslandsAndSeveralContoursByEvenOdd) {
  RtSpec spec;
  spec.rois = {{3,
                "Blase",
                "0\\128\\255",
                {closed(rectangle(0.5, 0.5, 7.5, 7.5, 0)), closed(rectangle(2.5, 2.5, 5.5, 5.5, 0)),
                 closed(rectangle(3.5, 3.5, 4.5, 4.5, 0)), closed(rectangle(8.6, 0.6, 9.4, 1.4, 0))}}};
  const io::OpenedLabels labels = opened(spec, labelGrid({10, 9, 1}));
  EXPECT_EQ(picture(*labels.labels, 0),
            "..........\n"
            ".3333333.3\n"
            ".3333333..\n"
            ".33...33..\n"
            ".33.3.33..\n"
            ".33...33..\n"
            ".3333333..\n"
            ".3333333..\n"
            "..........\n");
  EXPECT_EQ(labels.labels->find(3)->name, "Blase");
  EXPECT_LT(glm::distance(labels.labels->find(3)->colour, glm::dvec3(0, 128 / 255.0, 1)), 1e-12);
  EXPECT_TRUE(labels.warnings.empty()) << labels.warnings.front().text;
}

TEST(RtStruct, AKeyholeContourLeavesItsHoleOpen) {
  // One contour around the outside, in through a channel of no width, around the hole and out again.
  RtSpec spec;
  spec.rois = {{1,
                "ring",
                "",
                {closed({{0.5, 0.5, 0},
                         {6.5, 0.5, 0},
                         {6.5, 6.5, 0},
                         {0.5, 6.5, 0},
                         {0.5, 3.2, 0},
                         {2.5, 3.2, 0},
                         {2.5, 4.5, 0},
                         {4.5, 4.5, 0},
                         {4.5, 2.5, 0},
                         {2.5, 2.5, 0},
                         {2.5, 3.2, 0},
                         {0.5, 3.2, 0}})}}};
  EXPECT_EQ(picture(*opened(spec, labelGrid({8, 8, 1})).labels, 0),
            "........\n"
            ".111111.\n"
            ".111111.\n"
            ".11..11.\n"
            ".11..11.\n"
            ".111111.\n"
            ".111111.\n"
            "........\n");
}

TEST(RtStruct, ContoursThroughVoxelCentresGiveThoseVoxelsBack) {
  // As traced from a mask: through the centres of its border pixels, written with few decimals.
  RtSpec spec;
  spec.rois = {{1,
                "mask",
                "",
                {closed({{0.3333 * 2, 0.3333, 0},
                         {0.3333 * 5, 0.3333, 0},
                         {0.3333 * 6, 0.3333 * 2, 0},
                         {0.3333 * 6, 0.3333 * 4, 0},
                         {0.3333 * 2, 0.3333 * 4, 0}}),
                 closed(rectangle(0.3333 * 3, 0.3333 * 2, 0.3333 * 5, 0.3333 * 3, 0))}}};
  EXPECT_EQ(picture(*opened(spec, labelGrid({8, 6, 1}, glm::dvec3(0.0), glm::dvec3(1.0 / 3.0))).labels, 0),
            "........\n"
            "..1111..\n"
            "..11111.\n"
            "..11111.\n"
            "..11111.\n"
            "........\n");
}

TEST(RtStruct, SlicesTakeTheNearestContoursPlaneWithinReach) {
  RtSpec spec;
  // Every 2 mm from 3.2 on, between slices; a gap from 7.2 to 13.2; and a structure on one plane.
  for (const double z : {3.2, 5.2, 7.2, 13.2, 15.2})
    spec.rois.resize(1), spec.rois[0].contours.push_back(closed(rectangle(-0.5, -0.5, 0.5, 0.5, z)));
  spec.rois[0].name = "stack";
  spec.rois.push_back({2, "one plane", "", {closed(rectangle(0.6, -0.5, 1.5, 0.5, 10.0))}});
  const io::OpenedLabels labels = opened(spec, labelGrid({2, 1, 40}, glm::dvec3(0.0), {1, 1, 0.5}));
  for (int k = 0; k < 40; ++k) {
    const double z = 0.5 * k;
    const bool stack = (z >= 2.2 && z <= 8.2) || (z >= 12.2 && z <= 16.2);
    EXPECT_EQ(labels.labels->value({0, 0, k}), stack ? 1 : 0) << z;
    EXPECT_EQ(labels.labels->value({1, 0, k}), std::abs(z - 10.0) <= 1.0 ? 2 : 0) << z;
  }
}

TEST(RtStruct, ABallKeepsItsVolumeOnAlignedObliqueAndCoronalGrids) {
  // Circles of 720 corners every millimetre through a ball of radius 20 mm about (5, -3, 40).
  const glm::dvec3 centre(5, -3, 40);
  constexpr double radius = 20.0;
  RtSpec spec;
  spec.rois = {{1, "ball", "", {}}};
  for (int k = -20; k < 20; ++k) {
    const double z = k + 0.5, r = std::sqrt(radius * radius - z * z);
    std::vector<glm::dvec3> circle;
    for (int i = 0; i < 720; ++i) {
      const double angle = i * std::numbers::pi / 360.0;
      circle.push_back(centre + glm::dvec3(r * std::cos(angle), r * std::sin(angle), z));
    }
    spec.rois[0].contours.push_back(closed(std::move(circle)));
  }
  Grid axial = labelGrid({50, 50, 50}, centre - 24.5);
  Grid coronal = axial;
  coronal.direction = glm::dmat3(glm::dvec3(1, 0, 0), glm::dvec3(0, 0, -1), glm::dvec3(0, 1, 0));
  coronal.origin = centre + glm::dvec3(-24.5, -24.5, 24.5);
  Grid oblique = axial;
  const glm::dvec3 x = glm::normalize(glm::dvec3(2, 1, 1)), y = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), x));
  oblique.direction = {x, y, glm::cross(x, y)};
  oblique.origin = centre - oblique.direction * glm::dvec3(24.5);
  for (const Grid& grid : {axial, coronal, oblique}) {
    const auto map = opened(spec, grid).labels;
    double voxels = 0.0;
    for (int k = 0; k < 50; ++k)
      for (int j = 0; j < 50; ++j)
        for (int i = 0; i < 50; ++i) {
          const glm::dvec3 at = glm::dvec3(grid.worldFromIndex() * glm::dvec4(i, j, k, 1.0)) - centre;
          const bool inside = map->value({i, j, k}) == 1;
          voxels += inside;
          // The stack of slabs differs from the ball by the half of a millimetre that a slab reaches to each side: near
          // the poles sqrt(2·20·0.5) = 4.5 mm in the plane, at most 0.5 mm along z.
          const double r = std::hypot(at.x, at.y);
          const double nearest = std::hypot(r, std::max(0.0, std::abs(at.z) - 0.5)),
                       farthest = std::hypot(r, std::abs(at.z) + 0.5);
          if (farthest < radius - 0.01) {
            EXPECT_TRUE(inside) << i << " " << j << " " << k;
          }
          if (nearest > radius + 0.01) {
            EXPECT_FALSE(inside) << i << " " << j << " " << k;
          }
        }
    // Slabs through the middle of each millimetre hold pi·(r³·4/3 + r/6) mm³; counting voxels adds about the surface's
    // roughness, which is below half a percent at this radius.
    const double truth = std::numbers::pi * (4.0 / 3.0 * radius * radius * radius + radius / 6.0);
    EXPECT_NEAR(voxels / truth, 1.0, 0.005);
  }
}

TEST(RtStruct, TheSmallerOfOverlappingStructuresStays) {
  RtSpec spec;
  spec.rois = {{1, "lesion", "", {closed(rectangle(1.5, 0.5, 2.5, 1.5, 0))}},
               {2, "body", "", {closed(rectangle(-0.5, -0.5, 4.5, 2.5, 0))}}};
  const io::OpenedLabels labels = opened(spec, labelGrid({5, 3, 1}));
  EXPECT_EQ(picture(*labels.labels, 0), "22222\n22122\n22222\n");
  const std::string text = warningOf(labels.warnings, Warning::Kind::Other).text;
  EXPECT_NE(text.find("overlap at 1 voxel;"), std::string::npos) << text;
  EXPECT_NE(text.find("lesion over body at 1"), std::string::npos) << text;
}

TEST(RtStruct, OddNumbersOpenContoursAndEmptyStructures) {
  RtSpec spec;
  spec.rois = {{-4, "negative", "", {closed(rectangle(-0.5, -0.5, 0.5, 0.5, 0))}},
               {1, "marker", "", {{{{1, 1, 0}}, "POINT", {}, {}}, {rectangle(0, 0, 2, 2, 0), "OPEN_PLANAR", {}, {}}}},
               {70000, "large", "", {closed(rectangle(1.5, -0.5, 2.5, 0.5, 0))}},
               {5, "tilted", "", {closed({{0, 0, 0}, {4, 0, 0}, {4, 4, 3}})}},
               {2, "", "", {}}};
  const io::OpenedLabels labels = opened(spec, labelGrid({5, 1, 1}));
  EXPECT_EQ(picture(*labels.labels, 0), "3.4..\n");
  EXPECT_EQ(labels.labels->find(3)->name, "negative");
  EXPECT_EQ(labels.labels->find(4)->name, "large");
  EXPECT_EQ(labels.labels->find(1)->name, "marker");
  EXPECT_EQ(labels.labels->find(2)->name, "label 2");
  ASSERT_EQ(labels.warnings.size(), 2u);
  EXPECT_EQ(labels.warnings[0].text.find("2 of its contours left out: points or open lines"), 0u);
  EXPECT_EQ(labels.warnings[1].text.find("1 of its contours left out: they do not lie on planes"), 0u);
}

TEST(RtStruct, EdgesBeyondCountEndInBoundedTime) {
  // A zigzag that every row crosses 120 000 times; then on a grid across it, on which each row asks for a line of its
  // own.
  RtSpec spec;
  spec.rois = {{1, "zigzag", "", {}}};
  std::vector<glm::dvec3> zigzag;
  for (int i = 0; i < 4000; ++i) zigzag.push_back({0.01 * i, i % 2 ? 100.0 : 0.0, 0.0});
  for (int i = 0; i < 30; ++i) spec.rois[0].contours.push_back(closed(zigzag));
  // The zigzag's area is zero: a square shows how the plane lies.
  spec.rois[0].contours.push_back(closed(rectangle(0, 0, 40, 100, 0)));
  const fs::path path = scratchFolder() / "plan.dcm";
  writeRtStruct(path, spec);
  const auto start = std::chrono::steady_clock::now();
  io::openLabels(path, labelGrid({128, 128, 64}));
  Grid across = labelGrid({10, 4000, 4000});
  across.direction = glm::dmat3(glm::normalize(glm::dvec3(1, 1, 1)), glm::normalize(glm::dvec3(1, -1, 0)),
                                glm::normalize(glm::dvec3(1, 1, -2)));
  across.spacing = glm::dvec3(0.025);
  EXPECT_NE(errorOf([&] { io::openLabels(path, across); }).find("too many edges"), std::string::npos);
  // A second of sorting, mostly.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

}  // namespace fenestra::tests::rtStructTest
