// The kernels of thick slices for special processors against the one for any processor, which the tests of slabs
// otherwise do not run on most machines.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "rendering/volume/SlabJob.h"

namespace fenestra::slab_kernels_test {
namespace {

constexpr int side = 24, border = 3;  // voxels of the volume, and of the box about it on each side
constexpr SlabTile tile{2, 1, 2 + 29, 1 + SlabTile::side};  // 29 pixels: no multiple of the lanes
constexpr int pixels = (tile.right - tile.left) * (tile.bottom - tile.top);

/// Noise from -1000 to 1000; the box repeats the volume's outermost voxels.
template <class T>
std::vector<T> noise() {
  std::minstd_rand random(11);
  std::vector<T> volume(side * side * side);
  for (T& voxel : volume) voxel = static_cast<T>(static_cast<int>(random() % 2001) - 1000);
  constexpr int all = side + 2 * border;
  std::vector<T> box;
  const auto held = [](int at) { return std::clamp(at - border, 0, side - 1); };
  for (int z = 0; z < all; ++z)
    for (int y = 0; y < all; ++y)
      for (int x = 0; x < all; ++x)
        box.push_back(volume[static_cast<std::size_t>((held(z) * side + held(y)) * side + held(x))]);
  box.push_back(T{});  // voxels are read in pairs
  return box;
}

struct Lines {
  double along[3], right[3], down[3];
};
constexpr Lines directions[] = {{{0.5, 0.4, 0.7}, {0.6, -0.1, -0.3}, {-0.2, 0.6, -0.1}},
                                {{-0.6, 0.3, -0.5}, {0.3, 0.5, 0.1}, {0.1, -0.3, 0.6}},
                                {{0.0, 0.0, 1.0}, {0.7, 0.0, 0.0}, {0.0, 0.7, 0.0}},
                                {{0.0, -0.8, 0.4}, {0.7, 0.0, 0.0}, {0.0, 0.2, 0.6}}};

SlabLines linesAlong(const Lines& direction, double sign) {
  SlabLines lines;
  for (int axis = 0; axis < 3; ++axis) {
    lines.along[axis] = direction.along[axis];
    lines.right[axis] = direction.right[axis];
    lines.down[axis] = direction.down[axis];
    // The tile's middle in the middle of the volume; its corners miss it.
    lines.first[axis] = 0.5 * side + 0.013 - 16.0 * (direction.right[axis] + direction.down[axis]);
    lines.low[axis] = -0.5;
    lines.high[axis] = side - 0.5;
  }
  lines.sign = sign;
  return lines;
}

SlabSums nothing() {
  SlabSums sums;
  std::fill_n(sums.extreme, pixels, -std::numeric_limits<double>::infinity());
  std::fill_n(sums.sum, pixels, 0.0);
  std::fill_n(sums.length, pixels, 0.0);
  return sums;
}

template <class T>
void expectAlike(std::vector<T> voxels) {
  // There is nothing to compare with then; TheOneForAnyProcessorIsRight tests the general kernel.
  if (slabKernels(true, sizeof(T) == 2).size() == 1) GTEST_SKIP() << "this processor runs the general kernel alone";
  SlabBox box;
  box.voxels = voxels.data();
  box.row = side + 2 * border;
  box.plane = box.row * box.row;
  for (double& first : box.first) first = -border;
  int means = 0, extremes = 0;
  for (const bool ofMeans : {false, true}) {
    const std::vector<SlabKernel> kernels = slabKernels(ofMeans, sizeof(T) == 2);
    ASSERT_FALSE(kernels.empty());
    for (const Lines& direction : directions)
      for (const double sign : {1.0, -1.0}) {
        const SlabLines lines = linesAlong(direction, sign);
        SlabSums wanted = nothing();
        kernels.back()(lines, box, tile, -9.0, 11.0, wanted);
        for (std::size_t k = 0; k + 1 < kernels.size(); ++k) {
          SlabSums sums = nothing();
          kernels[k](lines, box, tile, -9.0, 11.0, sums);
          for (int pixel = 0; pixel < pixels; ++pixel) {
            // Slab.h promises values to a hundredth of a stored step; lengths are up to 20 mm in float32.
            EXPECT_NEAR(sums.length[pixel], wanted.length[pixel], 1e-4);
            if (ofMeans && wanted.length[pixel] > 1.0) {
              EXPECT_NEAR(sums.sum[pixel] / sums.length[pixel], wanted.sum[pixel] / wanted.length[pixel], 0.01);
              ++means;
            }
            if (ofMeans) continue;
            EXPECT_EQ(std::isfinite(sums.extreme[pixel]), std::isfinite(wanted.extreme[pixel]));
            if (!std::isfinite(wanted.extreme[pixel])) continue;
            EXPECT_NEAR(sums.extreme[pixel], wanted.extreme[pixel], 0.01);
            ++extremes;
          }
        }
      }
  }
  EXPECT_GT(means, 2000);
  EXPECT_GT(extremes, 2000);
}

TEST(SlabKernels, OfInt16AgreeOnAllProcessors) { expectAlike(noise<std::int16_t>()); }

TEST(SlabKernels, OfDoubleAgreeOnAllProcessors) {
  std::vector<double> voxels = noise<double>();
  for (std::size_t at = 5; at < voxels.size(); at += 997) voxels[at] = std::numeric_limits<double>::quiet_NaN();
  expectAlike(std::move(voxels));
}

/// What the kernel for any processor makes of a ramp, which is known: a linear field is greatest at a line's end, and
/// its mean is that of the line's middle.
TEST(SlabKernels, TheOneForAnyProcessorIsRight) {
  constexpr int all = side + 2 * border;
  std::vector<double> ramp;
  for (int z = 0; z < all; ++z)
    for (int y = 0; y < all; ++y)
      for (int x = 0; x < all; ++x) ramp.push_back(20.0 * (x - border) - 10.0 * (y - border) + 30.0 * (z - border));
  ramp.push_back(0.0);
  const std::vector<std::int16_t> stored(ramp.begin(), ramp.end());
  const SlabLines lines = linesAlong(directions[0], 1.0);
  int compared = 0;
  const auto check = [&](const SlabSums& means, const SlabSums& extremes, double tolerance) {
    for (int j = tile.top; j < tile.bottom; ++j)
      for (int i = tile.left; i < tile.right; ++i) {
        const int pixel = (j - tile.top) * (tile.right - tile.left) + i - tile.left;
        if (means.length[pixel] < 20.0 - 1e-4) continue;  // cut off by the volume, where the field is no ramp
        double middle = 0.0, perMm = 0.0;
        for (const auto& [axis, slope] : {std::pair(0, 20.0), {1, -10.0}, {2, 30.0}}) {
          middle += slope * (lines.first[axis] + i * lines.right[axis] + j * lines.down[axis] + lines.along[axis]);
          perMm += slope * lines.along[axis];
        }
        EXPECT_NEAR(means.sum[pixel] / means.length[pixel], middle, tolerance);
        EXPECT_NEAR(extremes.extreme[pixel], middle + 10.0 * perMm, tolerance);
        ++compared;
      }
  };
  for (const bool ofInt16 : {true, false}) {
    SlabBox box;
    box.voxels = ofInt16 ? static_cast<const void*>(stored.data()) : ramp.data();
    box.row = all;
    box.plane = all * all;
    for (double& first : box.first) first = -border;
    SlabSums means = nothing(), extremes = nothing();
    slabKernels(true, ofInt16).back()(lines, box, tile, -9.0, 11.0, means);
    slabKernels(false, ofInt16).back()(lines, box, tile, -9.0, 11.0, extremes);
    check(means, extremes, ofInt16 ? 0.01 : 1e-9);
  }
  EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace fenestra::slab_kernels_test
