#include "io/archive/Commitment.h"

#include <optional>
#include <thread>

#include "io/archive/Association.h"
#include "io/archive/Classes.h"
#include "io/archive/Provider.h"
#include "io/archive/Transaction.h"

namespace fenestra::io::archive {
namespace {

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
  if (server.ownPort != 0) provider.emplace(server, commitmentService(transaction));
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
