#pragma once
// A frame of an object that is on its way, over a connection of its own: a server takes about as long to take one frame
// out of a large object as to begin to send it, and is slower with both at once. So a frame is asked for where the line
// is slow alone. Private to io/archive.

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <thread>

#include "io/archive/WebFrame.h"
#include "io/archive/WebServer.h"

namespace fenestra::io::archive {

class FrameAhead {
 public:
  /// Calls `come` on a thread of its own once `file` holds the frame; never where the object of `bytes`, 0 where they
  /// are unknown, seems to be here within Limits::frameAhead, or where the server gives no frame. `server` outlives
  /// this.
  FrameAhead(const WebServer& server, FramePlace place, std::uint64_t bytes, std::filesystem::path file,
             std::function<void()> come);
  /// Fetches no longer, and removes the file. Nothing is called from here on.
  ~FrameAhead();
  FrameAhead(const FrameAhead&) = delete;
  FrameAhead& operator=(const FrameAhead&) = delete;

  /// So many bytes of the object came.
  void count(std::size_t bytes) { received_ += bytes; }

 private:
  /// False: it is too late for a frame.
  bool waitUntilSlow(std::chrono::milliseconds limit, std::uint64_t bytes) const;

  std::filesystem::path file_;
  std::atomic<bool> stops_ = false;
  std::atomic<std::uint64_t> received_ = 0;
  std::thread thread_;
};

}  // namespace fenestra::io::archive
