#pragma once
// Reading data off the GUI thread, with progress and cancel. One at a time: a new start replaces what was running.

#include <functional>
#include <string>

#include <QFutureWatcher>
#include <QObject>

#include "io/VolumeReader.h"

namespace fenestra::viewer {

class LoadJob : public QObject {
  Q_OBJECT
 public:
  /// What to do with the result, on the GUI thread.
  using Show = std::function<void()>;
  /// Reads on another thread. May throw io::Error, io::Cancelled.
  using Read = std::function<Show(const io::Progress&)>;

  explicit LoadJob(QObject* parent = nullptr);
  /// Cancels and waits until the reader has noticed.
  ~LoadJob() override;

  void start(Read read);
  void cancel();
  /// From started() until just before ended().
  bool isRunning() const { return running_; }

 Q_SIGNALS:
  void started();
  void progressed(double fraction, const QString& doing);
  /// Nothing came of it; the message is one line.
  void failed(const QString& message);
  /// The last signal of a run, whether it was shown, failed or cancelled.
  void ended();

 private:
  struct Outcome {
    Show show;
    std::string error;  ///< when there is nothing to show
  };

  void finish();

  QFutureWatcher<Outcome> watcher_;
  bool running_ = false;
};

}  // namespace fenestra::viewer
