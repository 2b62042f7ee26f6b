#include "io/archive/Reach.h"

#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <memory>
#include <mutex>
#include <thread>

namespace fenestra::io::archive {
namespace {

/// 0 when a connection to `address` was made, or why not.
int connectTo(const addrinfo& address, std::chrono::milliseconds most, Task& task) {
  const int socket = ::socket(address.ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (socket < 0) return errno;
  const std::unique_ptr<const int, void (*)(const int*)> closing(&socket, [](const int* open) { close(*open); });
  if (connect(socket, address.ai_addr, address.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  const auto end = std::chrono::steady_clock::now() + most;
  while (std::chrono::steady_clock::now() < end) {
    task.checkCancelled();
    pollfd waited{socket, POLLOUT, 0};
    if (poll(&waited, 1, 50) <= 0) continue;
    int failure = 0;
    socklen_t size = sizeof failure;
    getsockopt(socket, SOL_SOCKET, SO_ERROR, &failure, &size);
    return failure;
  }
  return ETIMEDOUT;
}

/// The addresses of a host, once they are known.
struct Lookup {
  std::mutex mutex;
  std::condition_variable known;
  bool isOver = false;
  addrinfo* found = nullptr;  ///< null after a failure

  Lookup() = default;
  Lookup(const Lookup&) = delete;
  Lookup& operator=(const Lookup&) = delete;
  ~Lookup() {
    if (found) freeaddrinfo(found);
  }
};

/// Asks the system for a name in a thread of its own, which is left behind when the user cancels: where no name server
/// answers, getaddrinfo() takes many seconds and cannot be interrupted. Throws Cancelled.
std::shared_ptr<Lookup> lookUp(const std::string& host, const std::string& port, Task& task) {
  auto lookup = std::make_shared<Lookup>();
  std::thread([lookup, host, port] {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    const bool failed = getaddrinfo(host.c_str(), port.c_str(), &hints, &found) != 0;
    const std::lock_guard lock(lookup->mutex);
    lookup->found = failed ? nullptr : found;
    lookup->isOver = true;
    lookup->known.notify_one();
  }).detach();
  std::unique_lock lock(lookup->mutex);
  while (!lookup->known.wait_for(lock, std::chrono::milliseconds(50), [&] { return lookup->isOver; }))
    task.checkCancelled();
  return lookup;
}

}  // namespace

std::string reach(const Server& server, Task& task) {
  const std::shared_ptr<Lookup> lookup = lookUp(server.host, std::to_string(server.port), task);
  if (!lookup->found)
    refuse(server, "there is no host \"" + server.host + "\"",
           "check the host's name, and that the network is connected");
  int failure = ETIMEDOUT;
  for (const addrinfo* each = lookup->found; each; each = each->ai_next) {
    failure = connectTo(*each, server.limits.connect, task);
    if (failure != 0) continue;
    char address[NI_MAXHOST];
    const bool isVersion4 = each->ai_family == AF_INET;  // DCMTK takes no other in figures
    if (!isVersion4 ||
        getnameinfo(each->ai_addr, each->ai_addrlen, address, sizeof address, nullptr, 0, NI_NUMERICHOST))
      return server.host;
    return address;
  }
  const std::string port = "port " + std::to_string(server.port);
  if (failure == ECONNREFUSED)
    refuse(server, "nothing listens on " + port + " of the host", "check the port, and that the server runs");
  if (failure == ETIMEDOUT)
    refuse(server, "the host does not answer on " + port, "check host and port; a firewall may be between");
  refuse(server, std::string("the host cannot be reached: ") + std::strerror(failure),
         "check the host's name, and that the network is connected");
}

}  // namespace fenestra::io::archive
