#pragma once
// Progress of work that many threads share.

#include <mutex>

#include "io/base/Reading.h"

namespace fenestra::io {

/// A part of a progress bar.
struct ProgressPart {
  const Progress& progress;
  double from = 0.0, to = 1.0;
};

/// Counts work from many threads and tells the callback, one call at a time.
class SharedProgress {
 public:
  SharedProgress(const ProgressPart& part, std::size_t count, const char* doing)
      : part_(part), count_(count), doing_(doing) {}

  /// Call before each piece of work; throws Cancelled.
  void step() {
    const std::scoped_lock lock(mutex_);
    const double fraction =
        part_.from + (part_.to - part_.from) * static_cast<double>(done_++) / static_cast<double>(count_);
    if (cancelled_ || (part_.progress && !part_.progress(fraction, doing_))) {
      cancelled_ = true;
      throw Cancelled();
    }
  }

 private:
  ProgressPart part_;
  std::size_t count_, done_ = 0;
  const char* doing_;
  bool cancelled_ = false;
  std::mutex mutex_;
};

}  // namespace fenestra::io
