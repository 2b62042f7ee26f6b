#include "io/archive/FrameAhead.h"

#include <exception>
#include <string_view>
#include <system_error>
#include <utility>

namespace fenestra::io::archive {

FrameAhead::FrameAhead(const WebServer& server, FramePlace place, std::uint64_t bytes, std::filesystem::path file,
                       std::function<void()> come)
    : file_(std::move(file)) {
  thread_ = std::thread([this, &server, place = std::move(place), bytes, come = std::move(come)] {
    try {
      if (waitUntilSlow(server.limits.frameAhead, bytes) &&
          fetchFrame(server, place, file_, [this](double, std::string_view) { return !stops_; }))
        come();
    } catch (const std::exception&) {
      // The object itself comes without, or tells why it does not.
    }
  });
}

bool FrameAhead::waitUntilSlow(std::chrono::milliseconds limit, std::uint64_t bytes) const {
  using Seconds = std::chrono::duration<double>;
  constexpr std::chrono::milliseconds step{20};
  constexpr Seconds least{0.5};  // of a transfer, for its speed to be known
  std::chrono::steady_clock::time_point begin;
  bool hasBegun = false;
  for (; !stops_; std::this_thread::sleep_for(step)) {
    const std::uint64_t received = received_;
    if (received == 0) continue;  // the server is still preparing it
    const auto now = std::chrono::steady_clock::now();
    if (!std::exchange(hasBegun, true)) begin = now;
    const Seconds elapsed = now - begin;
    const Seconds left = bytes == 0 ? elapsed
                         : bytes > received
                             ? elapsed * (static_cast<double>(bytes - received) / static_cast<double>(received))
                             : Seconds(0);
    if (elapsed >= least && left > limit) return true;
  }
  return false;
}

FrameAhead::~FrameAhead() {
  stops_ = true;
  thread_.join();
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

}  // namespace fenestra::io::archive
