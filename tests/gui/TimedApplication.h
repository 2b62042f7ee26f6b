#pragma once
// An application that measures how long its events keep the GUI thread busy.

#include <chrono>
#include <ctime>
#include <string>
#include <utility>

#include <QApplication>

namespace fenestra::viewer {

class TimedApplication : public QApplication {
 public:
  using QApplication::QApplication;

  /// Since the last call of takeBlocks().
  struct Blocks {
    double longest = 0.0;         ///< ms, of one event with all events that it sent on
    std::string event{};          ///< the longest: its receiver's class and its type
    double ownTime = 0.0;         ///< ms of a processor that the thread itself had meanwhile; the rest it waited
    int over50 = 0, over100 = 0;  ///< events that took longer than so many ms
  };
  Blocks takeBlocks() { return std::exchange(blocks_, {}); }

  /// Events of a nested event loop belong to the event that started it.
  bool notify(QObject* receiver, QEvent* event) override {
    using Clock = std::chrono::steady_clock;
    if (inside_) return QApplication::notify(receiver, event);
    const int type = event->type();
    const std::string name = receiver->metaObject()->className();
    inside_ = true;
    const double ownStart = threadTime();
    const auto start = Clock::now();
    const bool result = QApplication::notify(receiver, event);
    inside_ = false;
    const double took = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    if (took > 50.0) ++blocks_.over50;
    if (took > 100.0) ++blocks_.over100;
    if (took > blocks_.longest) {
      blocks_.longest = took;
      blocks_.event = name + ", event " + std::to_string(type);
      blocks_.ownTime = threadTime() - ownStart;
    }
    return result;
  }

 private:
  /// Milliseconds of a processor that this thread has had.
  static double threadTime() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
  }

  bool inside_ = false;
  Blocks blocks_;
};

}  // namespace fenestra::viewer
