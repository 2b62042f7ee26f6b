#include "tests/bench/GrowingClicks.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <optional>
#include <random>

#include "rendering/segmentation/RegionFacts.h"
#include "rendering/segmentation/RegionGrowing.h"
#include "tests/bench/GrowingTruths.h"

namespace fenestra::bench {

using namespace segmentation;

void writeClicks(const std::filesystem::path& folder, const std::vector<std::string>& parts, int seeds,
                 const Variant& variant) {
  std::filesystem::create_directories(folder);
  std::ofstream lines(folder / "growing-clicks.tsv");
  lines << "structure\ttuned\tseed\tvalue\tDice\tml\ttrue ml\tleaks\tdoubtful\n";
  const bool isChanged = variant.noise > 0.0 || variant.slices > 1;
  std::string image;
  LabelledVolume data;  // of `image`
  for (const Structure& structure : structures()) {
    if (!namesOne(structure, parts)) continue;
    const std::optional<LabelledVolume> found = dataOf(structure);
    if (!found) {
      std::cerr << "left out " << structure.name << ": needs " << structure.image << '\n';
      continue;
    }
    if (structure.image != image) data = isChanged ? changed(*found, variant) : *found;
    image = structure.image;
    const Volume& volume = *data.volume;
    const VoxelBox whole = wholeOf(volume.grid.dims);
    const Mask all = truthOf(structure, *data.labels);
    const std::vector<std::size_t> inner = innerVoxels(all);
    std::mt19937 random(12345);
    std::vector<double> dices;
    for (int i = 0; i < seeds; ++i) {
      const std::size_t seed = inner[random() % inner.size()];
      const Mask truth = partWith(seed, all);
      RegionFocus settings{{worldOf(volume.grid, seed)}, {}, {}};
      settings.rule = RegionRule::Tissues;
      const Growth growth = *growRegion(volume, settings, whole, {}, data.memory);
      const Mask region = maskAt(growth, growth.curve.automatic);
      const RegionFacts facts = GrowthFacts(volume, growth).at(growth, growth.curve.automatic);
      const glm::ivec3 at = whole.at(seed);
      dices.push_back(diceOf(region, truth));
      lines << structure.name << '\t' << (structure.tuned ? "*" : "") << '\t' << at.x << ' ' << at.y << ' ' << at.z
            << '\t' << volume.value(at) << '\t' << dices.back() << '\t' << volumeOf(region) / 1000.0 << '\t'
            << volumeOf(truth) / 1000.0 << '\t' << isLeak(volumeOf(region), truth, growth.bodyVolume) << '\t'
            << (facts.border == Border::Doubtful) << std::endl;
    }
    std::cerr << structure.name << ": " << median(dices) << std::endl;
  }
}

}  // namespace fenestra::bench
