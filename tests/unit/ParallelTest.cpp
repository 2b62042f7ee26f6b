#include "rendering/scene/Parallel.h"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace fenestra {
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
}  // namespace fenestra
