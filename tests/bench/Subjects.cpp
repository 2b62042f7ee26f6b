#include "tests/bench/Subjects.h"

#include <algorithm>

#include "tests/support/TestData.h"

namespace fenestra::bench {
namespace {

namespace fs = std::filesystem;

class List {
 public:
  explicit List(const Views& views) : views_(views) {}

  void phantom(const std::string& id, const std::string& name, const std::string& body) {
    Subject subject{id, name, {}};
    subject.options.phantom = body;
    subject.options.phantomVoxels = views_.phantomVoxels;
    subject.options.makePlain();
    if (id.starts_with(views_.only)) subjects_.here.push_back(std::move(subject));
  }
  void labelled(const std::string& id, const std::string& name, const fs::path& image, const fs::path& labels,
                std::vector<std::string> focus) {
    Subject subject{id, name, {}};
    subject.options.path = tests::findTestData(image);
    subject.options.labels = tests::findTestData(labels);
    subject.options.focusLabels = std::move(focus);
    add(std::move(subject), image);
  }
  void ranged(const std::string& id, const std::string& name, const fs::path& image, ValueRange focus) {
    Subject subject{id, name, {}};
    subject.options.path =
        image.extension() == ".xz" ? tests::unpackTestData(image, image.stem().stem()) : tests::findTestData(image);
    subject.options.focusRange = focus;
    add(std::move(subject), image);
  }
  /// The subject `id` if it has just been added.
  Subject* lastSubject(const std::string& id) {
    const bool here = !subjects_.here.empty() && subjects_.here.back().id == id;
    return here ? &subjects_.here.back() : nullptr;
  }
  io::StudyRequest* last(const std::string& id) {
    Subject* subject = lastSubject(id);
    return subject ? &subject->options : nullptr;
  }
  Subjects take() { return std::move(subjects_); }

 private:
  void add(Subject subject, const fs::path& image) {
    if (!subject.id.starts_with(views_.only)) return;
    subject.options.makePlain();
    if (subject.options.path.empty())
      subjects_.missing.push_back(subject.name + ": left out, needs the test-data file " + image.string());
    else
      subjects_.here.push_back(std::move(subject));
  }

  const Views& views_;
  Subjects subjects_;
};

const fs::path headCt = "visible-human/VHMCT1mm_Head.tar.xz", smallHeadCt = "ct-head/ct.nii.gz";
const fs::path torsoCt = "labelled/totalsegmentator-torso/example_ct.nii.gz";
const fs::path torsoLabels = "labelled/totalsegmentator-torso/example_seg_fast_force_split.nii.gz";
const fs::path brainMr = "labelled/brain-colin27/ch2.nii.gz", brainLabels = "labelled/brain-colin27/aal.nii.gz";
const fs::path chestCt = "labelled/slicer-ctchest/CTChest4.nrrd";
const fs::path chestLabels = "labelled/slicer-ctchest/Segmentation.seg.nrrd";

}  // namespace

Subjects reportSubjects(const Views& views) {
  List list(views);
  list.phantom("phantom", "phantom torso: organs", "torso");
  list.ranged("head", "Visible Human head, CT: skull", headCt, {300.0, 3000.0});
  list.labelled("torso", "torso, CT: kidneys", torsoCt, torsoLabels, {"2", "3"});
  list.labelled("brain", "brain, MR: hippocampus", brainMr, brainLabels, {"37", "38"});
  return list.take();
}

Subjects methodSubjects(const Views& views) {
  List list(views);
  list.phantom("phantom", "Phantom torso: lesion behind a rib, 180 mm around it", "torso");
  if (Subject* lesion = list.lastSubject("phantom")) {
    lesion->options.focusLabels = {"lesion"};
    lesion->aroundFocus = 90.0;
  }
  list.labelled("brain", "Brain, MR: hippocampus", brainMr, brainLabels, {"37", "38"});
  list.labelled("torso", "Torso, CT: kidneys and aorta", torsoCt, torsoLabels, {"2", "3", "52"});
  list.ranged("head", "Visible Human head, CT: skull", headCt, {300.0, 3000.0});
  return list.take();
}

Subjects boundSubjects(const Views& views) {
  List list(views);
  list.phantom("phantom", "phantom torso: organs", "torso");
  list.phantom("phantom-plain", "phantom torso: plain, unlit", "torso");
  if (io::StudyRequest* options = list.last("phantom-plain"))
    options->look.cutaway.enabled = options->look.shading.enabled = false;
  list.phantom("phantom-head", "phantom head: tumour, ventricles", "head");
  list.ranged("head", "Visible Human head, CT: skull", headCt, {300.0, 3000.0});
  list.ranged("small-head", "small head, CT: skull", smallHeadCt, {0.6, 1.0});
  list.ranged("small-head-plain", "small head, CT: plain", smallHeadCt, {0.6, 1.0});
  if (io::StudyRequest* options = list.last("small-head-plain")) options->look.cutaway.enabled = false;
  list.labelled("torso", "torso, CT: kidneys", torsoCt, torsoLabels, {"2", "3"});
  list.labelled("torso-aorta", "torso, CT: aorta, unlit", torsoCt, torsoLabels, {"52"});
  if (io::StudyRequest* options = list.last("torso-aorta")) options->look.shading.enabled = false;
  list.labelled("brain", "brain, MR: hippocampus", brainMr, brainLabels, {"37", "38"});
  list.labelled("chest", "chest, CT: lungs", chestCt, chestLabels, {"right lung", "left lung"});
  return list.take();
}

double stepLength(const Grid& grid, double samplesPerVoxel) {
  return std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z}) / samplesPerVoxel;
}

}  // namespace fenestra::bench
