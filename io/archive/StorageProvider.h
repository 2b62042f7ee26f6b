#pragma once
// Receives the objects that a server sends for our C-MOVE, and lets no one else in (storage service class provider,
// PS3.4 annex B). It listens from its construction to its destruction, on one address and port. It takes associations
// from the AE title of the server to ours, for the classes asked for; the Intake takes the objects asked for. Private
// to io/archive; include in .cpp files alone.

#include <atomic>
#include <chrono>
#include <list>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "io/archive/Intake.h"
#include "io/archive/Refusals.h"
#include "io/archive/Server.h"
#include "io/archive/Transport.h"
#include "io/archive/Watch.h"

namespace fenestra::io::archive {

class StorageProvider {
 public:
  /// Throws Error when the server's interface and own port cannot be listened on.
  StorageProvider(const Server& server, std::set<std::string> classes, Intake& intake);
  /// Ends all conversations at once.
  ~StorageProvider();
  StorageProvider(const StorageProvider&) = delete;
  StorageProvider& operator=(const StorageProvider&) = delete;

  /// Other than objects.
  Refusals refusals() const;

 private:
  /// A connection that has not said yet who it is.
  struct Waiting {
    int socket = -1;
    std::chrono::steady_clock::time_point since;
  };
  enum class Introduction : std::uint8_t { Expected, Complete, Wrong };

  void listen();
  void run();
  void admit();
  void sortWaiting();
  Introduction introductionOf(int socket) const;
  void serve(int socket);
  OFCondition receiveAssociation(int socket, WatchedLayer& layer, T_ASC_Network*& network,
                                 T_ASC_Association*& association);
  void converse(T_ASC_Association* association, Watch& watch);
  bool negotiate(T_ASC_Association* association);

  const Server& server_;
  const std::set<std::string> classes_;
  Intake& intake_;
  int socket_ = -1;
  std::atomic<bool> stops_ = false;
  std::atomic<std::size_t> connections_ = 0, titles_ = 0, classesRefused_ = 0;
  std::vector<Waiting> waiting_;  ///< of the listening thread
  /// A conversation, and whether it has ended.
  struct Served {
    std::atomic<bool> isOver = false;
    std::thread thread;
  };
  std::list<Served> served_;  ///< of the listening thread
  std::thread listening_;
};

}  // namespace fenestra::io::archive
