#pragma once
// One task for a server, such as a query or a retrieval: its progress, its cancellation, and the watch over its own
// connection. Private to io/archive.

#include <string>
#include <string_view>

#include "io/archive/Server.h"
#include "io/archive/Watch.h"
#include "io/base/Reading.h"

namespace fenestra::io::archive {

class Task {
 public:
  Task(const Limits& limits, const Progress& progress, std::string doing)
      : progress_(progress), doing_(std::move(doing)), watch_([this] { return report(); }, limits.silence, activity_) {}
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;

  Watch& watch() { return watch_; }
  Activity& activity() { return activity_; }
  void setFraction(double fraction) { fraction_ = fraction; }
  /// Throws Cancelled when the user wants no more.
  void checkCancelled() {
    if (!watch_.check()) throw Cancelled();
  }

 private:
  bool report() { return !progress_ || progress_(fraction_, doing_); }

  const Progress& progress_;
  std::string doing_;
  double fraction_ = 0.0;
  Activity activity_;
  Watch watch_;
};

}  // namespace fenestra::io::archive
