#pragma once
// Listens for a server that connects to us, from its construction to its destruction, on one address and port, and lets
// no one else hold it up: connections that say nothing, or something else than DICOM, are closed. Private to
// io/archive; include in .cpp files alone.

#include <atomic>
#include <chrono>
#include <list>
#include <thread>
#include <vector>

#include "io/archive/Reception.h"
#include "io/archive/Refusals.h"
#include "io/archive/Server.h"

namespace fenestra::io::archive {

class Provider {
 public:
  /// `server` outlives this. Throws Error when the server's interface and own port cannot be listened on.
  Provider(const Server& server, Service service);
  /// Ends all conversations at once.
  ~Provider();
  Provider(const Provider&) = delete;
  Provider& operator=(const Provider&) = delete;

  bool isIdle() const { return reception_.isIdle(); }
  /// Other than objects.
  Refusals refusals() const { return reception_.refusals(); }

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

  const Server& server_;
  Reception reception_;
  int socket_ = -1;
  std::atomic<bool> stops_ = false;
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
