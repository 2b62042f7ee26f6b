#include "tests/bench/GrowingSteadiness.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <random>

#include "rendering/segmentation/RegionGrowing.h"
#include "tests/bench/GrowingTruths.h"

namespace fenestra::bench {
namespace {

using namespace segmentation;

const std::vector<Variant> variants{{"as it is"},    {"10 HU", 10.0},      {"20 HU", 20.0},
                                    {"40 HU", 40.0}, {"2 slices", 0.0, 2}, {"4 slices", 0.0, 4}};

Mask regionAt(const LabelledVolume& data, glm::ivec3 seed) {
  const Grid& grid = data.volume->grid;
  const RegionFocus click{{worldOf(grid, grid.offset(seed))}, {}, {}, {}, RegionRule::Tissues};
  const Growth growth = *growRegion(*data.volume, click, wholeOf(grid.dims), {}, data.memory);
  return maskAt(growth, growth.curve.automatic);
}

/// The Dice of a click, and the share of its region's volume by which the region of a neighbouring voxel differs.
struct Click {
  double dice = 0.0, change = 0.0;
};

Click clickAt(const LabelledVolume& data, const Mask& truth, std::size_t seed, std::mt19937& random) {
  const VoxelBox whole = wholeOf(truth.grid.dims);
  const Mask region = regionAt(data, whole.at(seed));
  glm::ivec3 neighbour = whole.at(seed);
  neighbour[static_cast<int>(random() % 3)] += random() % 2 ? 1 : -1;
  neighbour = glm::clamp(neighbour, glm::ivec3(0), truth.grid.dims - 1);
  const Mask moved = regionAt(data, neighbour);
  double size = 0.0, different = 0.0;
  for (std::size_t i = 0; i < region.voxels.size(); ++i) {
    size += region.voxels[i];
    different += region.voxels[i] != moved.voxels[i];
  }
  return {diceOf(region, truth), different / std::max(1.0, size)};
}

/// Medians of the structures in one variant.
struct Medians {
  std::vector<double> dice, change;
  void add(double ofDice, double ofChange) {
    dice.push_back(ofDice);
    change.push_back(ofChange);
  }
  auto steady() const {
    return std::count_if(change.begin(), change.end(), [](double share) { return share < 0.03; });
  }
};

void writeCell(std::ostream& page, double dice, double change) {
  page << std::fixed << ' ' << std::setprecision(2) << dice << " / " << std::setprecision(1) << 100.0 * change << " |";
}

}  // namespace

LabelledVolume changed(const LabelledVolume& from, const Variant& variant) {
  const auto volume = std::make_shared<Volume>();
  volume->grid = from.volume->grid;
  volume->grid.dims.z /= variant.slices;
  // The centre of the first slice is that of those it stands for.
  const double shift = 0.5 * (variant.slices - 1) * volume->grid.spacing.z;
  volume->grid.origin += volume->grid.direction[2] * shift;
  volume->grid.spacing.z *= variant.slices;
  volume->modality = from.volume->modality;
  volume->unit = from.volume->unit;
  volume->windows = from.volume->windows;
  volume->voxels = Voxels(ScalarType::Float32, volume->grid.voxelCount());
  const auto labels = std::make_shared<LabelMap>();
  labels->grid = volume->grid;
  labels->labels = from.labels->labels;
  labels->voxels = Voxels(ScalarType::UInt16, volume->grid.voxelCount());
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 1.0);
  const VoxelBox whole = wholeOf(volume->grid.dims);
  from.labels->voxels.visit([&](auto values) {
    for (std::size_t i = 0; i < whole.count(); ++i) {
      const glm::ivec3 at = whole.at(i);
      double sum = 0.0;
      std::map<int, int> counts;
      for (int slice = 0; slice < variant.slices; ++slice) {
        const glm::ivec3 source(at.x, at.y, at.z * variant.slices + slice);
        sum += from.volume->value(source);
        ++counts[static_cast<int>(values[from.volume->grid.offset(source)])];
      }
      const auto most = std::max_element(counts.begin(), counts.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
      const double value = sum / variant.slices + (variant.noise > 0.0 ? variant.noise * noise(random) : 0.0);
      volume->voxels.as<float>()[i] = static_cast<float>(value);
      labels->voxels.as<std::uint16_t>()[i] = static_cast<std::uint16_t>(most->first);
    }
  });
  volume->computeRange();
  return {volume, labels, GrowthMemory()};
}

void writeSteadiness(const std::filesystem::path& folder, const std::vector<std::string>& parts, int seeds) {
  std::filesystem::create_directories(folder);
  std::ofstream page(folder / "growing-steadiness.md");
  page << "# Clicks in noise and thick slices\n\nMedian Dice of a click over " << seeds
       << " random inner voxels, a fifth of that in volumes of more than ten million voxels; behind the stroke, by "
          "which "
          "share of its volume the region of a neighbouring voxel differs from it, in %. Noise is added to each voxel; "
          "slices are averaged: the torso's are 3 mm thick, the elastix lung's 2.5 mm, the chest's 10 mm. Wanted: a "
          "change "
          "of less than 3 % (median). `growing-bench --steadiness` writes this page.\n\n| structure |";
  for (const Variant& variant : variants) page << ' ' << variant.name << " |";
  page << "\n|---|---|---|---|---|---|---|\n";
  std::map<std::pair<std::string, std::string>, LabelledVolume> made;
  std::map<std::string, Medians> all;  // by variant
  for (const Structure& structure : structures()) {
    if (!namesOne(structure, parts)) continue;
    const std::optional<LabelledVolume> data = dataOf(structure);
    if (!data || !data->volume->isInHounsfieldUnits()) continue;
    page << "| " << structure.name << " |";
    for (const Variant& variant : variants) {
      const auto key = std::pair(structure.image, variant.name);
      if (!made.contains(key)) {
        // The variants of one volume at a time: they are large.
        if (!made.empty() && made.begin()->first.first != structure.image) made.clear();
        made[key] = changed(*data, variant);
      }
      const LabelledVolume& changedData = made.at(key);
      const Mask truth = truthOf(structure, *changedData.labels);
      const std::vector<std::size_t> inner = innerVoxels(truth);
      std::mt19937 random(12345);
      std::vector<double> dice, change;
      const bool isLarge = data->volume->grid.voxelCount() > largeVolume;
      for (int i = 0; i < (isLarge ? std::max(1, seeds / 5) : seeds); ++i) {
        const std::size_t seed = inner[random() % inner.size()];
        const Click click = clickAt(changedData, partWith(seed, truth), seed, random);
        dice.push_back(click.dice);
        change.push_back(click.change);
      }
      all[variant.name].add(median(dice), median(change));
      writeCell(page, median(dice), median(change));
    }
    page << '\n' << std::flush;
    std::cerr << structure.name << '\n';
  }
  page << "| **median of the structures** |";
  for (const Variant& variant : variants)
    if (all.contains(variant.name)) writeCell(page, median(all[variant.name].dice), median(all[variant.name].change));
  page << "\n| structures that change by less than 3 % |";
  for (const Variant& variant : variants) page << ' ' << all[variant.name].steady() << " |";
  page << '\n';
}

}  // namespace fenestra::bench
