// What goes wrong with a server, in one sentence each; what came before it is kept, and no more than the rest is asked
// for again.

#include <poll.h>
#include <sys/mount.h>
#include <sys/socket.h>
#include <unistd.h>
#include <atomic>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "io/archive/Cache.h"
#include "io/archive/Query.h"
#include "io/archive/Retrieve.h"
#include "io/archive/Send.h"
#include "io/dicom/Dcmtk.h"
#include "tests/archive/MadeStudies.h"
#include "tests/archive/Servers.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::archiveFaultsTest {
namespace fs = std::filesystem;
namespace archive = io::archive;
using std::chrono::milliseconds;
namespace {

archive::Server serverAt(int port) {
  archive::Server server;
  server.host = "127.0.0.1";
  server.port = port;
  server.title = "ARCHIVE";
  server.limits.silence = milliseconds(300);
  return server;
}

std::string diagnosisOf(const archive::Server& server) {
  return errorOf([&] { archive::echo(server); });
}

/// Listens, and says nothing or `words`.
class Listener {
 public:
  explicit Listener(const std::string& words) : words_(words) {
    thread_ = std::thread([this] {
      while (!stops_) {
        const int client = accept_();
        if (client < 0) continue;
        if (!words_.empty() && ::write(client, words_.data(), words_.size()) <= 0) ADD_FAILURE() << "cannot write";
        clients_.push_back(client);
      }
    });
  }
  ~Listener() {
    stops_ = true;
    thread_.join();
    for (const int each : clients_) close(each);
    close(socket_);
  }
  int port() const { return port_; }

 private:
  int accept_() {
    pollfd waited{socket_, POLLIN, 0};
    return poll(&waited, 1, 10) > 0 ? accept(socket_, nullptr, nullptr) : -1;
  }

  std::string words_;
  int port_ = 0, socket_ = listeningSocket(port_);
  std::vector<int> clients_;
  std::atomic<bool> stops_ = false;
  std::thread thread_;
};

/// A server, dcmqrscp with one study, and what each test does with it.
class ArchiveFaults : public ::testing::Test {
 protected:
  /// The first test starts the server for all.
  void SetUp() override {
    FENESTRA_PROGRAM_OR_SKIP("dcmqrscp", "dcmtk");
    if (running_) return;
    const fs::path folder = scratchFolder();
    running_ = startDcmqrscp(folder / "server");
    ASSERT_TRUE(running_) << readFile(folder / "server/log");
    study_ = makeStudy(folder / "studies", "1.2.3.90", 12);
    archive::send(running_->server, archive::filesToSend({study_.folder}));
  }
  static void TearDownTestSuite() { running_.reset(); }

  static archive::Server through(int port) {
    archive::Server server = running_->server;
    server.port = port;
    server.limits.silence = milliseconds(300);
    return server;
  }
  /// A transfer through a fault fails with `sentence`; the next one without it asks for the rest alone.
  static void expectResumes(Proxy::Fault fault, const std::string& sentence) {
    const archive::Cache cache(scratchFolder() / "cache");
    {
      const Proxy proxy(running_->server.port, fault);
      const std::string error = errorOf([&] {
        archive::retrieve(through(proxy.port()), {study_.uid, study_.series}, cache);
      });
      EXPECT_NE(error.find(sentence), std::string::npos) << error;
    }
    const std::size_t held = cache.held(study_.uid, study_.series).size();
    EXPECT_GT(held, 0u);
    EXPECT_LT(held, 12u);
    EXPECT_FALSE(fs::exists(cache.folderOf(study_.uid, study_.series))) << "half a series is no series";
    const archive::Retrieved got = archive::retrieve(running_->server, {study_.uid, study_.series}, cache);
    EXPECT_EQ(got.series.at(0).received, 12u - held) << "only what is missing";
    EXPECT_EQ(objectsIn(got.series[0].folder), objectsIn(study_.folder));
  }

  static inline std::unique_ptr<RunningServer> running_;
  static inline MadeStudy study_;
};

}  // namespace

TEST(ArchiveDiagnoses, SaysInOneSentenceWhatIsWrong) {
  const auto expectSays = [](const archive::Server& server, const std::string& sentence) {
    const std::string error = diagnosisOf(server);
    EXPECT_TRUE(error.starts_with(server.name() + ": ")) << error;
    EXPECT_NE(error.find(sentence), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  };
  expectSays(serverAt(freePort()), "nothing listens on port");
  archive::Server unknown = serverAt(104);
  unknown.host = "no-such-host.invalid";
  expectSays(unknown, "there is no host");
  const Listener silent(""), web("HTTP/1.1 400 Bad Request\r\nConnection: close\r\n\r\n");
  expectSays(serverAt(silent.port()), "does not answer as a DICOM server");
  expectSays(serverAt(web.port()), "no DICOM server");
}

TEST(ArchiveDiagnoses, StopsAtOnceWhenCancelled) {
  const Listener silent("");
  archive::Server server = serverAt(silent.port());
  server.limits.silence = milliseconds(60'000);
  std::atomic<bool> goesOn = true;
  std::chrono::steady_clock::time_point cancelled;
  int asked = 0;
  EXPECT_THROW(archive::echo(server,
                             [&](double, std::string_view) {
                               if (++asked == 3) {
                                 goesOn = false;
                                 cancelled = std::chrono::steady_clock::now();
                               }
                               return goesOn.load();
                             }),
               io::Cancelled);
  EXPECT_LT(std::chrono::steady_clock::now() - cancelled, milliseconds(500));
}

TEST_F(ArchiveFaults, NamesTheWrongTitle) {
  archive::Server server = running_->server;
  server.title = "SOMEBODY";
  EXPECT_NE(diagnosisOf(server).find("does not go by the AE title \"SOMEBODY\""), std::string::npos)
      << diagnosisOf(server);
}

TEST_F(ArchiveFaults, SaysWhereAMoveWouldHaveToGo) {
  archive::Server server = running_->server;
  server.ownTitle = "STRANGER";
  const archive::Cache cache(scratchFolder() / "cache");
  const std::string error = errorOf([&] { archive::retrieve(server, {study_.uid, "", archive::Way::Move}, cache); });
  EXPECT_NE(error.find("does not know where to send objects for the AE title \"STRANGER\""), std::string::npos)
      << error;
  EXPECT_NE(error.find(std::to_string(server.ownPort)), std::string::npos) << error;
}

TEST_F(ArchiveFaults, ResumesAfterACutConnection) {
  expectResumes({.after = 60'000, .stalls = false}, "the connection broke while retrieving a series");
}

TEST_F(ArchiveFaults, ResumesAfterAStall) {
  expectResumes({.after = 60'000, .stalls = true}, "the server was silent for");
}

TEST_F(ArchiveFaults, ResumesAfterTheServerWasKilled) {
  const fs::path folder = scratchFolder();
  const archive::Cache cache(folder / "cache");
  {
    const std::unique_ptr<RunningServer> other = startDcmqrscp(folder / "server");
    ASSERT_TRUE(other);
    archive::send(other->server, archive::filesToSend({study_.folder}));
    const std::string error = errorOf([&] {
      archive::retrieve(other->server, {study_.uid, study_.series}, cache, [&](double fraction, std::string_view) {
        if (fraction > 0.4) other->program->kill();
        return true;
      });
    });
    EXPECT_NE(error.find("the connection broke"), std::string::npos) << error;
  }
  const std::size_t held = cache.held(study_.uid, study_.series).size();
  EXPECT_GT(held, 0u);
  EXPECT_EQ(archive::retrieve(running_->server, {study_.uid, study_.series}, cache).series.at(0).received, 12u - held);
}

TEST_F(ArchiveFaults, KeepsWhatCameBeforeACancel) {
  const archive::Cache cache(scratchFolder() / "cache");
  EXPECT_THROW(archive::retrieve(running_->server, {study_.uid, study_.series}, cache,
                                 [](double fraction, std::string_view) { return fraction < 0.4; }),
               io::Cancelled);
  const std::size_t held = cache.held(study_.uid, study_.series).size();
  EXPECT_GT(held, 0u);
  EXPECT_LT(held, 12u);
  EXPECT_EQ(archive::retrieve(running_->server, {study_.uid, study_.series}, cache).series.at(0).received, 12u - held);
}

TEST_F(ArchiveFaults, RefusesWhatTheDiskOrTheLimitsDoNotHold) {
  const archive::Cache cache(scratchFolder() / "cache");
  archive::Server server = running_->server;
  server.limits.freeDiskBytes = std::uint64_t(1) << 60;
  const std::string full = errorOf([&] { archive::retrieve(server, {study_.uid, study_.series}, cache); });
  EXPECT_NE(full.find("is full"), std::string::npos) << full;
  server = running_->server;
  server.limits.objectBytes = 4096;
  const std::string large = errorOf([&] { archive::retrieve(server, {study_.uid, study_.series}, cache); });
  EXPECT_NE(large.find("more than one message may hold"), std::string::npos) << large;
  EXPECT_TRUE(cache.held(study_.uid, study_.series).empty());
  EXPECT_EQ(cache.bytes(), 0u) << "nothing half-written stays";
}

TEST_F(ArchiveFaults, SendsTheRestWhereAnObjectIsRefused) {
  const fs::path folder = scratchFolder();
  const MadeStudy study = makeStudy(folder, "1.2.3.91", 2);
  std::vector<fs::path> files = archive::filesToSend({study.folder});
  archive::Server server = running_->server;
  server.title = "DCMQRSCP";
  DcmFileFormat unknown;
  ASSERT_TRUE(unknown.loadFile(files.at(0).c_str()).good());
  unknown.getDataset()->putAndInsertString(DCM_SOPClassUID, "1.2.3.4");
  ASSERT_TRUE(unknown.saveFile(files.at(0).c_str()).good());
  const std::vector<archive::Sent> sent = archive::send(server, files);
  ASSERT_EQ(sent.size(), 2u);
  EXPECT_FALSE(sent[0].accepted);
  EXPECT_NE(sent[0].text.find("does not take this class"), std::string::npos) << sent[0].text;
  EXPECT_TRUE(sent[1].accepted) << sent[1].text;
  EXPECT_NE(errorOf([&] { archive::filesToSend({folder / "nothing"}); }).find("does not exist"), std::string::npos);
}

TEST_F(ArchiveFaults, StopsAfterTheMostAnswers) {
  archive::Server server = running_->server;
  server.limits.answers = 5;
  const archive::Answers answers = archive::find(
      server, {archive::Level::Image, {{"StudyInstanceUID", study_.uid}, {"SeriesInstanceUID", study_.series}}});
  EXPECT_EQ(answers.records.size(), 5u);
  EXPECT_FALSE(answers.complete);
}

TEST(ArchiveCache, LaysOutASeriesAndLeavesWhatIsBesideIt) {
  const fs::path folder = scratchFolder();
  const archive::Cache cache(folder / "cache");
  writeFile(cache.partOf("1", "1.1") / "object.dcm", "x");
  cache.complete("1", "1.1");
  fs::create_directories(folder / "study.part");
  writeFile(folder / "study.part/mine", "y");
  EXPECT_EQ(archive::layOut({cache.folderOf("1", "1.1")}, folder / "study/"), 1u);
  EXPECT_EQ(readFile(folder / "study/object.dcm"), "x");
  EXPECT_EQ(readFile(folder / "study.part/mine"), "y");
  EXPECT_NE(errorOf([&] { archive::layOut({}, folder / "study"); }).find("holds files"), std::string::npos);
}

TEST(ArchiveCache, DropsWhatWasUsedLongestAgoAndNothingElse) {
  const archive::Cache cache(scratchFolder() / "cache");
  for (const char* series : {"1.1", "1.2", "1.3"}) {
    writeFile(cache.partOf("1", series) / (archive::cacheName(series) + ".dcm"), std::string(1000, 'x'));
    cache.complete("1", series);
    fs::last_write_time(cache.folderOf("1", series),
                        fs::file_time_type::clock::now() - std::chrono::hours(series[2] == '2' ? 9 : 1));
  }
  EXPECT_EQ(cache.bytes(), 3000u);
  cache.trim(2500, {});
  EXPECT_FALSE(fs::exists(cache.folderOf("1", "1.2")));
  EXPECT_EQ(cache.bytes(), 2000u);
  cache.trim(0, {cache.folderOf("1", "1.3")});
  EXPECT_EQ(cache.bytes(), 1000u) << "what is retrieved now stays";
  cache.clear();
  EXPECT_EQ(cache.bytes(), 0u);
}

/// A disk of 64 KiB at a folder, gone with this.
class SmallDisk {
 public:
  explicit SmallDisk(fs::path folder) : folder_(std::move(folder)) {
    fs::create_directories(folder_);
    isThere_ = mount("none", folder_.c_str(), "tmpfs", 0, "size=64k") == 0;
  }
  ~SmallDisk() {
    if (!isThere_) return;
    EXPECT_EQ(umount(folder_.c_str()), 0);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  bool isThere() const { return isThere_; }

 private:
  fs::path folder_;
  bool isThere_ = false;
};

TEST_F(ArchiveFaults, ADiskThatFillsUpMeanwhileIsSaidToBeFull) {
  for (const archive::Way way : {archive::Way::Get, archive::Way::Move}) {
    SCOPED_TRACE(way == archive::Way::Get ? "C-GET" : "C-MOVE");
    const fs::path folder = study_.folder.parent_path().parent_path() / "small";
    const SmallDisk disk(folder);
    if (!disk.isThere()) GTEST_SKIP() << "needs the right to mount a tmpfs: run it as root";
    archive::Server server = running_->server;
    server.limits.silence = std::chrono::seconds(5);
    server.limits.freeDiskBytes = 0;  // so that the disk is found to be full by the writing alone
    std::string error;
    std::size_t held = 0;
    {
      const archive::Cache cache(folder / "cache");
      error = errorOf([&] { archive::retrieve(server, {study_.uid, study_.series, way}, cache); });
      held = cache.held(study_.uid, study_.series).size();
      EXPECT_FALSE(fs::exists(cache.folderOf(study_.uid, study_.series))) << "half a series is no series";
      const auto sent = objectsIn(study_.folder), here = objectsIn(folder);
      EXPECT_EQ(here.size(), held) << "half an object cannot be read";
      for (const auto& [object, bytes] : here) EXPECT_TRUE(bytes == sent.at(object)) << "half of " << object;
      for (const auto& each : fs::recursive_directory_iterator(folder))
        EXPECT_EQ(each.path().filename().string().find("incoming"), std::string::npos) << each.path();
    }
    EXPECT_NE(error.find("is full"), std::string::npos) << error;
    EXPECT_GT(held, 0u) << "what came before is kept";
    EXPECT_LT(held, 12u);
  }
}

}  // namespace fenestra::tests::archiveFaultsTest
