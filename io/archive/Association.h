#pragma once
// An association that we request (PS3.8), with failures as one sentence each. Private to io/archive; include in .cpp
// files alone.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmnet/assoc.h>
#include <dcmtk/dcmnet/dimse.h>

#include "io/archive/Server.h"
#include "io/archive/Task.h"
#include "io/archive/Transport.h"

namespace fenestra::io::archive {

/// What is proposed for one kind of object or service.
struct Context {
  std::string abstractSyntax;
  std::vector<std::string> transferSyntaxes;
  bool receives = false;  ///< the server sends us objects by it (C-GET, PS3.7 D.3.3.4)
};

class Association {
 public:
  /// Connects and negotiates at most 128 contexts. Throws Error, Cancelled.
  Association(const Server& server, const std::vector<Context>& contexts, Task& task);
  /// Aborts it, unless it was released.
  ~Association();
  Association(const Association&) = delete;
  Association& operator=(const Association&) = delete;

  T_ASC_Association* get() const { return association_; }
  const Server& server() const { return server_; }
  Watch& watch() { return task_.watch(); }
  bool isOpen() const { return association_ != nullptr; }

  /// The accepted context of a service or class; 0: none. With a transfer syntax, that one's, or else another's.
  T_ASC_PresentationContextID contextOf(const std::string& abstractSyntax,
                                        const std::string& transferSyntax = {}) const;
  /// What was agreed on for an accepted context.
  std::string syntaxOf(T_ASC_PresentationContextID context) const;
  /// As contextOf; throws the Error of a server that does not offer `service`, "C-FIND".
  T_ASC_PresentationContextID require(const std::string& abstractSyntax, const char* service) const;

  DIC_US nextMessage() { return association_->nextMsgID++; }
  /// Throws what ended the conversation when `result` is bad: Cancelled, or an Error that says `doing`, "sending it".
  void check(const OFCondition& result, const std::string& doing);
  /// Whether what came last made no sense, where a connection that was closed or aborted would have been one thing.
  bool isGarbled() const { return isGarbled_; }
  /// The next command, whose response or request it is. Throws as check.
  T_DIMSE_Message receive(T_ASC_PresentationContextID& context, const std::string& doing);
  /// The data set that follows a command. Throws as check.
  std::unique_ptr<DcmDataset> receiveData(T_ASC_PresentationContextID context, const std::string& doing);

  /// Whether receive() has something to read at once.
  bool hasMessage() const;
  /// As receive; empty where the server has ended the association, which is closed then.
  std::optional<T_DIMSE_Message> receiveUnlessEnded(T_ASC_PresentationContextID& context, const std::string& doing);

  void release();

 private:
  void request(const std::string& host, const std::vector<Context>& contexts);
  [[noreturn]] void explain(const OFCondition& result, T_ASC_Parameters* parameters);
  void drop();

  const Server& server_;
  Task& task_;
  WatchedLayer layer_;
  T_ASC_Network* network_ = nullptr;
  T_ASC_Association* association_ = nullptr;
  bool isGarbled_ = false;
};

/// Throws the Error of a server's answer that is a failure, such as 0xA900; `service` is what was asked, "C-FIND".
[[noreturn]] void refuseStatus(const Server& server, const char* service, unsigned status);
/// The meaning of a status (PS3.7 annex C, PS3.4), "out of resources".
std::string meaningOf(unsigned status);

}  // namespace fenestra::io::archive
