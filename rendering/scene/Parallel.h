#pragma once
// Splits an index range over all cores.

#include <cstddef>
#include <functional>

namespace fenestra {

/// Calls body(begin, end) on disjoint pieces that cover [0, count), on as many threads as there are cores, and waits.
/// The first exception thrown by a piece is rethrown. `grain` is the least number of items worth a thread.
void parallelFor(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace fenestra
