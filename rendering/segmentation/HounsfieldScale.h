#pragma once
// The units of a CT whose values are not Hounsfield's: for transfer functions and presets.

#include <optional>

#include "rendering/segmentation/HounsfieldGuess.h"
#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

/// The scale of a CT in other units than Hounsfield's: stored values with 1024 added, or else hounsfieldGuess(), where
/// a volume of unknown modality must hold compact bone, too. Empty where the volume is in Hounsfield units or is no CT.
/// Reads some million voxels.
std::optional<HounsfieldScale> hounsfieldScaleOf(const Volume& volume);

}  // namespace fenestra::segmentation
