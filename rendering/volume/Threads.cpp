#include "rendering/volume/Threads.h"

#include <algorithm>
#include <utility>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace fenestra {
namespace {

thread_local Interruptible* current = nullptr;

/// While it lives, its thread works for `work`.
class WorkingFor {
 public:
  explicit WorkingFor(Interruptible* work) : before_(std::exchange(current, work)) {}
  ~WorkingFor() { current = before_; }
  WorkingFor(const WorkingFor&) = delete;
  WorkingFor& operator=(const WorkingFor&) = delete;

 private:
  Interruptible* const before_;
};

}  // namespace

void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  const std::size_t pieces = std::clamp<std::size_t>(count / std::max<std::size_t>(grain, 1), 1, cores);
  if (pieces == 1) {
    body(0, count);
    return;
  }
  const auto piece = [&, outer = current](std::size_t index) {
    const WorkingFor work(outer);
    body(count * index / pieces, count * (index + 1) / pieces);
  };
  // Isolated: a thread that waits here takes no piece of another parallelFor(), whose caller may hold a lock.
  tbb::this_task_arena::isolate([&] { tbb::parallel_for(std::size_t{0}, pieces, piece, tbb::static_partitioner()); });
}

void onEachCore(const std::function<void(bool isCaller)>& body) {
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  // The first piece is this thread's.
  parallelFor(cores, 1, [&](std::size_t begin, std::size_t) { body(begin == 0); });
}

void together(const std::function<void()>& here, const std::function<void()>& elsewhere) {
  parallelFor(2, 1, [&](std::size_t begin, std::size_t end) {
    if (begin == 0) here();
    if (end == 2) elsewhere();
  });
}

Interruptible::Interruptible(std::function<bool()> goOn)
    : goOn_(std::move(goOn)), thread_(std::this_thread::get_id()), outer_(std::exchange(current, this)) {}

Interruptible::~Interruptible() { current = outer_; }

void interruptionPoint() {
  Interruptible* const work = current;
  if (!work) return;
  if (work->thread_ == std::this_thread::get_id() && work->goOn_ && !work->goOn_()) work->stopped_ = true;
  if (work->stopped_) throw Interrupted();
}

}  // namespace fenestra
