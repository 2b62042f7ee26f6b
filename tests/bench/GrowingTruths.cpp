#include "tests/bench/GrowingTruths.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "io/LabelReader.h"
#include "io/PhantomFile.h"
#include "io/VolumeReader.h"
#include "rendering/segmentation/VoxelBox.h"
#include "tests/support/TestData.h"

namespace fenestra::bench {

using namespace segmentation;

constexpr int leastInner = 20;  ///< voxels

std::vector<Structure> structures() {
  const std::string torso = "labelled/totalsegmentator-torso/example_ct.nii.gz";
  const std::string organs = "labelled/totalsegmentator-torso/example_seg_fast_force_split.nii.gz";
  const std::string brain = "labelled/brain-colin27/ch2.nii.gz", regions = "labelled/brain-colin27/aal.nii.gz";
  const std::string chest = "labelled/slicer-ctchest/CTChest4.nrrd";
  const std::string segments = "labelled/slicer-ctchest/Segmentation.seg.nrrd";
  const std::string lung = "labelled/elastix-lung/3DCT_lung.mha";
  const std::string mask = "labelled/elastix-lung/3DCT_lung_baseline_mask.mha";
  const auto body = [](const std::string& part, const std::string& kind) {
    return "labelled/bodyparts3d/" + part + "/" + part + "_" + kind + ".nii.gz";
  };
  return {{"left kidney", torso, organs, {3}, true},
          {"right kidney", torso, organs, {2}, true},
          {"spleen", torso, organs, {1}, true},
          {"liver", torso, organs, {5}, true},
          {"bladder", torso, organs, {21}, true},
          {"aorta", torso, organs, {52}, true},
          {"vertebra L3", torso, organs, {29}, true},
          {"vertebra L1", torso, organs, {31}, true},
          {"left hip", torso, organs, {77}, true},
          {"stomach", torso, organs, {6}, true},
          {"vena cava", torso, organs, {63}, true},
          {"sacrum", torso, organs, {25}, true},
          {"left rib 10", torso, organs, {101}, true},
          {"right rib 10", torso, organs, {113}, true},
          {"right rib 11", torso, organs, {114}, true},
          {"vertebra L5", torso, organs, {27}, true},
          {"right hip", torso, organs, {78}, true},
          {"left rib 11", torso, organs, {102}, true},
          {"right rib 8", torso, organs, {111}, true},
          {"left lung, its base", torso, organs, {10, 11}, true},
          {"both lungs (elastix)", lung, mask, {1}, true},
          {"right lung (chest)", chest, segments, {5}, true},
          {"left lung (chest)", chest, segments, {6}, true},
          {"phantom: right lung", "torso", "", {6}, true},
          {"phantom: liver", "torso", "", {12}, true},
          {"phantom: spleen", "torso", "", {17}},
          {"phantom: left kidney", "torso", "", {20}},
          {"phantom: lesion", "torso", "", {43}, true},
          {"phantom: tumour", "head", "", {25}},
          {"phantom: ventricles", "head", "", {21}, true},
          {"putamen", brain, regions, {73}, true},
          {"thalamus", brain, regions, {77}, true},
          {"caudate nucleus", brain, regions, {71}, true},
          {"made: left kidney", body("torso", "ct"), body("torso", "seg"), {3}},
          {"made: right kidney", body("torso", "ct"), body("torso", "seg"), {2}, true},
          {"made: spleen", body("torso", "ct"), body("torso", "seg"), {1}, true},
          {"made: liver", body("torso", "ct"), body("torso", "seg"), {5}, true},
          {"made: gallbladder", body("torso", "ct"), body("torso", "seg"), {4}, true},
          {"made: bladder", body("torso", "ct"), body("torso", "seg"), {21}},
          {"made: trachea", body("torso", "ct"), body("torso", "seg"), {16}},
          {"made: right ventricle", body("torso", "ct"), body("torso", "seg"), {170}},
          {"made: aorta", body("torso", "ct"), body("torso", "seg"), {52}, true},
          {"made: vena cava", body("torso", "ct"), body("torso", "seg"), {63}, true},
          {"made: vertebra L3", body("torso", "ct"), body("torso", "seg"), {29}, true},
          {"made: vertebra L4", body("torso", "ct"), body("torso", "seg"), {28}},
          {"made: vertebra T7", body("torso", "ct"), body("torso", "seg"), {37}, true},
          {"made: left hip", body("torso", "ct"), body("torso", "seg"), {77}, true},
          {"made: right hip", body("torso", "ct"), body("torso", "seg"), {78}},
          {"made: left femur", body("torso", "ct"), body("torso", "seg"), {75}, true},
          {"made: left rib 6", body("torso", "ct"), body("torso", "seg"), {97}, true},
          {"made: right rib 7", body("torso", "ct"), body("torso", "seg"), {110}},
          {"made: left eye", body("head", "ct"), body("head", "seg"), {140}, true},
          {"made: right eye", body("head", "ct"), body("head", "seg"), {142}},
          {"made: mandible", body("head", "ct"), body("head", "seg"), {151}, true},
          {"made: vertebra C2", body("head", "ct"), body("head", "seg"), {49}, true},
          {"made: radius", body("hand", "ct"), body("hand", "seg"), {122}, true},
          {"made: ulna", body("hand", "ct"), body("hand", "seg"), {123}, true},
          {"made: capitate", body("hand", "ct"), body("hand", "seg"), {143}, true},
          {"made: scaphoid", body("hand", "ct"), body("hand", "seg"), {147}},
          {"made: first metacarpal", body("hand", "ct"), body("hand", "seg"), {138}, true},
          {"made: third metacarpal", body("hand", "ct"), body("hand", "seg"), {140}, true},
          {"made: calcaneus", body("foot", "ct"), body("foot", "seg"), {146}, true},
          {"made: cuboid", body("foot", "ct"), body("foot", "seg"), {147}},
          {"made: tibia", body("foot", "ct"), body("foot", "seg"), {124}, true},
          {"made: fibula", body("foot", "ct"), body("foot", "seg"), {125}}};
}

std::optional<LabelledVolume> dataOf(const Structure& structure) {
  static std::map<std::string, LabelledVolume> opened;
  const auto known = opened.find(structure.image);
  if (known != opened.end()) return known->second;
  LabelledVolume data;
  if (structure.labels.empty()) {
    const io::OpenedPhantom phantom = io::openPhantom(structure.image, phantomVoxels);
    data.volume = phantom.volume.volume;
    data.labels = phantom.labels;
  } else {
    const std::filesystem::path image = tests::findTestData(structure.image);
    if (image.empty()) return std::nullopt;
    data.volume = io::openVolume(image).volume;
    data.labels = io::openLabels(tests::findTestData(structure.labels), data.volume->grid).labels;
  }
  data.memory = GrowthMemory(TissueTree::build(*data.volume));
  return opened[structure.image] = data;
}

Mask truthOf(const Structure& structure, const LabelMap& labels) {
  Mask truth = maskOf(labels, structure.values.front());
  for (const std::uint16_t value : structure.values) {
    const Mask part = maskOf(labels, value);
    for (std::size_t i = 0; i < part.voxels.size(); ++i) truth.voxels[i] |= part.voxels[i];
  }
  return truth;
}

std::vector<std::size_t> innerVoxels(const Mask& truth) {
  const VoxelBox whole = wholeOf(truth.grid.dims);
  std::vector<std::size_t> inner, all;
  for (std::size_t i = 0; i < truth.voxels.size(); ++i) {
    if (!truth.voxels[i]) continue;
    all.push_back(i);
    bool surrounded = true;
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        glm::ivec3 at = whole.at(i);
        at[axis] += step;
        surrounded = surrounded && whole.contains(at) && truth.voxels[truth.grid.offset(at)];
      }
    if (surrounded) inner.push_back(i);
  }
  return inner.size() < leastInner ? all : inner;
}

glm::dvec3 worldOf(const Grid& grid, std::size_t offset) {
  return glm::dvec3(grid.worldFromIndex() * glm::dvec4(glm::dvec3(wholeOf(grid.dims).at(offset)), 1.0));
}

Mask partWith(std::size_t seed, const Mask& all) {
  const VoxelBox whole = wholeOf(all.grid.dims);
  Mask part{all.grid, std::vector<std::uint8_t>(all.voxels.size(), 0)};
  part.voxels[seed] = 1;
  for (std::vector<std::size_t> front{seed}; !front.empty();) {
    const glm::ivec3 at = whole.at(front.back());
    front.pop_back();
    const VoxelBox around = VoxelBox{at - 1, at + 2}.clippedTo(whole);
    for (std::size_t i = 0; i < around.count(); ++i) {
      const std::size_t next = whole.offset(around.at(i));
      if (!all.voxels[next] || part.voxels[next]) continue;
      part.voxels[next] = 1;
      front.push_back(next);
    }
  }
  return part;
}

double diceOf(const Mask& mask, const Mask& truth) {
  double both = 0.0, either = 0.0;
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
    both += mask.voxels[i] && truth.voxels[i];
    either += (mask.voxels[i] != 0) + (truth.voxels[i] != 0);
  }
  return 2.0 * both / either;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace fenestra::bench
