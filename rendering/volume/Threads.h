#pragma once
// Splits an index range over all cores, and lets long work on them be stopped.

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <thread>

namespace fenestra {

/// Calls body(begin, end) on disjoint pieces that cover [0, count), as many as there are cores, on oneTBB's threads and
/// this one, which does the first piece, and waits. The pieces depend on `count`, `grain` and the cores alone. The
/// first exception thrown by a piece is rethrown; pieces that have not begun by then are dropped. A body may call
/// parallelFor(). `grain` is the least number of items worth a thread.
void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body);

/// Calls body(isCaller) once for each core, on as many threads as are free, and waits: for work that they take in
/// turns. isCaller: the call is on this thread, and the others need not have begun.
void onEachCore(const std::function<void(bool isCaller)>& body);

/// Calls both at once where there are two cores, `here` on this thread, and waits.
void together(const std::function<void()>& here, const std::function<void()>& elsewhere);

/// What interruptionPoint() throws.
class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

/// While it lives, interruptionPoint() on its thread, and in the pieces of parallelFor() begun there, asks `goOn`
/// whether to go on. `goOn` is called on its own thread alone.
class Interruptible {
 public:
  explicit Interruptible(std::function<bool()> goOn);
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  friend void interruptionPoint();

  const std::function<bool()> goOn_;
  const std::thread::id thread_;
  Interruptible* const outer_;
  std::atomic<bool> stopped_ = false;
};

/// To be called in the loops of long work: throws Interrupted where that is no longer wanted. Costs next to nothing
/// outside an Interruptible.
void interruptionPoint();

}  // namespace fenestra
