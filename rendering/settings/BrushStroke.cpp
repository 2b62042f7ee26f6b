#include "rendering/settings/BrushStroke.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace fenestra {
namespace {

bool isFinite(glm::dvec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// Anchors closer than this share of the radius count as one: the rim moves by less than 1/16 of the radius.
constexpr double leastStep = 1.0 / 16.0;

}  // namespace

bool isEffective(const BrushStroke& stroke) {
  const bool movesRays = stroke.mode == BrushMode::Restore || stroke.mode == BrushMode::Open;
  const double effect = movesRays ? stroke.depth : stroke.amount;
  return !stroke.hidden && !stroke.anchors.empty() && stroke.radius > 0.0 && std::isfinite(stroke.radius) &&
         stroke.softness >= 0.0 && stroke.softness <= 1.0 && effect > 0.0 &&
         (movesRays ? std::isfinite(effect) : effect <= 1.0) &&
         std::all_of(stroke.anchors.begin(), stroke.anchors.end(), isFinite);
}

BrushStrokes strokesIn(int view, const BrushStrokes& strokes) {
  BrushStrokes chosen;
  std::copy_if(strokes.begin(), strokes.end(), std::back_inserter(chosen),
               [=](const BrushStroke& stroke) { return stroke.view < 0 || stroke.view == view; });
  return chosen;
}

bool extend(BrushStroke& stroke, glm::dvec3 anchor) {
  if (!isFinite(anchor)) return false;
  if (!stroke.anchors.empty() && glm::distance(stroke.anchors.back(), anchor) < leastStep * stroke.radius) return false;
  stroke.anchors.push_back(anchor);
  return true;
}

}  // namespace fenestra
