// fenestra-cli archive, as a script calls it.

#include <gtest/gtest.h>

#include "io/ImageWriter.h"
#include "io/LabelWriter.h"
#include "io/VolumeReader.h"
#include "io/archive/Server.h"
#include "tests/archive/MadeStudies.h"
#include "tests/archive/Servers.h"
#include "tests/cli/CommandLine.h"

namespace fenestra::tests::archiveCommandTest {
namespace {

using ArchiveCommand = CommandLine;

std::string addressOf(const io::archive::Server& server) { return server.name(); }

}  // namespace

TEST_F(ArchiveCommand, SendsFindsAndRetrievesAFolderThatOtherCommandsOpen) {
  FENESTRA_PROGRAM_OR_SKIP("dcmqrscp", "dcmtk");
  const fs::path scratch = folder();
  const std::unique_ptr<RunningServer> running = startDcmqrscp(scratch / "server");
  ASSERT_TRUE(running);
  const std::string server = addressOf(running->server);
  const std::vector<MadeStudy> studies = makeStudies(scratch / "studies");

  const Result echo = run({"archive", "echo", server});
  EXPECT_EQ(echo.exitCode, 0) << echo.error;
  EXPECT_EQ(echo.json()["source"], server);
  EXPECT_TRUE(echo.json()["answer_ms"].is_number());

  const Result sent = run({"archive", "send", server, at("studies")});
  EXPECT_EQ(sent.exitCode, 0) << sent.error;
  EXPECT_EQ(sent.json()["accepted"], 15);
  EXPECT_EQ(sent.json()["objects"].size(), 15u);
  EXPECT_FALSE(sent.json().contains("committed")) << "that was not asked";

  const Result unkept = run({"archive", "send", server, studies[0].folder.string(), "--commit"});
  EXPECT_EQ(unkept.exitCode, 1);
  EXPECT_EQ(unkept.json()["accepted"], 3) << "what came through is told in any case";
  EXPECT_EQ(unkept.json()["committed"], 0);
  EXPECT_TRUE(unkept.json()["objects"][0]["committed"].is_null());
  EXPECT_NE(unkept.error.find("does not offer storage commitment"), std::string::npos) << unkept.error;
  EXPECT_EQ(std::count(unkept.error.begin(), unkept.error.end(), '\n'), 1) << unkept.error;

  const Result found = run({"archive", "find", server, "--key", "PatientName=Müller*"});
  ASSERT_EQ(found.exitCode, 0) << found.error;
  ASSERT_EQ(found.json()["results"].size(), 1u) << found.out;
  EXPECT_EQ(found.json()["complete"], true);
  EXPECT_EQ(found.json()["results"][0]["PatientName"], "Müller^Jürgen");
  const std::string uid = found.json()["results"][0]["StudyInstanceUID"];
  const Result series = run({"archive", "find", server, "--level", "series", "--key", "StudyInstanceUID=" + uid});
  EXPECT_EQ(series.json()["results"][0]["SeriesInstanceUID"], studies[1].series) << series.out;

  for (const char* way : {"get", "move"}) {
    SCOPED_TRACE(way);
    const std::string output = at(std::string("out-") + way);
    std::vector<std::string> words{"archive",
                                   way,
                                   server,
                                   "--key",
                                   "StudyInstanceUID=" + uid,
                                   "-o",
                                   output,
                                   "--cache",
                                   at(std::string("cache-") + way)};
    if (std::string(way) == "move") words.insert(words.end(), {"--port", std::to_string(running->server.ownPort)});
    const Result got = run(words);
    ASSERT_EQ(got.exitCode, 0) << got.error;
    EXPECT_EQ(got.json()["series"][0]["received"], 3);
    EXPECT_EQ(got.json()["refused"]["objects"], 0);
    EXPECT_EQ(objectsIn(output), objectsIn(studies[1].folder));
    const Result info = run({"info", output});
    EXPECT_EQ(info.json()["dims"], (Json{64, 64, 3})) << info.error;
    const Result again = run(words);
    expectFailure(again, output);
  }
}

TEST_F(ArchiveCommand, ResultsComeBackIdentical) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  const std::unique_ptr<RunningServer> running = startOrthanc(folder() / "server");
  ASSERT_TRUE(running);
  const std::string server = addressOf(running->server);
  const MadeStudy study = makeStudy(folder() / "study", "1.2.3.96", 3);
  io::writePng(at("picture.png"), {2, 1}, 3, std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6});
  const std::string data = study.folder.string();
  LabelMap labels;
  labels.grid = io::openVolume(study.folder).volume->grid;
  labels.labels = {{1, "first", {1, 0, 0}}};
  labels.voxels = Voxels(ScalarType::UInt8, labels.grid.voxelCount());
  std::fill_n(labels.voxels.as<std::uint8_t>().begin(), 500, std::uint8_t{1});
  io::writeLabels(labels, at("labels.nrrd"));
  fs::create_directories(at("results"));
  const std::vector<std::vector<std::string>> reports{
      {"report", "measures", data, "--labels", at("labels.nrrd"), "-o", at("results/a.dcm")},
      {"report", "capture", data, "--picture", at("picture.png"), "-o", at("results/b.dcm")},
      {"report", "keys", data, "--slices", "1", "-o", at("results/c.dcm")}};
  for (const auto& words : reports) {
    const Result made = run(words);
    ASSERT_EQ(made.exitCode, 0) << made.error;
  }
  const std::string port = std::to_string(running->server.ownPort);
  const Result sent = run({"archive", "send", server, at("results"), "--commit", "--port", port});
  EXPECT_EQ(sent.exitCode, 0) << sent.error;
  const Json answer = sent.json();
  EXPECT_EQ(answer["accepted"], 4) << sent.out;
  EXPECT_EQ(answer["committed"], 4) << sent.out;
  EXPECT_EQ(answer["objects"].size(), 4u);
  for (const Json& object : answer["objects"]) EXPECT_EQ(object["committed"], true) << object;
  const Result got = run(
      {"archive", "get", server, "--key", "StudyInstanceUID=" + study.uid, "-o", at("out"), "--cache", at("cache")});
  ASSERT_EQ(got.exitCode, 0) << got.error;
  EXPECT_EQ(objectsIn(at("out")), objectsIn(at("results")));
}

TEST_F(ArchiveCommand, SpeaksDicomwebAndTellsNoSecret) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  const std::unique_ptr<RunningServer> running = startOrthanc(folder() / "server");
  ASSERT_TRUE(running);
  const MadeStudy study = makeStudy(folder() / "studies", "1.2.3.97", 3);
  write(at("secret"), "secret word\n");
  const auto runWeb = [&](std::vector<std::string> words, const std::string& secret) {
    words.insert(words.begin() + 2, running->web);
    words.insert(words.end(), {"--user", "reader", "--secret", at(secret)});
    const Result result = run(words);
    EXPECT_EQ((result.out + result.error).find("secret word"), std::string::npos);
    return result;
  };
  EXPECT_EQ(runWeb({"archive", "send", at("studies")}, "secret").json()["accepted"], 3);
  EXPECT_EQ(runWeb({"archive", "find", "--key", "PatientID=T-1.2.3.97"}, "secret").json()["results"].size(), 1u);
  const Result got = runWeb(
      {"archive", "get", "--key", "StudyInstanceUID=" + study.uid, "-o", at("out"), "--cache", at("cache")}, "secret");
  EXPECT_EQ(got.exitCode, 0) << got.error;
  EXPECT_EQ(objectsIn(at("out")), objectsIn(study.folder));
  write(at("wrong"), "another word\n");
  const Result refused = runWeb({"archive", "echo"}, "wrong");
  expectFailure(refused, running->web);
  EXPECT_EQ(refused.error.find("another"), std::string::npos) << refused.error;
}

TEST_F(ArchiveCommand, FailsWithOneLineAndKnowsWrongUsage) {
  const std::string nobody = "dicom://ANY@127.0.0.1:" + std::to_string(freePort());
  const Result refused = run({"archive", "echo", nobody});
  expectFailure(refused, nobody);
  EXPECT_NE(refused.error.find("nothing listens on port"), std::string::npos) << refused.error;
  const std::vector<std::vector<std::string>> wrong{
      {"archive", "echo", "127.0.0.1:104"},
      {"archive", "echo", "dicom://NO_TITLE_HAS_MORE_THAN_16@host:104"},
      {"archive", "echo", "dicom://A@host:99999"},
      {"archive", "fetch", nobody},
      {"archive", "echo", "dicoms://A@host:104"},
      {"archive", "echo", nobody, "--tls-authorities", "a.pem"},
      {"archive", "find", nobody, "--key", "PatientName"},
      {"archive", "find", nobody, "--key", "Nonsense=1"},
      {"archive", "find", nobody, "--key", "PixelData=1"},
      {"archive", "get", nobody, "-o", at("out")},
      {"archive", "get", nobody, "--key", "PatientID=1"},
      {"archive", "move", nobody, "--key", "StudyInstanceUID=1"},
      {"archive", "send", nobody},
      {"archive", "echo", nobody, "--commit"},
      {"archive", "send", nobody, at("file"), "--wait", "5"},
      {"archive", "send", "https://host/dicom-web", at("file"), "--commit"},
      {"archive", "echo", nobody, at("file")},
      {"archive", "echo", nobody, "--secret", at("file")},
      {"archive", "echo", "https://user:word@host/dicom-web"},
      {"archive", "echo", "https://host/dicom-web", "--user", "reader"},
      {"archive", "move", "https://host/dicom-web", "--key", "StudyInstanceUID=1", "--port", "5000"}};
  for (const std::vector<std::string>& words : wrong) {
    const Result result = run(words);
    EXPECT_EQ(result.exitCode, 2) << words[1] << " " << words.back() << ": " << result.error;
    EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
  }
  EXPECT_TRUE(nothingLeftBehind());
}

}  // namespace fenestra::tests::archiveCommandTest
