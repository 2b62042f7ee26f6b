// What a retrieval tells while it runs: the middle of a series comes first, and each object once. Two programs that
// retrieve the same series take turns.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <set>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/archive/Retrieve.h"
#include "io/archive/Send.h"
#include "io/archive/Wanted.h"
#include "io/archive/WebArchive.h"
#include "tests/archive/MadeStudies.h"
#include "tests/archive/Servers.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::arrivalTest {
namespace fs = std::filesystem;
namespace archive = io::archive;
namespace {

archive::WebServer webOf(const RunningServer& running) {
  archive::WebServer web = archive::parseWebServer(running.web).value();
  web.user = "reader";
  web.secret = archive::Secret("secret word");
  return web;
}

/// What arrives, and when.
class Arrivals {
 public:
  archive::Arrival take() {
    return [this](const archive::ArrivedObject& each) {
      if (all_.empty()) first_ = std::chrono::steady_clock::now() - start_;
      isThere_ = isThere_ && fs::exists(each.file);
      all_.push_back(each);
    };
  }
  /// Each object of `study` once, the middle one first, every file in place at that moment.
  void expectWhole(const MadeStudy& study) const {
    ASSERT_EQ(all_.size(), static_cast<std::size_t>(study.slices));
    EXPECT_EQ(all_.front().number, study.slices / 2 + 1);
    EXPECT_TRUE(isThere_);
    std::set<fs::path> files;
    for (const archive::ArrivedObject& each : all_) {
      files.insert(each.file);
      EXPECT_EQ(each.total, all_.size());
      EXPECT_EQ(each.series, study.series);
    }
    EXPECT_EQ(files.size(), all_.size());
  }
  double firstSeconds() const { return std::chrono::duration<double>(first_).count(); }
  const std::vector<archive::ArrivedObject>& all() const { return all_; }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::duration first_{};
  std::vector<archive::ArrivedObject> all_;
  bool isThere_ = true;
};

void sendTo(const RunningServer& running, const MadeStudy& study) {
  for (const archive::Sent& each : archive::send(running.server, archive::filesToSend({study.folder})))
    EXPECT_TRUE(each.accepted) << each.text;
}

}  // namespace

TEST(ArchiveArrival, TheOrderHalvesTheGaps) {
  archive::Wanted wanted{"1", "1.1", {}};
  for (int i = 1; i <= 7; ++i) {
    const std::string uid = "1.1." + std::to_string(8 - i);  // against the order of the UIDs
    wanted.objects[uid] = "1.2";
    wanted.numbers[uid] = i;
  }
  std::vector<int> numbers;
  for (const std::string& each : archive::middleFirst(wanted)) numbers.push_back(wanted.numbers.at(each));
  EXPECT_EQ(numbers, (std::vector<int>{4, 2, 6, 1, 3, 5, 7}));
  wanted.numbers.clear();
  EXPECT_EQ(archive::middleFirst(wanted).size(), 7u) << "without numbers by UID";
  EXPECT_TRUE(archive::middleFirst({"1", "1.1", {}}).empty());
}

TEST(ArchiveArrival, TheMiddleOfASeriesComesFirstOnEveryWay) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  const fs::path folder = scratchFolder();
  const std::unique_ptr<RunningServer> running = startOrthanc(folder / "server");
  ASSERT_TRUE(running);
  const MadeStudy study = makeStudy(folder / "made", "1.2.3.81", 20);
  sendTo(*running, study);
  for (const archive::Way way : {archive::Way::Get, archive::Way::Move}) {
    SCOPED_TRACE(way == archive::Way::Get ? "C-GET" : "C-MOVE");
    Arrivals arrivals;
    const archive::Cache cache(folder / (way == archive::Way::Get ? "got" : "moved"));
    const archive::Retrieved got =
        archive::retrieve(running->server, {study.uid, study.series, way, arrivals.take()}, cache);
    arrivals.expectWhole(study);
    EXPECT_EQ(got.refusals.objects, 0u);
    EXPECT_EQ(objectsIn(got.series.at(0).folder), objectsIn(study.folder));
  }
  Arrivals arrivals;
  const archive::Cache cache(folder / "web");
  const archive::Retrieved got =
      archive::retrieve(webOf(*running), {study.uid, study.series, archive::Way::Get, arrivals.take()}, cache);
  arrivals.expectWhole(study);
  EXPECT_EQ(arrivals.all().at(1).number, 6) << "the middle of the first ten";
  EXPECT_EQ(objectsIn(got.series.at(0).folder), objectsIn(study.folder));
}

TEST(ArchiveArrival, WhatABrokenTransferLeftIsToldOfAgain) {
  FENESTRA_PROGRAM_OR_SKIP("dcmqrscp", "dcmtk");
  const fs::path folder = scratchFolder();
  const std::unique_ptr<RunningServer> running = startDcmqrscp(folder / "server");
  ASSERT_TRUE(running);
  const MadeStudy study = makeStudy(folder / "made", "1.2.3.82", 30);
  sendTo(*running, study);
  const archive::Cache cache(folder / "cache");
  Arrivals first;
  EXPECT_THROW(archive::retrieve(running->server, {study.uid, study.series, archive::Way::Get, first.take()}, cache,
                                 [&](double, std::string_view) { return first.all().size() < 5; }),
               io::Cancelled);
  ASSERT_GE(first.all().size(), 5u);
  ASSERT_LT(first.all().size(), 30u);
  Arrivals second;
  archive::retrieve(running->server, {study.uid, study.series, archive::Way::Get, second.take()}, cache);
  EXPECT_EQ(second.all().size(), 30u);
  std::set<fs::path> files;
  for (const archive::ArrivedObject& each : second.all()) files.insert(each.file);
  EXPECT_EQ(files.size(), 30u);
}

TEST(ArchiveArrival, Thorough_TheFirstOfFiveHundredSlicesComesAtOnce) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  const fs::path folder = scratchFolder();
  const std::unique_ptr<RunningServer> orthanc = startOrthanc(folder / "orthanc"),
                                       dcmqrscp = startDcmqrscp(folder / "dcmqrscp");
  ASSERT_TRUE(orthanc && dcmqrscp);
  const MadeStudy study = makeStudy(folder / "made", "1.2.3.83", 500);
  sendTo(*orthanc, study);
  sendTo(*dcmqrscp, study);
  const auto measure = [&](const char* name, const auto& server) {
    Arrivals arrivals;
    const auto start = std::chrono::steady_clock::now();
    archive::retrieve(server, {study.uid, study.series, archive::Way::Get, arrivals.take()},
                      archive::Cache(folder / "cache" / name));
    const double whole = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("500 slices by %s: the first after %.3f s, all after %.3f s\n", name, arrivals.firstSeconds(), whole);
    arrivals.expectWhole(study);
    EXPECT_LT(arrivals.firstSeconds(), 0.5 * whole) << "long before the last one";
  };
  fs::create_directories(folder / "cache");
  measure("C-GET-dcmqrscp", dcmqrscp->server);
  measure("C-GET-Orthanc", orthanc->server);
  measure("DICOMweb-Orthanc", webOf(*orthanc));
}

TEST(ArchiveTurns, ARetrievalWaitsForAnotherProgramAndThenHasAll) {
  FENESTRA_PROGRAM_OR_SKIP("dcmqrscp", "dcmtk");
  const fs::path folder = scratchFolder();
  const std::unique_ptr<RunningServer> running = startDcmqrscp(folder / "server");
  ASSERT_TRUE(running);
  const MadeStudy study = makeStudy(folder / "made", "1.2.3.84", 200);
  sendTo(*running, study);
  const archive::Cache cache(folder / "cache");
  const std::vector<std::string> words{FENESTRA_CLI, "archive",
                                       "get",        running->server.name(),
                                       "--key",      "StudyInstanceUID=" + study.uid,
                                       "--cache",    cache.root().string()};
  const auto received = [&](const fs::path& output) {
    const auto answer = nlohmann::json::parse(readFile(output), nullptr, false);
    EXPECT_FALSE(answer.is_discarded()) << readFile(output);
    return answer.is_discarded() ? 1000 : answer["series"][0]["received"].get<int>();
  };
  {
    // While we hold the series, the other program asks for nothing of it.
    std::optional<archive::SeriesLock> held(cache.lock(study.uid, study.series, [] { FAIL() << "it is free"; }));
    Program first(words, folder / "1"), second(words, folder / "2");
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    EXPECT_TRUE(first.isRunning() && second.isRunning());
    EXPECT_TRUE(cache.held(study.uid, study.series).empty());
    held.reset();
    EXPECT_TRUE(eventually([&] { return !first.isRunning() && !second.isRunning(); }));
  }
  EXPECT_EQ(received(folder / "1") + received(folder / "2"), 200) << "never the same object twice";
  EXPECT_EQ(objectsIn(cache.folderOf(study.uid, study.series)), objectsIn(study.folder));
  for (const auto& entry : fs::recursive_directory_iterator(cache.root()))
    EXPECT_TRUE(entry.is_directory() || entry.path().extension() == ".dcm") << entry.path() << " is left behind";
}

TEST(ArchiveTurns, WhatAnEndedProgramWasReceivingIsNoObjectOfTheSeries) {
  const archive::Cache cache(scratchFolder() / "cache");
  const fs::path part = cache.partOf("1.1", "1.1.1");
  std::ofstream(part / "a.dcm") << "object";
  std::ofstream(part / "incoming-1-0") << "a half of one, or a frame";
  cache.complete("1.1", "1.1.1");
  const fs::path whole = cache.folderOf("1.1", "1.1.1");
  EXPECT_TRUE(fs::exists(whole / "a.dcm"));
  EXPECT_FALSE(fs::exists(whole / "incoming-1-0"));
}

TEST(ArchiveTurns, WhatIsBeingWrittenIsNeitherTrimmedNorCleared) {
  const archive::Cache cache(scratchFolder() / "cache");
  std::ofstream(cache.partOf("1.1", "1.1.1") / "a.dcm") << "object";
  std::ofstream(cache.partOf("1.2", "1.2.1") / "b.dcm") << "object";
  {
    const archive::SeriesLock held = cache.lock("1.1", "1.1.1", [] {});
    EXPECT_FALSE(archive::SeriesLock::tryTake(cache.folderOf("1.1", "1.1.1")));
    cache.trim(0, {});
    EXPECT_EQ(cache.held("1.1", "1.1.1"), std::set<std::string>{"a"});
    EXPECT_TRUE(cache.held("1.2", "1.2.1").empty());
    cache.clear();
    EXPECT_EQ(cache.held("1.1", "1.1.1"), std::set<std::string>{"a"});
    EXPECT_THROW(cache.lock("1.1", "1.1.1", [] { throw io::Cancelled(); }), io::Cancelled) << "waiting can be ended";
  }
  cache.clear();
  EXPECT_TRUE(fs::is_empty(cache.root()));
}

}  // namespace fenestra::tests::arrivalTest
