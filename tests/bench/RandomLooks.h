#pragma once
// Random transfer functions and views, to measure errors on looks that were not chosen by hand.

#include <random>

#include "rendering/settings/Camera.h"
#include "rendering/settings/TransferFunction.h"
#include "rendering/volume/Volume.h"

namespace fenestra::bench {

/// Two to seven nodes anywhere in the range of values, some of them clear, the others of all opacities from 0.003 to
/// 0.9 over 1 mm alike.
TransferFunction randomTransfer(ValueRange range, std::mt19937& random);

/// Seven nodes anywhere in the range of values, of any colour and any opacity up to 0.35 over 1 mm: steep where nodes
/// are near each other, and nowhere clear.
TransferFunction steepTransfer(ValueRange range, std::mt19937& random);

/// From anywhere but the poles, in perspective or in parallel projection.
Camera randomCamera(const Grid& grid, std::mt19937& random);

}  // namespace fenestra::bench
