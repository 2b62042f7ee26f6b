#pragma once
// The focus as one segment.

#include <memory>
#include <string>

#include "rendering/scene/Scene.h"

namespace fenestra::io {

/// The voxels in focus as a label map of one label of that name, on the volume's grid; null without a focus. Labels in
/// focus: their voxels. A range of values: voxels whose value, as 3-D pictures show it, lies in the range and that
/// touch a cell that ValueFocus keeps, so that the parts it is too small for are left out. `scene` is one that is
/// drawn, in which a region is a label.
std::shared_ptr<const LabelMap> focusSegment(const Scene& scene, const std::string& name);

}  // namespace fenestra::io
