#include "io/archive/Commitment.h"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include <dcmtk/dcmdata/dcdeftag.h>
#include <dcmtk/dcmdata/dcuid.h>

#include "io/archive/Association.h"
#include "io/archive/Classes.h"
#include "io/archive/Provider.h"
#include "io/dicom/DicomValues.h"

namespace fenestra::io::archive {
namespace {

constexpr const char* commitmentClass = UID_StorageCommitmentPushModelSOPClass;
constexpr const char* commitmentInstance = UID_StorageCommitmentPushModelSOPInstance;

/// PS3.3 C.14.1.1.
std::string reasonOf(unsigned code) {
  switch (code) {
    case 0x0110:
      return "processing failure";
    case 0x0112:
      return "the server has no such object";
    case 0x0119:
      return "the server has it with another class";
    case 0x0122:
      return "class of objects not supported";
    case 0x0131:
      return "the transaction's UID is in use";
    case 0x0213:
      return "out of resources";
    default:
      break;
  }
  char text[32];
  std::snprintf(text, sizeof text, "failure reason %04X", code);
  return text;
}

/// One request and its report, which may come on any of several connections.
class Transaction {
 public:
  Transaction(const Server& server, std::map<std::string, std::string> classes)
      : server_(server), classes_(std::move(classes)) {
    char uid[100];
    uid_ = dcmGenerateUniqueIdentifier(uid, SITE_INSTANCE_UID_ROOT);
  }

  /// The Action Information of N-ACTION (PS3.4 J.3.2.1.1).
  std::unique_ptr<DcmDataset> request() const {
    auto data = std::make_unique<DcmDataset>();
    data->putAndInsertString(DCM_TransactionUID, uid_.c_str());
    for (const auto& [object, objectClass] : classes_) {
      DcmItem* item = nullptr;
      data->findOrCreateSequenceItem(DCM_ReferencedSOPSequence, item, -2);  // a new one at the end
      item->putAndInsertString(DCM_ReferencedSOPClassUID, objectClass.c_str());
      item->putAndInsertString(DCM_ReferencedSOPInstanceUID, object.c_str());
    }
    return data;
  }

  /// Reads what follows a request of the server, takes it where it is this transaction's report, and answers. False:
  /// the association is of no more use.
  bool take(T_ASC_Association* association, T_ASC_PresentationContextID context, const T_DIMSE_Message& message,
            Watch& watch) {
    if (message.CommandField != DIMSE_N_EVENT_REPORT_RQ) return false;
    const T_DIMSE_N_EventReportRQ& request = message.msg.NEventReportRQ;
    std::unique_ptr<DcmDataset> data;
    if (request.DataSetType != DIMSE_DATASET_NULL) {
      DcmDataset* read = nullptr;
      watch.beginMessage(server_.limits.answerBytes);
      const OFCondition result =
          DIMSE_receiveDataSetInMemory(association, DIMSE_BLOCKING, 0, &context, &read, nullptr, nullptr);
      data.reset(read);
      if (result.bad()) return false;
    }
    const DIC_US status = verdictOn(request, data.get());
    if (status == STATUS_Success) keep(*data);
    const bool isAnswered = answer(association, context, request, status).good();
    if (status == STATUS_Success) {  // after the answer, so that it is not cut off
      const std::lock_guard lock(mutex_);
      isReported_ = true;
      reported_.notify_all();
    }
    return isAnswered;
  }

  /// Whether the report is there, for which this waits at most `time`.
  bool wait(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return reported_.wait_for(lock, time, [this] { return isReported_; });
  }

  std::map<std::string, Commitment> verdicts() const {
    const std::lock_guard lock(mutex_);
    return verdicts_;
  }

 private:
  /// PS3.7 10.1.1.1.8.
  DIC_US verdictOn(const T_DIMSE_N_EventReportRQ& request, DcmDataset* data) const {
    if (std::string(request.AffectedSOPClassUID) != commitmentClass) return STATUS_N_NoSuchSOPClass;
    if (std::string(request.AffectedSOPInstanceUID) != commitmentInstance) return STATUS_N_NoSuchObjectInstance;
    if (request.EventTypeID != 1 && request.EventTypeID != 2) return STATUS_N_NoSuchEventType;
    return data && textOf(*data, DCM_TransactionUID) == uid_ ? STATUS_Success : STATUS_N_InvalidArgumentValue;
  }

  /// An object that stands among those kept and those failed counts as failed.
  void keep(DcmDataset& data) {
    const std::lock_guard lock(mutex_);
    if (isReported_) return;
    for (const auto& [object, objectClass] : classes_) verdicts_[object];
    read(data, DCM_ReferencedSOPSequence, [](DcmItem&) { return Commitment{Commitment::Verdict::Kept, ""}; });
    read(data, DCM_FailedSOPSequence, [](DcmItem& item) {
      const auto reason = static_cast<unsigned>(integerOf(item, DCM_FailureReason).value_or(0));
      return Commitment{Commitment::Verdict::NotKept, reasonOf(reason)};
    });
  }

  template <class Judge>
  void read(DcmDataset& data, const DcmTagKey& sequence, const Judge& judge) {
    forEachItem(data, sequence, [&](DcmItem& item) {
      const auto asked = classes_.find(textOf(item, DCM_ReferencedSOPInstanceUID));
      if (asked != classes_.end() && asked->second == textOf(item, DCM_ReferencedSOPClassUID))
        verdicts_[asked->first] = judge(item);
    });
  }

  static OFCondition answer(T_ASC_Association* association, T_ASC_PresentationContextID context,
                            const T_DIMSE_N_EventReportRQ& request, DIC_US status) {
    T_DIMSE_Message message{};
    message.CommandField = DIMSE_N_EVENT_REPORT_RSP;
    T_DIMSE_N_EventReportRSP& response = message.msg.NEventReportRSP;
    response.MessageIDBeingRespondedTo = request.MessageID;
    response.DimseStatus = status;
    response.DataSetType = DIMSE_DATASET_NULL;
    response.EventTypeID = request.EventTypeID;
    OFStandard::strlcpy(response.AffectedSOPClassUID, request.AffectedSOPClassUID, sizeof response.AffectedSOPClassUID);
    OFStandard::strlcpy(response.AffectedSOPInstanceUID, request.AffectedSOPInstanceUID,
                        sizeof response.AffectedSOPInstanceUID);
    response.opts =
        O_NEVENTREPORT_AFFECTEDSOPCLASSUID | O_NEVENTREPORT_AFFECTEDSOPINSTANCEUID | O_NEVENTREPORT_EVENTTYPEID;
    return DIMSE_sendMessageUsingMemoryData(association, context, &message, nullptr, nullptr, nullptr, nullptr);
  }

  const Server& server_;
  const std::map<std::string, std::string> classes_;  ///< of the objects, by their UIDs
  std::string uid_;
  mutable std::mutex mutex_;
  std::condition_variable reported_;
  bool isReported_ = false;
  std::map<std::string, Commitment> verdicts_;
};

void ask(Association& association, const Transaction& transaction) {
  const std::string doing = "asking whether it keeps the objects";
  const auto context = association.require(commitmentClass, "storage commitment");
  T_DIMSE_Message message{};
  message.CommandField = DIMSE_N_ACTION_RQ;
  T_DIMSE_N_ActionRQ& request = message.msg.NActionRQ;
  request.MessageID = association.nextMessage();
  OFStandard::strlcpy(request.RequestedSOPClassUID, commitmentClass, sizeof request.RequestedSOPClassUID);
  OFStandard::strlcpy(request.RequestedSOPInstanceUID, commitmentInstance, sizeof request.RequestedSOPInstanceUID);
  request.ActionTypeID = 1;
  request.DataSetType = DIMSE_DATASET_PRESENT;
  const std::unique_ptr<DcmDataset> data = transaction.request();
  association.check(
      DIMSE_sendMessageUsingMemoryData(association.get(), context, &message, nullptr, data.get(), nullptr, nullptr),
      doing);
  T_ASC_PresentationContextID answered = 0;
  const T_DIMSE_Message response = association.receive(answered, doing);
  if (response.CommandField != DIMSE_N_ACTION_RSP)
    refuse(association.server(), "the server answers N-ACTION with another message", "");
  const T_DIMSE_N_ActionRSP& said = response.msg.NActionRSP;
  if (said.DataSetType != DIMSE_DATASET_NULL) association.receiveData(answered, doing);
  if (said.DimseStatus == STATUS_Success) return;
  char code[8];
  std::snprintf(code, sizeof code, "%04X", static_cast<unsigned>(said.DimseStatus));
  refuse(association.server(),
         std::string("the server refuses to say whether it keeps the objects, with ") + code + ", " +
             meaningOf(said.DimseStatus),
         "have storage commitment allowed for our AE title \"" + association.server().ownTitle + "\" at the server");
}

void awaitReport(Association& association, Transaction& transaction, Task& task) {
  const Server& server = association.server();
  const auto end = std::chrono::steady_clock::now() + server.limits.commitment;
  constexpr std::chrono::milliseconds step{20};
  while (!transaction.wait(association.hasMessage() ? std::chrono::milliseconds(0) : step)) {
    task.checkCancelled();
    if (association.hasMessage()) {
      T_ASC_PresentationContextID context = 0;
      const auto message = association.receiveUnlessEnded(context, "waiting for its confirmation");
      if (message && !transaction.take(association.get(), context, *message, association.watch()))
        refuse(server, "the server sends something else than its confirmation", "");
    }
    const std::string wayOut =
        server.ownPort == 0 ? "many servers open a connection for it: set a port of ours, and have it entered at "
                              "the server with our AE title \"" +
                                  server.ownTitle + "\""
                            : "check that the server knows our AE title \"" + server.ownTitle +
                                  "\" with this machine's address and port " + std::to_string(server.ownPort);
    if (!association.isOpen() && server.ownPort == 0 && !transaction.wait({}))
      refuse(server, "the server closed the connection before it confirmed that it keeps the objects", wayOut);
    if (std::chrono::steady_clock::now() > end)
      refuse(server,
             "the server has not confirmed within " + std::to_string(server.limits.commitment.count() / 1000) +
                 " s that it keeps the objects",
             wayOut);
  }
}

}  // namespace

std::map<std::string, Commitment> commit(const Server& server, const std::vector<Sent>& sent,
                                         const Progress& progress) {
  std::map<std::string, std::string> classes;
  for (const Sent& each : sent)
    if (each.accepted) classes[each.object] = each.objectClass;
  if (classes.empty()) return {};
  Task task(server.limits, progress, "waiting for the archive to confirm that it keeps them");
  Transaction transaction(server, std::move(classes));
  std::optional<Provider> provider;
  // Before the request, because the answer may be faster than we are.
  if (server.ownPort != 0)
    provider.emplace(
        server,
        Service{{commitmentClass}, true, [&](auto* association, auto context, const auto& message, Watch& watch) {
                  return transaction.take(association, context, message, watch);
                }});
  // Every server offers verification, so that one without commitment accepts the association, and can be told apart.
  Association association(server, {{commitmentClass, plainSyntaxes()}, {UID_VerificationSOPClass, plainSyntaxes()}},
                          task);
  ask(association, transaction);
  awaitReport(association, transaction, task);
  association.release();
  // A server that is cut off before it has released its association takes the report for undelivered.
  constexpr int steps = 50;
  constexpr std::chrono::milliseconds step{20};
  for (int i = 0; provider && !provider->isIdle() && i < steps; ++i) std::this_thread::sleep_for(step);
  return transaction.verdicts();
}

}  // namespace fenestra::io::archive
