#pragma once
// A request for storage commitment and its report, which may come on any of several connections (PS3.4 annex J).
// Private to io/archive; include in .cpp files alone.

#include <chrono>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmnet/assoc.h>
#include <dcmtk/dcmnet/dimse.h>

#include "io/archive/Reception.h"
#include "io/archive/Server.h"
#include "io/archive/Verdict.h"
#include "io/archive/Watch.h"

namespace fenestra::io::archive {

inline constexpr const char* commitmentClass = UID_StorageCommitmentPushModelSOPClass;
inline constexpr const char* commitmentInstance = UID_StorageCommitmentPushModelSOPInstance;

class Transaction {
 public:
  /// `classes`: those of the objects, by the objects' UIDs. Without `uid` it gets a new one. `server` outlives this.
  Transaction(const Server& server, std::map<std::string, std::string> classes, std::string uid = {});

  /// The Action Information of N-ACTION (PS3.4 J.3.2.1.1).
  std::unique_ptr<DcmDataset> request() const;

  /// Reads what follows a request of the server, takes it where it is this transaction's report, and answers. False:
  /// the association is of no more use.
  bool take(T_ASC_Association* association, T_ASC_PresentationContextID context, const T_DIMSE_Message& message,
            Watch& watch);

  /// Whether the report is there, for which this waits at most `time`.
  bool wait(std::chrono::milliseconds time);

  /// One for each object once the report is there; none before.
  std::map<std::string, Commitment> verdicts() const;

 private:
  DIC_US verdictOn(const T_DIMSE_N_EventReportRQ& request, DcmDataset* data) const;
  void keep(DcmDataset& data);
  template <class Judge>
  void read(DcmDataset& data, const DcmTagKey& sequence, const Judge& judge);

  const Server& server_;
  const std::map<std::string, std::string> classes_;
  std::string uid_;
  mutable std::mutex mutex_;
  std::condition_variable reported_;
  bool isReported_ = false;
  std::map<std::string, Commitment> verdicts_;
};

/// Takes the report over a connection that the server opens. `transaction` outlives what uses it.
inline Service commitmentService(Transaction& transaction) {
  return {{commitmentClass},
          true,
          [&transaction](T_ASC_Association* association, T_ASC_PresentationContextID context,
                         const T_DIMSE_Message& message,
                         Watch& watch) { return transaction.take(association, context, message, watch); }};
}

}  // namespace fenestra::io::archive
