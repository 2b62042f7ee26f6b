#pragma once
// Reading and writing data off the GUI thread, with progress and cancel. One job at a time: a new start replaces the
// running one.

#include <functional>
#include <string>

#include <QFutureWatcher>
#include <QObject>
#include <QThreadPool>

#include "io/base/Reading.h"

namespace fenestra::viewer {

class LoadJob : public QObject {
  Q_OBJECT
 public:
  /// Shows the result, on the GUI thread.
  using Show = std::function<void()>;
  /// Reads or writes on another thread. May throw io::Error, io::Cancelled.
  using Read = std::function<Show(const io::Progress&)>;

  explicit LoadJob(QObject* parent = nullptr);
  /// On `threads`, which outlive this.
  explicit LoadJob(QThreadPool& threads, QObject* parent = nullptr);
  /// Cancels and waits until the reader has stopped.
  ~LoadJob() override;

  void start(Read read);
  void cancel();
  /// Until release(), an outcome waits: neither shown nor reported. For questions about what a result would replace.
  void hold() { isHeld_ = true; }
  void release();
  /// From started() until just before ended().
  bool isRunning() const { return running_; }

 Q_SIGNALS:
  void started();
  void progressed(double fraction, const QString& doing);
  /// Reading failed; the message is one line.
  void failed(const QString& message);
  /// The last signal of every run: after showing the result, a failure or a cancel.
  void ended();

 private:
  struct Outcome {
    Show show;
    std::string error;  ///< when there is nothing to show
  };

  void finish();

  QThreadPool& threads_;
  QFutureWatcher<Outcome> watcher_;
  bool running_ = false;
  bool isHeld_ = false, waits_ = false;  ///< waits_: an outcome waits for release()
};

}  // namespace fenestra::viewer
