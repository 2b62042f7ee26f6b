// Surfaces of balls and of real labels: volume, distance from the level set, closedness, orientation and files.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "io/LabelReader.h"
#include "io/VolumeReader.h"
#include "io/surface/Surface.h"
#include "tests/io/IoTesting.h"
#include "tests/io/LabelFiles.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::surfaceTest {
namespace fs = std::filesystem;

namespace {

/// A ball as label 1 on a grid.
Scene ballScene(const Grid& grid, glm::dvec3 centre, double radius) {
  auto labels = std::make_shared<LabelMap>();
  labels->grid = grid;
  labels->labels = {{1, "ball", {}}};
  labels->voxels = Voxels(ScalarType::UInt8, grid.voxelCount());
  for (int z = 0; z < grid.dims.z; ++z)
    for (int y = 0; y < grid.dims.y; ++y)
      for (int x = 0; x < grid.dims.x; ++x)
        labels->voxels.as<std::uint8_t>()[grid.offset({x, y, z})] =
            glm::distance(glm::dvec3(grid.worldFromIndex() * glm::dvec4(x, y, z, 1.0)), centre) < radius;
  Scene scene;
  scene.labels = std::move(labels);
  scene.look.focus = LabelFocus{{1}};
  return scene;
}

double labelVolume(const Scene& scene) {
  const auto& focus = std::get<LabelFocus>(scene.look.focus).labels;
  double voxels = 0.0;
  for (const int value : valuesOf(*scene.labels))
    voxels += std::binary_search(focus.begin(), focus.end(), static_cast<std::uint16_t>(value));
  return voxels * scene.labels->grid.voxelVolume();
}

/// Every edge belongs to two triangles that run along it in opposite directions.
void expectClosed(const io::Surface& surface) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& [a, b, c] : surface.triangles)
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      edges[std::minmax(from, to)] += from < to ? 1 : -1;
  EXPECT_TRUE(std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; }));
}

/// The label's trilinear indicator at an index position; 0 beyond the border of the grid.
double indicator(const Scene& scene, glm::dvec3 index) {
  const auto& focus = std::get<LabelFocus>(scene.look.focus).labels;
  const glm::ivec3 base(glm::floor(index));
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2), at = base + step;
    if (!scene.labels->grid.contains(at)) continue;
    const glm::dvec3 part = glm::mix(1.0 - (index - glm::dvec3(base)), index - glm::dvec3(base), glm::dvec3(step));
    sum += part.x * part.y * part.z * std::binary_search(focus.begin(), focus.end(), scene.labels->value(at));
  }
  return sum;
}

/// Whether the 0.5 level of the indicator passes within half a voxel of a point: along some direction, the indicator
/// crosses 0.5 within that distance.
bool isNearLevel(const Scene& scene, glm::dvec3 index) {
  const bool inside = indicator(scene, index) > 0.5;
  // 0.5, and a fiftieth of a voxel for the sampled directions and the triangles' interior.
  for (double reach = 0.02; reach <= 0.52; reach += 0.05)
    for (int i = 0; i < 200; ++i) {
      // Directions evenly over the sphere (Fibonacci lattice).
      const double z = 1.0 - (2.0 * i + 1.0) / 200.0, angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
      const double r = std::sqrt(1.0 - z * z);
      if ((indicator(scene, index + reach * glm::dvec3(r * std::cos(angle), r * std::sin(angle), z)) > 0.5) != inside)
        return true;
    }
  return false;
}

void expectFaithful(const Scene& scene) {
  const io::Surface surface = io::extractSurface(scene, "test");
  EXPECT_NEAR(surface.volume() / labelVolume(scene), 1.0, 0.005);
  expectClosed(surface);
  const glm::dmat4 indexFromWorld = scene.labels->grid.indexFromWorld();
  std::size_t far = 0;
  for (std::size_t i = 0; i < surface.points.size(); ++i)
    far += !isNearLevel(scene, glm::dvec3(indexFromWorld * glm::dvec4(surface.points[i], 1.0)));
  EXPECT_EQ(far, 0u) << "of " << surface.points.size();
}

}  // namespace

TEST(Surface, ABallHasItsVolumeAndPlace) {
  const glm::dvec3 centre(3, -4, 5);
  const Scene scene = ballScene(labelGrid({48, 48, 48}, centre - 23.3), centre, 20.0);
  expectFaithful(scene);
  const io::Surface surface = io::extractSurface(scene, "test");
  double farthest = 0.0;
  for (const glm::dvec3& point : surface.points)
    farthest = std::max(farthest, std::abs(glm::distance(point, centre) - 20.0));
  // A ball of voxels leaves steps of up to 0.87 voxels; smoothing brings the surface well within half a voxel.
  EXPECT_LT(farthest, 0.5);
  // Triangles face outward.
  for (const auto& [a, b, c] : surface.triangles) {
    const glm::dvec3 normal = glm::cross(surface.points[b] - surface.points[a], surface.points[c] - surface.points[a]);
    if (glm::length(normal) > 1e-3) {
      EXPECT_GT(glm::dot(normal, surface.points[a] - centre), 0.0);
    }
  }
  const io::Surface raw = io::extractSurface(scene, "test", {.smooth = false});
  EXPECT_EQ(raw.points.size(), surface.points.size());
  expectClosed(raw);
}

TEST(Surface, AnisotropicShearedAndMirroredGrids) {
  Grid grid = labelGrid({40, 44, 24}, {0, 0, 0}, {1.0, 0.9, 2.2});
  grid.direction = {glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0), glm::normalize(glm::dvec3(0.0, 0.4, 1.0))};
  expectFaithful(ballScene(grid, grid.centre(), 14.0));
}

TEST(Surface, ClosesWhereTheFocusMeetsTheBorder) {
  // A box of 10 x 12 x 6 voxels that fills its grid: 720 mm³ with rounded edges, held to the volume.
  Scene scene = ballScene(labelGrid({10, 12, 6}), glm::dvec3(5.0), 100.0);
  const io::Surface raw = io::extractSurface(scene, "test", {.smooth = false});
  expectClosed(raw);
  glm::dvec3 low = raw.points[0], high = low;
  for (const glm::dvec3& point : raw.points) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  EXPECT_LT(glm::distance(low, glm::dvec3(-0.5)), 1e-6);
  EXPECT_LT(glm::distance(high, glm::dvec3(9.5, 11.5, 5.5)), 1e-6);
  expectFaithful(scene);
}

TEST(Surface, ARangeOfValuesWithoutItsIslands) {
  // Values fall linearly from the centres of two balls; the small one is an island.
  auto volume = std::make_shared<Volume>();
  volume->grid = labelGrid({60, 40, 40});
  volume->voxels = Voxels(ScalarType::Float32, volume->grid.voxelCount());
  for (int z = 0; z < 40; ++z)
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 60; ++x) {
        const glm::dvec3 at(x, y, z);
        volume->voxels.as<float>()[volume->grid.offset({x, y, z})] = static_cast<float>(std::max(
            100.0 - glm::distance(at, glm::dvec3(20.2, 20.1, 19.8)), 88.0 - glm::distance(at, glm::dvec3(50, 20, 20))));
      }
  volume->computeRange();
  Scene scene;
  scene.volume = volume;
  scene.look.focus = ValueFocus{{85.0, 200.0}, 300.0};
  const io::Surface surface = io::extractSurface(scene, "test", {.smooth = false});
  expectClosed(surface);
  for (const glm::dvec3& point : surface.points)
    // Linear interpolation of a cone's flank along an edge of one voxel is within 1/(8·15) voxels of it.
    EXPECT_NEAR(glm::distance(point, glm::dvec3(20.2, 20.1, 19.8)), 15.0, 0.02);
  const io::Surface smooth = io::extractSurface(scene, "test");
  EXPECT_NEAR(smooth.volume() / surface.volume(), 1.0, 0.001);
  scene.look.focus = ValueFocus{{85.0, 200.0}, 0.0};
  EXPECT_GT(io::extractSurface(scene, "test", {.smooth = false}).points.size(), surface.points.size());
}

TEST(Surface, ARealKidneyAndThinVessels) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "labelled/totalsegmentator-torso");
  Scene scene;
  scene.volume = io::openVolume(folder / "example_ct.nii.gz").volume;
  scene.labels = io::openLabels(folder / "example_seg_fast_force_split.nii.gz", scene.volume->grid).labels;
  for (const std::uint16_t label : {2, 3, 52}) {
    SCOPED_TRACE(scene.labels->find(label)->name);
    scene.look.focus = LabelFocus{{label}};
    expectFaithful(scene);
  }
}

TEST(Surface, FilesHoldTheSameTrianglesInTheFrameAskedFor) {
  const Scene scene = ballScene(labelGrid({20, 20, 20}, {100, 200, 300}), {109, 209, 309}, 6.0);
  const io::Surface surface = io::extractSurface(scene, "test");
  const fs::path folder = scratchFolder();
  for (const auto& [frame, word, sign] :
       {std::tuple(io::SurfaceFrame::Lps, "SPACE=LPS", 1.0), std::tuple(io::SurfaceFrame::Ras, "SPACE=RAS", -1.0)}) {
    for (const char* name : {"a.stl", "a.ply", "a.obj"}) io::writeSurface(surface, folder / name, frame);
    const std::string stl = readFile(folder / "a.stl"), ply = readFile(folder / "a.ply"),
                      obj = readFile(folder / "a.obj");
    for (const std::string& text : {stl.substr(0, 80), ply.substr(0, 200), obj.substr(0, 80)})
      EXPECT_NE(text.find(word), std::string::npos) << text;
    // STL: 80 bytes of header, a count, and fifty bytes a triangle: normal, corners, attribute.
    ASSERT_EQ(stl.size(), 84 + 50 * surface.triangles.size());
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
      float numbers[12];
      std::memcpy(numbers, stl.data() + 84 + 50 * i, sizeof numbers);
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const glm::dvec3 p = surface.points[surface.triangles[i][corner]];
        // Single precision of a few hundred millimetres.
        EXPECT_NEAR(numbers[3 + 3 * corner], sign * p.x, 1e-4);
        EXPECT_NEAR(numbers[4 + 3 * corner], sign * p.y, 1e-4);
        EXPECT_NEAR(numbers[5 + 3 * corner], p.z, 1e-4);
      }
    }
    EXPECT_NE(ply.find("element vertex " + std::to_string(surface.points.size())), std::string::npos);
    EXPECT_NE(ply.find("element face " + std::to_string(surface.triangles.size())), std::string::npos);
    std::istringstream lines(obj);
    std::size_t vertices = 0, faces = 0;
    for (std::string kind, line; std::getline(lines, line);) {
      std::istringstream fields(line);
      fields >> kind;
      if (kind == "v") {
        glm::dvec3 p;
        fields >> p.x >> p.y >> p.z;
        EXPECT_LT(glm::distance(p, surface.points[vertices] * glm::dvec3(sign, sign, 1.0)), 1e-5);
        ++vertices;
      }
      faces += kind == "f";
    }
    EXPECT_EQ(vertices, surface.points.size());
    EXPECT_EQ(faces, surface.triangles.size());
  }
}

TEST(Surface, WhatCannotBeMadeSaysWhyAndLeavesNothing) {
  Scene scene = ballScene(labelGrid({8, 8, 8}), glm::dvec3(4.0), 3.0);
  const io::Surface surface = io::extractSurface(scene, "test");
  const fs::path folder = scratchFolder();
  EXPECT_NE(errorOf([&] { io::writeSurface(surface, folder / "a.vtk", {}); }).find("no surface format"),
            std::string::npos);
  testing::internal::CaptureStderr();
  for (const char* name : {"no/a.stl", "no/a.ply", "no/a.obj"})
    EXPECT_NE(errorOf([&] { io::writeSurface(surface, folder / name, {}); }).find("cannot be written"),
              std::string::npos);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_TRUE(fs::is_empty(folder));
  scene.look.focus = LabelFocus{{2}};
  EXPECT_NE(errorOf([&] { io::extractSurface(scene, "test"); }).find("test: has no voxel in the focus"),
            std::string::npos);
  scene.look.focus = std::monostate{};
  EXPECT_NE(errorOf([&] { io::extractSurface(scene, "test"); }).find("has no focus"), std::string::npos);
}

}  // namespace fenestra::tests::surfaceTest
