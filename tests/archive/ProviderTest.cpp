// Our storage provider and those who try to send it something else than what was asked for.

#include <sys/socket.h>
#include <unistd.h>
#include <chrono>

#include <gtest/gtest.h>

#include "io/archive/Send.h"
#include "io/archive/StorageProvider.h"
#include "tests/archive/MadeStudies.h"
#include "tests/archive/Servers.h"
#include "tests/io/DicomWriter.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::providerTest {
namespace fs = std::filesystem;
namespace archive = io::archive;
namespace {

const std::string ct = "1.2.840.10008.5.1.4.1.1.2";

/// A provider that waits for the three objects of a study, and what others send to it.
class ArchiveProvider : public ::testing::Test {
 protected:
  void start(archive::Wanted wanted) {
    intake_.emplace(cache_, server_.limits, activity_);
    intake_->expect(wanted, wanted);
    provider_.emplace(server_, std::set<std::string>{ct}, *intake_);
  }
  void start() {
    start({study_.uid,
           study_.series,
           {{study_.series + ".1", ct}, {study_.series + ".2", ct}, {study_.series + ".3", ct}}});
  }

  static archive::Server made() {
    archive::Server server;
    server.title = "ARCHIVE";
    server.ownPort = freePort();
    server.limits.silence = std::chrono::seconds(20);
    server.limits.freeDiskBytes = 0;
    return server;
  }
  /// What a client of these titles gets that sends `files` to us.
  std::vector<archive::Sent> sendAs(const std::string& calling, const std::string& called, const fs::path& files) {
    archive::Server us;
    us.host = "127.0.0.1";
    us.port = server_.ownPort;
    us.title = called;
    us.ownTitle = calling;
    return archive::send(us, archive::filesToSend({files}));
  }
  std::string errorAs(const std::string& calling, const std::string& called, const fs::path& files) {
    return errorOf([&] { sendAs(calling, called, files); });
  }
  std::size_t held() const { return cache_.held(study_.uid, study_.series).size(); }

  fs::path folder_ = scratchFolder();
  MadeStudy study_ = makeStudy(folder_, "1.2.3.10", 3), other_ = makeStudy(folder_, "1.2.3.66", 2);
  archive::Server server_ = made();
  archive::Cache cache_{folder_ / "cache"};
  archive::Activity activity_;
  std::optional<archive::Intake> intake_;
  std::optional<archive::StorageProvider> provider_;
};

}  // namespace

TEST_F(ArchiveProvider, TakesWhatWasAskedForFromWhomItWasAsked) {
  start();
  for (const archive::Sent& each : sendAs("ARCHIVE", "FENESTRA", study_.folder))
    EXPECT_TRUE(each.accepted) << each.text;
  EXPECT_EQ(intake_->received(), 3u);
  EXPECT_EQ(held(), 3u);
  EXPECT_EQ(intake_->refused(), 0u);
}

TEST_F(ArchiveProvider, RefusesOtherTitles) {
  start();
  EXPECT_NE(errorAs("ATTACKER", "FENESTRA", study_.folder).find("does not know our AE title"), std::string::npos);
  EXPECT_NE(errorAs("ARCHIVE", "OTHER", study_.folder).find("does not go by the AE title"), std::string::npos);
  EXPECT_EQ(provider_->refusals().titles, 2u);
  EXPECT_EQ(held(), 0u);
}

TEST_F(ArchiveProvider, RefusesObjectsOfAnotherStudy) {
  start();
  for (const archive::Sent& each : sendAs("ARCHIVE", "FENESTRA", other_.folder)) {
    EXPECT_FALSE(each.accepted);
    EXPECT_EQ(each.status, 0x0124u) << each.text;
  }
  EXPECT_EQ(intake_->refused(), 2u);
  EXPECT_EQ(held(), 0u);
}

TEST_F(ArchiveProvider, RefusesAnObjectThatGoesByTheUidOfOneAskedFor) {
  // Asked for are objects of `study_` with the UIDs that those of the other study have.
  start({study_.uid, study_.series, {{other_.series + ".1", ct}, {other_.series + ".2", ct}}});
  for (const archive::Sent& each : sendAs("ARCHIVE", "FENESTRA", other_.folder)) EXPECT_EQ(each.status, 0xa900u);
  EXPECT_EQ(intake_->refused(), 2u);
  EXPECT_EQ(held(), 0u);
  EXPECT_EQ(cache_.bytes(), 0u);
}

TEST_F(ArchiveProvider, RefusesClassesThatWereNotAskedFor) {
  start();
  DicomSpec spec;
  spec.sopClass = "1.2.840.10008.5.1.4.1.1.4";  // MR
  fs::create_directories(folder_ / "mr");
  writeDicom(folder_ / "mr/1.dcm", spec);
  EXPECT_NE(errorAs("ARCHIVE", "FENESTRA", folder_ / "mr").find("refuses the association"), std::string::npos);
  EXPECT_EQ(provider_->refusals().classes, 1u);
}

TEST_F(ArchiveProvider, EndsAnObjectThatIsTooLarge) {
  server_.limits.objectBytes = 4096;
  start();
  EXPECT_NE(errorAs("ARCHIVE", "FENESTRA", study_.folder).find("the connection broke"), std::string::npos);
  EXPECT_EQ(held(), 0u);
  EXPECT_EQ(cache_.bytes(), 0u);
}

TEST_F(ArchiveProvider, LetsTheServerInBesideConnectionsThatSayNothing) {
  start();
  std::vector<int> open;
  for (int i = 0; i < 500; ++i) {
    open.push_back(connectTo(server_.ownPort));
    ASSERT_GE(open.back(), 0);
    if (i % 50 == 0) send(open.back(), "\x01\x00\x00", 3, MSG_NOSIGNAL);  // the start of an association request
    if (i % 50 == 1) send(open.back(), "GET / HT", 8, MSG_NOSIGNAL);
  }
  const auto before = std::chrono::steady_clock::now();
  for (const archive::Sent& each : sendAs("ARCHIVE", "FENESTRA", study_.folder))
    EXPECT_TRUE(each.accepted) << each.text;
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(5));
  EXPECT_EQ(held(), 3u);
  EXPECT_GE(provider_->refusals().connections, 400u);
  for (const int each : open) close(each);
}

TEST_F(ArchiveProvider, LetsTheServerInBesideHandshakesThatStop) {
  FENESTRA_PROGRAM_OR_SKIP("openssl", "openssl");
  const Certificate own = makeCertificate(folder_, "own");
  server_.tls = archive::TlsFiles{own.certificate, own.certificate, own.key};
  server_.limits.introduction = std::chrono::milliseconds(300);
  start();
  std::vector<int> open;
  for (int i = 0; i < 6; ++i) {  // more than associations may be
    open.push_back(connectTo(server_.ownPort));
    send(open.back(), "\x16\x03\x01", 3, MSG_NOSIGNAL);  // the start of a handshake
  }
  archive::Server us = server_;
  us.host = "127.0.0.1";
  us.port = server_.ownPort;
  std::swap(us.title, us.ownTitle);
  for (const archive::Sent& each : archive::send(us, archive::filesToSend({study_.folder})))
    EXPECT_TRUE(each.accepted) << each.text;
  EXPECT_EQ(held(), 3u);
  EXPECT_TRUE(eventually([&] { return provider_->refusals().connections >= 6; }));
  for (const int each : open) close(each);
}

TEST_F(ArchiveProvider, StopsListeningAtOnce) {
  start();
  const int open = connectTo(server_.ownPort);
  const auto before = std::chrono::steady_clock::now();
  provider_.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(1));
  EXPECT_EQ(connectTo(server_.ownPort), -1);
  close(open);
}

TEST_F(ArchiveProvider, ListensOnTheInterfaceThatItIsGiven) {
  server_.interface = "127.0.0.2";
  start();
  EXPECT_EQ(connectTo(server_.ownPort), -1) << "on 127.0.0.1";
  server_.interface = "192.0.2.1";  // an address of documentation (RFC 5737), of no machine
  EXPECT_NE(errorOf([&] { archive::StorageProvider(server_, {ct}, *intake_); }).find("cannot be listened on"),
            std::string::npos);
}

}  // namespace fenestra::tests::providerTest
