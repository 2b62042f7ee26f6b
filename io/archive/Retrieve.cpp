#include "io/archive/Retrieve.h"

#include <algorithm>
#include <optional>
#include <set>

#include "io/archive/Association.h"
#include "io/archive/Classes.h"
#include "io/archive/Intake.h"
#include "io/archive/Keys.h"
#include "io/archive/Query.h"
#include "io/archive/StorageProvider.h"

namespace fenestra::io::archive {
namespace {

/// What the server says that it holds of a study, by series.
std::vector<Wanted> contentsOf(const Server& server, const Retrieval& retrieval, const Progress& progress) {
  Query query{Level::Image, {{"StudyInstanceUID", retrieval.study}}};
  if (!retrieval.series.empty()) query.keys["SeriesInstanceUID"] = retrieval.series;
  const Answers answers = find(server, query, progress);
  if (!answers.complete)
    refuse(server, "the study has more than " + std::to_string(server.limits.answers) + " objects",
           "retrieve its series one by one");
  std::vector<Wanted> all = wantedIn(answers.records, retrieval.study);
  if (all.empty()) refuse(server, "the server holds no such study or series", "search for it first, for its UID");
  return all;
}

class Transfer {
 public:
  Transfer(const Server& server, const Retrieval& retrieval, const Cache& cache, const Progress& progress)
      : server_(server),
        retrieval_(retrieval),
        cache_(cache),
        task_(server.limits, progress, retrieval.way == Way::Get ? "retrieving" : "waiting for what the server sends"),
        intake_(cache, server.limits, task_.activity(), retrieval.arrived) {}

  Retrieved run(const std::vector<Wanted>& all) {
    std::set<std::string> classes;
    for (const Wanted& each : all) {
      total_ += each.objects.size();
      for (const auto& [object, objectClass] : each.objects) classes.insert(objectClass);
    }
    makeRoom(all, cache_, server_.limits);
    for (const Wanted& each : all) retrieve(each, classes);
    if (association_) association_->release();
    count();
    return std::move(retrieved_);
  }

 private:
  void count() {
    if (provider_) retrieved_.refusals = provider_->refusals();
    retrieved_.refusals.objects = intake_.refused();
  }

  /// Opens what the transfer needs when the first object turns out to be missing.
  void open(const std::set<std::string>& classes) {
    if (association_) return;
    const std::vector<Context> objects = receivingContexts(classes);
    std::vector<Context> contexts{{model(), plainSyntaxes()}};
    if (retrieval_.way == Way::Get) {
      contexts.insert(contexts.end(), objects.begin(), objects.end());
    } else {
      std::set<std::string> known;
      for (const Context& each : objects) known.insert(each.abstractSyntax);
      provider_.emplace(server_, known, intake_);
    }
    association_.emplace(server_, contexts, task_);
    association_->require(model(), service());
  }

  const char* model() const {
    return retrieval_.way == Way::Get ? UID_GETStudyRootQueryRetrieveInformationModel
                                      : UID_MOVEStudyRootQueryRetrieveInformationModel;
  }
  const char* service() const { return retrieval_.way == Way::Get ? "C-GET" : "C-MOVE"; }

  SeriesLock lockOf(const Wanted& wanted) {
    return cache_.lock(wanted.study, wanted.series, [this] {
      task_.activity().note();  // a server that is not asked is not silent
      task_.checkCancelled();
    });
  }

  void retrieve(const Wanted& wanted, const std::set<std::string>& classes) {
    const SeriesLock lock = lockOf(wanted);
    const Wanted missing = missingOf(wanted, cache_);
    const std::size_t count = missing.objects.size();
    before_ += wanted.objects.size() - count;
    if (count > 0) {
      open(classes);
      intake_.expect(wanted, missing);
      if (retrieval_.arrived && count > 1) askForMiddle(missing);
      const bool isWhole = count == wanted.objects.size() && intake_.received() == 0;
      if (isWhole)
        ask(Level::Series, {{"StudyInstanceUID", wanted.study}, {"SeriesInstanceUID", wanted.series}});
      else
        askForSome(missingOf(wanted, cache_));
      before_ += intake_.received();
      if (intake_.received() < count) refuseIncomplete(count);
    }
    cache_.complete(wanted.study, wanted.series);
    retrieved_.series.push_back(
        {wanted.study, wanted.series, cache_.folderOf(wanted.study, wanted.series), wanted.objects.size(), count});
  }

  /// Shows where one is before all others come. A server that refuses to send single objects is asked for the series.
  void askForMiddle(const Wanted& missing) {
    toleratesRefusal_ = true;
    ask(Level::Image, {{"StudyInstanceUID", missing.study},
                       {"SeriesInstanceUID", missing.series},
                       {"SOPInstanceUID", middleFirst(missing).front()}});
    toleratesRefusal_ = false;
  }

  /// By their UIDs, so many at a time that the attribute's 64 KiB hold them (PS3.5 7.1.2).
  void askForSome(const Wanted& missing) {
    constexpr std::size_t most = 900;
    std::string uids;
    std::size_t count = 0, left = missing.objects.size();
    for (const auto& [object, objectClass] : missing.objects) {
      uids += (uids.empty() ? "" : "\\") + object;
      --left;
      if (++count < most && left > 0) continue;
      ask(Level::Image, {{"StudyInstanceUID", missing.study},
                         {"SeriesInstanceUID", missing.series},
                         {"SOPInstanceUID", std::exchange(uids, {})}});
      count = 0;
    }
  }

  /// Throws where the reason is on our side.
  void refuseUnwritten() {
    if (const std::string failure = intake_.failure(); !failure.empty())
      refuse(server_, failure, "make room, and try again; what came is kept");
  }

  [[noreturn]] void refuseIncomplete(std::size_t count) {
    refuseUnwritten();
    refuse(server_,
           std::to_string(count - intake_.received()) + " of " + std::to_string(count) +
               " objects of a series did not come",
           "try again: only these are asked for then");
  }

  void ask(Level level, const Attributes& keys) {
    const std::unique_ptr<DcmDataset> identifier = identifierOf(level, keys, {});
    const auto context = association_->require(model(), service());
    T_DIMSE_Message request{};
    if (retrieval_.way == Way::Get) {
      request.CommandField = DIMSE_C_GET_RQ;
      fill(request.msg.CGetRQ);
    } else {
      request.CommandField = DIMSE_C_MOVE_RQ;
      fill(request.msg.CMoveRQ);
      OFStandard::strlcpy(request.msg.CMoveRQ.MoveDestination, server_.ownTitle.c_str(),
                          sizeof request.msg.CMoveRQ.MoveDestination);
    }
    association_->check(DIMSE_sendMessageUsingMemoryData(association_->get(), context, &request, nullptr,
                                                         identifier.get(), nullptr, nullptr),
                        "asking for a series");
    try {
      while (!isLast(receiveOne(context))) report();
    } catch (const Error&) {
      if (association_->isGarbled()) intake_.dropLast();
      throw;
    }
  }

  template <class Request>
  void fill(Request& request) {
    request.MessageID = association_->nextMessage();
    OFStandard::strlcpy(request.AffectedSOPClassUID, model(), sizeof request.AffectedSOPClassUID);
    request.Priority = DIMSE_PRIORITY_MEDIUM;
    request.DataSetType = DIMSE_DATASET_PRESENT;
  }

  /// The status of the next response; pending after an object.
  unsigned receiveOne(T_ASC_PresentationContextID context) {
    const std::string doing = "retrieving a series";
    T_DIMSE_Message message = association_->receive(context, doing);
    if (message.CommandField == DIMSE_C_STORE_RQ && retrieval_.way == Way::Get) {
      const OFCondition result =
          intake_.receive(association_->get(), context, message.msg.CStoreRQ, association_->watch());
      if (result.bad()) refuseUnwritten();
      association_->check(result, doing);
      return STATUS_GET_Pending_SubOperationsAreContinuing;
    }
    if (message.CommandField == DIMSE_C_GET_RSP) return statusOf(message.msg.CGetRSP, context);
    if (message.CommandField == DIMSE_C_MOVE_RSP) return statusOf(message.msg.CMoveRSP, context);
    refuse(server_, std::string("the server answers ") + service() + " with another message", "");
  }

  template <class Response>
  unsigned statusOf(const Response& response, T_ASC_PresentationContextID context) {
    // A list of what failed; what is missing is known without.
    if (response.DataSetType != DIMSE_DATASET_NULL) association_->receiveData(context, "retrieving a series");
    return response.DimseStatus;
  }

  /// Whether this answer ends the retrieval. After a warning, what came tells what is missing.
  bool isLast(unsigned status) {
    if (DICOM_PENDING_STATUS(status)) return false;
    const bool warns = status >> 12 == 0xb;
    const bool allFailed = intake_.received() == 0 && !intake_.failure().empty();
    if (status != STATUS_Success && !warns && !allFailed && !toleratesRefusal_)
      refuseStatus(server_, service(), status);
    return true;
  }

  void report() {
    const double fraction = static_cast<double>(before_ + intake_.received()) / static_cast<double>(total_);
    task_.setFraction(std::min(fraction, 1.0));
    task_.checkCancelled();
  }

  const Server& server_;
  const Retrieval& retrieval_;
  const Cache& cache_;
  Task task_;
  Intake intake_;
  std::optional<StorageProvider> provider_;  ///< outlives the association, over which the server tells when it is done
  std::optional<Association> association_;
  bool toleratesRefusal_ = false;  ///< of the objects asked for now
  std::size_t total_ = 0, before_ = 0;
  Retrieved retrieved_;
};

}  // namespace

Retrieved retrieve(const Server& server, const Retrieval& retrieval, const Cache& cache, const Progress& progress) {
  if (retrieval.way == Way::Move && server.ownPort == 0)
    refuse(server, "C-MOVE needs a port of ours that the server sends to",
           "set one that is entered at the server, or retrieve by C-GET");
  const std::vector<Wanted> all = contentsOf(server, retrieval, progress);
  return Transfer(server, retrieval, cache, progress).run(all);
}

}  // namespace fenestra::io::archive
