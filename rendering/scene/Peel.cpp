#include "rendering/scene/Peel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rendering/scene/FocusVoxels.h"
#include "rendering/scene/Scene.h"
#include "rendering/scene/VisibleFraming.h"

namespace fenestra {
namespace {

constexpr double pi = std::numbers::pi;

glm::dvec3 directionOf(PeelSide side) {
  switch (side) {
    case PeelSide::Anterior:
      break;
    case PeelSide::Posterior:
      return {0.0, 1.0, 0.0};
    case PeelSide::Left:
      return {1.0, 0.0, 0.0};
    case PeelSide::Right:
      return {-1.0, 0.0, 0.0};
    case PeelSide::Superior:
      return {0.0, 0.0, 1.0};
    case PeelSide::Inferior:
      return {0.0, 0.0, -1.0};
  }
  return {0.0, -1.0, 0.0};
}

/// Columns u, v and a.
glm::dmat3 axesOf(const MethodStages::Peel& peel) {
  const glm::dvec3 a = directionOf(peel.side);
  const glm::dvec3 head = a.z == 0.0 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 beside = glm::cross(a, head);
  const double turn = peel.turn * pi / 180.0;
  const glm::dvec3 u = std::cos(turn) * head + std::sin(turn) * beside;
  return {u, glm::cross(a, u), a};
}

}  // namespace

std::optional<MethodStages::Peel> peelOf(const Look& look) {
  return look.cutaway.enabled ? stagesOf(look.method).peel : std::nullopt;
}

Grid bodyBox(const ShownVolume& shown) {
  constexpr double leastTissue = -500.0, leastShare = 0.1;  // HU; of the range
  const Volume& volume = *shown.volume;
  const double least = volume.isInHounsfieldUnits()
                           ? leastTissue
                           : volume.range.low + leastShare * (volume.range.high - volume.range.low);
  TransferFunction solid;
  solid.nodes = {{least, {glm::dvec3(1.0), 0.0}}, {least, {glm::dvec3(1.0), 1.0}}};
  return visibleGrid(shown, solid);
}

Peel::Peel(const MethodStages::Peel& peel, const FocusVoxels& focus, const Grid& grid, const Grid& body)
    : axes_(axesOf(peel)) {
  const glm::dmat3 toLocal = glm::transpose(axes_);
  const glm::dmat3 fromIndex(grid.worldFromIndex());
  glm::dvec3 half(0.0);  // of a voxel's extent along the axes
  for (int axis = 0; axis < 3; ++axis) half += 0.5 * glm::abs(toLocal * fromIndex[axis]);
  glm::dvec3 low = toLocal * grid.centre(), high = low;
  if (const auto extent = focus.extent(axes_)) {
    low = extent->low - half;
    high = extent->high + half;
  }
  const double breakAt = high.z + half.z - peel.depth * (high.z - low.z + 2.0 * half.z);
  origin_ = axes_ * glm::dvec3(0.5 * (low.x + high.x), 0.5 * (low.y + high.y), breakAt);
  double front = breakAt;
  for (const glm::dvec3& corner : body.corners()) front = std::max(front, glm::dot(corner, axes_[2]));
  thickness_ = front - breakAt;
  glm::dvec3 least = local(grid.centre()), greatest = least;
  for (const glm::dvec3& corner : grid.corners()) {
    least = glm::min(least, local(corner));
    greatest = glm::max(greatest, local(corner));
  }
  halfLength_ = std::min(0.5 * (high.x - low.x) + peel.margin, std::max(-least.x, greatest.x));
  halfWidth_ = std::min(0.5 * (high.y - low.y) + peel.margin, std::max(-least.y, greatest.y));
  along_ = {std::max(-halfLength_, least.x), std::min(halfLength_, greatest.x)};
  radius_ = thickness_ + peel.radius;
  roll_ = peel.amount * (halfWidth_ + radius_);
}

Peel::Source Peel::sourceOf(glm::dvec3 place) const {
  const glm::dvec3 at = local(place);
  if (at.z < hair || std::abs(at.x) > halfLength_ - hair) return {Part::InPlace, place};
  const double across = std::abs(at.y), side = at.y < 0.0 ? -1.0 : 1.0;
  const bool isOpen = across < roll_ - hair;
  const Source none{isOpen ? Part::Nothing : Part::InPlace, place};
  const glm::dvec2 fromAxis(roll_ - across, radius_ - at.z);
  const double height = isOpen ? radius_ - glm::length(fromAxis) : 2.0 * radius_ - at.z;
  if (height < 0.0 || height > thickness_) return none;
  const double length = isOpen ? radius_ * std::atan2(fromAxis.x, fromAxis.y) : pi * radius_ + across - roll_;
  if (length > roll_) return none;
  return {side < 0.0 ? Part::Negative : Part::Positive, world({at.x, side * (roll_ - length), height})};
}

glm::dvec3 Peel::shownAt(glm::dvec3 place) const {
  const glm::dvec3 at = local(place);
  const double length = roll_ - std::abs(at.y), side = at.y < 0.0 ? -1.0 : 1.0;
  if (at.z < hair || at.z > thickness_ || std::abs(at.x) > halfLength_ - hair || length <= hair) return place;
  const double turn = length / radius_, inner = radius_ - at.z;
  if (turn > pi) return world({at.x, side * (roll_ + length - pi * radius_), radius_ + inner});
  return world({at.x, side * (roll_ - inner * std::sin(turn)), radius_ - inner * std::cos(turn)});
}

std::array<glm::dvec3, 8> Peel::reach() const {
  // Sideways no farther than what folds back beyond the roll; up to the top of the roll, or of the layer's end.
  const double turn = std::min(roll_ / radius_, pi);
  const double side = roll_ + std::max(roll_ - pi * radius_, 0.0), top = radius_ - radius_ * std::cos(turn);
  const double inner = radius_ - (radius_ - thickness_) * std::cos(turn);
  std::array<glm::dvec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] =
        world({i & 1u ? along_.y : along_.x, i & 2u ? side : -side, i & 4u ? std::max({top, inner, thickness_}) : 0.0});
  return corners;
}

}  // namespace fenestra
