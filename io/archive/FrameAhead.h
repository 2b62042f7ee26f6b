#pragma once
// The middle frame of an object that is on its way, over a connection of its own: a server needs about as long to take
// one frame out of a large object as to begin to send it, so neither waits for the other. Private to io/archive.

#include <atomic>
#include <filesystem>
#include <functional>
#include <thread>

#include "io/archive/WebFrame.h"
#include "io/archive/WebServer.h"

namespace fenestra::io::archive {

class FrameAhead {
 public:
  /// Calls `come` on a thread of its own once `file` holds the frame; never where the server gives none. `server`
  /// outlives this.
  FrameAhead(const WebServer& server, FramePlace place, std::filesystem::path file, std::function<void()> come);
  /// Fetches no longer, and removes the file. Nothing is called from here on.
  ~FrameAhead();
  FrameAhead(const FrameAhead&) = delete;
  FrameAhead& operator=(const FrameAhead&) = delete;

 private:
  std::filesystem::path file_;
  std::atomic<bool> stops_ = false;
  std::thread thread_;
};

}  // namespace fenestra::io::archive
