#pragma once
// The dense voxels of a CT, with the marrow that they enclose, and how deep each lies.

#include <vector>

#include "rendering/segmentation/Levels.h"
#include "rendering/segmentation/Smoothing.h"
#include "rendering/segmentation/VoxelSet.h"
#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

inline constexpr double boneFrom = 125.0;  ///< HU: spongy bone begins here, soft tissue without contrast agent ends

/// Voxels of at least boneFrom after smoothing, and what they enclose in an axial, sagittal or coronal plane if it is
/// no larger than a marrow canal: bone is brightest in its shell. Contrast agent, calcifications and metal are dense,
/// too. `volume` is in Hounsfield units, `noise` its own. Runs on all cores.
VoxelSet boneVoxels(const Volume& volume, const Noise& noise);

/// Whether boneVoxels() has a voxel in the ball around one, whose offsets are given: takes a few milliseconds, where
/// boneVoxels() takes nearly a second of a large volume. `volume` is in Hounsfield units.
bool isNearBone(const Volume& volume, glm::ivec3 voxel, const std::vector<glm::ivec3>& ball);

/// By voxel of the volume: how far its value lies below boneFrom, as a cost; nothing for what is dense. Runs on all
/// cores.
std::vector<Level> boneCosts(const Volume& volume, const Noise& noise);

/// By number: mm from the centre of a voxel of the set to that of the nearest one outside it. Each voxel compares the
/// nearest outside voxels of its neighbours (P.-E. Danielsson: Euclidean distance mapping, Computer Graphics and Image
/// Processing 14, 1980), so that a few distances are too long by a small part of a voxel. The volume's faces are no
/// outside: a bone that the scan cuts is not thin there. 0 where nothing is outside.
std::vector<float> depthsOf(const VoxelSet& voxels, const Grid& grid);

}  // namespace fenestra::segmentation
