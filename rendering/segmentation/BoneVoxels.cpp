#include "rendering/segmentation/BoneVoxels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <type_traits>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "rendering/segmentation/Morphology.h"
#include "rendering/segmentation/Smoothing.h"
#include "rendering/segmentation/VoxelBox.h"
#include "rendering/volume/Threads.h"

namespace fenestra::segmentation {
namespace {

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

/// Finds the voxels whose smoothed value is dense.
class DenseFinder {
 public:
  /// Both outlive this.
  DenseFinder(const Volume& volume, const ToneScale& scale)
      : volume_(volume), smoother_(volume, scale), least_(static_cast<float>(scale(boneFrom))) {}

  /// take(voxel) for those of a box, which lies in the volume.
  template <class Take>
  void operator()(const VoxelBox& box, Take take) {
    if (!reaches(volume_, box.grownBy(glm::ivec3(2)).clippedTo(wholeOf(volume_.grid.dims)), boneFrom)) return;
    const std::span<const float> tones = smoother_(box);
    for (std::size_t v = 0; v < tones.size(); ++v)
      if (tones[v] >= least_) take(box.at(v));
  }

 private:
  const Volume& volume_;
  ToneSmoother smoother_;
  float least_;
};

ToneScale denseScale(const Volume& volume, const Noise& noise) { return {volume, noise, softTissue}; }

/// 1 where the smoothed value is dense.
std::vector<std::uint8_t> denseVoxels(const Volume& volume, const Noise& noise) {
  const ToneScale scale = denseScale(volume, noise);
  const VoxelBox whole = wholeOf(volume.grid.dims);
  std::vector<std::uint8_t> dense(whole.count(), 0);
  constexpr glm::ivec3 tile(128, 32, 32);  // intermediate arrays that fit a core's cache
  const VoxelBox tiles = wholeOf((whole.dims() + tile - 1) / tile);
  parallelFor(tiles.count(), 1, [&](std::size_t begin, std::size_t end) {
    DenseFinder find(volume, scale);
    for (std::size_t i = begin; i < end; ++i) {
      interruptionPoint();
      const glm::ivec3 low = tiles.at(i) * tile;
      find(VoxelBox{low, low + tile}.clippedTo(whole), [&](glm::ivec3 voxel) { dense[whole.offset(voxel)] = 1; });
    }
  });
  return dense;
}

/// The dense voxels near a place: found block by block, when they are asked about.
class DenseNearby {
 public:
  explicit DenseNearby(const Volume& volume)
      : whole_(wholeOf(volume.grid.dims)), scale_(denseScale(volume, noiseOf(volume))), find_(volume, scale_) {}

  bool holds(std::size_t offset) {
    constexpr int side = 16;
    const glm::ivec3 low = whole_.at(offset) / side * side;
    const auto [block, isNew] = known_.insert(whole_.offset(low));
    if (isNew)
      find_(VoxelBox{low, low + side}.clippedTo(whole_),
            [&](glm::ivec3 voxel) { dense_.insert(whole_.offset(voxel)); });
    return dense_.contains(offset);
  }

 private:
  VoxelBox whole_;
  ToneScale scale_;
  DenseFinder find_;
  std::unordered_set<std::size_t> known_;  ///< offsets of the blocks' first voxels
  std::unordered_set<std::size_t> dense_;  ///< offsets
};

enum class HoleState : std::uint8_t { Unknown, Seen, Open };

/// The holes that dense voxels enclose in the planes across one axis. `Dense` holds offsets, `States` is a container of
/// HoleState by offset.
template <class Dense, class States>
class PlaneHoles {
 public:
  PlaneHoles(Dense& dense, const Grid& grid, int axis, States states = {})
      : dense_(dense), whole_(wholeOf(grid.dims)), u_((axis + 1) % 3), v_((axis + 2) % 3), states_(std::move(states)) {
    const glm::dvec3 a = grid.direction[u_] * grid.spacing[u_], b = grid.direction[v_] * grid.spacing[v_];
    most_ = static_cast<std::size_t>(largestCanal / glm::length(glm::cross(a, b)));
  }

  /// Whether a voxel lies in a hole.
  bool hold(glm::ivec3 voxel) {
    if (dense_.holds(whole_.offset(voxel))) return false;
    return isUnknown(voxel) ? isHole(voxel) : states_[whole_.offset(voxel)] == HoleState::Seen;
  }

  /// Sets the voxels in holes to 1; of `Dense` all are known.
  void fill(std::vector<std::uint8_t>& mask) {
    const std::size_t step = whole_.offset(glm::ivec3(u_ == 0, u_ == 1, u_ == 2));
    for (const std::uint32_t offset : dense_.offsets()) {
      // Every hole has a voxel behind a dense one. Behind most is another one, which is seen without a division.
      if (offset + step >= states_.size() || dense_.holds(offset + step)) continue;
      glm::ivec3 behind = whole_.at(offset);
      ++behind[u_];
      if (isUnknown(behind) && isHole(behind))
        for (const glm::ivec3 each : found_) mask[whole_.offset(each)] = 1;
    }
  }

 private:
  bool isUnknown(glm::ivec3 voxel) {
    return whole_.contains(voxel) && states_[whole_.offset(voxel)] == HoleState::Unknown &&
           !dense_.holds(whole_.offset(voxel));
  }

  /// Finds what is connected to a voxel in its plane, until that is too large, leaves the volume or meets what does.
  bool isHole(glm::ivec3 first) {
    found_.assign(1, first);
    states_[whole_.offset(first)] = HoleState::Seen;
    bool isOpen = false;
    for (std::size_t i = 0; i < found_.size() && !isOpen && found_.size() <= most_; ++i)
      for (const auto& [axis, way] : {std::pair{u_, 1}, {u_, -1}, {v_, 1}, {v_, -1}}) {
        glm::ivec3 next = found_[i];
        next[axis] += way;
        isOpen = isOpen || !whole_.contains(next) || states_[whole_.offset(next)] == HoleState::Open;
        if (isOpen) break;
        if (!isUnknown(next)) continue;
        states_[whole_.offset(next)] = HoleState::Seen;
        found_.push_back(next);
      }
    isOpen = isOpen || found_.size() > most_;
    if (isOpen)
      for (const glm::ivec3 each : found_) states_[whole_.offset(each)] = HoleState::Open;
    return !isOpen;
  }

  Dense& dense_;
  VoxelBox whole_;
  int u_, v_;
  std::size_t most_ = 0;  ///< voxels
  States states_;
  std::vector<glm::ivec3> found_;
};

/// Each plane by itself: what one plane fills encloses nothing in another.
void fillCanals(std::vector<std::uint8_t>& mask, const Grid& grid) {
  const VoxelSet dense(mask);
  for (int axis = 0; axis < 3; ++axis) PlaneHoles(dense, grid, axis, std::vector<HoleState>(mask.size())).fill(mask);
}

/// Hands the nearest voxel outside from neighbour to neighbour, the shortest distance first.
class DepthSpreader {
 public:
  DepthSpreader(const VoxelSet& voxels, const Grid& grid)
      : voxels_(voxels),
        neighbours_(wholeOf(grid.dims)),
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
    neighbours_.visit(voxels_.offsets()[number], [&](glm::ivec3 step, std::size_t offset) {
      if (!voxels_.holds(offset)) take(number, step);
    });
  }

  void passOn(std::uint32_t number) {
    const glm::ivec3 way(ways_[number]);
    neighbours_.visit(voxels_.offsets()[number], [&](glm::ivec3 step, std::size_t offset) {
      if (voxels_.holds(offset)) take(voxels_.numberOf(offset), way - step);
    });
  }

  const VoxelSet& voxels_;
  Neighbours neighbours_;
  glm::dmat3 steps_;
  double perBucket_;  ///< mm
  std::vector<float> depths_;
  std::vector<glm::i16vec3> ways_;  ///< by number: to the nearest voxel outside, in voxels
  std::vector<std::vector<std::uint32_t>> waiting_;
};

}  // namespace

VoxelSet boneVoxels(const Volume& volume, const Noise& noise) {
  assert(volume.isInHounsfieldUnits());
  std::vector<std::uint8_t> mask = denseVoxels(volume, noise);
  fillCanals(mask, volume.grid);
  return VoxelSet(mask);
}

bool isNearBone(const Volume& volume, glm::ivec3 voxel, const std::vector<glm::ivec3>& ball) {
  assert(volume.isInHounsfieldUnits());
  const VoxelBox whole = wholeOf(volume.grid.dims);
  DenseNearby dense(volume);
  const auto anyInBall = [&](auto holds) {
    return std::any_of(ball.begin(), ball.end(),
                       [&](glm::ivec3 offset) { return whole.contains(voxel + offset) && holds(voxel + offset); });
  };
  if (anyInBall([&](glm::ivec3 at) { return dense.holds(whole.offset(at)); })) return true;
  for (int axis = 0; axis < 3; ++axis) {
    PlaneHoles<DenseNearby, std::unordered_map<std::size_t, HoleState>> holes(dense, volume.grid, axis);
    if (anyInBall([&](glm::ivec3 at) { return holes.hold(at); })) return true;
  }
  return false;
}

std::vector<Level> boneCosts(const Volume& volume, const Noise& noise) {
  std::vector<Level> costs(volume.grid.voxelCount());
  volume.voxels.visit([&](auto scalars) {
    using Stored = typename decltype(scalars)::value_type;
    const auto costOf = [&](Stored stored) {
      const double value = finiteValue(stored, volume);
      return value < boneFrom ? levelOf((boneFrom - value) / noise.unit) : Level{0};
    };
    // A logarithm a voxel would take longer than all else.
    std::vector<Level> known;
    if constexpr (sizeof(Stored) <= 2) {
      known.resize(std::size_t{1} << 8 * sizeof(Stored));
      for (std::size_t bits = 0; bits < known.size(); ++bits) known[bits] = costOf(static_cast<Stored>(bits));
    }
    parallelFor(costs.size(), std::size_t{1} << 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if constexpr (sizeof(Stored) <= 2)
          costs[i] = known[static_cast<std::make_unsigned_t<Stored>>(scalars[i])];
        else
          costs[i] = costOf(scalars[i]);
    });
  });
  return costs;
}

std::vector<float> depthsOf(const VoxelSet& voxels, const Grid& grid) { return DepthSpreader(voxels, grid).run(); }

}  // namespace fenestra::segmentation
