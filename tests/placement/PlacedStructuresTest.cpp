// Where `fenestra-cli place` puts the cameras for structures of real data, and for a region grown from a click.

#include <cmath>

#include "tests/cli/CommandLine.h"

namespace fenestra::tests::placedStructuresTest {
namespace {

class PlacedStructures : public CommandLine {
 protected:
  Json placed(std::vector<std::string> scene, const std::vector<std::string>& more = {}) const {
    scene.insert(scene.begin(), "place");
    scene.insert(scene.end(), more.begin(), more.end());
    const Result result = run(scene);
    EXPECT_EQ(result.exitCode, 0) << result.error;
    return result.json();
  }

  /// The cosine between a camera's direction and the patient's axis.
  static double along(const Json& camera) { return camera["direction"][2].get<double>(); }

  /// Neither camera looks within 45° through an end of the scan, and the two are 60° to 120° apart. `end`: 1 where the
  /// scan ends above, -1 where it ends below, 0 at both.
  void expectNoneThroughEnds(const std::vector<std::string>& scene, int end) const {
    const Json json = placed(scene);
    double cosine = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      cosine += json["c1"]["direction"][i].get<double>() * json["c2"]["direction"][i].get<double>();
    EXPECT_LE(std::abs(cosine), 0.5 + 1e-9);
    for (const char* camera : {"c1", "c2"}) {
      const double height = along(json[camera]);
      EXPECT_LE(end == 0 ? std::abs(height) : end * height, std::sqrt(0.5)) << camera;
      EXPECT_LE(json[camera]["awkward"]["through_cut_end"].get<double>(), 0.5) << camera;
    }
  }
  static std::vector<std::string> labelled(const fs::path& image, const fs::path& labels, const std::string& focus) {
    return {image.string(), "--labels", labels.string(), "--focus-labels", focus};
  }
};

const std::vector<std::string> withoutHabits{"--avoid-cut-ends",  "off", "--upright-first",   "off",
                                             "--near-side-first", "off", "--flat-from-front", "off"};

TEST_F(PlacedStructures, Thorough_OfATorso) {
  FENESTRA_TEST_DATA_OR_SKIP(ct, "labelled/totalsegmentator-torso/example_ct.nii.gz");
  FENESTRA_TEST_DATA_OR_SKIP(labels, "labelled/totalsegmentator-torso/example_seg_fast_force_split.nii.gz");
  // Kidneys, liver, the third lumbar vertebra, aorta, spleen.
  for (const char* focus : {"2,3", "5", "29", "52", "1"}) expectNoneThroughEnds(labelled(ct, labels, focus), 0);
}

TEST_F(PlacedStructures, Thorough_OfAHead) {
  FENESTRA_TEST_DATA_OR_SKIP(ct, "labelled/bodyparts3d/head/head_ct.nii.gz");
  FENESTRA_TEST_DATA_OR_SKIP(labels, "labelled/bodyparts3d/head/head_seg.nii.gz");
  // Ventricles, eyes, mandible.
  for (const char* focus : {"139", "140,142", "151"}) expectNoneThroughEnds(labelled(ct, labels, focus), -1);
  // Without the habit, C2 looks up at the ventricles through the neck.
  EXPECT_LT(along(placed(labelled(ct, labels, "139"), withoutHabits)["c2"]), -std::sqrt(0.5));
}

TEST_F(PlacedStructures, Thorough_OfTheVisibleHumansHead) {
  const fs::path ct = unpackTestData("visible-human/VHMCT1mm_Head.tar.xz", "VHMCT1mm_Head");
  if (ct.empty()) GTEST_SKIP() << "needs the test-data file visible-human/VHMCT1mm_Head.tar.xz";
  expectNoneThroughEnds({ct.string(), "--focus-range", "300:3000"}, -1);
}

TEST_F(PlacedStructures, Thorough_OfABrain) {
  FENESTRA_TEST_DATA_OR_SKIP(mr, "labelled/brain-colin27/ch2.nii.gz");
  FENESTRA_TEST_DATA_OR_SKIP(labels, "labelled/brain-colin27/aal.nii.gz");
  for (const char* focus : {"37,38", "71,72", "77,78"}) expectNoneThroughEnds(labelled(mr, labels, focus), -1);
}

TEST_F(PlacedStructures, Thorough_OfAHandAndAFoot) {
  FENESTRA_TEST_DATA_OR_SKIP(hand, "labelled/bodyparts3d/hand/hand_ct.nii.gz");
  FENESTRA_TEST_DATA_OR_SKIP(handLabels, "labelled/bodyparts3d/hand/hand_seg.nii.gz");
  FENESTRA_TEST_DATA_OR_SKIP(foot, "labelled/bodyparts3d/foot/foot_ct.nii.gz");
  FENESTRA_TEST_DATA_OR_SKIP(footLabels, "labelled/bodyparts3d/foot/foot_seg.nii.gz");
  // Both are cut above: scaphoid and third metacarpal; talus and calcaneus.
  for (const char* focus : {"147", "140"}) expectNoneThroughEnds(labelled(hand, handLabels, focus), 1);
  for (const char* focus : {"152", "146"}) expectNoneThroughEnds(labelled(foot, footLabels, focus), 1);
  EXPECT_GT(along(placed(labelled(hand, handLabels, "147"), withoutHabits)["c1"]), std::sqrt(0.5));
}

TEST_F(PlacedStructures, Thorough_OfAThinStack) {
  FENESTRA_TEST_DATA_OR_SKIP(ct, "labelled/totalsegmentator-dicom/example_ct_dicom");
  FENESTRA_TEST_DATA_OR_SKIP(labels, "labelled/totalsegmentator-dicom/example_seg_dicom.nii.gz");
  const Json liver = placed(labelled(ct, labels, "5"));
  EXPECT_LT(along(liver["c1"]), -0.9) << "axial slices are seen from below";
  EXPECT_LT(along(liver["c2"]), -0.45) << "60° from C1 is the least";
  EXPECT_GT(along(placed(labelled(ct, labels, "5"), withoutHabits)["c1"]), -0.5);
}

TEST_F(PlacedStructures, AGrownRegionAsALabel) {
  // The right kidney of the phantom, whose trunk goes on below.
  const std::vector<std::string> region{"--phantom", "torso", "--phantom-voxels", "96", "--seed", "-62,42,-112"};
  expectNoneThroughEnds(region, -1);
  const Json ends = placed(region)["scan"]["ends"];
  EXPECT_EQ(ends["I"]["cut"], 1.0);
  EXPECT_EQ(ends["A"]["cut"], 0.0);
}

}  // namespace
}  // namespace fenestra::tests::placedStructuresTest
