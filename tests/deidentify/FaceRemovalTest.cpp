// Faces are taken out of copies of a made head, and nothing else of their pixels; images of which none can be taken are
// left out.

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "io/deidentify/Deidentify.h"
#include "io/dicom/Dataset.h"
#include "io/dicom/DicomValues.h"
#include "rendering/segmentation/Face.h"
#include "tests/cli/CommandLine.h"
#include "tests/io/DicomMakes.h"
#include "tests/io/IoTesting.h"
#include "tests/io/LabelFiles.h"
#include "tests/support/MadeHead.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::face_removal {
namespace {

namespace fs = std::filesystem;
using io::deidentify::Outcome;

constexpr double side = 6.0;  // mm of a voxel

/// A series of the made head, from `top` mm above the brain's centre down.
fs::path headSeries(const fs::path& folder, Modality modality, Syntax syntax, double top = 96.0) {
  fs::create_directories(folder);
  const auto head = madeHead(modality, side, top);
  const Grid& grid = head->grid;
  const bool isCt = modality == Modality::CT;
  DicomSpec spec;
  spec.syntax = syntax;
  spec.sopClass = isCt ? "1.2.840.10008.5.1.4.1.1.2" : "1.2.840.10008.5.1.4.1.1.4";
  spec.modality = isCt ? "CT" : "MR";
  spec.imageType = "ORIGINAL\\PRIMARY\\AXIAL";
  spec.columns = grid.dims.x;
  spec.rows = grid.dims.y;
  spec.isSigned = false;
  spec.pixelSpacing = "6\\6";
  spec.patientName = "Mustermann^Erika";
  if (isCt) spec.slope = "1", spec.intercept = "-1024";
  const auto voxels = head->voxels.as<std::int16_t>();
  for (int z = 0; z < grid.dims.z; ++z) {
    spec.words.clear();
    for (std::size_t i = grid.offset({0, 0, z}); i < grid.offset({0, 0, z + 1}); ++i)
      spec.words.push_back(static_cast<std::uint32_t>(voxels[i] + (isCt ? 1024 : 0)));
    spec.instance = "1.2.3.4.5." + std::to_string(z + 1);
    spec.instanceNumber = z + 1;
    spec.position = grid.origin + glm::dvec3(0.0, 0.0, side * z);
    const fs::path file = folder / (std::to_string(z) + ".dcm");
    if (syntax == Syntax::ExplicitBig || syntax == Syntax::Deflated)
      writeDicom(file, spec);
    else
      writeEdited(file, spec, {set(smallest, 3), set(largest, 4000)});
  }
  return folder;
}

class FaceRemoval : public ::testing::Test {
 protected:
  Outcome run(const fs::path& input) {
    fs::remove_all(out_);
    return io::deidentify::deidentify({.inputs = {input}, .output = out_, .options = {.removeFace = true}});
  }

  const fs::path folder_ = scratchFolder();
  const fs::path out_ = folder_ / "out";
};

TEST_F(FaceRemoval, BlanksTheFaceAndNothingElse) {
  int made = 0;
  for (const auto& [modality, syntax] : {std::pair{Modality::CT, Syntax::ExplicitLittle},
                                         {Modality::CT, Syntax::JpegLossless},
                                         {Modality::MR, Syntax::ExplicitBig},
                                         {Modality::MR, Syntax::Deflated}}) {
    SCOPED_TRACE(static_cast<int>(syntax));
    const fs::path source = headSeries(folder_ / std::to_string(made++), modality, syntax);
    const Outcome outcome = run(source);
    EXPECT_EQ(outcome.faces, outcome.objects);
    EXPECT_EQ(outcome.leftOut, 0u);
    const io::OpenedVolume before = io::openVolume(source), after = io::openVolume(out_);
    const segmentation::FaceSearch face = segmentation::findFace(*before.volume);
    ASSERT_TRUE(face.isFound) << face.reason;
    const Grid& grid = before.volume->grid;
    expectSameGrid(after.volume->grid, grid, 0.0);
    const double air = modality == Modality::CT ? airValue : before.volume->range.low;
    int blanked = 0, wrong = 0;
    for (int z = 0; z < grid.dims.z; ++z)
      for (int y = 0; y < grid.dims.y; ++y)
        for (int x = 0; x < grid.dims.x; ++x) {
          const glm::dvec3 p(grid.worldFromIndex() * glm::dvec4(x, y, z, 1.0));
          const bool isFace = face.region.contains(p);
          const double value = after.volume->value({x, y, z});
          wrong += value != (isFace ? air : before.volume->value({x, y, z}));
          blanked += isFace && madeHeadAt(p) != MadeTissue::Air;
        }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(blanked * side * side * side, 300.0 * mm3PerMl) << "of cheeks, nose and jaws";
  }
}

TEST_F(FaceRemoval, SaysWhatWasDone) {
  run(headSeries(folder_ / "in", Modality::CT, Syntax::JpegLossless));
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(out_)) {
    if (!entry.is_regular_file()) continue;
    ++files;
    DcmFileFormat object;
    io::loadObject(entry.path(), object);
    DcmDataset& dataset = *object.getDataset();
    EXPECT_EQ(io::textOf(dataset, DCM_ImageType).substr(0, 8), "DERIVED\\");
    EXPECT_EQ(io::textOf(dataset, DcmTagKey(0x0028, 0x0302)), "NO");
    EXPECT_FALSE(dataset.tagExists(DCM_SmallestImagePixelValue) || dataset.tagExists(DCM_LargestImagePixelValue));
    EXPECT_EQ(io::textOf(dataset, DCM_PatientName), "");
    EXPECT_TRUE(io::textOf(dataset, DCM_SOPInstanceUID).starts_with("2.25."));
    std::vector<std::string> codes;
    io::forEachItem(dataset, DCM_DeidentificationMethodCodeSequence,
                    [&](DcmItem& code) { codes.push_back(io::textOf(code, DCM_CodeValue)); });
    EXPECT_EQ(codes, (std::vector<std::string>{"113100", "113101"}));
  }
  EXPECT_GT(files, 40u);
}

TEST_F(FaceRemoval, LeavesOutWhatItCannotTreat) {
  const fs::path source = headSeries(folder_ / "in", Modality::CT, Syntax::ExplicitLittle);
  DicomSpec capture = pictureSpec();
  capture.sopClass = "1.2.840.10008.5.1.4.1.1.7";
  capture.modality = "OT";
  capture.instance = "1.2.3.9";
  capture.series = "1.2.3.99";
  writeDicom(source / "capture.dcm", capture);
  DicomSpec scout = pictureSpec();
  scout.instance = "1.2.3.8";
  scout.series = "1.2.3.88";
  writeDicom(source / "scout.dcm", scout);
  SegSpec labels;
  labels.columns = 40;
  labels.rows = 30;
  labels.frames = {{1, glm::dvec3(0.0), std::vector<int>(1200, 1)}};
  writeSeg(source / "seg.dcm", labels);
  const Outcome outcome = run(source);
  EXPECT_EQ(outcome.leftOut, 2u);
  EXPECT_EQ(outcome.objects, outcome.faces + 1) << "the segmentation stays";
  std::string texts;
  for (const io::Warning& warning : outcome.warnings) texts += warning.text + "\n";
  for (const char* text : {"1 file left out: a face can be taken out of images of CT and MR alone",
                           "1 file left out: no face is found in the series: it is a single slice",
                           "look at each, as slices and in 3-D, before you give it away",
                           "1 object with labels or contours, whose shapes stay"})
    EXPECT_NE(texts.find(text), std::string::npos) << text << " in\n" << texts;
}

TEST_F(FaceRemoval, RefusesWhatIsNoHead) {
  const fs::path source = headSeries(folder_ / "in", Modality::CT, Syntax::ExplicitLittle, 30.0);
  const std::string refusal = errorOf([&] { run(source); });
  EXPECT_NE(refusal.find("no face is found in the series: its top is cut off"), std::string::npos) << refusal;
  EXPECT_FALSE(fs::exists(out_));
  const std::string contradiction = errorOf(
      [&] { io::deidentify::deidentify({.inputs = {source}, .options = {.retainUids = true, .removeFace = true}}); });
  EXPECT_NE(contradiction.find("other pixels are other objects"), std::string::npos) << contradiction;
}

using FaceCommand = CommandLine;

TEST_F(FaceCommand, TakesFacesOut) {
  headSeries(folder() / "in", Modality::MR, Syntax::ExplicitLittle);
  const Result done = run({"deidentify", at("in"), "-o", at("out"), "--remove-face"});
  ASSERT_EQ(done.exitCode, 0) << done.error;
  const Json json = done.json();
  EXPECT_EQ(json["faces_removed"], json["objects"]);
  EXPECT_EQ(json["options"], Json({"remove-face"}));
  EXPECT_NE(done.error.find("look at each"), std::string::npos) << done.error;
  EXPECT_EQ(run({"deidentify", at("in"), "-o", at("b"), "--remove-face", "--retain-uids"}).exitCode, 2);
  const Json plain = run({"deidentify", at("in"), "--preview"}).json();
  EXPECT_EQ(plain["faces_removed"], 0);
}

}  // namespace
}  // namespace fenestra::tests::face_removal
