// Whether a server keeps what it took: against Orthanc, and against a server of our own that answers as it should not.

#include <chrono>
#include <functional>
#include <optional>
#include <thread>

#include <gtest/gtest.h>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmnet/assoc.h>
#include <dcmtk/dcmnet/dimse.h>

#include "io/archive/Commitment.h"
#include "tests/archive/MadeStudies.h"
#include "tests/archive/Servers.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::commitmentTest {
namespace archive = io::archive;
namespace {

using Verdict = archive::Commitment::Verdict;
const std::string ct = "1.2.840.10008.5.1.4.1.1.2";
const std::string commitment = UID_StorageCommitmentPushModelSOPClass;

archive::Sent sentObject(const std::string& object) {
  archive::Sent sent;
  sent.object = object;
  sent.objectClass = ct;
  sent.accepted = true;
  return sent;
}

/// One association, requested or accepted by a test.
struct Line {
  T_ASC_Network* network = nullptr;
  T_ASC_Association* association = nullptr;
  bool isOpen = false;
  ~Line() {
    if (association) ASC_dropAssociation(association);
    if (association) ASC_destroyAssociation(&association);
    if (network) ASC_dropNetwork(&network);
  }
};

constexpr int seconds = 20;  // until a test that waits for a message has failed

/// The association that a server opens to us to report.
std::unique_ptr<Line> lineTo(int port, const char* calling, const char* called) {
  auto line = std::make_unique<Line>();
  T_ASC_Parameters* parameters = nullptr;
  ASC_initializeNetwork(NET_REQUESTOR, 0, seconds, &line->network);
  ASC_createAssociationParameters(&parameters, ASC_DEFAULTMAXPDU);
  ASC_setAPTitles(parameters, calling, called, nullptr);
  ASC_setPresentationAddresses(parameters, "localhost", ("127.0.0.1:" + std::to_string(port)).c_str());
  const char* syntaxes[]{UID_LittleEndianImplicitTransferSyntax};
  ASC_addPresentationContext(parameters, 1, commitment.c_str(), syntaxes, 1, ASC_SC_ROLE_SCP);
  line->isOpen = ASC_requestAssociation(line->network, parameters, &line->association).good();
  return line;
}

/// Reports `kept` and `failed` for a transaction, and returns the status of the answer.
unsigned report(Line& line, const std::string& transaction, const std::vector<std::string>& kept,
                const std::vector<std::string>& failed) {
  DcmDataset data;
  data.putAndInsertString(DCM_TransactionUID, transaction.c_str());
  const auto add = [&](const DcmTagKey& sequence, const std::string& object) {
    DcmItem* item = nullptr;
    data.findOrCreateSequenceItem(sequence, item, -2);
    item->putAndInsertString(DCM_ReferencedSOPClassUID, ct.c_str());
    item->putAndInsertString(DCM_ReferencedSOPInstanceUID, object.c_str());
    return item;
  };
  for (const std::string& each : kept) add(DCM_ReferencedSOPSequence, each);
  for (const std::string& each : failed)
    add(DCM_FailedSOPSequence, each)->putAndInsertUint16(DCM_FailureReason, 0x0213);
  T_DIMSE_Message message{};
  message.CommandField = DIMSE_N_EVENT_REPORT_RQ;
  T_DIMSE_N_EventReportRQ& request = message.msg.NEventReportRQ;
  request.MessageID = line.association->nextMsgID++;
  OFStandard::strlcpy(request.AffectedSOPClassUID, commitment.c_str(), sizeof request.AffectedSOPClassUID);
  OFStandard::strlcpy(request.AffectedSOPInstanceUID, UID_StorageCommitmentPushModelSOPInstance,
                      sizeof request.AffectedSOPInstanceUID);
  request.EventTypeID = failed.empty() ? 1 : 2;
  request.DataSetType = DIMSE_DATASET_PRESENT;
  T_ASC_PresentationContextID context = ASC_findAcceptedPresentationContextID(line.association, commitment.c_str());
  EXPECT_TRUE(
      DIMSE_sendMessageUsingMemoryData(line.association, context, &message, nullptr, &data, nullptr, nullptr).good());
  T_DIMSE_Message response{};
  const OFCondition got =
      DIMSE_receiveCommand(line.association, DIMSE_NONBLOCKING, seconds, &context, &response, nullptr);
  EXPECT_TRUE(got.good()) << got.text();
  return response.msg.NEventReportRSP.DimseStatus;
}

/// A server that takes one request, and then does what a test says.
class Committer {
 public:
  using Act = std::function<void(Line& line, const std::string& transaction)>;
  explicit Committer(Act act, unsigned status = 0) : act_(std::move(act)), status_(status), thread_([this] { run(); }) {
    EXPECT_TRUE(eventually([this] { return isListening_.load(); }));
  }
  ~Committer() { thread_.join(); }

  archive::Server server() const {
    archive::Server server;
    server.host = "127.0.0.1";
    server.port = port_;
    server.title = "KEEPER";
    server.ownPort = ownPort_;
    return server;
  }
  int ownPort() const { return ownPort_; }

 private:
  void run() {
    Line line;
    ASSERT_TRUE(ASC_initializeNetwork(NET_ACCEPTOR, port_, seconds, &line.network).good());
    isListening_ = true;
    ASSERT_TRUE(accept(line) || accept(line)) << "the first connection asks only whether somebody listens";
    T_ASC_PresentationContextID context = 0;
    T_DIMSE_Message message{}, answer{};
    ASSERT_TRUE(DIMSE_receiveCommand(line.association, DIMSE_NONBLOCKING, seconds, &context, &message, nullptr).good());
    ASSERT_EQ(message.CommandField, DIMSE_N_ACTION_RQ);
    DcmDataset* data = nullptr;
    ASSERT_TRUE(
        DIMSE_receiveDataSetInMemory(line.association, DIMSE_NONBLOCKING, seconds, &context, &data, nullptr, nullptr)
            .good());
    OFString transaction;
    data->findAndGetOFString(DCM_TransactionUID, transaction);
    delete data;
    answer.CommandField = DIMSE_N_ACTION_RSP;
    answer.msg.NActionRSP.MessageIDBeingRespondedTo = message.msg.NActionRQ.MessageID;
    answer.msg.NActionRSP.DimseStatus = static_cast<DIC_US>(status_);
    answer.msg.NActionRSP.DataSetType = DIMSE_DATASET_NULL;
    DIMSE_sendMessageUsingMemoryData(line.association, context, &answer, nullptr, nullptr, nullptr, nullptr);
    act_(line, transaction.c_str());
    // Until the other side has gone.
    if (DIMSE_receiveCommand(line.association, DIMSE_NONBLOCKING, seconds, &context, &message, nullptr) ==
        DUL_PEERREQUESTEDRELEASE)
      ASC_acknowledgeRelease(line.association);
  }

  static bool accept(Line& line) {
    if (ASC_receiveAssociation(line.network, &line.association, ASC_DEFAULTMAXPDU, nullptr, nullptr, OFFalse,
                               DUL_NOBLOCK, seconds)
            .bad())
      return false;
    const char* syntaxes[]{UID_LittleEndianExplicitTransferSyntax};
    const char* classes[]{commitment.c_str()};
    ASC_acceptContextsWithPreferredTransferSyntaxes(line.association->params, classes, 1, syntaxes, 1);
    if (ASC_acknowledgeAssociation(line.association).good()) return true;
    ASC_dropAssociation(line.association);
    ASC_destroyAssociation(&line.association);
    return false;
  }

  const int port_ = freePort(), ownPort_ = freePort();
  Act act_;
  const unsigned status_;
  std::atomic<bool> isListening_ = false;
  std::thread thread_;
};

const std::vector<archive::Sent> two{sentObject("1.2.3.1"), sentObject("1.2.3.2")};

}  // namespace

TEST(ArchiveCommitment, OrthancSaysOfEachObjectWhetherItIsKept) {
  FENESTRA_PROGRAM_OR_SKIP("Orthanc", "orthanc");
  const std::filesystem::path folder = scratchFolder();
  const std::unique_ptr<RunningServer> running = startOrthanc(folder / "server");
  ASSERT_TRUE(running) << readFile(folder / "server/log");
  archive::Server& server = running->server;
  const MadeStudy study = makeStudy(folder / "study", "1.2.3.98", 3);
  std::vector<archive::Sent> sent = archive::send(server, archive::filesToSend({study.folder}));
  ASSERT_EQ(sent.size(), 3u);
  sent.push_back(sentObject("1.2.3.4.5"));  // that it never got
  sent.push_back(sentObject("1.2.3.4.6"));
  sent.back().accepted = false;
  const auto verdicts = archive::commit(server, sent);
  ASSERT_EQ(verdicts.size(), 4u);
  for (const auto& [object, verdict] : verdicts) {
    const bool isThere = object != "1.2.3.4.5";
    EXPECT_EQ(verdict.verdict, isThere ? Verdict::Kept : Verdict::NotKept) << object;
    EXPECT_EQ(verdict.text, isThere ? "" : "the server has no such object");
  }
  EXPECT_EQ(connectTo(server.ownPort), -1) << "it listens no more";
  server.ownTitle = "NOBODY";
  const auto before = std::chrono::steady_clock::now();
  const std::string error = errorOf([&] { archive::commit(server, sent); });
  EXPECT_FALSE(error.empty()) << "Orthanc does not know where to report to";
  EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(20)) << error;
}

TEST(ArchiveCommitment, AServerWithoutTheServiceIsSaidToBeSo) {
  FENESTRA_PROGRAM_OR_SKIP("dcmqrscp", "dcmtk");
  const std::filesystem::path folder = scratchFolder();
  const std::unique_ptr<RunningServer> running = startDcmqrscp(folder / "server");
  ASSERT_TRUE(running) << readFile(folder / "server/log");
  EXPECT_NE(errorOf([&] { archive::commit(running->server, two); }).find("does not offer storage commitment"),
            std::string::npos);
  EXPECT_TRUE(archive::commit(running->server, {}).empty()) << "nothing to ask about";
}

TEST(ArchiveCommitment, TheReportMayComeOverOurConnection) {
  unsigned wrong = 0, right = 0;
  Committer committer([&](Line& line, const std::string& transaction) {
    wrong = report(line, "1.2.3.4", {"1.2.3.1", "1.2.3.2"}, {});
    right = report(line, transaction, {"1.2.3.1", "1.2.3.99"}, {"1.2.3.2"});
  });
  archive::Server server = committer.server();
  server.ownPort = 0;  // nothing listens
  const auto verdicts = archive::commit(server, two);
  EXPECT_EQ(wrong, 0x0115u) << "another transaction";
  EXPECT_EQ(right, 0u);
  ASSERT_EQ(verdicts.size(), 2u) << "an object that was not asked about has no verdict";
  EXPECT_EQ(verdicts.at("1.2.3.1").verdict, Verdict::Kept);
  EXPECT_EQ(verdicts.at("1.2.3.2").verdict, Verdict::NotKept);
  EXPECT_EQ(verdicts.at("1.2.3.2").text, "out of resources");
}

TEST(ArchiveCommitment, OnlyTheServerAndThisTransactionAreLetIn) {
  std::optional<Committer> committer;
  const auto act = [&](Line& own, const std::string& transaction) {
    const int port = committer->ownPort();
    EXPECT_FALSE(lineTo(port, "ATTACKER", "FENESTRA")->isOpen);
    EXPECT_FALSE(lineTo(port, "KEEPER", "OTHER")->isOpen);
    ASC_abortAssociation(own.association);  // as of a server that reports on a connection of its own
    const auto line = lineTo(port, "KEEPER", "FENESTRA");
    ASSERT_TRUE(line->isOpen);
    EXPECT_EQ(report(*line, "1.2.3.4", {"1.2.3.2"}, {}), 0x0115u);
    EXPECT_EQ(report(*line, transaction, {"1.2.3.1"}, {}), 0u);
    EXPECT_TRUE(ASC_releaseAssociation(line->association).good()) << "it is not cut off";
  };
  committer.emplace(act);
  const auto verdicts = archive::commit(committer->server(), two);
  ASSERT_EQ(verdicts.size(), 2u);
  EXPECT_EQ(verdicts.at("1.2.3.1").verdict, Verdict::Kept);
  EXPECT_EQ(verdicts.at("1.2.3.2").verdict, Verdict::Unsaid) << "neither kept nor failed";
}

TEST(ArchiveCommitment, AServerThatNeverReportsIsWaitedForNoLonger) {
  Committer committer([](Line&, const std::string&) {});
  archive::Server server = committer.server();
  server.limits.commitment = std::chrono::milliseconds(300);
  const auto before = std::chrono::steady_clock::now();
  const std::string error = errorOf([&] { archive::commit(server, two); });
  EXPECT_NE(error.find("has not confirmed within"), std::string::npos) << error;
  EXPECT_NE(error.find(std::to_string(server.ownPort)), std::string::npos) << "the way out: " << error;
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(5));
}

TEST(ArchiveCommitment, ARefusalAndACancelEndIt) {
  {
    Committer committer([](Line&, const std::string&) {}, 0x0213);
    EXPECT_NE(errorOf([&] { archive::commit(committer.server(), two); }).find("0213"), std::string::npos);
  }
  Committer committer([](Line&, const std::string&) {});
  const auto before = std::chrono::steady_clock::now();
  const auto goesOn = [&](double, std::string_view) {
    return std::chrono::steady_clock::now() - before < std::chrono::milliseconds(400);
  };
  EXPECT_THROW(archive::commit(committer.server(), two, goesOn), io::Cancelled);
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(3));
}

}  // namespace fenestra::tests::commitmentTest
