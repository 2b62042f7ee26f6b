// Servers that die at any time, and lines between that are slow or repeat themselves.

#include <chrono>

#include <gtest/gtest.h>

#include "io/archive/Retrieve.h"
#include "io/archive/Send.h"
#include "io/archive/WebArchive.h"
#include "tests/archive/MadeStudies.h"
#include "tests/archive/Servers.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::badLinesTest {
namespace fs = std::filesystem;
namespace archive = io::archive;
using std::chrono::milliseconds;
namespace {

constexpr milliseconds silence{300};

archive::Server through(const RunningServer& running, const Proxy& proxy) {
  archive::Server server = running.server;
  server.port = proxy.port();
  server.limits.silence = silence;
  return server;
}

archive::WebServer webThrough(const RunningServer& running, int port) {
  archive::WebServer web = archive::parseWebServer(running.web).value();
  if (port != 0) web.url = "http://127.0.0.1:" + std::to_string(port) + "/dicom-web";
  web.user = "reader";
  web.secret = archive::Secret("secret word");
  web.limits.silence = silence;
  return web;
}

int webPortOf(const RunningServer& running) { return std::stoi(running.web.substr(running.web.rfind(':') + 1)); }

/// One line that says what is wrong, and no series in the cache; the next retrieval, over a good line, brings the rest.
template <class Bad, class Good>
void expectRefusedThenWhole(const Bad& bad, const Good& good, const MadeStudy& study, const fs::path& folder) {
  const archive::Cache cache(folder);
  const std::string error = errorOf([&] { archive::retrieve(bad, {study.uid, study.series}, cache); });
  EXPECT_TRUE(error.starts_with(bad.name() + ": ")) << error;
  EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  EXPECT_FALSE(fs::exists(cache.folderOf(study.uid, study.series))) << "half a series is no series";
  const archive::Retrieved got = archive::retrieve(good, {study.uid, study.series}, cache);
  EXPECT_EQ(objectsIn(got.series.at(0).folder), objectsIn(study.folder));
}

}  // namespace

TEST(ArchiveBadLines, AServerThatDiesAtAnyTimeIsResumed) {
  FENESTRA_PROGRAM_OR_SKIP("dcmqrscp", "dcmtk");
  const fs::path folder = scratchFolder();
  std::unique_ptr<RunningServer> running = startDcmqrscp(folder / "server");
  ASSERT_TRUE(running);
  const MadeStudy study = makeStudy(folder / "studies", "1.2.3.96", 100);
  archive::send(running->server, archive::filesToSend({study.folder}));
  for (const int percent : {10, 50, 99}) {
    SCOPED_TRACE(percent);
    const archive::Cache cache(folder / ("cache" + std::to_string(percent)));
    int came = 0;
    const std::string error = errorOf([&] {
      archive::retrieve(running->server,
                        {study.uid, study.series, archive::Way::Get,
                         [&](const archive::ArrivedObject&) {
                           if (++came == percent) running->program->kill();
                         }},
                        cache);
    });
    EXPECT_NE(error.find("the connection broke while retrieving a series"), std::string::npos) << error;
    // What the dead server had written into the socket may still come, and the last one may be in doubt.
    const std::size_t held = cache.held(study.uid, study.series).size();
    EXPECT_GE(held + 1, static_cast<std::size_t>(percent));
    EXPECT_LE(held, 100u);
    EXPECT_FALSE(fs::exists(cache.folderOf(study.uid, study.series)));
    running = startDcmqrscp(folder / "server");
    ASSERT_TRUE(running);
    const archive::Retrieved got = archive::retrieve(running->server, {study.uid, study.series}, cache);
    EXPECT_EQ(got.series.at(0).received, 100u - held) << "only what is missing";
    EXPECT_EQ(objectsIn(got.series[0].folder).size(), 100u);
  }
}

TEST(ArchiveBadLines, BytesThatComeTwiceAreRefused) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  const fs::path folder = scratchFolder();
  const std::unique_ptr<RunningServer> running = startOrthanc(folder / "server");
  ASSERT_TRUE(running);
  const MadeStudy study = makeStudy(folder / "studies", "1.2.3.97", 12);
  archive::send(running->server, archive::filesToSend({study.folder}));
  {
    const Proxy proxy(running->server.port, {.after = 40'000, .doubles = true});
    expectRefusedThenWhole(through(*running, proxy), running->server, study, folder / "a");
  }
  const Proxy proxy(webPortOf(*running), {.after = 40'000, .doubles = true});
  expectRefusedThenWhole(webThrough(*running, proxy.port()), webThrough(*running, 0), study, folder / "b");
}

TEST(ArchiveBadLines, ASlowLineIsWaitedForAsLongAsSomethingComes) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  const fs::path folder = scratchFolder();
  const std::unique_ptr<RunningServer> running = startOrthanc(folder / "server");
  ASSERT_TRUE(running);
  const MadeStudy study = makeStudy(folder / "studies", "1.2.3.98", 12);
  archive::send(running->server, archive::filesToSend({study.folder}));
  const auto expectComes = [&](const auto& server, const fs::path& place) {
    const auto start = std::chrono::steady_clock::now();
    const archive::Retrieved got = archive::retrieve(server, {study.uid, study.series}, archive::Cache(place));
    EXPECT_GT(std::chrono::steady_clock::now() - start, silence) << "the line is not slow";
    EXPECT_EQ(objectsIn(got.series.at(0).folder), objectsIn(study.folder));
  };
  // 100 KB in steps of 5 ms: more than half a second.
  const Proxy proxy(running->server.port, {.slow = 1000}), web(webPortOf(*running), {.slow = 1000});
  expectComes(through(*running, proxy), folder / "a");
  expectComes(webThrough(*running, web.port()), folder / "b");
}

}  // namespace fenestra::tests::badLinesTest
