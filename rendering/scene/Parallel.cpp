#include "rendering/scene/Parallel.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <utility>
#include <vector>

namespace fenestra {
namespace {

thread_local Interruptible* current = nullptr;

}  // namespace

void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  const std::size_t pieces = std::clamp<std::size_t>(count / std::max<std::size_t>(grain, 1), 1, cores);
  if (pieces == 1) {
    body(0, count);
    return;
  }
  std::mutex mutex;
  std::exception_ptr failure;
  const auto piece = [&](std::size_t index) {
    try {
      body(count * index / pieces, count * (index + 1) / pieces);
    } catch (...) {
      const std::scoped_lock lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t index = 1; index < pieces; ++index)
      threads.emplace_back([&piece, index, outer = current] {
        current = outer;
        piece(index);
      });
    piece(0);
  }
  if (failure) std::rethrow_exception(failure);
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
