#include "viewer/exports/Verification.h"

#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QClipboard>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>

#include "io/study/PictureProof.h"
#include "io/study/SessionData.h"
#include "rendering/volume/Threads.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/bars/StudyDialogs.h"
#include "viewer/exports/PictureFile.h"
#include "viewer/model/Document.h"
#include "viewer/model/Paths.h"
#include "viewer/panels/FileDialog.h"
#include "viewer/views/ViewArea.h"
#include "viewer/views/VolumeView.h"

namespace fenestra::viewer {
namespace {

reference::Certificate certified(const FinishedPicture& picture, const io::Progress& progress) try {
  const Interruptible work([&progress] { return progress(0.0, {}); });
  return reference::certify(picture.pixels, picture.scene, picture.view, {.within = errorBound(picture.view)});
} catch (const Interrupted&) {
  throw io::Cancelled();
}

/// The text below the statement.
QString detailsOf(const reference::Certificate& certificate) {
  const QLocale locale;
  return Verification::tr(
             "Computed again in double precision: %1 pixels, drawn at random (seed %2). Beyond that: %3. "
             "Greatest difference: %4/255.")
      .arg(locale.toString(certificate.pixels), QString::number(certificate.seed),
           locale.toString(certificate.exceeding), locale.toString(certificate.greatest, 'g', 3));
}

}  // namespace

QString statement(const reference::Certificate& certificate) {
  const QLocale locale;
  // Rounded down, so that the statement stays true.
  const QString share = locale.toString(std::floor(certificate.share * 1e4 + 1e-9) / 100.0);
  const QString within = locale.toString(certificate.within);
  if (certificate.confidence >= 1.0)
    return Verification::tr("%1 % of the pixels are within %2/255 of the exact picture: all were computed again.")
        .arg(share, within);
  return Verification::tr("At least %1 % of the pixels are within %2/255 of the exact picture, with %3 % confidence.")
      .arg(share, within, locale.toString(100.0 * certificate.confidence));
}

Verification::Verification(QMainWindow& window, const Document& document, ViewArea& views, NoticeBar& notices,
                           std::function<io::Session()> session)
    : QObject(&window), window_(window), views_(views), notices_(notices), session_(std::move(session)) {
  for (LoadJob* job : {&job_, &writer_})
    connect(job, &LoadJob::failed, this,
            [this](const QString& problem) { notices_.addError(NoticeBar::Subject::Verifying, problem); });
  connect(&document, &Document::volumeChanged, this, &Verification::cancel);
  for (VolumeView* view : views.volumeViews())
    connect(view, &VolumeView::settled, this, [this, view] {
      if (view == awaited_) begin(*view);
    });
}

void Verification::start() {
  cancel();
  const auto& volumes = views_.volumeViews();
  const auto isSeen = [](const VolumeView* view) { return view->isVisible(); };
  auto* view = qobject_cast<VolumeView*>(views_.activeView());
  if (!view || !isSeen(view)) {
    const auto first = std::find_if(volumes.begin(), volumes.end(), isSeen);
    view = first != volumes.end() ? *first : nullptr;
  }
  if (!view || !view->problem().isEmpty()) {
    notices_.add(NoticeBar::Kind::Warning, NoticeBar::Subject::Verifying,
                 tr("No 3-D view is on screen that could be verified."));
    return;
  }
  awaited_ = view;
  if (view->isSettled())
    begin(*view);
  else
    window_.statusBar()->showMessage(tr("The picture is verified once it is drawn at full quality."), 4000);
}

void Verification::cancel() {
  awaited_ = nullptr;
  job_.cancel();
}

void Verification::begin(VolumeView& view) {
  const std::optional<FinishedPicture> picture = view.finishedPicture();
  if (!picture) return;  // it changes again
  awaited_ = nullptr;
  job_.start([this, &view, picture = *picture, fidelity = textOf(linesOf(view.fidelity())),
              session = session_()](const io::Progress& progress) mutable -> LoadJob::Show {
    Result result{certified(picture, progress), picture.image, {}, fidelity};
    io::noteContents(session, progress);
    result.proof = io::proofOf(result.certificate, std::move(session));
    return [this, &view, shown = picture.view, result = std::move(result)] {
      // It may have changed meanwhile.
      if (const auto now = view.finishedPicture(); now && now->view == shown)
        view.noteVerified(statement(result.certificate));
      show(result);
    };
  });
}

void Verification::show(const Result& result) {
  notices_.end(NoticeBar::Subject::Verifying);
  auto* box = new QMessageBox(QMessageBox::NoIcon, tr("Verify this picture"), statement(result.certificate),
                              QMessageBox::Close, &window_);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setModal(false);
  markAsStudyDialog(*box);
  box->setInformativeText(detailsOf(result.certificate));
  box->setTextInteractionFlags(Qt::TextSelectableByMouse);
  const QPushButton* save = box->addButton(tr("&Save the picture…"), QMessageBox::AcceptRole);
  connect(save, &QPushButton::clicked, this, [this, result] {
    const std::optional<NewFile> file =
        askForNewFile(&window_, tr("Save the picture with its certificate"), {{tr("PNG"), QStringLiteral(".png")}});
    if (file) write(file->path, result);
  });
  const QPushButton* copy = box->addButton(tr("&Copy"), QMessageBox::AcceptRole);
  connect(copy, &QPushButton::clicked, this, [result] {
    QApplication::clipboard()->setText(statement(result.certificate) + QLatin1Char('\n') +
                                       detailsOf(result.certificate));
  });
  box->show();
  Q_EMIT verified(result);
}

void Verification::write(const std::filesystem::path& png, const Result& result) {
  writer_.start([this, png, result](const io::Progress&) -> LoadJob::Show {
    writePng(result.picture, png, {result.proof, result.fidelity});
    return [this, png] { window_.statusBar()->showMessage(tr("Wrote %1").arg(toQString(png.filename())), 8000); };
  });
}

}  // namespace fenestra::viewer
