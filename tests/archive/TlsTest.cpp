// DICOM over TLS: both sides show certificates, and each refuses one that it does not trust.

#include <gtest/gtest.h>

#include "io/archive/Commitment.h"
#include "io/archive/Query.h"
#include "io/archive/Retrieve.h"
#include "io/archive/Send.h"
#include "tests/archive/MadeStudies.h"
#include "tests/archive/Servers.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::archiveTlsTest {
namespace fs = std::filesystem;
namespace archive = io::archive;

TEST(ArchiveTls, TransfersBothWaysAndRefusesStrangers) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  FENESTRA_PROGRAM_OR_SKIP("openssl", "openssl");
  const fs::path folder = scratchFolder();
  const Certificate own = makeCertificate(folder, "server"), client = makeCertificate(folder, "client"),
                    stranger = makeCertificate(folder, "stranger");
  const std::unique_ptr<RunningServer> running = startOrthanc(folder / "server", own, client);
  ASSERT_TRUE(running) << readFile(folder / "server/log");
  const archive::Server& server = running->server;
  EXPECT_TRUE(server.name().starts_with("dicoms://"));
  const MadeStudy study = makeStudy(folder, "1.2.3.80", 2);
  const std::vector<archive::Sent> sent = archive::send(server, archive::filesToSend({study.folder}));
  for (const archive::Sent& each : sent) EXPECT_TRUE(each.accepted) << each.text;
  const auto verdicts = archive::commit(server, sent);
  EXPECT_EQ(verdicts.size(), 2u);
  for (const auto& [object, said] : verdicts) EXPECT_EQ(said.verdict, archive::Commitment::Verdict::Kept) << said.text;
  for (const archive::Way way : {archive::Way::Get, archive::Way::Move}) {
    SCOPED_TRACE(way == archive::Way::Get ? "C-GET" : "C-MOVE");
    const archive::Cache cache(folder / (way == archive::Way::Get ? "got" : "moved"));
    const archive::Retrieved got = archive::retrieve(server, {study.uid, "", way}, cache);
    EXPECT_EQ(objectsIn(got.series.at(0).folder), objectsIn(study.folder));
  }

  archive::Server other = server;
  other.tls->authorities = stranger.certificate;
  const std::string untrusted = errorOf([&] { archive::echo(other); });
  EXPECT_NE(untrusted.find("no secure connection: "), std::string::npos) << untrusted;
  EXPECT_NE(untrusted.find("certificate"), std::string::npos) << untrusted;
  other = server;
  other.tls->certificate = stranger.certificate;
  other.tls->key = stranger.key;
  const std::string unknown = errorOf([&] { archive::echo(other); });
  EXPECT_NE(unknown.find("certificate"), std::string::npos) << unknown;
  other.tls->key = own.key;
  EXPECT_NE(errorOf([&] { archive::echo(other); }).find("is not the key of the certificate"), std::string::npos);
  other = server;
  other.tls.reset();
  other.limits.silence = std::chrono::milliseconds(500);
  const std::string plain = errorOf([&] { archive::echo(other); });
  EXPECT_NE(plain.find("dicoms://"), std::string::npos) << plain;
}

}  // namespace fenestra::tests::archiveTlsTest
