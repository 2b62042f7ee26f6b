#pragma once
// A spline volume sampled on a finer grid, for shaders that interpolate trilinearly.
//
// Each voxel becomes factor³ of them, the factor odd: the volume's box stays the same, the finer grid's cells lie whole
// in cells of the volume (so a label's trilinear indicator is trilinear in each), and every voxel's centre is one of
// theirs. In the cell frame (index + 1) a position x of the volume's grid is factor · x - (factor - 1)/2 of the finer
// one.
//
// Between samples h = 1/factor voxels apart, the trilinear interpolant of samples of f exceeds f by h²/12 · f'' in the
// mean for each axis, and by h²/8 · f'' at most. The samples are therefore those of f - h²/12 · f'', taken along each
// axis: the error is then 0 in the mean, so that integrals over a cell are right to fourth order, and h²/12 · |f''| at
// most.

#include <memory>
#include <optional>

#include "rendering/gpu/FocusIndex.h"
#include "rendering/gpu/VolumeTexture.h"
#include "rendering/scene/SplineVolume.h"

namespace fenestra {

/// Samples along the side of a voxel that pictures are made from.
inline constexpr int splineRefinement = 3;

/// The grid of a refined volume.
Grid refined(const Grid& grid, int factor);

/// 16-bit values spread over the spline's range where `volume`, of which `spline` is one, has integers of no more;
/// else floats. Runs on all cores.
std::shared_ptr<const Volume> refinedVolume(const Volume& volume, const SplineVolume& spline, int factor);

/// Bytes that a refined volume takes while it is made and drawn: texture, gradients where `lit`, bricks, coefficients
/// and the samples on their way to the texture.
std::size_t refinedBytes(const Volume& volume, int factor, bool lit);

/// The spline's coefficients in the coded values of `coding`, RGBA32F, from index -1 on along each axis. A texel holds
/// four along x, its own first: a cell's 64 are 16 texels.
gl::Texture makeCoefficients(const SplineVolume& spline, const VolumeCoding& coding);

/// Widens the ranges of a refined volume's samples by brick, which have no octants, so that the spline itself lies
/// between them: between samples it differs from its trilinear interpolant by an eighth of the second differences along
/// each axis, and the samples from it by a twelfth. Taken twice, because the differences change from sample to sample.
void widen(BrickRanges& bricks, const Volume& samples);

/// The light's normals of a spline of `volume` at its voxels (rendering/scene/Lighting.h).
SplineVectors gatedNormals(const Volume& volume, const SplineVolume& spline);
/// Their coefficients, RGB10A2, zero at 511/1023, from index -1 on along each axis.
gl::Texture makeCoefficients(const SplineVectors& normals);
/// A texture for the normals at the refined voxels in a box of those, placed as by makeGradientTexture(), without
/// texels. To allocate it takes as long as to find the normals, so that both are done at once.
GradientTexture refinedGradientFor(glm::ivec3 dims, int factor, const std::optional<IndexBox>& box);
/// Fills the texture that refinedGradientFor() made for the same factor and box.
void fillRefinedGradient(GradientTexture& gradient, const SplineVectors& normals, int factor,
                         const std::optional<IndexBox>& box);

/// By brick of the refined grid: 1 where some of the focus lies in it, else 0. `dims`: of the volume.
std::vector<std::uint8_t> refinedOccupied(const FocusIndex& focus, glm::ivec3 dims, int factor);

}  // namespace fenestra
