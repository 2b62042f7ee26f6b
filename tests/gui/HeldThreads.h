#pragma once
// Keeps the threads for work in the background busy, so that each job that starts waits as if its work took long.

#include <utility>

#include <QSemaphore>
#include <QThread>
#include <QThreadPool>

#include "viewer/jobs/BackgroundThreads.h"

namespace fenestra::viewer {

class HeldThreads {
 public:
  HeldThreads() {
    for (int thread = 0; thread < count_; ++thread)
      backgroundThreads().start([this] {
        busy_.release();
        goOn_.acquire();
        busy_.acquire();
      });
    while (busy_.available() < count_) QThread::yieldCurrentThread();
  }
  ~HeldThreads() { release(); }
  HeldThreads(const HeldThreads&) = delete;
  HeldThreads& operator=(const HeldThreads&) = delete;

  /// Jobs run from now on.
  void release() {
    if (std::exchange(released_, true)) return;
    goOn_.release(count_);
    while (busy_.available() > 0) QThread::yieldCurrentThread();
  }

 private:
  const int count_ = backgroundThreads().maxThreadCount();
  QSemaphore busy_, goOn_;
  bool released_ = false;
};

}  // namespace fenestra::viewer
