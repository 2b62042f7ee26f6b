#pragma once
// Tissues side by side, and the order in which they merge, see TissueTree.

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "rendering/segmentation/MergeTree.h"
#include "rendering/segmentation/TissueCells.h"

namespace fenestra::segmentation {

struct Tissue {
  double volume = 0.0;   ///< mm³
  double tones = 0.0;    ///< units of the noise times mm³
  double surface = 0.0;  ///< mm², without faces of the volume
  double mean() const { return tones / volume; }
};

/// The faces that two tissues have in common.
struct TissueContact {
  std::uint32_t a = 0, b = 0;
  float area = 0.0f;        ///< mm²
  float difference = 0.0f;  ///< of the values on both sides, units of the noise times mm²
};

struct Tissues {
  std::vector<Tissue> all;
  std::vector<TissueContact> contacts;  ///< each pair of tissues once
};

/// One tissue a basin.
Tissues tissuesOf(const TissueCells& cells, const Basins& basins);

/// Merges the cheapest pair first until no two touch. Empty when `goOn` has returned false.
std::optional<MergeTree> mergeTissues(Tissues tissues, const std::function<bool(double)>& goOn);

}  // namespace fenestra::segmentation
