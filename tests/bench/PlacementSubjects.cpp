#include "tests/bench/PlacementSubjects.h"

#include <filesystem>
#include <iostream>

#include "tests/support/TestData.h"

namespace fenestra::bench {

std::vector<Structure> structures() {
  std::vector<Structure> list;
  const auto phantom = [&](const std::string& name, const std::string& body, std::vector<std::string> labels) {
    io::StudyRequest scene;
    scene.makePlain();
    scene.phantom = body;
    scene.focusLabels = std::move(labels);
    list.push_back({name, scene, true});
  };
  const auto labelled = [&](const std::string& name, const std::string& image, const std::string& labels,
                            std::vector<std::string> focus) {
    io::StudyRequest scene;
    scene.makePlain();
    scene.path = tests::findTestData(image);
    scene.labels = tests::findTestData(labels);
    scene.focusLabels = std::move(focus);
    if (scene.path.empty() || scene.labels.empty())
      std::cerr << "left out " << name << ": needs " << image << '\n';
    else
      list.push_back({name, scene});
  };
  const auto ranged = [&](const std::string& name, const std::filesystem::path& image, ValueRange range) {
    io::StudyRequest scene;
    scene.makePlain();
    scene.path = image;
    scene.focusRange = range;
    if (image.empty())
      std::cerr << "left out " << name << '\n';
    else
      list.push_back({name, scene});
  };
  phantom("phantom torso: organs", "torso", {});
  phantom("phantom head: tumour, ventricles", "head", {});
  const std::string torso = "labelled/totalsegmentator-torso/example_ct.nii.gz";
  const std::string organs = "labelled/totalsegmentator-torso/example_seg_fast_force_split.nii.gz";
  labelled("torso: kidneys", torso, organs, {"2", "3"});
  labelled("torso: aorta", torso, organs, {"52"});
  ranged("CT head: skull", tests::findTestData("ct-head/ct.nii.gz"), {0.6, 1.0});
  labelled("torso: liver", torso, organs, {"5"});
  const std::string brain = "labelled/brain-colin27/ch2.nii.gz", regions = "labelled/brain-colin27/aal.nii.gz";
  labelled("brain: hippocampus", brain, regions, {"37", "38"});
  labelled("brain: thalamus", brain, regions, {"77", "78"});
  labelled("chest: right and left lung", "labelled/slicer-ctchest/CTChest4.nrrd",
           "labelled/slicer-ctchest/Segmentation.seg.nrrd", {"right lung", "left lung"});
  ranged("Visible Human head: skull", tests::unpackTestData("visible-human/VHMCT1mm_Head.tar.xz", "VHMCT1mm_Head"),
         {300.0, 3000.0});
  labelled("torso: spleen", torso, organs, {"1"});
  labelled("torso: vertebra L1", torso, organs, {"31"});
  return list;
}

}  // namespace fenestra::bench
