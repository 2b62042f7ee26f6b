// Both servers, over DICOM's own protocol: five studies are sent, found by each key, and retrieved as they were.

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "io/archive/Query.h"
#include "io/archive/Retrieve.h"
#include "io/archive/Send.h"
#include "tests/archive/MadeStudies.h"
#include "tests/archive/Servers.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::dimseTest {
namespace fs = std::filesystem;
namespace archive = io::archive;
namespace {

std::set<std::string> studiesFound(const archive::Server& server, const archive::Attributes& keys) {
  std::set<std::string> found;
  for (const archive::Attributes& record : archive::find(server, {archive::Level::Study, keys}).records)
    found.insert(archive::valueOf(record, "StudyInstanceUID"));
  return found;
}

using Uids = std::set<std::string>;

void expectSent(const archive::Server& server, const fs::path& folder) {
  const std::vector<fs::path> files = archive::filesToSend({folder});
  for (const archive::Sent& each : archive::send(server, files)) EXPECT_TRUE(each.accepted) << each.text;
}

/// What each key finds; names are found in every character set, and come back as they were written.
void expectFound(const archive::Server& server, const std::vector<MadeStudy>& studies) {
  for (const MadeStudy& study : studies) {
    SCOPED_TRACE(study.name);
    const Uids only{study.uid};
    EXPECT_EQ(studiesFound(server, {{"PatientID", study.id}}), only);
    EXPECT_EQ(studiesFound(server, {{"AccessionNumber", study.accession}}), only);
    EXPECT_EQ(studiesFound(server, {{"StudyInstanceUID", study.uid}}), only);
    EXPECT_EQ(studiesFound(server, {{"StudyDate", study.date}}), only);
    EXPECT_EQ(studiesFound(server, {{"PatientName", study.name.substr(0, study.name.find('^')) + "*"}}), only);
    const archive::Answers answers = archive::find(server, {archive::Level::Study, {{"PatientID", study.id}}});
    ASSERT_EQ(answers.records.size(), 1u);
    EXPECT_EQ(archive::valueOf(answers.records[0], "PatientName"), study.name);
    EXPECT_EQ(archive::valueOf(answers.records[0], "StudyDescription"), study.description);
  }
  EXPECT_EQ(studiesFound(server, {}).size(), studies.size());
  EXPECT_EQ(studiesFound(server, {{"AccessionNumber", "A*"}}).size(), 3u);
  EXPECT_EQ(studiesFound(server, {{"PatientID", "P-?"}}).size(), 5u);
  EXPECT_EQ(studiesFound(server, {{"StudyDate", "20240101-20241231"}}).size(), 3u);
  EXPECT_TRUE(studiesFound(server, {{"PatientID", "nobody"}}).empty());
}

void expectLevels(const archive::Server& server, const MadeStudy& study) {
  const archive::Answers patients = archive::find(server, {archive::Level::Patient, {{"PatientID", study.id}}});
  ASSERT_EQ(patients.records.size(), 1u);
  EXPECT_EQ(archive::valueOf(patients.records[0], "PatientName"), study.name);
  // Without the study's UID: the studies that match are found first.
  const archive::Answers series =
      archive::find(server, {archive::Level::Series, {{"PatientID", study.id}, {"Modality", "CT"}}});
  ASSERT_EQ(series.records.size(), 1u);
  EXPECT_EQ(archive::valueOf(series.records[0], "SeriesInstanceUID"), study.series);
  EXPECT_EQ(archive::valueOf(series.records[0], "PatientName"), study.name) << "of the study above";
  const archive::Answers images = archive::find(server, {archive::Level::Image, {{"StudyInstanceUID", study.uid}}});
  EXPECT_EQ(images.records.size(), static_cast<std::size_t>(study.slices));
}

void expectRetrieved(const archive::Server& server, const MadeStudy& study, archive::Way way, const fs::path& folder) {
  SCOPED_TRACE(way == archive::Way::Get ? "C-GET" : "C-MOVE");
  const archive::Cache cache(folder);
  const archive::Retrieved got = archive::retrieve(server, {study.uid, "", way}, cache);
  ASSERT_EQ(got.series.size(), 1u);
  EXPECT_EQ(got.series[0].received, static_cast<std::size_t>(study.slices));
  EXPECT_EQ(got.refusals.objects + got.refusals.titles + got.refusals.classes, 0u);
  EXPECT_EQ(objectsIn(got.series[0].folder), objectsIn(study.folder));
  const io::OpenedVolume before = io::openVolume(study.folder), after = io::openVolume(got.series[0].folder);
  EXPECT_EQ(realValues(*after.volume), realValues(*before.volume));
  // Nobody else can read it, and no name tells what it is.
  EXPECT_EQ(fs::status(folder).permissions(), fs::perms::owner_all);
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    EXPECT_EQ(entry.status().permissions() & (fs::perms::group_all | fs::perms::others_all), fs::perms::none);
    EXPECT_EQ(entry.path().string().find("1.2.3"), std::string::npos) << entry.path();
  }
  EXPECT_EQ(archive::retrieve(server, {study.uid, "", way}, cache).series[0].received, 0u) << "it is here already";
}

void expectAll(RunningServer* running, const fs::path& folder) {
  ASSERT_TRUE(running) << readFile(folder / "server/log");
  const archive::Server& server = running->server;
  archive::echo(server);
  const std::vector<MadeStudy> studies = makeStudies(folder / "studies");
  expectSent(server, folder / "studies");
  expectFound(server, studies);
  expectLevels(server, studies[1]);
  for (std::size_t i = 0; i < 2; ++i) {
    expectRetrieved(server, studies[i], archive::Way::Get, folder / "got" / std::to_string(i));
    expectRetrieved(server, studies[i], archive::Way::Move, folder / "moved" / std::to_string(i));
  }
}

}  // namespace

TEST(ArchiveDimse, DcmqrscpHoldsFindsAndReturnsFiveStudies) {
  FENESTRA_PROGRAM_OR_SKIP("dcmqrscp", "dcmtk");
  const fs::path folder = scratchFolder();
  expectAll(startDcmqrscp(folder / "server").get(), folder);
}

TEST(ArchiveDimse, OrthancHoldsFindsAndReturnsFiveStudies) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  const fs::path folder = scratchFolder();
  expectAll(startOrthanc(folder / "server").get(), folder);
}

TEST(ArchiveDimse, ARealSeriesComesBackAsItWas) {
  FENESTRA_PROGRAM_OR_SKIP("dcmqrscp", "dcmtk");
  FENESTRA_TEST_DATA_OR_SKIP(real, "dicom/ct-missing-slice-tilted");
  const fs::path folder = scratchFolder();
  const std::unique_ptr<RunningServer> running = startDcmqrscp(folder / "server");
  ASSERT_TRUE(running) << readFile(folder / "server/log");
  expectSent(running->server, real);
  const archive::Answers series = archive::find(running->server, {archive::Level::Series, {}});
  ASSERT_FALSE(series.records.empty());
  for (const archive::Way way : {archive::Way::Get, archive::Way::Move}) {
    const fs::path root = folder / (way == archive::Way::Get ? "got" : "moved");
    const archive::Cache cache(root);
    for (const archive::Attributes& each : series.records)
      archive::retrieve(running->server,
                        {archive::valueOf(each, "StudyInstanceUID"), archive::valueOf(each, "SeriesInstanceUID"), way},
                        cache);
    EXPECT_TRUE(objectsIn(root) == objectsIn(real));
  }
}

}  // namespace fenestra::tests::dimseTest
