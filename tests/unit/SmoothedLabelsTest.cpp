// Smoothed surfaces of the labels of phantoms and of a real label map: their volumes.

#include <iostream>

#include <gtest/gtest.h>

#include "io/LabelReader.h"
#include "io/PhantomFile.h"
#include "io/VolumeReader.h"
#include "tests/support/TestData.h"
#include "tests/unit/SampledIndicator.h"

namespace fenestra::tests::smoothedLabelsTest {
namespace {

/// Holds the smoothed volume of every label of at least `least` voxels to that of the exact surface.
void expectVolumesKept(const LabelMap& map, std::size_t least) {
  std::vector<std::pair<glm::ivec3, glm::ivec3>> boxes(65536, {map.grid.dims, glm::ivec3(-1)});
  std::vector<std::size_t> counts(65536, 0);
  forEachVoxel(map.grid.dims, [&](glm::ivec3 at) {
    const std::uint16_t label = map.value(at);
    auto& [low, high] = boxes[label];
    low = glm::min(low, at);
    high = glm::max(high, at);
    ++counts[label];
  });
  constexpr int margin = 12;
  std::array<double, 3> worst{};
  int compared = 0;
  for (std::size_t label = 1; label < boxes.size(); ++label) {
    if (counts[label] < least) continue;
    ++compared;
    const glm::ivec3 low = boxes[label].first - margin, dims = boxes[label].second - low + margin + 1;
    const auto insideAt = [&](glm::ivec3 at) { return map.grid.contains(low + at) && map.value(low + at) == label; };
    const double before = SampledIndicator(dims, insideAt, LabelSmoothing::Off).volume(6);
    for (const LabelSmoothing strength : {LabelSmoothing::Light, LabelSmoothing::Strong}) {
      const double change = SampledIndicator(dims, insideAt, strength).volume(6) / before - 1.0;
      EXPECT_LT(std::abs(change), 0.01) << "label " << label << " of " << counts[label] << " voxels, strength "
                                        << int(strength);
      double& most = worst[static_cast<std::size_t>(strength)];
      most = std::max(most, std::abs(change));
    }
  }
  std::cout << compared << " labels: volumes change by at most " << 100.0 * worst[1] << " % (light) and "
            << 100.0 * worst[2] << " % (strong)\n";
  EXPECT_GT(compared, 0);
}

TEST(SmoothedLabels, Exhaustive_OfPhantomsKeepTheirVolume) {
  for (const std::string& name : io::phantomNames()) expectVolumesKept(*io::openPhantom(name, 60).labels, 1);
}

TEST(SmoothedLabels, Exhaustive_OfATorsoKeepTheirVolume) {
  FENESTRA_TEST_DATA_OR_SKIP(image, "labelled/totalsegmentator-torso/example_ct.nii.gz");
  FENESTRA_TEST_DATA_OR_SKIP(labels, "labelled/totalsegmentator-torso/example_seg_fast_force_split.nii.gz");
  const auto volume = io::openVolume(image).volume;
  expectVolumesKept(*io::openLabels(labels, volume->grid).labels, 1);
}

}  // namespace
}  // namespace fenestra::tests::smoothedLabelsTest
