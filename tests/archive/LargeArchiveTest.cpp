// What takes long: ten thousand answers, and how fast a series of 500 slices comes beside DCMTK's own program.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include "io/archive/Query.h"
#include "io/archive/Retrieve.h"
#include "io/archive/Send.h"
#include "io/archive/WebArchive.h"
#include "tests/archive/MadeStudies.h"
#include "tests/archive/Servers.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::largeArchiveTest {
namespace fs = std::filesystem;
namespace archive = io::archive;
namespace {

double secondsOf(const std::function<void()>& act) {
  const auto start = std::chrono::steady_clock::now();
  act();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

TEST(ArchiveLarge, Exhaustive_TenThousandAnswersComeWhole) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  const fs::path folder = scratchFolder();
  const std::unique_ptr<RunningServer> running = startOrthanc(folder / "server");
  ASSERT_TRUE(running);
  const MadeStudy study = makeStudy(folder / "studies", "1.2.3.98", 10'000);
  archive::send(running->server, archive::filesToSend({study.folder}));
  archive::WebServer web = archive::parseWebServer(running->web).value();
  web.user = "reader";
  web.secret = archive::Secret("secret word");
  const archive::Query query{archive::Level::Image,
                             {{"StudyInstanceUID", study.uid}, {"SeriesInstanceUID", study.series}}};
  EXPECT_EQ(archive::find(running->server, query).records.size(), 10'000u);
  EXPECT_EQ(archive::find(web, query).records.size(), 10'000u);
}

TEST(ArchiveLarge, Exhaustive_ASeriesComesAboutAsFastAsWithDcmtksProgram) {
  FENESTRA_PROGRAM_OR_SKIP("getscu", "dcmtk");
  const fs::path folder = scratchFolder();
  const std::unique_ptr<RunningServer> running = startDcmqrscp(folder / "server");
  ASSERT_TRUE(running);
  const archive::Server& server = running->server;
  const MadeStudy study = makeStudy(folder / "studies", "1.2.3.99", 200);
  archive::send(server, archive::filesToSend({study.folder}));
  fs::create_directories(folder / "peer");
  const std::string peer = "getscu -aet FENESTRA -aec " + server.title +
                           " -S -k QueryRetrieveLevel=SERIES -k StudyInstanceUID=" + study.uid +
                           " -k SeriesInstanceUID=" + study.series + " -od '" + (folder / "peer").string() +
                           "' 127.0.0.1 " + std::to_string(server.port) + " >/dev/null 2>&1";
  double ours = 1e9, theirs = 1e9;  // the fastest of three each
  for (int i = 0; i < 3; ++i) {
    theirs = std::min(theirs, secondsOf([&] { EXPECT_EQ(std::system(peer.c_str()), 0); }));
    const archive::Cache cache(folder / ("cache" + std::to_string(i)));
    ours =
        std::min(ours, secondsOf([&] {
                   EXPECT_EQ(archive::retrieve(server, {study.uid, study.series}, cache).series.at(0).received, 200u);
                 }));
  }
  std::printf("200 slices: %.3f s, getscu %.3f s\n", ours, theirs);
  EXPECT_LT(ours, 1.5 * theirs + 0.1);
}

}  // namespace fenestra::tests::largeArchiveTest
