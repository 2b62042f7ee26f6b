// growing-bench FOLDER [PART-OF-A-NAME …] [--seeds N] [--steadiness] [--clicks]: grows structures of the labelled data
// and of the phantoms from random seeds, compares them with their labels, takes times on a head, and writes growing.md
// to FOLDER. growing-outcomes.txt beside it keeps what each seed came to: a run that was stopped goes on, and more
// seeds add to it. Or it grows them from neighbouring seeds, in noise and thick slices, and writes
// growing-steadiness.md. With parts of names, only the structures that hold one of them, and no times. --clicks
// compares versions in little time.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>

#include "io/VolumeReader.h"
#include "rendering/segmentation/Flood.h"
#include "rendering/segmentation/Mask.h"
#include "rendering/segmentation/RegionFacts.h"
#include "rendering/segmentation/RegionGrowing.h"
#include "rendering/segmentation/Smoothing.h"
#include "tests/bench/GrowingClicks.h"
#include "tests/bench/GrowingOutcomes.h"
#include "tests/bench/GrowingSteadiness.h"
#include "tests/bench/GrowingTruths.h"
#include "tests/support/TestData.h"

namespace fenestra {
namespace {

using namespace bench;
using namespace segmentation;

/// Dice by step, for regions nested by `steps` (0: never).
struct Scores {
  std::array<double, 256> dice{};
  std::size_t best = 0;  ///< step

  Scores(std::span<const std::uint8_t> steps, const Mask& truth) {
    std::array<double, 256> all{}, right{};
    double size = 0.0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      all[steps[i]] += 1.0;
      right[steps[i]] += truth.voxels[i];
      size += truth.voxels[i];
    }
    double region = 0.0, both = 0.0;
    for (std::size_t step = 1; step < dice.size(); ++step) {
      region += all[step];
      both += right[step];
      dice[step] = 2.0 * both / (region + size);
      if (dice[step] > dice[best]) best = step;
    }
  }
};

Scores scoresOf(const Growth& growth, const Mask& truth) {
  return Scores(growth.steps->voxels.as<std::uint8_t>(), truth);
}

/// The result of a plain tolerance: connected values within it of the mean of 3×3×3 around the seed. Best Dice.
double plainDice(const Volume& volume, std::size_t seed, const Mask& truth) {
  const Grid& grid = volume.grid;
  const VoxelBox whole = wholeOf(grid.dims);
  const double noise = noiseOf(volume).unit;
  const glm::ivec3 at = whole.at(seed);
  const VoxelBox around = VoxelBox{at - 1, at + 2}.clippedTo(whole);
  double sum = 0.0;
  for (std::size_t i = 0; i < around.count(); ++i) sum += volume.value(around.at(i));
  const double mean = sum / static_cast<double>(around.count());
  PaddedLevels costs(grid.dims);
  volume.voxels.visit([&](auto scalars) {
    for (std::size_t i = 0; i < scalars.size(); ++i) {
      const double value = volume.slope * static_cast<double>(scalars[i]) + volume.intercept;
      costs.all()[costs.offset(whole.at(i))] = levelOf(std::abs(value - mean) / noise);
    }
  });
  const Flooded flooded = flood({&costs, {at}}, {}, [](double) { return true; });
  std::vector<std::uint8_t> steps(whole.count());
  for (std::size_t i = 0; i < steps.size(); ++i)
    steps[i] = static_cast<std::uint8_t>(flooded.reached.all()[flooded.reached.offset(whole.at(i))] + 1);
  const Scores scores(steps, truth);
  return scores.dice[scores.best];
}

struct Error {
  std::size_t voxel;
  int depth;  ///< steps over faces to the nearest right voxel
};

/// Where a set of wrong voxels is deepest; empty when it is.
std::optional<Error> deepest(const Mask& wrong) {
  const VoxelBox whole = wholeOf(wrong.grid.dims);
  std::vector<std::uint8_t> left = wrong.voxels;
  std::vector<std::size_t> front, next;
  const auto forNeighbours = [&](std::size_t voxel, auto visit) {
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        glm::ivec3 at = whole.at(voxel);
        at[axis] += step;
        if (whole.contains(at)) visit(whole.offset(at));
      }
  };
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (!left[i]) continue;
    bool isBorder = false;
    forNeighbours(i, [&](std::size_t other) { isBorder = isBorder || !wrong.voxels[other]; });
    if (isBorder) front.push_back(i);
  }
  for (const std::size_t voxel : front) left[voxel] = 0;
  std::optional<Error> last;
  for (int depth = 1; !front.empty(); ++depth, front.swap(next)) {
    last = Error{front[front.size() / 2], depth};
    next.clear();
    for (const std::size_t voxel : front)
      forNeighbours(voxel, [&](std::size_t other) {
        if (!left[other]) return;
        left[other] = 0;
        next.push_back(other);
      });
  }
  return last;
}

/// Voxels in `a` and not in `b`.
Mask without(const Mask& a, const Mask& b) {
  Mask rest = a;
  for (std::size_t i = 0; i < rest.voxels.size(); ++i) rest.voxels[i] &= static_cast<std::uint8_t>(1 - b.voxels[i]);
  return rest;
}

/// A seed where the region is most wrong: inside what it misses, or outside in what it should not hold.
bool correct(RegionFocus& settings, const Mask& region, const Mask& truth) {
  const Mask wrong = without(region, truth), missed = without(truth, region);
  const std::optional<Error> in = deepest(missed), out = deepest(wrong);
  if (!in && !out) return false;
  const bool adds =
      in && (!out || in->depth > out->depth || (in->depth == out->depth && volumeOf(missed) > volumeOf(wrong)));
  if (adds)
    settings.inside.push_back(worldOf(truth.grid, in->voxel));
  else
    settings.outside.push_back(worldOf(truth.grid, out->voxel));
  return true;
}

GrownRegion regionOf(const Volume& volume, const Growth& growth, const Mask& truth) {
  const int step = growth.curve.automatic;
  const RegionFacts facts = GrowthFacts(volume, growth).at(growth, step);
  return {scoresOf(growth, truth).dice[static_cast<std::size_t>(step)], isLeak(facts.volume, truth, growth.bodyVolume),
          shareOfBody(growth, step).value_or(0.0) <= largeShareOfBody, facts.border == Border::Doubtful};
}

ClickOutcome outcomeOf(const LabelledVolume& data, const Mask& truth, std::size_t seed) {
  const Volume& volume = *data.volume;
  const VoxelBox whole = wholeOf(volume.grid.dims);
  RegionFocus settings{{worldOf(volume.grid, seed)}, {}, {}};
  ClickOutcome outcome;
  outcome.plain = plainDice(volume, seed, truth);
  {
    const Growth byValues = *growRegion(volume, settings, whole);
    const auto step = static_cast<std::size_t>(byValues.curve.automatic);
    outcome.values = scoresOf(byValues, truth).dice[step];
    outcome.leaksByValues = isLeak(byValues.curve.volume[step], truth, data.memory.tissues()->bodyVolume());
  }
  settings.rule = RegionRule::Tissues;
  const auto grow = [&] { return *growRegion(volume, settings, whole, {}, data.memory); };
  Growth growth = grow();
  const Scores scores = scoresOf(growth, truth);
  outcome.dragged = scores.dice[scores.best];
  outcome.byTissues[0] = regionOf(volume, growth, truth);
  for (const std::size_t corrections : {1U, 2U}) {
    if (correct(settings, maskAt(growth, growth.curve.automatic), truth)) growth = grow();
    outcome.byTissues[corrections] = regionOf(volume, growth, truth);
  }
  return outcome;
}

/// Adds what `outcomes` lacks of seeds; calls `changed` after each structure.
void measure(ClickOutcomes& outcomes, const std::vector<std::string>& parts, int seeds,
             const std::function<void()>& changed) {
  for (const Structure& structure : structures()) {
    if (!namesOne(structure, parts)) continue;
    const std::optional<LabelledVolume> data = dataOf(structure);
    if (!data) {
      std::cerr << "left out " << structure.name << ": needs " << structure.image << '\n';
      continue;
    }
    const bool isLarge = data->volume->grid.voxelCount() > largeVolume;
    const std::size_t wanted = static_cast<std::size_t>(isLarge ? std::max(1, seeds / 5) : seeds);
    if (outcomes.of(structure.name).size() >= wanted) continue;
    const Mask truth = truthOf(structure, *data->labels);
    const std::vector<std::size_t> inner = innerVoxels(truth);
    std::mt19937 random(12345);
    for (std::size_t i = 0; i < wanted; ++i) {
      const std::size_t seed = inner[random() % inner.size()];
      if (i < outcomes.of(structure.name).size()) continue;
      outcomes.add(structure.name, outcomeOf(*data, partWith(seed, truth), seed));
    }
    changed();
    std::cerr << structure.name << '\n';
  }
}

/// Median of five, ms.
template <class F>
double timed(F&& f) {
  std::vector<double> times;
  for (int i = 0; i < 5; ++i) {
    const auto start = std::chrono::steady_clock::now();
    f();
    times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  return median(times);
}

/// The volume between the same faces with other numbers of voxels.
std::shared_ptr<const Volume> resampled(const Volume& from, glm::ivec3 dims) {
  auto volume = std::make_shared<Volume>();
  volume->grid = from.grid;
  volume->grid.dims = dims;
  volume->grid.spacing = from.grid.spacing * glm::dvec3(from.grid.dims) / glm::dvec3(dims);
  volume->modality = from.modality;
  volume->unit = from.unit;
  volume->voxels = Voxels(ScalarType::Int16, volume->grid.voxelCount());
  const auto values = volume->voxels.as<std::int16_t>();
  const VoxelBox whole = wholeOf(dims);
  const glm::dvec3 step = glm::dvec3(from.grid.dims) / glm::dvec3(dims);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<std::int16_t>(std::lround(from.sample((glm::dvec3(whole.at(i)) + 0.5) * step - 0.5)));
  volume->computeRange();
  return volume;
}

struct TimedClick {
  std::string name;
  glm::ivec3 seed, outside;  ///< voxels; of a correction
};

/// Without the window: see window-bench --grow.
void writeTimes(std::ostream& page, const std::string& name, const Volume& volume,
                const std::vector<TimedClick>& clicks) {
  const VoxelBox whole = wholeOf(volume.grid.dims);
  const auto worldAt = [&](glm::ivec3 index) { return worldOf(volume.grid, volume.grid.offset(index)); };
  for (const TimedClick& click : clicks) {
    RegionFocus settings{{worldAt(click.seed)}, {}, {}};
    settings.rule = RegionRule::Tissues;
    Growth growth;
    GrowthMemory memory;
    const double first = timed([&] { growRegion(volume, settings, previewBox(volume, settings)); });
    const double all = timed([&] {
      memory = {};
      growth = *growRegion(volume, settings, whole, {}, memory);
    });
    Mask mask = maskAt(growth, 1);
    const double change = timed([&] { setMask(mask, growth, growth.curve.automatic); });
    settings.outside = {worldAt(click.outside)};
    const double correction = timed([&] { growRegion(volume, settings, whole, {}, memory); });
    // One byte is the region's own.
    const double held = 1.0 + static_cast<double>(memory.bytes()) / static_cast<double>(whole.count());
    page << "| " << name << ": " << click.name << std::fixed << std::setprecision(0) << " | " << first << " | " << all
         << " | " << correction << " | " << change << " | " << std::setprecision(1) << held << " | "
         << std::setprecision(0) << volumeOf(mask) / 1000.0 << " |\n";
  }
}

void writeTimes(std::ostream& page) {
  page << "| seed | first part, ms | whole region, ms | a correction, ms | mask of another tolerance, ms | held, bytes "
          "a "
          "voxel | region, ml |\n|---|---|---|---|---|---|---|\n";
  if (const auto head = tests::unpackTestData("visible-human/VHMCT1mm_Head.tar.xz", "VHMCT1mm_Head"); !head.empty())
    writeTimes(page, "head", *io::openVolume(head).volume,
               {{"brain", {256, 230, 200}, {256, 330, 180}},
                {"bone", {256, 330, 120}, {256, 330, 150}},
                {"muscle", {330, 300, 20}, {300, 300, 30}}});
  else
    std::cerr << "left out the times of a head: needs visible-human/VHMCT1mm_Head.tar.xz\n";
  if (const auto torso = tests::findTestData("labelled/bodyparts3d/torso/torso_ct.nii.gz"); !torso.empty())
    writeTimes(page, "made torso", *resampled(*io::openVolume(torso).volume, {512, 512, 275}),
               {{"soft tissue", {180, 256, 140}, {200, 240, 140}}, {"near bone", {256, 330, 140}, {256, 330, 160}}});
  else
    std::cerr << "left out the times of a torso: needs labelled/bodyparts3d/torso/torso_ct.nii.gz\n";
}

void writePage(const std::filesystem::path& folder, const ClickOutcomes& outcomes, int seeds, bool withTimes) {
  std::ofstream page(folder / "growing.md");
  page << "# Region growing\n\nMedian Dice over up to " << seeds
       << " random inner voxels as seeds, a fifth of that in volumes of more than ten million voxels. In brackets: how "
          "many of the regions leak, to over twice the structure's volume, or over 15 % of the body where the "
          "structure is less. `growing-bench` writes this page.\n\n"
          "- By values: the region of rule *values* after one click, as sessions of earlier versions have it.\n"
          "- Click: the region of rule *tissues* after one click; it is what the window opens.\n"
          "- Corrections: a seed where the region is most wrong, inside in what it misses or outside in what it should "
          "not hold, whichever is deeper.\n"
          "- Plain tolerance, best: connected values around the seed's, with the tolerance that has the best Dice, "
          "which nobody knows. After one drag: the best tolerance of the click's region, without corrections.\n"
          "- Constants were chosen on the structures marked \\*.\n"
          "- A structure in several parts, such as the ventricles, counts as the part that holds the seed.\n"
          "- AAL labels are an atlas' regions, which T1 values bound in part only. Phantoms have "
       << phantomVoxels
       << " voxels along their longest side. *Made* are the labelled bodies of BodyParts3D, with a scanner's noise.\n\n"
          "## What was wanted, and what is reached\n\nThe median of the structures' medians, and how many of the "
          "structures reach what is wanted. The columns *not tuned on* leave out the structures marked \\*.\n\n";
  outcomes.writeGoals(page);
  page << "\n## Leaks\n\nWanted: 2 % of the seeds after the click, none after two corrections. The window asks before "
          "it opens to more than 15 % of the body.\n\n";
  outcomes.writeLeaks(page);
  page << "\n## Structures\n\n";
  outcomes.writeRows(page);
  if (!withTimes) return;
  page << "\n## Times\n\nBy tissues, on " << std::thread::hardware_concurrency()
       << " cores; medians of five. Head: Visible Human, 512×512×245 voxels. Made torso: BodyParts3D, resampled to "
          "512×512×275. The whole region begins with a volume of which nothing is known. `window-bench --grow` "
          "measures what the window adds: the outline on the slice, and the cameras placed and at rest.\n\n";
  writeTimes(page);
}

void run(const std::filesystem::path& folder, const std::vector<std::string>& parts, int seeds) {
  std::filesystem::create_directories(folder);
  ClickOutcomes outcomes(folder / "growing-outcomes.txt");
  measure(outcomes, parts, seeds, [&] { writePage(folder, outcomes, seeds, false); });
  if (parts.empty()) writePage(folder, outcomes, seeds, true);
}

}  // namespace
}  // namespace fenestra

int main(int argc, char** argv) {
  CLI::App program{"Measures region growing against known structures and writes growing.md.", "growing-bench"};
  std::string folder;
  std::vector<std::string> parts;
  program.add_option("FOLDER", folder, "where the page goes")->required();
  program.add_option("PART", parts, "only the structures whose names hold one of these, and no times");
  int seeds = 20;
  program.add_option("--seeds", seeds, "for each structure")->check(CLI::PositiveNumber);
  bool steadiness = false;
  program.add_flag("--steadiness", steadiness, "how regions change with the seed, in noise and thick slices");
  bool clicks = false;
  program.add_flag("--clicks", clicks, "one click a seed, without corrections; a line each, and no page");
  fenestra::bench::Variant variant;
  program.add_option("--noise", variant.noise, "of the clicks' volumes: HU that are added");
  program.add_option("--slices", variant.slices, "of the clicks' volumes: how many are averaged");
  CLI11_PARSE(program, argc, argv);
  try {
    if (steadiness)
      fenestra::bench::writeSteadiness(folder, parts, seeds);
    else if (clicks)
      fenestra::bench::writeClicks(folder, parts, seeds, variant);
    else
      fenestra::run(folder, parts, seeds);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "growing-bench: " << error.what() << '\n';
    return 1;
  }
}
