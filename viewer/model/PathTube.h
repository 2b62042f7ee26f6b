#pragma once
// The tube around the path of the curved reformat as a focus, to which the view opens along the path: a region that is
// painted with one stroke. So slices, sessions and programs have it as any region; whether a focus is the tube of a
// path follows from the stroke, and nothing else is kept.

#include <optional>
#include <vector>

#include "rendering/settings/Focus.h"

namespace fenestra::viewer {

/// The region within `radius` mm of the curve through the points of a path, two or more (LPS, mm).
RegionFocus tubeAround(const std::vector<glm::dvec3>& path, double radius);

/// mm, where the focus is the tube around that path; empty otherwise.
std::optional<double> tubeRadius(const Focus& focus, const std::vector<glm::dvec3>& path);

}  // namespace fenestra::viewer
