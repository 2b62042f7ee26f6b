#pragma once
// How parts of bones meet: where a joint is, a gap darker than the bone on both sides parts them.

#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "rendering/segmentation/VoxelSet.h"
#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

/// The border of two parts of bone. Sums are over its faces, weighted by their area.
struct BoneMeeting {
  double depth = 0.0;  ///< mm: the greatest depth where they touch; 0: they only face each other across a gap
  double dip = 0.0;    ///< HU mm²: how much darker the border is than the darker of its two sides
  double side = 0.0;   ///< HU mm²: the darker of its two sides

  void add(const BoneMeeting& other);
  /// The share of the bone's density that is missing between the parts: cartilage and joint space, blurred by the
  /// scanner, lie between two layers of dense bone; where a bone is thin, its density falls towards no border.
  double gap() const { return side > 0.0 && dip > 0.0 ? dip / side : 0.0; }
};

/// By part: the parts it meets.
using BoneMeetings = std::vector<std::unordered_map<std::uint32_t, BoneMeeting>>;

/// Adds `dip` and `side` of the borders between the parts, which touch, or face each other along an axis across less
/// than bone; in loud noise, of a standard deviation of `noise` HU, less what that makes of one. `parts` is by voxel of
/// the set, `volume` in Hounsfield units. `goOn` is asked now and then; false, and not done, when it returned false.
bool addGaps(const Volume& volume, double noise, const VoxelSet& voxels, std::span<const std::uint32_t> parts,
             BoneMeetings& meetings, const std::function<bool()>& goOn = {});

}  // namespace fenestra::segmentation
