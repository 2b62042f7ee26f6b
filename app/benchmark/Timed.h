#pragma once
// Times of work that the graphics card shares.

#include <chrono>

#include "rendering/gl/Context.h"

namespace fenestra::bench {

/// Milliseconds that `work` takes, the GPU's included.
template <class Work>
double timed(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  gl::TimerQuery timer;
  work();
  timer.elapsedMilliseconds();  // waits
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace fenestra::bench
