#pragma once
// Levels of importance of labels: which labels are opened to, and which of them give way to which.

#include <cstdint>
#include <vector>

#include "rendering/scene/Scene.h"

namespace fenestra {

/// Every label has a level of importance (I. Viola, A. Kanitsar, M. E. Gröller: Importance-driven volume rendering,
/// IEEE Visualization 2004), and so has a point: it is of level k or more where the interpolated 0/1 indicator of the
/// labels of level k or more is ½ or more, with the smoothing of the focus where it has one. A point without a label
/// has level 0.
///
/// Let x be where a ray first meets context or focus, H_k where it first meets level k or more, or x where that lies
/// deeper. For each level k > 0 in use there is a cut:
///
///   C_k = H_k where the ray meets level k or more, else where it leaves the last of the cones that stand on the
///         silhouette of all H_k, not before x (rendering/passes/ConePass.h)          Maximum
///         H_k where the ray meets level k or more, else none                         Average
///
/// A point of level j gives way where it lies in front of the cut of a level above its own, C_k with k > j: it is gone,
/// or with Average it is kept as faintly as what hides the focus. It never gives way to its own level or a lower one.
///
/// So a ray starts at the deepest of its cuts, max_k C_k. Proof: what lies behind all cuts lies behind those of the
/// higher levels. A point is of its own level j and so of every level k ≤ j, which the ray then meets: C_k is H_k, and
/// the point, where it shows anything, lies at H_k or behind it. So nothing lies before a cut that it does not give way
/// to. What a ray is opened to, the deepest H_k where it starts there, stands for its focus hit in all later stages;
/// a ray that starts deeper, on a cone within a less important label, has none. Where another camera cuts the opening,
/// the most important labels stand for the focus.
///
/// Levels count for a focus of labels with the method Importance; a value focus and a grown region have one. A label
/// that is not in focus and is hidden or not visible has level 0.

/// The level of importance of a label of structuresOf(scene).
int importanceOf(const Scene& scene, std::uint16_t label);

/// For each level above 0 in use, from the lowest up, the labels of that level or more, ascending. Empty where the
/// focus is the one level, or the picture has none. One empty set where nothing is important.
std::vector<std::vector<std::uint16_t>> importanceLevels(const Scene& scene);

}  // namespace fenestra
