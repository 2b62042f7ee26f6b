#pragma once
// Proves how exact a picture on screen is: pixels of it drawn at random are computed again by the reference, in double
// precision and off the GUI thread (rendering/reference/Certificate.h).

#include <filesystem>
#include <functional>

#include <QImage>
#include <QObject>

#include "io/ImageWriter.h"
#include "io/session/Session.h"
#include "rendering/reference/Certificate.h"
#include "viewer/jobs/LoadJob.h"

class QMainWindow;

namespace fenestra::viewer {

class Document;
class NoticeBar;
class ViewArea;
class VolumeView;

class Verification : public QObject {
  Q_OBJECT
 public:
  struct Result {
    reference::Certificate certificate;
    QImage picture;
    io::PngText proof;
    io::PngText fidelity;  ///< see Fidelity.h
  };

  /// `session` gives the session as it stands. `window` is the dialogs' parent and owns this; all others outlive it.
  Verification(QMainWindow& window, const Document& document, ViewArea& views, NoticeBar& notices,
               std::function<io::Session()> session);

  /// Verifies the active 3-D view's picture, or else the first on screen, as soon as it is drawn at full quality; then
  /// shows the result. A running verification is dropped.
  void start();
  void cancel();
  bool isBusy() const { return awaited_ || job_.isRunning(); }
  /// Writes a picture with its certificate as text of the PNG. A failure becomes a notice.
  void write(const std::filesystem::path& png, const Result& result);
  LoadJob& job() { return job_; }

 Q_SIGNALS:
  void verified(const Result& result);

 private:
  void begin(VolumeView& view);
  void show(const Result& result);

  QMainWindow& window_;
  ViewArea& views_;
  NoticeBar& notices_;
  const std::function<io::Session()> session_;
  VolumeView* awaited_ = nullptr;  ///< the view whose picture is not yet at full quality
  LoadJob job_, writer_;
};

/// One sentence: what a certificate states.
QString statement(const reference::Certificate& certificate);

}  // namespace fenestra::viewer
