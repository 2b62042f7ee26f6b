#include "app/viewer/TerminationSignals.h"

#include <sys/socket.h>
#include <unistd.h>
#include <array>
#include <csignal>
#include <utility>

namespace fenestra::viewer {
namespace {

constexpr std::array handled{SIGTERM, SIGINT, SIGHUP};

/// A handler may only call what is safe in a signal (POSIX 2.4.3): it writes a byte, and the event loop reads it.
std::array<int, 2> sockets{-1, -1};

void note(int) {
  const char byte = 1;
  [[maybe_unused]] const ssize_t written = ::write(sockets[0], &byte, 1);
}

}  // namespace

TerminationSignals::TerminationSignals(std::function<void()> asked) {
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0) return;
  notifier_ = std::make_unique<QSocketNotifier>(sockets[1], QSocketNotifier::Read);
  QObject::connect(notifier_.get(), &QSocketNotifier::activated, notifier_.get(), [this, asked = std::move(asked)] {
    notifier_->setEnabled(false);
    asked();
  });
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int number : handled) ::sigaction(number, &action, nullptr);
}

TerminationSignals::~TerminationSignals() {
  if (!notifier_) return;
  for (const int number : handled) std::signal(number, SIG_DFL);
  notifier_.reset();
  for (int& socket : sockets) ::close(std::exchange(socket, -1));
}

}  // namespace fenestra::viewer
