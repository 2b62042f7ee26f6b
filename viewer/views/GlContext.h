#pragma once
// The OpenGL context that 3-D pictures are drawn in. It shares its objects with the contexts of the widgets that show
// them (see PictureSurface). One thread at a time has it: the window's, or for a while another one, for work that would
// block the window (compiling programs, uploading voxels). All views use this one, because drivers compile programs for
// each context again.

#include <atomic>
#include <exception>
#include <functional>
#include <memory>

#include <QObject>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QThread>

namespace fenestra::viewer {

class GlContext : public QObject {
  Q_OBJECT
 public:
  /// Needs requestOpenGl() and the QApplication.
  GlContext();
  ~GlContext() override;

  /// Runs `work` with the context current, and makes the context current again that was so before. Stops background
  /// work first and waits for it. False, without running `work`, where the driver gives no context. Exceptions pass
  /// through.
  bool run(const std::function<void()>& work);

  /// Returns soon after `stop` is set, where that is possible.
  using Work = std::function<void(const std::atomic<bool>& stop)>;
  /// Called on the window's thread with the work's exception, or null.
  using Done = std::function<void(std::exception_ptr)>;
  /// Runs `work` on another thread, then `done` and freed() on this one. Only while not busy. Where the platform has no
  /// OpenGL beside the window's thread, it runs at once.
  void runBehind(Work work, Done done);
  bool isBusy() const { return thread_ != nullptr; }
  /// Waits until background work is done, for so many milliseconds at most.
  void waitFor(int milliseconds);
  /// Asks background work to stop, without waiting.
  void askToStop() { stop_ = true; }
  bool isAskedToStop() const { return stop_; }
  /// Stops background work and waits for it.
  void stop();

 Q_SIGNALS:
  /// Background work is done.
  void freed();

 private:
  void makeCurrentAndRun(const Work& work);
  void finish();

  QOffscreenSurface surface_;
  QOpenGLContext context_;
  std::unique_ptr<QThread> thread_;
  Done done_;
  std::exception_ptr error_;
  std::atomic<bool> stop_{false};
};

}  // namespace fenestra::viewer
