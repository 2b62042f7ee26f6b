#pragma once
// growing-bench --clicks: regions after one click alone, to compare two versions with equal seeds in little time.

#include <filesystem>
#include <string>
#include <vector>

#include "tests/bench/GrowingSteadiness.h"

namespace fenestra::bench {

/// Grows each structure whose name holds one of `parts`, or all without any, from `seeds` random inner voxels, those of
/// the other tables, and writes a line a seed to growing-clicks.tsv in the folder: the structure, * where constants
/// were chosen on it, the seed's voxel and value, the Dice and volume of the region, the structure's, and whether it
/// leaks and is called doubtful. Of the variant of each volume.
void writeClicks(const std::filesystem::path& folder, const std::vector<std::string>& parts, int seeds,
                 const Variant& variant);

}  // namespace fenestra::bench
