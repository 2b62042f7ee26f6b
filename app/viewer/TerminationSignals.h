#pragma once
// SIGTERM, SIGINT and SIGHUP as events: a desktop that shuts down ends programs by them.

#include <functional>
#include <memory>

#include <QSocketNotifier>

namespace fenestra::viewer {

/// One at a time. While it lives, the signals do not end the program but have `asked` called from the event loop, once.
class TerminationSignals {
 public:
  explicit TerminationSignals(std::function<void()> asked);
  ~TerminationSignals();
  TerminationSignals(const TerminationSignals&) = delete;
  TerminationSignals& operator=(const TerminationSignals&) = delete;

 private:
  std::unique_ptr<QSocketNotifier> notifier_;
};

}  // namespace fenestra::viewer
