#include "rendering/segmentation/RegionBalls.h"

#include <algorithm>

namespace fenestra::segmentation {
namespace {

constexpr double largestBall = 25.0, largestBallSides = 40.0;  ///< mm, and voxel sides, whichever is less
constexpr double bodyReach = 2.0;  ///< voxel sides: an irregular surface has balls that grow no farther than this
constexpr double farNearer = 0.8;  ///< of the distance from a body that the seed inside has

}  // namespace

RegionBalls::RegionBalls(const Grid& grid, std::span<const Level> joins, int step)
    : whole_(wholeOf(grid.dims)),
      joins_(joins),
      step_(step),
      worldFromIndex_(grid.worldFromIndex()),
      side_(segmentation::voxelSide(grid)),
      largest_(std::min(largestBall, largestBallSides * side_)),
      offsets_(nearestFirst(grid, largest_)) {}

double RegionBalls::lengthOf(glm::ivec3 offset) const {
  return glm::length(glm::dvec3(worldFromIndex_ * glm::dvec4(glm::dvec3(offset), 0.0)));
}

HeldBall RegionBalls::ballAt(glm::ivec3 voxel) const {
  HeldBall ball{voxel, largest_, largest_};
  for (const auto& [offset, length] : offsets_) {
    if (holds(voxel + offset)) continue;
    ball.radius = std::min(ball.radius, length);
    if (!whole_.contains(voxel + offset)) continue;
    ball.depth = length;
    break;
  }
  return ball;
}

HeldBall RegionBalls::grown(HeldBall ball, double HeldBall::*measure) const {
  for (bool grows = true; grows && ball.*measure < largest_;) {
    HeldBall best = ball;
    for (const auto& [offset, length] : offsets_) {
      if (length > std::max(bodyReach * side_, std::min(ball.*measure, 1.5 * bodyReach * side_))) break;
      if (!holds(ball.centre + offset)) continue;
      if (const HeldBall next = ballAt(ball.centre + offset); next.*measure > best.*measure) best = next;
    }
    grows = best.*measure > ball.*measure;
    ball = best;
  }
  return ball;
}

bool RegionBalls::means(const HeldBall& outside, const HeldBall& inside, const HeldBall& body) const {
  return lengthOf(body.centre - outside.centre) <
         std::max(outside.radius, farNearer * lengthOf(body.centre - inside.centre));
}

}  // namespace fenestra::segmentation
