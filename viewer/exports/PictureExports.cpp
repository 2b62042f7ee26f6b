#include "viewer/exports/PictureExports.h"

#include <algorithm>
#include <numbers>

#include <QApplication>
#include <QClipboard>
#include <QMainWindow>
#include <QProcess>
#include <QProgressDialog>
#include <QStandardPaths>
#include <QStatusBar>

#include "viewer/bars/NoticeBar.h"
#include "viewer/dialogs/PictureDialog.h"
#include "viewer/exports/PictureFile.h"
#include "viewer/model/Document.h"
#include "viewer/model/Paths.h"
#include "viewer/panels/FileDialog.h"
#include "viewer/views/SliceView.h"
#include "viewer/views/ViewArea.h"

namespace fenestra::viewer {
namespace {

const QString filmEnding = QStringLiteral(".mp4");
const QString pictureEnding = QStringLiteral(".png");

QString filmProgram() { return QStandardPaths::findExecutable(QStringLiteral("ffmpeg")); }

/// NAME-0001.png, from 1.
std::filesystem::path frameFile(const std::filesystem::path& file, int number) {
  const QString digits = QStringLiteral("-%1").arg(number, 4, 10, QLatin1Char('0'));
  return file.parent_path() / (file.stem().string() + digits.toStdString() + pictureEnding.toStdString());
}

}  // namespace

struct PictureExports::Turntable {
  /// A process or dialog may be in the middle of a signal when it is dropped.
  struct Later {
    void operator()(QObject* object) const { object->deleteLater(); }
  };

  std::filesystem::path file;
  PictureMaker::Request request;
  int frames = 0, framesPerSecond = 0;
  int done = 0;
  std::vector<std::filesystem::path> written;
  std::unique_ptr<QProcess, Later> film;  ///< null for a sequence of pictures
  std::unique_ptr<QProgressDialog, Later> progress;

  bool isFilm() const { return toQString(file).endsWith(filmEnding, Qt::CaseInsensitive); }
  /// A film is written here first.
  std::filesystem::path part() const {
    return file.parent_path() / (file.stem().string() + ".part" + filmEnding.toStdString());
  }
};

PictureExports::PictureExports(QMainWindow& window, const Document& document, ViewArea& views, NoticeBar& notices)
    : QObject(&window), window_(window), views_(views), notices_(notices), maker_(views) {
  connect(&maker_, &PictureMaker::made, this, &PictureExports::made);
  connect(&maker_, &PictureMaker::failed, this, &PictureExports::fail);
  connect(&writer_, &LoadJob::failed, this, &PictureExports::fail);
  // Both studies on the graphics card at once may not fit.
  connect(&document, &Document::volumeChanged, this, &PictureExports::cancel);
}

PictureExports::~PictureExports() { cancel(); }

bool PictureExports::isBusy() const { return turntable_ || maker_.isMaking() || writer_.isRunning(); }

bool PictureExports::canWriteFilms() { return !filmProgram().isEmpty(); }

void PictureExports::choosePicture() {
  PictureDialog dialog(PictureDialog::What::Picture, views_, maker_, &window_);
  if (dialog.exec() != QDialog::Accepted) return;
  if (const auto file = askForNewFile(&window_, tr("Save a picture"), {{tr("PNG"), pictureEnding}}))
    writePicture(file->path, dialog.request());
}

void PictureExports::chooseTurntable() {
  const auto& volumes = views_.volumeViews();
  if (std::none_of(volumes.begin(), volumes.end(), [](const VolumeView* view) { return view->isVisible(); })) {
    notices_.add(NoticeBar::Kind::Warning, NoticeBar::Subject::Writing,
                 tr("No 3-D view is on screen that could turn."));
    return;
  }
  PictureDialog dialog(PictureDialog::What::Turntable, views_, maker_, &window_);
  if (dialog.exec() != QDialog::Accepted) return;
  QList<FileKind> kinds{{tr("PNG, one for each picture"), pictureEnding}};
  if (canWriteFilms()) kinds.prepend({tr("MP4 film"), filmEnding});
  if (const auto file = askForNewFile(&window_, tr("Save a turntable"), kinds))
    writeTurntable(file->path, dialog.request(), dialog.frames(), dialog.framesPerSecond());
}

void PictureExports::copyPicture() {
  cancel();
  PictureMaker::Request request{.scale = window_.devicePixelRatioF()};
  if (auto* volume = qobject_cast<VolumeView*>(views_.activeView())) request.volumes = {volume};
  if (auto* slice = qobject_cast<SliceView*>(views_.activeView())) request.slices = {slice};
  maker_.start(request);
}

void PictureExports::writePicture(const std::filesystem::path& png, const PictureMaker::Request& request) {
  cancel();
  png_ = png;
  window_.statusBar()->showMessage(tr("Drawing %1…").arg(toQString(png.filename())));
  maker_.start(request);
}

void PictureExports::writeTurntable(const std::filesystem::path& file, const PictureMaker::Request& request, int frames,
                                    int framesPerSecond) {
  cancel();
  // The dialog asked about NAME.png only, and a cancelled turntable removes the files that it has written.
  if (toQString(file).endsWith(pictureEnding, Qt::CaseInsensitive))
    for (int number = 1; number <= frames; ++number)
      if (const std::filesystem::path frame = frameFile(file, number); std::filesystem::exists(frame)) {
        notices_.add(NoticeBar::Kind::Warning, NoticeBar::Subject::Writing,
                     tr("%1 exists already: choose another name, or delete the pictures of an earlier turntable.")
                         .arg(toQString(frame.filename())));
        return;
      }
  turntable_ = std::make_unique<Turntable>();
  turntable_->file = file;
  turntable_->request = request;
  turntable_->frames = frames;
  turntable_->framesPerSecond = framesPerSecond;
  turntable_->progress.reset(
      new QProgressDialog(tr("Drawing %1…").arg(toQString(file.filename())), tr("Cancel"), 0, frames, &window_));
  turntable_->progress->setMinimumDuration(0);
  turntable_->progress->setAutoReset(false);
  connect(turntable_->progress.get(), &QProgressDialog::canceled, this, &PictureExports::cancel, Qt::QueuedConnection);
  turntable_->progress->setValue(0);
  nextFrame();
}

void PictureExports::cancel() {
  maker_.cancel();
  png_.clear();
  const std::unique_ptr<Turntable> dropped = std::move(turntable_);
  if (!dropped) return;
  writer_.cancel();
  if (dropped->film) {
    dropped->film->disconnect(this);
    dropped->film->kill();
    dropped->film->waitForFinished();
    dropped->written.push_back(dropped->part());
  }
  dropped->progress->disconnect(this);
  dropped->progress->hide();
  std::error_code ignored;
  for (const std::filesystem::path& file : dropped->written) std::filesystem::remove(file, ignored);
}

void PictureExports::fail(const QString& problem) {
  cancel();
  window_.statusBar()->clearMessage();
  notices_.addError(NoticeBar::Subject::Writing, problem);
}

void PictureExports::tellWritten(const std::filesystem::path& path) {
  constexpr int milliseconds = 8000;
  notices_.end(NoticeBar::Subject::Writing);
  window_.statusBar()->showMessage(tr("Wrote %1").arg(toQString(path.filename())), milliseconds);
}

void PictureExports::made(const QImage& picture) {
  if (turntable_ && turntable_->isFilm()) {
    if (!turntable_->film) startFilm(picture.size());
    const QImage rgb = picture.convertToFormat(QImage::Format_RGB888);
    for (int y = 0; y < rgb.height(); ++y)
      turntable_->film->write(reinterpret_cast<const char*>(rgb.constScanLine(y)), 3 * rgb.width());
    frameWritten();
    return;
  }
  const std::filesystem::path path = turntable_ ? frameFile(turntable_->file, turntable_->done + 1) : png_;
  if (path.empty()) {
    QApplication::clipboard()->setImage(picture);
    constexpr int milliseconds = 4000;
    window_.statusBar()->showMessage(tr("Copied the picture"), milliseconds);
    return;
  }
  if (turntable_) turntable_->written.push_back(path);
  const io::PngText texts = textOf(maker_.fidelity());
  writer_.start([this, path, picture, texts](const io::Progress& progress) -> LoadJob::Show {
    writePng(picture, path, {texts});
    if (!progress(1.0, {})) {
      std::filesystem::remove(path);
      throw io::Cancelled();
    }
    return [this, path] {
      if (turntable_)
        frameWritten();
      else
        tellWritten(path);
    };
  });
}

void PictureExports::nextFrame() {
  PictureMaker::Request request = turntable_->request;
  request.turn = 2.0 * std::numbers::pi * turntable_->done / turntable_->frames;
  maker_.start(request);
}

void PictureExports::frameWritten() {
  turntable_->progress->setValue(++turntable_->done);
  if (turntable_->done < turntable_->frames) {
    nextFrame();
  } else if (turntable_->film) {
    turntable_->film->closeWriteChannel();
  } else {
    tellWritten(frameFile(turntable_->file, turntable_->frames));
    turntable_.reset();
  }
}

void PictureExports::startFilm(QSize size) {
  turntable_->film.reset(new QProcess);
  QProcess& film = *turntable_->film;
  connect(&film, &QProcess::finished, this, &PictureExports::filmEnded);
  // From the event loop: a process must not be deleted while it emits.
  connect(
      &film, &QProcess::errorOccurred, this,
      [this](QProcess::ProcessError error) {
        if (turntable_ && error == QProcess::FailedToStart) fail(tr("ffmpeg cannot be started; save PNGs instead."));
      },
      Qt::QueuedConnection);
  // H.264 in a form that every player shows has even sides: an odd one gains a black line.
  film.start(filmProgram(),
             {QStringLiteral("-loglevel"), QStringLiteral("error"), QStringLiteral("-y"), QStringLiteral("-f"),
              QStringLiteral("rawvideo"), QStringLiteral("-pix_fmt"), QStringLiteral("rgb24"), QStringLiteral("-s"),
              QStringLiteral("%1x%2").arg(size.width()).arg(size.height()), QStringLiteral("-r"),
              QString::number(turntable_->framesPerSecond), QStringLiteral("-i"), QStringLiteral("-"),
              QStringLiteral("-vf"), QStringLiteral("pad=ceil(iw/2)*2:ceil(ih/2)*2"), QStringLiteral("-pix_fmt"),
              QStringLiteral("yuv420p"), toQString(turntable_->part())});
}

void PictureExports::filmEnded(int exitCode) {
  const QString problem = QString::fromUtf8(turntable_->film->readAllStandardError()).trimmed();
  if (exitCode != 0 || turntable_->done < turntable_->frames) {
    fail(tr("ffmpeg could not write %1: %2").arg(toQString(turntable_->file), problem.section(QLatin1Char('\n'), -1)));
    return;
  }
  std::error_code error;
  std::filesystem::rename(turntable_->part(), turntable_->file, error);
  if (error) {
    fail(tr("%1 cannot be written: %2").arg(toQString(turntable_->file), QString::fromStdString(error.message())));
    return;
  }
  tellWritten(turntable_->file);
  turntable_.reset();
}

}  // namespace fenestra::viewer
