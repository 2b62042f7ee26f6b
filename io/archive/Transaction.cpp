#include "io/archive/Transaction.h"

#include <cstdio>
#include <utility>

#include <dcmtk/dcmdata/dcdeftag.h>
#include <dcmtk/dcmdata/dcuid.h>

#include "io/dicom/DicomValues.h"

namespace fenestra::io::archive {
namespace {

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

OFCondition answer(T_ASC_Association* association, T_ASC_PresentationContextID context,
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

}  // namespace

Transaction::Transaction(const Server& server, std::map<std::string, std::string> classes, std::string uid)
    : server_(server), classes_(std::move(classes)), uid_(std::move(uid)) {
  char made[100];
  if (uid_.empty()) uid_ = dcmGenerateUniqueIdentifier(made, SITE_INSTANCE_UID_ROOT);
}

std::unique_ptr<DcmDataset> Transaction::request() const {
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

bool Transaction::take(T_ASC_Association* association, T_ASC_PresentationContextID context,
                       const T_DIMSE_Message& message, Watch& watch) {
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

bool Transaction::wait(std::chrono::milliseconds time) {
  std::unique_lock lock(mutex_);
  return reported_.wait_for(lock, time, [this] { return isReported_; });
}

std::map<std::string, Commitment> Transaction::verdicts() const {
  const std::lock_guard lock(mutex_);
  return verdicts_;
}

/// PS3.7 10.1.1.1.8.
DIC_US Transaction::verdictOn(const T_DIMSE_N_EventReportRQ& request, DcmDataset* data) const {
  if (std::string(request.AffectedSOPClassUID) != commitmentClass) return STATUS_N_NoSuchSOPClass;
  if (std::string(request.AffectedSOPInstanceUID) != commitmentInstance) return STATUS_N_NoSuchObjectInstance;
  if (request.EventTypeID != 1 && request.EventTypeID != 2) return STATUS_N_NoSuchEventType;
  return data && textOf(*data, DCM_TransactionUID) == uid_ ? STATUS_Success : STATUS_N_InvalidArgumentValue;
}

template <class Judge>
void Transaction::read(DcmDataset& data, const DcmTagKey& sequence, const Judge& judge) {
  forEachItem(data, sequence, [&](DcmItem& item) {
    const auto asked = classes_.find(textOf(item, DCM_ReferencedSOPInstanceUID));
    if (asked != classes_.end() && asked->second == textOf(item, DCM_ReferencedSOPClassUID))
      verdicts_[asked->first] = judge(item);
  });
}

/// An object that stands among those kept and those failed counts as failed.
void Transaction::keep(DcmDataset& data) {
  const std::lock_guard lock(mutex_);
  if (isReported_) return;
  for (const auto& [object, objectClass] : classes_) verdicts_[object];
  read(data, DCM_ReferencedSOPSequence, [](DcmItem&) { return Commitment{Commitment::Verdict::Kept, ""}; });
  read(data, DCM_FailedSOPSequence, [](DcmItem& item) {
    const auto reason = static_cast<unsigned>(integerOf(item, DCM_FailureReason).value_or(0));
    return Commitment{Commitment::Verdict::NotKept, reasonOf(reason)};
  });
}

}  // namespace fenestra::io::archive
