#include "rendering/volume/Threads.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace fenestra::threadsTest {
namespace {

TEST(ParallelFor, visitsEachItemOnce) {
  std::vector<std::atomic<int>> visits(1000);
  parallelFor(visits.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) ++visits[i];
  });
  for (const std::atomic<int>& each : visits) EXPECT_EQ(each, 1);
}

TEST(ParallelFor, rethrowsWhatAPieceThrows) {
  const auto fails = [](std::size_t begin, std::size_t) {
    if (begin == 0) throw std::runtime_error("failed");
  };
  EXPECT_THROW(parallelFor(100, 1, fails), std::runtime_error);
}

TEST(ParallelFor, CutsTheItemsTheSameWayEachTime) {
  const auto pieces = [] {
    std::mutex mutex;
    std::set<std::pair<std::size_t, std::size_t>> found;
    parallelFor(1001, 10, [&](std::size_t begin, std::size_t end) {
      const std::scoped_lock lock(mutex);
      found.emplace(begin, end);
    });
    return found;
  };
  const auto first = pieces();
  EXPECT_EQ(first.size(), std::min<std::size_t>(std::max(1u, std::thread::hardware_concurrency()), 100));
  for (int again = 0; again < 20; ++again) EXPECT_EQ(pieces(), first);
}

TEST(ParallelFor, DoesTheFirstPieceOnTheCallingThread) {
  std::thread::id first;
  parallelFor(1000, 1, [&](std::size_t begin, std::size_t) {
    if (begin == 0) first = std::this_thread::get_id();
  });
  EXPECT_EQ(first, std::this_thread::get_id());
}

TEST(OnEachCore, CallsOnceOnTheCallingThreadAndOnceForEachOtherCore) {
  const std::thread::id here = std::this_thread::get_id();
  for (int again = 0; again < 20; ++again) {
    std::atomic<int> calls = 0, byCaller = 0;
    onEachCore([&](bool isCaller) {
      ++calls;
      if (!isCaller) return;
      ++byCaller;
      EXPECT_EQ(std::this_thread::get_id(), here);
    });
    EXPECT_EQ(calls, static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
    EXPECT_EQ(byCaller, 1);
  }
}

TEST(Together, DoesBothAndTheFirstOnTheCallingThread) {
  for (int again = 0; again < 20; ++again) {
    std::thread::id here, caller;
    std::atomic<int> nested = 0;
    together(
        [&] {
          here = std::this_thread::get_id();
          onEachCore([&](bool isCaller) {
            if (isCaller) caller = std::this_thread::get_id();
          });
        },
        [&] { parallelFor(100, 1, [&](std::size_t from, std::size_t to) { nested += static_cast<int>(to - from); }); });
    EXPECT_EQ(here, std::this_thread::get_id());
    EXPECT_EQ(caller, here) << "OpenGL's thread is the one that uploads, in nested work, too";
    EXPECT_EQ(nested, 100);
  }
}

TEST(ParallelFor, MayBeCalledByItsBody) {
  std::atomic<int> visits = 0;
  parallelFor(64, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      parallelFor(100, 1, [&](std::size_t from, std::size_t to) { visits += static_cast<int>(to - from); });
  });
  EXPECT_EQ(visits, 6400);
}

TEST(ParallelFor, TakesNoOtherWorkWhileItWaitsWithALock) {
  std::mutex mutex;
  int visits = 0;
  parallelFor(64, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::scoped_lock lock(mutex);
      std::atomic<int> inner = 0;
      parallelFor(100, 1, [&](std::size_t from, std::size_t to) { inner += static_cast<int>(to - from); });
      visits += inner;
    }
  });
  EXPECT_EQ(visits, 6400);
}

TEST(Interruptible, StopsNestedPieces) {
  const Interruptible work([] { return false; });
  EXPECT_THROW(parallelFor(8, 1,
                           [](auto, auto) {
                             parallelFor(8, 1, [](auto, auto) {
                               while (true) interruptionPoint();
                             });
                           }),
               Interrupted);
}

TEST(Interruptible, StopsThePiecesOnAllThreads) {
  constexpr std::size_t count = 100000;
  std::atomic<std::size_t> done = 0;
  int asked = 0;
  const Interruptible work([&] { return ++asked < 10; });
  EXPECT_THROW(parallelFor(count, 1,
                           [&](std::size_t begin, std::size_t end) {
                             for (std::size_t i = begin; i < end; ++i) {
                               interruptionPoint();
                               // The other threads wait for the one that asks, and stop with it.
                               if (begin != 0)
                                 while (i > begin) interruptionPoint();
                               ++done;
                             }
                           }),
               Interrupted);
  EXPECT_EQ(asked, 10);
  EXPECT_LT(done, 100u);
}

TEST(Interruptible, HoldsUntilItEnds) {
  const auto work = [] { interruptionPoint(); };
  EXPECT_NO_THROW(work());
  {
    const Interruptible stopped([] { return false; });
    EXPECT_THROW(work(), Interrupted);
    {
      const Interruptible inner([] { return true; });
      EXPECT_NO_THROW(work());
    }
    EXPECT_THROW(work(), Interrupted);
  }
  EXPECT_NO_THROW(work());
}

}  // namespace
}  // namespace fenestra::threadsTest
