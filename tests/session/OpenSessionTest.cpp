// A session's data: found in their place, where they moved to, or not; changed data gives a warning; and the file holds
// nothing of the patient.

#include <algorithm>
#include <chrono>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "io/VolumeWriter.h"
#include "io/session/SessionFile.h"
#include "io/study/ReadStudy.h"
#include "io/study/SessionData.h"
#include "tests/io/DicomWriter.h"
#include "tests/io/IoTesting.h"
#include "tests/io/LabelFiles.h"
#include "tests/io/NiftiBytes.h"
#include "tests/session/SessionTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::openSessionTest {
namespace {

namespace fs = std::filesystem;
using Kind = io::Warning::Kind;

/// The data of a session, at the places that are given.
io::Study openSession(const fs::path& file, const fs::path& volume = {}, const fs::path& labels = {}) {
  io::DataRequest request;
  request.path = file;
  request.data = volume;
  request.labels = labels;
  return io::openData(request);
}
io::Study openOutside(const fs::path& file) {
  io::DataRequest request;
  request.path = file;
  request.allowOutside = true;
  return io::openData(request);
}

/// A study of five slices and a label map beside it, and a session for both in a folder of their own.
class OpenSession : public testing::Test {
 protected:
  void SetUp() override {
    top_ = scratchFolder();
    project_ = top_ / "project";
    fs::create_directories(project_);
    writeStudy(project_ / "study", 0);
    Volume labels;
    labels.grid.dims = {4, 3, 5};
    labels.voxels = Voxels(ScalarType::UInt8, labels.grid.voxelCount());
    for (std::size_t i = 0; i < 60; ++i) labels.voxels.as<std::uint8_t>()[i] = static_cast<std::uint8_t>(i % 3);
    io::writeVolume(labels, project_ / "labels.nii.gz");
  }

  static void writeStudy(const fs::path& folder, std::uint32_t value, const std::string& series = "1.2.3.4") {
    fs::create_directories(folder);
    for (int slice = 0; slice < 5; ++slice) {
      DicomSpec spec;
      spec.series = series;
      spec.instance = series + "." + std::to_string(slice);
      spec.instanceNumber = slice + 1;
      spec.position = glm::dvec3(0.0, 0.0, slice);
      spec.words.assign(12, value + static_cast<std::uint32_t>(slice));
      writeDicom(folder / ("slice" + std::to_string(slice)), spec);
    }
  }

  /// A session for the files in the project's folder.
  fs::path save(const fs::path& file, const fs::path& volume, const fs::path& labels = {}) {
    const io::OpenedVolume opened = io::openVolume(volume);
    io::Session session;
    session.volume = io::sessionVolume(volume, opened);
    if (!labels.empty()) session.labels = io::sessionLabels(labels);
    io::noteContents(session);
    io::writeSession(file, session);
    return file;
  }

  static std::string missing(const fs::path& file, io::DataMissing::Data which) {
    try {
      openSession(file);
    } catch (const io::DataMissing& error) {
      EXPECT_EQ(error.data(), which);
      return error.what();
    }
    ADD_FAILURE() << "nothing was missing";
    return {};
  }

  fs::path top_, project_;
};

TEST_F(OpenSession, AChosenTableOfNamesIsKeptAndItsLossIsSaid) {
  const fs::path file = project_ / "a.fenestra", table = project_ / "names.ctbl";
  writeFile(table, "1 liver 10 20 30 255\n");
  io::DataRequest request;
  request.path = project_ / "study";
  request.labels = project_ / "labels.nii.gz";
  request.labelTable = table;
  io::Study study = io::openData(request);
  EXPECT_EQ(study.scene.labels->find(1)->name, "liver");
  EXPECT_EQ(study.session.labels.table, fs::absolute(table));
  io::noteContents(study.session);
  io::writeSession(file, study.session);
  EXPECT_EQ(openSession(file).scene.labels->find(1)->name, "liver");
  // A label map that is named anew is shown with the session's table, too.
  EXPECT_EQ(openSession(file, {}, project_ / "labels.nii.gz").scene.labels->find(1)->colour,
            glm::dvec3(10, 20, 30) / 255.0);
  fs::remove(table);
  const io::Study without = openSession(file);
  EXPECT_EQ(without.scene.labels->find(1)->name, "label 1");
  EXPECT_NE(warningOf(without.warnings, Kind::ChangedData).text.find("names.ctbl"), std::string::npos);
}

TEST_F(OpenSession, AFolderOfMasksIsFoundAgain) {
  const fs::path masks = project_ / "segmentations";
  fs::create_directories(masks);
  for (const char* name : {"liver.nii.gz", "spleen.nii.gz"})
    fs::copy_file(project_ / "labels.nii.gz", masks / name, fs::copy_options::overwrite_existing);
  // The label map holds two labels; masks hold one.
  Volume mask;
  mask.grid.dims = {4, 3, 5};
  mask.voxels = Voxels(ScalarType::UInt8, mask.grid.voxelCount());
  std::ranges::fill(mask.voxels.as<std::uint8_t>(), std::uint8_t{0});
  mask.voxels.as<std::uint8_t>()[7] = 1;
  io::writeVolume(mask, masks / "liver.nii.gz");
  const fs::path file = save(project_ / "a.fenestra", project_ / "study", masks);
  const io::Study opened = openSession(file);
  EXPECT_EQ(opened.scene.labels->find(1)->name, "liver");
  EXPECT_EQ(opened.session.labels.contents.files, 2u);
  io::writeVolume(mask, masks / "spleen.nii.gz");
  EXPECT_TRUE(hasWarning(openSession(file).warnings, Kind::ChangedData));
}

TEST_F(OpenSession, LabelsMayBeADicomSegmentation) {
  SegSpec spec;
  spec.columns = 4;
  spec.frames = {{1, glm::dvec3(0, 0, 2), {0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}}};
  writeSeg(project_ / "study" / "seg.dcm", spec);
  const fs::path file = save(project_ / "a.fenestra", project_ / "study", project_ / "study" / "seg.dcm");
  const io::Study opened = openSession(file);
  ASSERT_TRUE(opened.scene.labels);
  EXPECT_EQ(opened.scene.labels->value({1, 0, 2}), 1);
  EXPECT_EQ(opened.scene.labels->find(1)->name, "first");
  EXPECT_EQ(kindsOf(opened.warnings), "");
}

TEST_F(OpenSession, LabelsMayLieInAnArchive) {
  fs::create_directories(project_ / "more");
  writeFile(project_ / "more" / "labels.nii", readFile(project_ / "labels.nii.gz"));
  ASSERT_EQ(std::system(("tar -C '" + (project_ / "more").string() + "' -cf '" + (project_ / "labels.tar").string() +
                         "' labels.nii")
                            .c_str()),
            0);
  const fs::path member = project_ / "labels.tar" / "labels.nii";
  save(project_ / "a.fenestra", project_ / "study", member);
  EXPECT_EQ(openSession(project_ / "a.fenestra").session.labels.path, member);

  // The archive lies elsewhere now: it is known by its contents.
  fs::create_directories(project_ / "moved");
  fs::rename(project_ / "labels.tar", project_ / "moved" / "labels.tar");
  const io::Study moved = openSession(project_ / "a.fenestra");
  EXPECT_EQ(moved.session.labels.path, project_ / "moved" / "labels.tar" / "labels.nii");
  EXPECT_EQ(moved.scene.labels->labels.size(), 2u);
  EXPECT_TRUE(hasWarning(moved.warnings, Kind::MovedData));
}

TEST_F(OpenSession, KeepsTheTimePoint) {
  std::vector<std::int16_t> values;
  for (int i = 0; i < 72; ++i) values.push_back(static_cast<std::int16_t>(i));
  const fs::path file = project_ / "perfusion.nii", session = project_ / "a.fenestra";
  writeFile(file, niftiHeader({.dims = {2, 3, 4, 3}}) + bytesOf(values));
  for (const int time : {1, 3}) {
    const io::OpenedVolume opened = io::openVolume(file, {.time = time});
    io::Session saved;
    saved.volume = io::sessionVolume(file, opened);
    io::noteContents(saved);
    io::writeSession(session, saved);
    const io::Study again = openSession(session);
    EXPECT_EQ(again.session.volume.time, time);
    EXPECT_EQ(realValues(*again.scene.volume), realValues(*opened.volume));
    EXPECT_EQ(again.scene.volume->value({0, 0, 0}), (time - 1) * 24.0);
  }
}

TEST_F(OpenSession, FilesOutsideAHeadersFolderNeedPermission) {
  fs::create_directories(project_ / "inner");
  writeFile(project_ / "voxels.raw", std::string(8, '\x05'));
  const fs::path header = project_ / "inner" / "a.mhd", session = project_ / "a.fenestra";
  writeFile(header,
            "NDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\nElementDataFile = "
            "../voxels.raw\n");
  io::Session saved;
  saved.volume = io::sessionVolume(header, io::openVolume(header, {.allowOutside = true}));
  io::noteContents(saved);
  io::writeSession(session, saved);
  EXPECT_NE(missing(session, io::DataMissing::Data::Volume).find("names voxels outside its folder"), std::string::npos);
  EXPECT_EQ(openOutside(session).scene.volume->value({1, 1, 1}), 5.0);
}

TEST_F(OpenSession, FindsDataWhereTheyAre) {
  const fs::path file = save(project_ / "a.fenestra", project_ / "study", project_ / "labels.nii.gz");
  const io::Study opened = openSession(file);
  EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
  EXPECT_EQ(opened.scene.volume->grid.dims, glm::ivec3(4, 3, 5));
  ASSERT_TRUE(opened.scene.labels);
  EXPECT_EQ(opened.scene.labels->labels.size(), 2u);
  io::writeSession(project_ / "b.fenestra", opened.session);
  EXPECT_EQ(readFile(project_ / "a.fenestra"), readFile(project_ / "b.fenestra"));
}

TEST_F(OpenSession, KeepsWorkingWhenTheProjectMoves) {
  save(project_ / "a.fenestra", project_ / "study", project_ / "labels.nii.gz");
  fs::rename(project_, top_ / "elsewhere");
  const io::Study opened = openSession(top_ / "elsewhere" / "a.fenestra");
  EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
}

TEST_F(OpenSession, ASessionAmongTheSlicesIsNoSlice) {
  const fs::path file = save(project_ / "study" / "a.fenestra", project_ / "study");
  EXPECT_TRUE(openSession(file).warnings.empty());
}

TEST_F(OpenSession, SearchesBesideAndBelowByName) {
  const fs::path file = save(project_ / "a.fenestra", project_ / "study", project_ / "labels.nii.gz");
  const std::string before = readFile(file);
  fs::create_directories(project_ / "data" / "2026");
  fs::rename(project_ / "study", project_ / "data" / "2026" / "study");
  fs::rename(project_ / "labels.nii.gz", project_ / "data" / "labels.nii.gz");
  // A study of other voxels lies where the first one was.
  writeStudy(project_ / "study", 7);
  const io::Study opened = openSession(file);
  EXPECT_EQ(opened.session.volume.path, project_ / "study")
      << "the study at the stored place is taken, with a warning that it changed";
  EXPECT_TRUE(hasWarning(opened.warnings, Kind::ChangedData));
  EXPECT_TRUE(hasWarning(opened.warnings, Kind::MovedData));
  EXPECT_EQ(opened.session.labels.path, project_ / "data" / "labels.nii.gz");
  fs::rename(project_ / "study", project_ / "data" / "study");
  const io::Study again = openSession(file);
  EXPECT_EQ(again.session.volume.path, project_ / "data" / "2026" / "study") << "equal contents, not the nearest name";
  EXPECT_FALSE(hasWarning(again.warnings, Kind::ChangedData));
  io::writeSession(file, again.session);
  EXPECT_NE(readFile(file), before);
  EXPECT_TRUE(openSession(file).warnings.empty()) << "saved again, it knows where they are";
}

TEST_F(OpenSession, SearchesByContentsWhenTheNameIsGone) {
  const fs::path file = save(project_ / "a.fenestra", project_ / "study", project_ / "labels.nii.gz");
  fs::create_directories(project_ / "data" / "decoy");
  fs::rename(project_ / "study", project_ / "data" / "anonymous");
  fs::rename(project_ / "labels.nii.gz", project_ / "data" / "x.nii.gz");
  for (int i = 0; i < 7; ++i) writeFile(project_ / "data" / "decoy" / std::to_string(i), "not a slice");
  const io::Study opened = openSession(file);
  EXPECT_EQ(opened.session.volume.path, project_ / "data" / "anonymous");
  EXPECT_EQ(opened.session.labels.path, project_ / "data" / "x.nii.gz");
  EXPECT_EQ(opened.warnings.size(), 2u) << kindsOf(opened.warnings);
}

TEST_F(OpenSession, AsksForWhatItDoesNotFind) {
  const fs::path file = save(project_ / "a.fenestra", project_ / "study", project_ / "labels.nii.gz");
  fs::rename(project_ / "labels.nii.gz", top_ / "labels.nii.gz");
  std::string said = missing(file, io::DataMissing::Data::Labels);
  EXPECT_NE(said.find("--labels"), std::string::npos) << said;
  fs::rename(project_ / "study", top_ / "study");
  said = missing(file, io::DataMissing::Data::Volume);
  EXPECT_NE(said.find("--data"), std::string::npos) << said;
  EXPECT_EQ(said.find('\n'), std::string::npos);
  const io::Study opened = openSession(file, top_ / "study", top_ / "labels.nii.gz");
  EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
  EXPECT_EQ(opened.session.volume.path, top_ / "study");
}

TEST_F(OpenSession, AFolderIsFoundThatHasTheNameOfOneAboveIt) {
  project_ = top_ / "study" / "project";
  fs::create_directories(project_ / "data");
  writeStudy(project_ / "study", 0);
  const fs::path file = save(project_ / "a.fenestra", project_ / "study");
  fs::rename(project_ / "study", project_ / "data" / "study");
  EXPECT_EQ(openSession(file).session.volume.path, project_ / "data" / "study");
}

TEST_F(OpenSession, SaysThatDataChanged) {
  const fs::path file = save(project_ / "a.fenestra", project_ / "study", project_ / "labels.nii.gz");
  std::string bytes = readFile(project_ / "study" / "slice2");
  bytes.back() = static_cast<char>(bytes.back() + 1);
  writeFile(project_ / "study" / "slice2", bytes);
  io::Study opened = openSession(file);
  EXPECT_TRUE(hasWarning(opened.warnings, Kind::ChangedData)) << "one bit in one slice";
  io::writeSession(file, opened.session);
  EXPECT_TRUE(openSession(file).warnings.empty()) << "saved again, that is what they are";

  // Outside the session's folder changed data is not taken without being asked for.
  fs::create_directories(top_ / "sessions");
  const fs::path outside = save(top_ / "sessions" / "a.fenestra", project_ / "study");
  EXPECT_TRUE(openSession(outside).warnings.empty());
  writeStudy(project_ / "study", 7);
  EXPECT_NE(missing(outside, io::DataMissing::Data::Volume).find("is not what it was"), std::string::npos);
  opened = openSession(outside, project_ / "study");
  EXPECT_TRUE(hasWarning(opened.warnings, Kind::ChangedData));
}

TEST_F(OpenSession, OpensTheSeriesThatWasChosen) {
  writeStudy(project_ / "study" / "other", 100, "1.2.3.5");
  io::OpenOptions options;
  options.series = "1.2.3.5";
  const io::OpenedVolume opened = io::openVolume(project_ / "study", options);
  io::Session session;
  session.volume = io::sessionVolume(project_ / "study", opened);
  io::noteContents(session);
  io::writeSession(project_ / "a.fenestra", session);
  const io::Study again = openSession(project_ / "a.fenestra");
  EXPECT_EQ(again.series.id, "1.2.3.5");
  EXPECT_EQ(again.scene.volume->range.low, 100.0);
  EXPECT_EQ(again.otherSeries.size(), 1u);
}

TEST_F(OpenSession, AStudyExportedAnewIsTakenWhereTheUserNamesIt) {
  const fs::path file = save(project_ / "a.fenestra", project_ / "study");
  fs::remove_all(project_ / "study");
  writeStudy(top_ / "export", 0, "9.8.7");
  const io::Study opened = openSession(file, top_ / "export");
  EXPECT_EQ(opened.series.id, "9.8.7");
  EXPECT_TRUE(hasWarning(opened.warnings, Kind::ChangedData));
}

TEST_F(OpenSession, SavesWhileTheDataAreAway) {
  const io::OpenedVolume opened = io::openVolume(project_ / "study");
  io::Session session;
  session.volume = io::sessionVolume(project_ / "study", opened);
  fs::rename(project_ / "study", top_ / "away");
  io::noteContents(session);
  io::writeSession(project_ / "a.fenestra", session);
  fs::rename(top_ / "away", project_ / "study");
  EXPECT_TRUE(openSession(project_ / "a.fenestra").warnings.empty());
}

TEST_F(OpenSession, ContentsAreThoseOfSha256sum) {
  writeFile(top_ / "abc", "abc");
  // FIPS 180-2, appendix B.1.
  const std::string abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
  EXPECT_EQ(io::contentsOf({top_ / "abc"}), (io::Contents{"sha256:" + abc, 3, 1}));
  writeFile(top_ / "copy", "abc");
  EXPECT_EQ(io::contentsOf({top_ / "abc", top_ / "copy"}).hash, io::hashOf(abc + "\n" + abc + "\n"));
  writeFile(top_ / "other", "abd");
  EXPECT_EQ(io::contentsOf({top_ / "abc", top_ / "other"}), io::contentsOf({top_ / "other", top_ / "copy"}))
      << "names and their order do not count";
}

/// A session holds no patient's name, identifier or date of birth, nor anything that leads to them.
TEST_F(OpenSession, HoldsNothingOfThePatient) {
  const fs::path folder = project_ / "scan";
  fs::create_directories(folder);
  DicomSpec spec;
  spec.patientName = "Doe^Jane Q";
  spec.patientId = "MRN-7421963";
  spec.birthDate = "19610417";
  spec.accessionNumber = "ACC5550199";
  spec.description = "HEAD DOE JANE";
  spec.series = "1.2.826.0.1.3680043.9.77777.1";
  spec.instance = "1.2.826.0.1.3680043.9.77777.1.1";
  spec.frameOfReference = "1.2.826.0.1.3680043.9.77777.2";
  writeDicom(folder / "1", spec);
  const std::string study = readFile(folder / "1");
  const std::vector<std::string> secrets{spec.patientName,     spec.patientId,   spec.birthDate,
                                         spec.accessionNumber, spec.description, "77777"};
  for (const std::string& secret : secrets) ASSERT_NE(study.find(secret), std::string::npos) << secret;

  const io::OpenedVolume opened = io::openVolume(folder);
  io::Session session = fullSession(project_);
  session.volume = io::sessionVolume(folder, opened);
  session.labels = io::sessionLabels(project_ / "labels.nii.gz");
  io::noteContents(session);
  io::writeSession(project_ / "a.fenestra", session);
  const std::string text = readFile(project_ / "a.fenestra");
  EXPECT_NE(text.find("\"path\": \"scan\""), std::string::npos) << "the names of files are the user's own";
  for (const std::string& secret : secrets) EXPECT_EQ(text.find(secret), std::string::npos) << secret;
  for (const char* part : {"Doe", "DOE", "Jane", "JANE", "7421963", "1961", "5550199"})
    EXPECT_EQ(text.find(part), std::string::npos) << part;
  EXPECT_EQ(text.find(top_.string()), std::string::npos);
}

}  // namespace
}  // namespace fenestra::tests::openSessionTest
