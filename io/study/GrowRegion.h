#pragma once
// The region that a user asks for by seeds and strokes, grown in the whole volume.

#include <memory>
#include <string>

#include "io/base/Reading.h"
#include "rendering/segmentation/RegionGrowing.h"

namespace fenestra::io {

/// Seeds and balls outside the volume are left out, and the region may come out empty. `memory` keeps what corrections
/// need. Throws Cancelled.
std::shared_ptr<const segmentation::Growth> growRegion(const Volume& volume, const RegionFocus& region,
                                                       const Progress& progress = {},
                                                       const segmentation::GrowthMemory& memory = {});

/// As growRegion, but throws Error that names `source` where a seed or ball lies outside the volume or no voxel joins.
std::shared_ptr<const segmentation::Growth> growWholeRegion(const Volume& volume, const RegionFocus& region,
                                                            const std::string& source, const Progress& progress = {});

}  // namespace fenestra::io
