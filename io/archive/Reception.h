#pragma once
// What becomes of a connection to us: an association is taken from the AE title of the server to ours, for the classes
// asked for, and each message goes to who expects it. Several threads may serve connections at once. Private to
// io/archive; include in .cpp files alone.

#include <atomic>
#include <functional>
#include <set>
#include <string>

#include "io/archive/Refusals.h"
#include "io/archive/Server.h"
#include "io/archive/Transport.h"
#include "io/archive/Watch.h"

#include <dcmtk/dcmnet/assoc.h>
#include <dcmtk/dcmnet/dimse.h>

namespace fenestra::io::archive {

/// What we take, and from whom.
struct Service {
  /// Takes a request and answers it; false: the association ends at once.
  using Receive = std::function<bool(T_ASC_Association* association, T_ASC_PresentationContextID context,
                                     const T_DIMSE_Message& request, Watch& watch)>;
  std::set<std::string> classes;
  /// Whether who connects provides the service (PS3.7 D.3.3.4), as a server that reports a storage commitment does.
  bool isOfPeer = false;
  Receive receive;
};

class Reception {
 public:
  /// `server` outlives this.
  Reception(const Server& server, Service service) : server_(server), service_(std::move(service)) {}

  /// Converses over a connection that was accepted until it ends or `stops`, and closes it.
  void serve(int socket, const std::atomic<bool>& stops);
  /// Whether no connection is served.
  bool isIdle() const { return serving_ == 0; }
  /// One that is not served is turned away.
  void countConnection() { ++connections_; }
  /// Other than objects.
  Refusals refusals() const { return {connections_, titles_, classes_, 0}; }

 private:
  OFCondition receiveAssociation(int socket, WatchedLayer& layer, T_ASC_Network*& network,
                                 T_ASC_Association*& association);
  bool negotiate(T_ASC_Association* association);
  void converse(T_ASC_Association* association, Watch& watch);

  const Server& server_;
  const Service service_;
  std::atomic<std::size_t> connections_ = 0, titles_ = 0, classes_ = 0, serving_ = 0;
};

}  // namespace fenestra::io::archive
