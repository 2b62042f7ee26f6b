#pragma once
// Progress of work that many threads share.

#include <mutex>

#include "io/base/Reading.h"

namespace fenestra::io {

/// Counts work from many threads and tells the callback, one call at a time.
class SharedProgress {
 public:
  SharedProgress(const Progress& progress, double from, double to, std::size_t count, const char* doing)
      : progress_(progress), from_(from), to_(to), count_(count), doing_(doing) {}

  /// Call before each piece of work; throws Cancelled.
  void step() {
    const std::scoped_lock lock(mutex_);
    const double fraction = from_ + (to_ - from_) * static_cast<double>(done_++) / static_cast<double>(count_);
    if (cancelled_ || (progress_ && !progress_(fraction, doing_))) {
      cancelled_ = true;
      throw Cancelled();
    }
  }

 private:
  const Progress& progress_;
  double from_, to_;
  std::size_t count_, done_ = 0;
  const char* doing_;
  bool cancelled_ = false;
  std::mutex mutex_;
};

}  // namespace fenestra::io
