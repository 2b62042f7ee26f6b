// The context's edges explain and do not cover: with the look that the window opens new data in, they change at most an
// eighth of the focus's projection by more than 32/255, on all labelled data.

#include <cmath>

#include "io/ImageWriter.h"
#include "tests/cli/CommandLine.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::contextEdgesTest {
namespace {

struct Labelled {
  std::string name, image, labels, focus;
};
void PrintTo(const Labelled& data, std::ostream* out) { *out << data.name; }

class ContextEdges : public CommandLine, public ::testing::WithParamInterface<Labelled> {};

TEST_P(ContextEdges, Thorough_ChangeAnEighthOfTheFocusAtMost) {
  const Labelled& data = GetParam();
  std::vector<std::string> scene{"render", "--phantom", "torso", "--phantom-voxels", "128"};
  if (!data.image.empty()) {
    FENESTRA_TEST_DATA_OR_SKIP(image, data.image);
    FENESTRA_TEST_DATA_OR_SKIP(labels, data.labels);
    scene = {"render", image.string(), "--labels", labels.string()};
  }
  for (const std::string& each : {std::string("--focus-labels"), data.focus, std::string("--size"),
                                  std::string("280x260"), std::string("--look"), std::string("starting")})
    scene.push_back(each);
  const auto drawn = [&](const std::string& name, const std::string& camera, const std::vector<std::string>& more) {
    std::vector<std::string> all = scene;
    for (const std::string& each :
         {std::string("--camera"), camera, std::string("-o"), at(name + ".png"), std::string("--layers"), at(name)})
      all.push_back(each);
    all.insert(all.end(), more.begin(), more.end());
    const Result result = run(all);
    EXPECT_EQ(result.exitCode, 0) << result.error;
    return io::readPicture(fs::path(at(name)) / "final.mha").values;
  };
  for (const std::string camera : {"30,15", "150,5"}) {
    const auto with = drawn("with", camera, {}), without = drawn("without", camera, {"--context-layer", "0"});
    const auto focus = io::readPicture(fs::path(at("with")) / "t_focus.mha").values;
    std::size_t shown = 0, changed = 0;
    for (std::size_t i = 0; i < focus.size(); ++i) {
      if (std::isnan(focus[i])) continue;
      ++shown;
      float most = 0.0f;
      for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(with[4 * i + c] - without[4 * i + c]));
      changed += most > 32.0f / 255.0f ? 1 : 0;
    }
    const double share = static_cast<double>(changed) / static_cast<double>(std::max<std::size_t>(shown, 1));
    EXPECT_LE(share, 0.125) << "from " << camera << ", " << shown << " pixels";
    RecordProperty("from " + camera, std::to_string(share));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Data, ContextEdges,
    ::testing::Values(Labelled{"Phantom", "", "", "heart muscle"},
                      Labelled{"Torso", "labelled/totalsegmentator-torso/example_ct.nii.gz",
                               "labelled/totalsegmentator-torso/example_seg_fast_force_split.nii.gz", "2,3,52"},
                      Labelled{"Abdomen", "labelled/totalsegmentator-dicom/example_ct_dicom",
                               "labelled/totalsegmentator-dicom/example_seg_dicom.nii.gz", "5"},
                      Labelled{"Chest", "labelled/slicer-ctchest/CTChest4.nrrd",
                               "labelled/slicer-ctchest/Segmentation.seg.nrrd", "right lung,left lung"},
                      Labelled{"Lung", "labelled/elastix-lung/3DCT_lung.mha",
                               "labelled/elastix-lung/3DCT_lung_baseline_mask.mha", "1"},
                      Labelled{"Brain", "labelled/brain-colin27/ch2.nii.gz", "labelled/brain-colin27/aal.nii.gz",
                               "37,38"},
                      Labelled{"Hand", "labelled/bodyparts3d/hand/hand_ct.nii.gz",
                               "labelled/bodyparts3d/hand/hand_seg.nii.gz", "120,121"},
                      Labelled{"Foot", "labelled/bodyparts3d/foot/foot_ct.nii.gz",
                               "labelled/bodyparts3d/foot/foot_seg.nii.gz", "119,120"},
                      Labelled{"Head", "labelled/bodyparts3d/head/head_ct.nii.gz",
                               "labelled/bodyparts3d/head/head_seg.nii.gz", "135,137"},
                      Labelled{"Body", "labelled/bodyparts3d/torso/torso_ct.nii.gz",
                               "labelled/bodyparts3d/torso/torso_seg.nii.gz", "2,3,52"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace fenestra::tests::contextEdgesTest
