#include "io/archive/Watch.h"

#include <poll.h>
#include <cerrno>

namespace fenestra::io::archive {

bool Watch::check() {
  if (end_ == End::None && goesOn_ && !goesOn_()) end_ = End::Stopped;
  return end_ == End::None;
}

bool Watch::wait(int socket, short events) {
  constexpr int step = 50;  // ms; a user who cancels notices no delay below 100
  while (check()) {
    pollfd waited{socket, events, 0};
    const int ready = poll(&waited, 1, step);
    if (ready > 0) return true;
    if (ready < 0 && errno != EINTR) return true;  // the call that follows fails with its reason
    if (activity_.idle() > silence_) end_ = End::Silent;
  }
  return false;
}

bool Watch::count(std::uint64_t bytes) {
  activity_.note();
  if (bytes > left_) end_ = End::TooLarge;
  left_ -= bytes < left_ ? bytes : left_;
  return end_ == End::None;
}

}  // namespace fenestra::io::archive
