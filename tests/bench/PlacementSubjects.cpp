#include "tests/bench/PlacementSubjects.h"

#include <filesystem>
#include <iostream>

#include "tests/support/TestData.h"

namespace fenestra::bench {
namespace {

/// Collects structures; leaves out those whose data is not there, and says so.
class Structures {
 public:
  void phantom(const std::string& name, const std::string& body, std::vector<std::string> labels) {
    io::StudyRequest scene;
    scene.makePlain();
    scene.phantom = body;
    scene.focusLabels = std::move(labels);
    list_.push_back({name, scene, true});
  }
  void labelled(const std::string& name, const std::string& image, const std::string& labels,
                std::vector<std::string> focus) {
    io::StudyRequest scene;
    scene.makePlain();
    scene.path = tests::findTestData(image);
    scene.labels = tests::findTestData(labels);
    scene.focusLabels = std::move(focus);
    if (scene.path.empty() || scene.labels.empty())
      std::cerr << "left out " << name << ": needs " << image << '\n';
    else
      list_.push_back({name, scene});
  }
  void ranged(const std::string& name, const std::filesystem::path& image, ValueRange range) {
    io::StudyRequest scene;
    scene.makePlain();
    scene.path = image;
    scene.focusRange = range;
    if (image.empty())
      std::cerr << "left out " << name << '\n';
    else
      list_.push_back({name, scene});
  }
  std::vector<Structure> take() { return std::move(list_); }

 private:
  std::vector<Structure> list_;
};

const std::string torso = "labelled/totalsegmentator-torso/example_ct.nii.gz";
const std::string organs = "labelled/totalsegmentator-torso/example_seg_fast_force_split.nii.gz";

void addVisibleHumansHead(Structures& list) {
  list.ranged("Visible Human head: skull", tests::unpackTestData("visible-human/VHMCT1mm_Head.tar.xz", "VHMCT1mm_Head"),
              {300.0, 3000.0});
}

}  // namespace

std::vector<Structure> structures() {
  Structures list;
  list.phantom("phantom torso: organs", "torso", {});
  list.phantom("phantom head: tumour, ventricles", "head", {});
  list.labelled("torso: kidneys", torso, organs, {"2", "3"});
  list.labelled("torso: aorta", torso, organs, {"52"});
  list.ranged("CT head: skull", tests::findTestData("ct-head/ct.nii.gz"), {0.6, 1.0});
  list.labelled("torso: liver", torso, organs, {"5"});
  const std::string brain = "labelled/brain-colin27/ch2.nii.gz", regions = "labelled/brain-colin27/aal.nii.gz";
  list.labelled("brain: hippocampus", brain, regions, {"37", "38"});
  list.labelled("brain: thalamus", brain, regions, {"77", "78"});
  list.labelled("chest: right and left lung", "labelled/slicer-ctchest/CTChest4.nrrd",
                "labelled/slicer-ctchest/Segmentation.seg.nrrd", {"right lung", "left lung"});
  addVisibleHumansHead(list);
  list.labelled("torso: spleen", torso, organs, {"1"});
  list.labelled("torso: vertebra L1", torso, organs, {"31"});
  return list.take();
}

std::vector<Structure> paperSubjects() {
  Structures list;
  const auto body = [&](const std::string& name, const std::string& region, std::vector<std::string> focus) {
    const std::string start = "labelled/bodyparts3d/" + region + "/" + region;
    list.labelled(name, start + "_ct.nii.gz", start + "_seg.nii.gz", std::move(focus));
  };
  body("hand: carpus", "hand", {"143", "144", "145", "146", "147", "148", "149", "150"});
  body("foot: talus, calcaneus", "foot", {"146", "152"});
  addVisibleHumansHead(list);
  list.labelled("torso: kidneys, aorta", torso, organs, {"2", "3", "52"});
  return list.take();
}

}  // namespace fenestra::bench
