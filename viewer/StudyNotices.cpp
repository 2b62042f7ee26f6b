#include "viewer/StudyNotices.h"

#include <algorithm>
#include <vector>

#include <QMainWindow>
#include <QMenu>
#include <QStatusBar>
#include <QTimer>

#include "viewer/actions/SegmentationMenu.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/files/FileOpener.h"
#include "viewer/files/Sessions.h"
#include "viewer/jobs/StudyLoader.h"
#include "viewer/model/Translation.h"
#include "viewer/model/WayOutText.h"
#include "viewer/model/Workspace.h"

namespace fenestra::viewer {
namespace {

constexpr int recognisedMilliseconds = 10000;  ///< how long the status bar shows a remark

QString describe(const io::SeriesInfo& series) {
  return QStringLiteral("%1 %2×%3×%4")
      .arg(QString::fromStdString(series.modality))
      .arg(series.dims.x)
      .arg(series.dims.y)
      .arg(series.dims.z)
      .trimmed();
}

}  // namespace

StudyNotices::StudyNotices(QMainWindow& window, Workspace& workspace, StudyLoader& loader, FileOpener& files,
                           Sessions& sessions, NoticeBar& notices)
    : QObject(&window),
      window_(window),
      workspace_(workspace),
      loader_(loader),
      files_(files),
      sessions_(sessions),
      notices_(notices) {}

void StudyNotices::show() {
  warn();
  offerSegmentations();
  offerSeries();
}

void StudyNotices::offerSeries() {
  const io::Study& study = workspace_.document.study();
  if (study.otherSeries.empty() || study.restoresSession) return;
  const int count = static_cast<int>(study.otherSeries.size()) + 1;
  QStringList open{describe(study.series)};
  if (!study.reason.empty()) open << translated(study.reason);
  const QString text =
      study.series.times > 1
          ? tr("There are %n time points here; this is number %1.", nullptr, study.series.times).arg(study.series.time)
          : tr("There are %n series here; open is %1.", nullptr, count).arg(open.join(QStringLiteral(", ")));
  notices_.add(NoticeBar::Kind::Offer, NoticeBar::Subject::Study, text,
               {{tr("Choose…"), [this] { files_.chooseSeries(); }}});
}

void StudyNotices::offerSegmentations() {
  const io::Study& study = workspace_.document.study();
  if (study.segmentations.empty() || workspace_.document.labels()) return;
  if (study.segmentations.size() == 1) {
    const io::SegmentationInfo& only = study.segmentations.front();
    const QString text = tr("A segmentation of this series lies beside it: %1.");
    notices_.add(NoticeBar::Kind::Offer, NoticeBar::Subject::Segmentations,
                 text.arg(titleOf(only, SegmentationTitle::Full)),
                 {{tr("Open"), [this, file = only.file] { loader_.openLabels(file); }}},
                 text.arg(titleOf(only, SegmentationTitle::Nameless)));
    return;
  }
  notices_.add(
      NoticeBar::Kind::Offer, NoticeBar::Subject::Segmentations,
      tr("%n segmentations of this series lie beside it.", nullptr, static_cast<int>(study.segmentations.size())),
      {{tr("Choose…"), [this] {
          // From the event loop: the notice may be gone while the menu is open.
          QTimer::singleShot(0, this, [this] {
            QMenu menu;
            fillSegmentationMenu(
                menu, workspace_.document.study().segmentations,
                workspace_.options.hidesPatient() ? SegmentationTitle::Nameless : SegmentationTitle::Full, loader_);
            menu.exec(QCursor::pos());
          });
        }}});
}

void StudyNotices::warn() {
  const io::Study& study = workspace_.document.study();
  std::vector<io::Warning> warnings;
  for (const io::Warning& warning : study.warnings) {
    const bool isInReport =
        study.geometry && std::find(study.geometry->findings.begin(), study.geometry->findings.end(), warning) !=
                              study.geometry->findings.end();
    if (!isInReport) warnings.push_back(warning);
  }
  // Recognised data is no problem, so the status bar shows it, and no notice takes room from the pictures.
  for (const io::Warning& warning : warnings)
    if (warning.kind == io::Warning::Kind::Recognised)
      window_.statusBar()->showMessage(windowText(warning), recognisedMilliseconds);
  std::erase_if(warnings, [](const auto& warning) { return warning.kind == io::Warning::Kind::Recognised; });
  notices_.addWarnings(warnings);
  if (study.geometry)
    notices_.addGeometry(*study.geometry, [this](io::Regularise choice) { sessions_.regularise(choice); });
}

}  // namespace fenestra::viewer
