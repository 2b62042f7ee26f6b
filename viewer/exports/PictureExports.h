#pragma once
// Pictures of the views to files and the clipboard, and turntables: pictures of a full turn, as a sequence of PNGs or,
// where the program ffmpeg is installed, as a film. Drawn a little at a time; the window answers meanwhile.

#include <filesystem>
#include <memory>

#include <QObject>

#include "viewer/jobs/LoadJob.h"
#include "viewer/views/PictureMaker.h"

class QMainWindow;

namespace fenestra::viewer {

class Document;
class NoticeBar;
class ViewArea;

class PictureExports : public QObject {
  Q_OBJECT
 public:
  /// `window` is the dialogs' parent, shows in its status bar what was written, and owns this; all others outlive it.
  PictureExports(QMainWindow& window, const Document& document, ViewArea& views, NoticeBar& notices);
  ~PictureExports() override;

  /// Ask for views, size and file.
  void choosePicture();
  void chooseTurntable();
  /// Copies the active view as it is on screen.
  void copyPicture();

  /// Failures become notices, and leave no file. A running export is dropped first.
  void writePicture(const std::filesystem::path& png, const PictureMaker::Request& request);
  /// `file` is a film with the ending .mp4; or names the pictures: NAME.png gives NAME-0001.png and so on. Nothing is
  /// written where one of these exists already.
  void writeTurntable(const std::filesystem::path& file, const PictureMaker::Request& request, int frames,
                      int framesPerSecond);
  void cancel();
  bool isBusy() const;
  static bool canWriteFilms();

 private:
  struct Turntable;

  void made(const QImage& picture);
  void nextFrame();
  void frameWritten();
  void startFilm(QSize size);
  void filmEnded(int exitCode);
  void fail(const QString& problem);
  void tellWritten(const std::filesystem::path& path);

  QMainWindow& window_;
  ViewArea& views_;
  NoticeBar& notices_;
  PictureMaker maker_;
  LoadJob writer_;             ///< writes PNG files
  std::filesystem::path png_;  ///< the file of the picture being made
  std::unique_ptr<Turntable> turntable_;
};

}  // namespace fenestra::viewer
