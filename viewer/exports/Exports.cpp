#include "viewer/exports/Exports.h"

#include <QMainWindow>
#include <QStatusBar>

#include "io/LabelWriter.h"
#include "io/base/AtomicFile.h"
#include "rendering/segmentation/Mask.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/model/Document.h"
#include "viewer/model/MeasureText.h"
#include "viewer/model/Paths.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/panels/FileDialog.h"

namespace fenestra::viewer {

Exports::Exports(QMainWindow& window, const Document& document, const ViewOptions& options, NoticeBar& notices)
    : QObject(&window), window_(window), document_(document), options_(options), notices_(notices) {
  connect(&job_, &LoadJob::failed, this,
          [this](const QString& message) { notices_.addError(NoticeBar::Subject::Writing, message); });
}

bool Exports::canWriteLabels(Labels which) const {
  if (which == Labels::Focus && document_.region()) return document_.isWhole();
  return document_.hasVolume() && document_.labels() &&
         (which == Labels::All || std::holds_alternative<LabelFocus>(document_.focus()));
}

bool Exports::canWriteSurface() const {
  return document_.hasVolume() && !document_.awaitsGrowth() &&
         !std::holds_alternative<std::monostate>(document_.focus());
}

bool Exports::canWriteMeasures() const { return document_.hasVolume() && !document_.measures().empty(); }

void Exports::chooseLabelFile(Labels which) {
  const QList<FileKind> kinds{{tr("NRRD, with names and colours"), QStringLiteral(".nrrd")},
                              {tr("DICOM segmentation, with names and colours"), QStringLiteral(".dcm")},
                              {tr("NIfTI"), QStringLiteral(".nii.gz")},
                              {tr("MetaImage"), QStringLiteral(".mha")}};
  const QString title = which == Labels::All ? tr("Export all labels") : tr("Export the focus as labels");
  if (const auto file = askForNewFile(&window_, title, kinds)) writeLabels(file->path, which);
}

void Exports::chooseSurfaceFile() {
  QList<FileKind> kinds;
  for (const QString& axes : {QStringLiteral("LPS"), QStringLiteral("RAS")})
    for (const QString& format : {QStringLiteral("STL"), QStringLiteral("PLY"), QStringLiteral("OBJ")})
      kinds << FileKind{tr("%1 in mm, %2 axes").arg(format, axes), QStringLiteral(".") + format.toLower()};
  if (const auto file = askForNewFile(&window_, tr("Export the focus as a surface"), kinds))
    writeSurface(file->path, file->kind < kinds.size() / 2 ? io::SurfaceFrame::Lps : io::SurfaceFrame::Ras);
}

void Exports::chooseMeasureFile() {
  const QList<FileKind> kinds{{tr("Table (CSV)"), QStringLiteral(".csv")}};
  if (const auto file = askForNewFile(&window_, tr("Export the measures"), kinds)) writeMeasures(file->path);
}

void Exports::writeMeasures(const std::filesystem::path& path) {
  if (!canWriteMeasures()) return;
  job_.start([this, path, table = measuresCsv(document_).toStdString()](const io::Progress&) {
    io::writeText(path, table);
    return written(path);
  });
}

void Exports::writeLabels(const std::filesystem::path& path, Labels which) {
  if (!canWriteLabels(which)) return;
  io::LabelOutput output;
  const bool region = which == Labels::Focus && document_.region();
  if (which == Labels::Focus && !region) output.only = std::get<LabelFocus>(document_.focus()).labels;
  output.series = document_.study().series.files;
  output.namesPatient = !options_.hidesPatient();
  job_.start([this, path, output, scene = document_.scene(), region, all = document_.labels(),
              name = tr("Region").toStdString()](const io::Progress& progress) {
    // A region in focus is one label, whatever the number of its steps.
    const auto labels = region ? segmentation::focusLabel(scene, {1, name, segmentation::regionColour}) : all;
    io::writeLabels(*labels, path, output, progress);
    return written(path);
  });
}

void Exports::writeSurface(const std::filesystem::path& path, io::SurfaceFrame frame) {
  if (!canWriteSurface()) return;
  job_.start([this, path, frame, scene = document_.scene()](const io::Progress& progress) {
    io::writeSurface(io::extractSurface(scene, path, {}, progress), path, frame);
    return written(path);
  });
}

LoadJob::Show Exports::written(const std::filesystem::path& path) {
  return [this, path] {
    constexpr int milliseconds = 8000;
    notices_.end(NoticeBar::Subject::Writing);
    window_.statusBar()->showMessage(tr("Wrote %1").arg(toQString(path.filename())), milliseconds);
  };
}

}  // namespace fenestra::viewer
