// Rows of a refined volume, made many values at a time, against the same values one by one.

#include "rendering/gpu/RefinedVolume.h"

#include <random>

#include <gtest/gtest.h>

#include "rendering/gpu/FocusIndexing.h"
#include "rendering/gpu/RefinedSampler.h"
#include "tests/support/Scenes.h"

namespace fenestra::tests::refinedVolumeTest {
namespace {

const std::vector<glm::ivec3> awkwardSizes{{1, 1, 1}, {1, 6, 5}, {2, 3, 1}, {3, 2, 4}, {13, 4, 5}};

SplineVectors randomVectors(glm::ivec3 dims) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> component(-1.2, 1.2);  // beyond what texels hold, too
  std::vector<glm::dvec3> vectors;
  forEachVoxel(dims,
               [&](glm::ivec3) { vectors.emplace_back(component(random), component(random), component(random)); });
  Grid grid;
  grid.dims = dims;
  return SplineVectors(dims, [&](glm::ivec3 voxel) { return vectors[grid.offset(voxel)]; });
}

TEST(RefinedVolume, GradientsOfARowAreThoseOfItsVoxels) {
  for (const glm::ivec3 dims : awkwardSizes) {
    const SplineVectors vectors = randomVectors(dims);
    const SplineVolume& spline = vectors.part(0);
    std::vector<glm::dvec3> row(static_cast<std::size_t>(dims.x));
    forEachVoxel(dims, [&](glm::ivec3 voxel) {
      if (voxel.x == 0) voxelGradients(spline, voxel.y, voxel.z, row);
      EXPECT_EQ(row[static_cast<std::size_t>(voxel.x)], spline.gradient(glm::dvec3(voxel)))
          << voxel.x << ' ' << voxel.y << ' ' << voxel.z << " of " << dims.x;
    });
  }
}

TEST(RefinedVolume, NormalsOfARowAreTheirComponentsInTenBitsEach) {
  constexpr int factor = 3;
  for (const glm::ivec3 dims : awkwardSizes) {
    const SplineVectors vectors = randomVectors(dims);
    const std::array<RefinedSampler, 3> samplers{RefinedSampler(vectors.part(0), factor),
                                                 RefinedSampler(vectors.part(1), factor),
                                                 RefinedSampler(vectors.part(2), factor)};
    RefinedSampler::Room room;
    const auto width = static_cast<std::size_t>(factor * dims.x);
    for (int z = 0; z < factor * dims.z; ++z) {
      const std::array<std::vector<double>, 3> planes{samplers[0].plane(z), samplers[1].plane(z), samplers[2].plane(z)};
      for (int y = 0; y < factor * dims.y; ++y) {
        std::vector<std::uint32_t> expected(width, 0);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          std::vector<double> samples(width);
          samplers[axis].row(planes[axis], y, room, samples);
          setTenBits(samples, 10 * static_cast<int>(axis), expected.data());
        }
        for (std::size_t low = 0; low < std::min<std::size_t>(width, 5); ++low) {
          std::vector<std::uint32_t> texels(width - low);
          samplers[0].normals(planes, y, room, static_cast<int>(low), texels);
          EXPECT_EQ(texels, std::vector(expected.begin() + static_cast<std::ptrdiff_t>(low), expected.end()))
              << dims.x << " voxels, from " << low;
        }
      }
    }
  }
}

TEST(RefinedVolume, RowsOfSixteenBitsAreTheSamplesRounded) {
  constexpr int factor = 3;
  for (const glm::ivec3 dims : awkwardSizes) {
    const SplineVectors vectors = randomVectors(dims);
    const RefinedSampler sampler(vectors.part(0), factor);
    RefinedSampler::Room room;
    const std::vector<double> plane = sampler.plane(0);
    std::vector<double> samples(static_cast<std::size_t>(factor * dims.x));
    sampler.row(plane, 1, room, samples);
    std::vector<std::uint16_t> stored(samples.size());
    const double least = -0.9, scale = 40000.0;  // samples below and beyond sixteen bits, too
    sampler.row(plane, 1, room, least, scale, stored);
    for (std::size_t x = 0; x < samples.size(); ++x)
      EXPECT_EQ(stored[x], std::floor(std::clamp((samples[x] - least) * scale + 0.5, 0.0, 65535.0))) << x;
  }
}

TEST(RefinedVolume, BricksOccupiedAreThoseThatHoldSomeOfTheFocus) {
  constexpr int factor = 3;
  Grid grid;
  grid.dims = {23, 19, 17};
  // A plate, which fills bricks' rows, and a lone voxel, in rows that hold nothing else.
  const Scene scene = labelScene(grid, [](glm::ivec3 v) { return v.z == 4 || v == glm::ivec3(21, 14, 15) ? 1 : 0; });
  const FocusIndex focus = buildFocusIndex(scene, brickRanges(shownVolume(scene)));
  const std::vector<std::uint8_t> occupied = refinedOccupied(focus, grid.dims, factor);
  const glm::ivec3 bricks = brickCount(grid.dims * factor);
  ASSERT_EQ(occupied.size(), brickOffset(bricks, {0, 0, bricks.z}));
  int held = 0;
  forEachVoxel(bricks, [&](glm::ivec3 brick) {
    // Cell c of the finer grid lies in the volume's (c + 1) / 3.
    bool holds = false;
    forEachVoxel(glm::ivec3(brickSide), [&](glm::ivec3 cell) {
      holds |= focus.holds(glm::min((brick * brickSide + cell + 1) / factor, grid.dims));
    });
    held += holds;
    EXPECT_EQ(occupied[brickOffset(bricks, brick)], holds ? 1 : 0) << brick.x << ' ' << brick.y << ' ' << brick.z;
  });
  EXPECT_GT(held, 100);
}

}  // namespace
}  // namespace fenestra::tests::refinedVolumeTest
