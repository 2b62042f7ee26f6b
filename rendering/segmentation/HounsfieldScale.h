#pragma once
// The units of a CT whose values are not Hounsfield's: for transfer functions and presets.

#include <optional>

#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

/// HU = factor · real value + offset.
struct HounsfieldScale {
  double factor = 1.0, offset = 0.0;

  /// The real value of HU.
  double realAt(double hounsfield) const { return (hounsfield - offset) / factor; }
};

/// Of a CT in other units than Hounsfield's: stored values with 1024 added, or else hounsfieldGuess(), where a volume
/// of unknown modality must hold compact bone, too. Empty where the volume is in Hounsfield units or is no CT. Reads
/// some million voxels.
std::optional<HounsfieldScale> hounsfieldScaleOf(const Volume& volume);

}  // namespace fenestra::segmentation
