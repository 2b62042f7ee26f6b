#include "rendering/segmentation/BoneVoxels.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "rendering/segmentation/Morphology.h"
#include "rendering/segmentation/Smoothing.h"
#include "rendering/segmentation/VoxelBox.h"
#include "rendering/volume/Threads.h"

namespace fenestra::segmentation {
namespace {

constexpr double softTissue = 40.0;     ///< HU: the reference of tones
constexpr double largestCanal = 800.0;  ///< mm² in one plane: a medullary cavity, a vertebral canal

bool reaches(const Volume& volume, const VoxelBox& box, double least) {
  return volume.voxels.visit([&](auto scalars) {
    for (int z = box.low.z; z < box.high.z; ++z)
      for (int y = box.low.y; y < box.high.y; ++y) {
        const auto* row = scalars.data() + volume.grid.offset({box.low.x, y, z});
        for (int x = 0; x < box.dims().x; ++x)
          if (finiteValue(row[x], volume) >= least) return true;
      }
    return false;
  });
}

/// 1 where the smoothed value is dense.
std::vector<std::uint8_t> denseVoxels(const Volume& volume) {
  const ToneScale scale(volume, noiseOf(volume), softTissue);
  const auto least = static_cast<float>(scale(boneFrom));
  const VoxelBox whole = wholeOf(volume.grid.dims);
  std::vector<std::uint8_t> dense(whole.count(), 0);
  constexpr glm::ivec3 tile(128, 32, 32);  // intermediate arrays that fit a core's cache
  const VoxelBox tiles = wholeOf((whole.dims() + tile - 1) / tile);
  parallelFor(tiles.count(), 1, [&](std::size_t begin, std::size_t end) {
    ToneSmoother smoother(volume, scale);
    for (std::size_t i = begin; i < end; ++i) {
      interruptionPoint();
      const glm::ivec3 low = tiles.at(i) * tile;
      const VoxelBox box = VoxelBox{low, low + tile}.clippedTo(whole);
      if (!reaches(volume, box.grownBy(glm::ivec3(2)).clippedTo(whole), boneFrom)) continue;
      const std::span<const float> tones = smoother(box);
      for (std::size_t v = 0; v < tones.size(); ++v)
        if (tones[v] >= least) dense[whole.offset(box.at(v))] = 1;
    }
  });
  return dense;
}

/// The holes in one plane of a mask.
class PlaneFiller {
 public:
  PlaneFiller(glm::ivec3 dims, int axis, const Grid& grid) : axis_(axis), u_((axis + 1) % 3), v_((axis + 2) % 3) {
    width_ = dims[u_];
    height_ = dims[v_];
    const glm::dvec3 a = grid.direction[u_] * grid.spacing[u_], b = grid.direction[v_] * grid.spacing[v_];
    most_ = static_cast<std::size_t>(largestCanal / glm::length(glm::cross(a, b)));
    states_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  }

  /// filled(voxel) for each voxel in a hole of the plane `at` of `mask`.
  template <class Filled>
  void run(std::span<const std::uint8_t> mask, const VoxelBox& whole, int at, Filled filled) {
    for (int v = 0; v < height_; ++v)
      for (int u = 0; u < width_; ++u) states_[offset(u, v)] = mask[whole.offset(voxel(u, v, at))] ? Dense : Unknown;
    for (int v = 0; v < height_; ++v)
      for (int u = 1; u < width_; ++u)
        // Every hole has a voxel behind a dense one.
        if (states_[offset(u, v)] == Unknown && states_[offset(u - 1, v)] == Dense && isHole(u, v))
          for (const glm::ivec2 each : found_) filled(voxel(each.x, each.y, at));
  }

 private:
  enum State : std::uint8_t { Unknown, Dense, Seen, Open };

  std::size_t offset(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(u);
  }
  glm::ivec3 voxel(int u, int v, int at) const {
    glm::ivec3 index;
    index[axis_] = at;
    index[u_] = u;
    index[v_] = v;
    return index;
  }

  /// Finds what is connected to a voxel, until that is too large, leaves the plane or meets what does.
  bool isHole(int u, int v) {
    found_.assign(1, {u, v});
    states_[offset(u, v)] = Seen;
    bool isOpen = false;
    for (std::size_t i = 0; i < found_.size() && !isOpen; ++i)
      for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
        const glm::ivec2 next = found_[i] + step;
        if (next.x < 0 || next.y < 0 || next.x == width_ || next.y == height_) {
          isOpen = true;
          continue;
        }
        State& state = states_[offset(next.x, next.y)];
        isOpen = isOpen || state == Open;
        if (state != Unknown) continue;
        state = Seen;
        found_.push_back(next);
      }
    isOpen = isOpen || found_.size() > most_;
    if (isOpen)
      for (const glm::ivec2 each : found_) states_[offset(each.x, each.y)] = Open;
    return !isOpen;
  }

  int axis_, u_, v_, width_ = 0, height_ = 0;
  std::size_t most_ = 0;  ///< voxels
  std::vector<State> states_;
  std::vector<glm::ivec2> found_;
};

void fillCanals(std::vector<std::uint8_t>& mask, const Grid& grid) {
  const VoxelBox whole = wholeOf(grid.dims);
  // Apart from the mask: what one plane fills encloses nothing in another.
  std::vector<std::uint8_t> filled(mask.size(), 0);
  for (int axis = 0; axis < 3; ++axis)
    parallelFor(static_cast<std::size_t>(grid.dims[axis]), 1, [&](std::size_t begin, std::size_t end) {
      PlaneFiller filler(grid.dims, axis, grid);
      for (std::size_t at = begin; at < end; ++at)
        filler.run(mask, whole, static_cast<int>(at), [&](glm::ivec3 voxel) { filled[whole.offset(voxel)] = 1; });
    });
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] |= filled[i];
}

/// Passes on the nearest voxel outside from voxel to voxel, the nearest first.
class DepthSpreader {
 public:
  DepthSpreader(const VoxelSet& voxels, const Grid& grid)
      : voxels_(voxels),
        whole_(wholeOf(grid.dims)),
        steps_(grid.direction[0] * grid.spacing.x, grid.direction[1] * grid.spacing.y,
               grid.direction[2] * grid.spacing.z),
        perBucket_(voxelSide(grid) / bucketsPerSide),
        depths_(voxels.size(), std::numeric_limits<float>::infinity()),
        ways_(voxels.size(), glm::i16vec3(0)) {}

  std::vector<float> run() {
    for (std::uint32_t number = 0; number < voxels_.size(); ++number) begin(number);
    for (std::size_t bucket = 0; bucket < waiting_.size(); ++bucket)
      for (std::size_t i = 0; i < waiting_[bucket].size(); ++i) {
        const std::uint32_t number = waiting_[bucket][i];
        if (bucketOf(depths_[number]) == bucket) passOn(number);
      }
    for (float& depth : depths_)
      if (!std::isfinite(depth)) depth = 0.0f;
    return std::move(depths_);
  }

 private:
  static constexpr double bucketsPerSide = 16.0;

  std::size_t bucketOf(float depth) const { return static_cast<std::size_t>(static_cast<double>(depth) / perBucket_); }

  template <class Visit>
  void forNeighbours(std::uint32_t number, Visit visit) const {
    const glm::ivec3 at = whole_.at(voxels_.offsets()[number]);
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
          if (const glm::ivec3 step(x, y, z); step != glm::ivec3(0) && whole_.contains(at + step))
            visit(step, whole_.offset(at + step));
  }

  void take(std::uint32_t number, glm::ivec3 way) {
    const auto depth = static_cast<float>(glm::length(steps_ * glm::dvec3(way)));
    if (!(depth < depths_[number])) return;
    depths_[number] = depth;
    ways_[number] = glm::i16vec3(way);
    const std::size_t bucket = bucketOf(depth);
    if (waiting_.size() <= bucket) waiting_.resize(bucket + 1);
    waiting_[bucket].push_back(number);
  }

  void begin(std::uint32_t number) {
    forNeighbours(number, [&](glm::ivec3 step, std::size_t offset) {
      if (!voxels_.holds(offset)) take(number, step);
    });
  }

  void passOn(std::uint32_t number) {
    const glm::ivec3 way(ways_[number]);
    forNeighbours(number, [&](glm::ivec3 step, std::size_t offset) {
      if (voxels_.holds(offset)) take(voxels_.numberOf(offset), way - step);
    });
  }

  const VoxelSet& voxels_;
  VoxelBox whole_;
  glm::dmat3 steps_;
  double perBucket_;  ///< mm
  std::vector<float> depths_;
  std::vector<glm::i16vec3> ways_;  ///< by number: to the nearest voxel outside, in voxels
  std::vector<std::vector<std::uint32_t>> waiting_;
};

}  // namespace

VoxelSet boneVoxels(const Volume& volume) {
  assert(volume.isInHounsfieldUnits());
  std::vector<std::uint8_t> mask = denseVoxels(volume);
  fillCanals(mask, volume.grid);
  return VoxelSet(mask);
}

std::vector<Level> boneCosts(const Volume& volume, const Noise& noise) {
  std::vector<Level> costs(volume.grid.voxelCount());
  volume.voxels.visit([&](auto scalars) {
    parallelFor(costs.size(), std::size_t{1} << 16, [&](std::size_t begin, std::size_t end) {
      // Neighbours are seldom far apart: the logarithm is taken anew for another value alone.
      double last = boneFrom;
      Level level = 0;
      for (std::size_t i = begin; i < end; ++i) {
        const double value = finiteValue(scalars[i], volume);
        if (value != last) level = value < boneFrom ? levelOf((boneFrom - value) / noise.unit) : Level{0};
        last = value;
        costs[i] = level;
      }
    });
  });
  return costs;
}

std::vector<float> depthsOf(const VoxelSet& voxels, const Grid& grid) { return DepthSpreader(voxels, grid).run(); }

}  // namespace fenestra::segmentation
