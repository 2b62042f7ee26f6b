#pragma once
// Hounsfield units of a CT whose values are others: rescaled to 0 … 1, offset by 1024, or of 12 bits.

#include <memory>
#include <optional>

#include "rendering/segmentation/VoxelBox.h"
#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

/// HU = factor · real value + offset.
struct HounsfieldScale {
  double factor = 1.0, offset = 0.0;

  /// The real value of HU.
  double realAt(double hounsfield) const { return (hounsfield - offset) / factor; }
};

/// The measures say how much the values are spread as a CT's are.
struct HounsfieldGuess : HounsfieldScale {
  double soft = 0.0;    ///< of the body's voxels, those within 60 HU of the peak of soft tissue, or between it and that
                        ///< of fat where this is higher
  double valley = 0.0;  ///< how many voxels have values half-way between air and soft tissue, of those at the peak
  double bone = 0.0;    ///< of the body's voxels, those of bone
};

/// From the peaks of air and of soft tissue, -1000 and 45 HU. Empty where the volume is in Hounsfield units, is of
/// another modality, or has values that are not spread as in CT: a narrow peak of soft tissue far above air, next to
/// nothing between the two, some bone. Where no modality is known, the peak must be narrower: MR's tissues are not as
/// alike as those in CT. Reads about a million voxels.
std::optional<HounsfieldGuess> hounsfieldGuess(const Volume& volume);

/// A copy of the voxels of a box in the units of a guess.
std::shared_ptr<const Volume> inHounsfieldUnits(const Volume& volume, const HounsfieldGuess& guess,
                                                const VoxelBox& box);

}  // namespace fenestra::segmentation
