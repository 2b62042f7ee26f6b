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
  return {{"left kidney", Kind::Organ, torso, organs, {3}, true},
          {"right kidney", Kind::Organ, torso, organs, {2}, true},
          {"spleen", Kind::Organ, torso, organs, {1}, true},
          {"liver", Kind::Organ, torso, organs, {5}, true},
          {"bladder", Kind::Fluid, torso, organs, {21}, true},
          {"aorta", Kind::Vessel, torso, organs, {52}, true},
          {"vertebra L3", Kind::Spine, torso, organs, {29}, true},
          {"vertebra L1", Kind::Spine, torso, organs, {31}, true},
          {"left hip", Kind::Bone, torso, organs, {77}, true},
          {"stomach", Kind::Other, torso, organs, {6}, true},
          {"vena cava", Kind::Vessel, torso, organs, {63}, true},
          {"sacrum", Kind::Other, torso, organs, {25}, true},
          {"left rib 10", Kind::Spine, torso, organs, {101}, true},
          {"right rib 10", Kind::Spine, torso, organs, {113}, true},
          {"right rib 11", Kind::Spine, torso, organs, {114}, true},
          {"vertebra L5", Kind::Spine, torso, organs, {27}, true},
          {"right hip", Kind::Bone, torso, organs, {78}, true},
          {"left rib 11", Kind::Spine, torso, organs, {102}, true},
          {"right rib 8", Kind::Spine, torso, organs, {111}, true},
          {"pancreas", Kind::Other, torso, organs, {7}},
          {"duodenum", Kind::Other, torso, organs, {19}},
          {"portal vein", Kind::Other, torso, organs, {64}},
          {"left iliac artery", Kind::Other, torso, organs, {65}},
          {"left gluteus medius", Kind::Other, torso, organs, {82}, true},
          {"right back muscles", Kind::Other, torso, organs, {87}},
          {"left iliopsoas", Kind::Other, torso, organs, {88}},
          {"vertebra L2", Kind::Spine, torso, organs, {30}},
          {"vertebra L4", Kind::Spine, torso, organs, {28}},
          {"left lung, its base", Kind::Air, torso, organs, {10, 11}, true},
          {"both lungs (elastix)", Kind::Air, lung, mask, {1}, true},
          {"right lung (chest)", Kind::Air, chest, segments, {5}, true},
          {"left lung (chest)", Kind::Air, chest, segments, {6}, true},
          {"phantom: right lung", Kind::Air, "torso", "", {6}, true},
          {"phantom: liver", Kind::Organ, "torso", "", {12}, true},
          {"phantom: spleen", Kind::Organ, "torso", "", {17}},
          {"phantom: left kidney", Kind::Organ, "torso", "", {20}},
          {"phantom: lesion", Kind::Other, "torso", "", {43}, true},
          {"phantom: tumour", Kind::Other, "head", "", {25}},
          {"phantom: ventricles", Kind::Fluid, "head", "", {21}, true},
          {"putamen", Kind::Nucleus, brain, regions, {73}, true},
          {"thalamus", Kind::Nucleus, brain, regions, {77}, true},
          {"caudate nucleus", Kind::Nucleus, brain, regions, {71}, true},
          {"right putamen", Kind::Nucleus, brain, regions, {74}},
          {"right thalamus", Kind::Nucleus, brain, regions, {78}},
          {"right caudate nucleus", Kind::Nucleus, brain, regions, {72}},
          {"hippocampus", Kind::Other, brain, regions, {37}},
          {"made: left kidney", Kind::Organ, body("torso", "ct"), body("torso", "seg"), {3}},
          {"made: right kidney", Kind::Organ, body("torso", "ct"), body("torso", "seg"), {2}, true},
          {"made: spleen", Kind::Organ, body("torso", "ct"), body("torso", "seg"), {1}, true},
          {"made: liver", Kind::Organ, body("torso", "ct"), body("torso", "seg"), {5}, true},
          {"made: gallbladder", Kind::Other, body("torso", "ct"), body("torso", "seg"), {4}, true},
          {"made: bladder", Kind::Fluid, body("torso", "ct"), body("torso", "seg"), {21}},
          {"made: trachea", Kind::Air, body("torso", "ct"), body("torso", "seg"), {16}},
          {"made: right ventricle", Kind::Other, body("torso", "ct"), body("torso", "seg"), {170}},
          {"made: aorta", Kind::Vessel, body("torso", "ct"), body("torso", "seg"), {52}, true},
          {"made: vena cava", Kind::Vessel, body("torso", "ct"), body("torso", "seg"), {63}, true},
          {"made: left iliac artery", Kind::Other, body("torso", "ct"), body("torso", "seg"), {65}},
          {"made: vertebra L3", Kind::Spine, body("torso", "ct"), body("torso", "seg"), {29}, true},
          {"made: vertebra L4", Kind::Spine, body("torso", "ct"), body("torso", "seg"), {28}},
          {"made: vertebra T7", Kind::Spine, body("torso", "ct"), body("torso", "seg"), {37}, true},
          {"made: left hip", Kind::Bone, body("torso", "ct"), body("torso", "seg"), {77}, true},
          {"made: right hip", Kind::Bone, body("torso", "ct"), body("torso", "seg"), {78}},
          {"made: left femur", Kind::Bone, body("torso", "ct"), body("torso", "seg"), {75}, true},
          {"made: left rib 6", Kind::Spine, body("torso", "ct"), body("torso", "seg"), {97}, true},
          {"made: right rib 7", Kind::Spine, body("torso", "ct"), body("torso", "seg"), {110}},
          {"made: left eye", Kind::Fluid, body("head", "ct"), body("head", "seg"), {140}, true},
          {"made: ventricles", Kind::Fluid, body("head", "ct"), body("head", "seg"), {139}},
          {"made: right eye", Kind::Fluid, body("head", "ct"), body("head", "seg"), {142}},
          {"made: mandible", Kind::Other, body("head", "ct"), body("head", "seg"), {151}, true},
          {"made: vertebra C2", Kind::Spine, body("head", "ct"), body("head", "seg"), {49}, true},
          {"made: radius", Kind::Bone, body("hand", "ct"), body("hand", "seg"), {122}, true},
          {"made: ulna", Kind::Bone, body("hand", "ct"), body("hand", "seg"), {123}, true},
          {"made: capitate", Kind::Bone, body("hand", "ct"), body("hand", "seg"), {143}, true},
          {"made: scaphoid", Kind::Bone, body("hand", "ct"), body("hand", "seg"), {147}},
          {"made: first metacarpal", Kind::Bone, body("hand", "ct"), body("hand", "seg"), {138}, true},
          {"made: third metacarpal", Kind::Bone, body("hand", "ct"), body("hand", "seg"), {140}, true},
          {"made: calcaneus", Kind::Bone, body("foot", "ct"), body("foot", "seg"), {146}, true},
          {"made: cuboid", Kind::Bone, body("foot", "ct"), body("foot", "seg"), {147}},
          {"made: tibia", Kind::Bone, body("foot", "ct"), body("foot", "seg"), {124}, true},
          {"made: fibula", Kind::Bone, body("foot", "ct"), body("foot", "seg"), {125}}};
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

bool namesOne(const Structure& structure, const std::vector<std::string>& parts) {
  return parts.empty() || std::ranges::any_of(parts, [&](const std::string& part) {
           return structure.name.find(part) != std::string::npos;
         });
}

bool isLeak(double volume, const Mask& truth, double body) {
  const double size = volumeOf(truth);
  return volume > 2.0 * size || (size <= 0.15 * body && volume > 0.15 * body);
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
