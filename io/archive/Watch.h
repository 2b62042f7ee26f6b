#pragma once
// What ends a conversation over a socket early: the user cancels, the peer is silent for too long, or it sends more
// than one message may hold. Private to io/archive.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>

namespace fenestra::io::archive {

/// When a byte last came or went on any of the connections of one task: a server that sends objects on one of them may
/// say nothing on the other.
class Activity {
 public:
  Activity() { note(); }
  void note() { last_ = std::chrono::steady_clock::now().time_since_epoch().count(); }
  std::chrono::steady_clock::duration idle() const {
    return std::chrono::steady_clock::now().time_since_epoch() - std::chrono::steady_clock::duration(last_.load());
  }

 private:
  std::atomic<std::chrono::steady_clock::rep> last_;
};

class Watch {
 public:
  enum class End : std::uint8_t { None, Stopped, Silent, TooLarge };

  /// `goesOn` is called at least every 50 ms while a peer is waited for, and stops the conversation by false.
  Watch(std::function<bool()> goesOn, std::chrono::milliseconds silence, Activity& activity)
      : goesOn_(std::move(goesOn)), silence_(silence), activity_(activity) {}

  /// Waits until `socket` can be read (POLLIN) or written (POLLOUT), as poll() has it; false: the conversation ends.
  bool wait(int socket, short events);
  /// `bytes` came; false: the message is larger than it may be.
  bool count(std::uint64_t bytes);
  void sent() { activity_.note(); }
  /// From here on a message begins that may hold `most` bytes.
  void beginMessage(std::uint64_t most) { left_ = most; }
  /// Asks goesOn where nothing is waited for.
  bool check();

  void setSilence(std::chrono::milliseconds silence) { silence_ = silence; }

  End end() const { return end_; }
  std::chrono::milliseconds silence() const { return silence_; }

 private:
  std::function<bool()> goesOn_;
  std::chrono::milliseconds silence_;
  Activity& activity_;
  std::uint64_t left_ = 1u << 20;
  End end_ = End::None;
};

}  // namespace fenestra::io::archive
