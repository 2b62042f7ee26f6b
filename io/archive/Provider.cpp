#include "io/archive/Provider.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "io/base/Error.h"
#include "io/dicom/Dcmtk.h"

namespace fenestra::io::archive {

Provider::Provider(const Server& server, Service service) : server_(server), reception_(server, std::move(service)) {
  prepareDcmtk();
  listen();
  listening_ = std::thread([this] { run(); });
}

Provider::~Provider() {
  stops_ = true;
  listening_.join();
  for (Served& each : served_) each.thread.join();
  for (const Waiting& each : waiting_) close(each.socket);
  close(socket_);
}

void Provider::listen() {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(server_.ownPort));
  const std::string place = server_.interface + ":" + std::to_string(server_.ownPort);
  if (inet_pton(AF_INET, server_.interface.c_str(), &address.sin_addr) != 1)
    throw Error(place, "is no address of this machine", "give the address that the server sends to, in figures");
  socket_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const int on = 1;
  setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (socket_ >= 0 && bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
      ::listen(socket_, SOMAXCONN) == 0)
    return;
  const std::string why = std::strerror(errno);
  if (socket_ >= 0) close(socket_);
  throw Error(place, "cannot be listened on: " + why,
              "give a free port of this machine, and have it entered at the server");
}

void Provider::run() {
  while (!stops_) {
    pollfd waited{socket_, POLLIN, 0};
    constexpr int step = 20;  // ms; connections that wait are looked at as often
    if (poll(&waited, 1, step) > 0) admit();
    sortWaiting();
  }
}

void Provider::admit() {
  for (int accepted = -1; !stops_ && (accepted = accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC)) >= 0;) {
    if (waiting_.size() >= server_.limits.waitingConnections) sortWaiting();
    if (waiting_.size() >= server_.limits.waitingConnections) {  // the one that waits longest makes room
      close(waiting_.front().socket);
      waiting_.erase(waiting_.begin());
      reception_.countConnection();
    }
    waiting_.push_back({accepted, std::chrono::steady_clock::now()});
  }
}

Provider::Introduction Provider::introductionOf(int socket) const {
  std::array<unsigned char, 6> start{};
  const ssize_t there = recv(socket, start.data(), start.size(), MSG_PEEK | MSG_DONTWAIT);
  if (there < 0) return errno == EAGAIN || errno == EINTR ? Introduction::Expected : Introduction::Wrong;
  if (there == 0) return Introduction::Wrong;
  constexpr unsigned char handshake = 0x16, associateRequest = 0x01;  // RFC 8446 5.1; PS3.8 9.3.2
  if (server_.tls) return start[0] == handshake ? Introduction::Complete : Introduction::Wrong;
  if (start[0] != associateRequest) return Introduction::Wrong;
  if (there < static_cast<ssize_t>(start.size())) return Introduction::Expected;
  const std::uint32_t length = static_cast<std::uint32_t>(start[2]) << 24 | static_cast<std::uint32_t>(start[3]) << 16 |
                               static_cast<std::uint32_t>(start[4]) << 8 | start[5];
  constexpr std::uint32_t most = 1u << 16;  // 128 contexts with ten transfer syntaxes each
  if (length > most) return Introduction::Wrong;
  int bytes = 0;
  ioctl(socket, FIONREAD, &bytes);
  return static_cast<std::uint32_t>(bytes) >= length + start.size() ? Introduction::Complete : Introduction::Expected;
}

void Provider::sortWaiting() {
  for (auto each = served_.begin(); each != served_.end();) {
    if (!each->isOver) {
      ++each;
      continue;
    }
    each->thread.join();
    each = served_.erase(each);
  }
  const auto now = std::chrono::steady_clock::now();
  for (auto each = waiting_.begin(); each != waiting_.end();) {
    const Introduction introduction = introductionOf(each->socket);
    const bool isComplete = introduction == Introduction::Complete;
    const bool isLate = now - each->since > (isComplete ? server_.limits.silence : server_.limits.introduction);
    if (isComplete && served_.size() < server_.limits.associations) {
      Served& served = served_.emplace_back();
      served.thread = std::thread([this, &served, socket = each->socket] {
        reception_.serve(socket, stops_);
        served.isOver = true;
      });
    } else if (introduction != Introduction::Wrong && !isLate) {
      ++each;
      continue;
    } else {
      reception_.countConnection();
      close(each->socket);
    }
    each = waiting_.erase(each);
  }
}

}  // namespace fenestra::io::archive
