#include "io/archive/Query.h"

#include <algorithm>
#include <iterator>

#include <dcmtk/dcmnet/diutil.h>

#include "io/archive/Association.h"
#include "io/archive/Classes.h"
#include "io/archive/Descent.h"
#include "io/archive/Keys.h"

namespace fenestra::io::archive {
namespace {

constexpr const char* patientModel = UID_FINDPatientRootQueryRetrieveInformationModel;
constexpr const char* studyModel = UID_FINDStudyRootQueryRetrieveInformationModel;

/// The levels of one query, asked over one association.
class Search {
 public:
  Search(const Server& server, Task& task)
      : server_(server), association_(server, {{patientModel, plainSyntaxes()}, {studyModel, plainSyntaxes()}}, task) {}

  Answers run(const Query& query) {
    answers_.records = descend(query, [this](Level level, const Attributes& keys) { return ask(level, keys); });
    association_.release();
    return std::move(answers_);
  }

 private:
  /// Asks in one character set after the other.
  std::vector<Attributes> ask(Level level, const Attributes& keys) {
    for (const std::string& set : characterSetsFor(keys, server_.characterSet)) {
      const std::unique_ptr<DcmDataset> identifier = identifierOf(level, keys, wantedAt(level));
      if (!encode(*identifier, set)) continue;
      std::vector<Attributes> found = ask(level, *identifier);
      if (!found.empty()) return found;
    }
    return {};
  }

  std::vector<Attributes> ask(Level level, DcmDataset& identifier) {
    const std::string model = level == Level::Patient ? patientModel : studyModel;
    const auto context = association_.require(model, "C-FIND");
    T_DIMSE_Message request{};
    request.CommandField = DIMSE_C_FIND_RQ;
    T_DIMSE_C_FindRQ& find = request.msg.CFindRQ;
    find.MessageID = association_.nextMessage();
    OFStandard::strlcpy(find.AffectedSOPClassUID, model.c_str(), sizeof find.AffectedSOPClassUID);
    find.Priority = DIMSE_PRIORITY_MEDIUM;
    find.DataSetType = DIMSE_DATASET_PRESENT;
    association_.check(
        DIMSE_sendMessageUsingMemoryData(association_.get(), context, &request, nullptr, &identifier, nullptr, nullptr),
        "asking for what it holds");
    return receiveAll(context, find.MessageID);
  }

  std::vector<Attributes> receiveAll(T_ASC_PresentationContextID context, DIC_US message) {
    const std::string doing = "reading what it holds";
    std::vector<Attributes> found;
    for (;;) {
      T_ASC_PresentationContextID of = context;
      const T_DIMSE_Message answer = association_.receive(of, doing);
      if (answer.CommandField != DIMSE_C_FIND_RSP)
        refuse(server_, "the server answers C-FIND with another message", "");
      const T_DIMSE_C_FindRSP& response = answer.msg.CFindRSP;
      std::unique_ptr<DcmDataset> data;
      if (response.DataSetType != DIMSE_DATASET_NULL) data = association_.receiveData(of, doing);
      if (DICOM_PENDING_STATUS(response.DimseStatus)) {
        answers_.ignoresKeys = answers_.ignoresKeys || response.DimseStatus == 0xff01;
        if (data && found.size() < server_.limits.answers) {
          found.push_back(attributesOf(*data));
        } else if (answers_.complete) {
          answers_.complete = false;
          DIMSE_sendCancelRequest(association_.get(), of, message);
        }
        continue;
      }
      if (response.DimseStatus != STATUS_Success && response.DimseStatus != STATUS_FIND_Cancel)
        refuseStatus(server_, "C-FIND", response.DimseStatus);
      return found;
    }
  }

  const Server& server_;
  Association association_;
  Answers answers_;
};

}  // namespace

std::chrono::milliseconds echo(const Server& server, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  Task task(server.limits, progress, "asking the server whether it answers");
  Association association(server, {{UID_VerificationSOPClass, plainSyntaxes()}}, task);
  association.require(UID_VerificationSOPClass, "C-ECHO");
  DIC_US status = 0;
  DcmDataset* detail = nullptr;
  const OFCondition result =
      DIMSE_echoUser(association.get(), association.nextMessage(), DIMSE_BLOCKING, 0, &status, &detail);
  delete detail;
  association.check(result, "waiting for its answer");
  if (status != STATUS_Success) refuseStatus(server, "C-ECHO", status);
  association.release();
  return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - start);
}

Answers find(const Server& server, const Query& query, const Progress& progress) {
  Task task(server.limits, progress, "searching the archive");
  return Search(server, task).run(query);
}

}  // namespace fenestra::io::archive
