#pragma once
// How regions change with the voxel that was clicked, in noise and in thick slices.

#include <filesystem>
#include <string>
#include <vector>

#include "tests/bench/GrowingTruths.h"

namespace fenestra::bench {

/// A change of a labelled volume before a click.
struct Variant {
  std::string name;
  double noise = 0.0;  ///< HU, standard deviation
  int slices = 1;      ///< of the volume's, averaged
};
LabelledVolume changed(const LabelledVolume& from, const Variant& variant);

/// Writes growing-steadiness.md to `folder`: of the structures in Hounsfield units that namesOne() finds, with
/// `seeds` seeds each, a fifth of that in large volumes.
void writeSteadiness(const std::filesystem::path& folder, const std::vector<std::string>& parts, int seeds);

}  // namespace fenestra::bench
