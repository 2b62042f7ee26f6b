#include "viewer/files/FileOpener.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>

#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QTimer>
#include <QUrl>

#include "io/base/SessionName.h"
#include "io/study/Interpret.h"
#include "io/study/ReadStudy.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/bars/StudyDialogs.h"
#include "viewer/dialogs/SpacingDialog.h"
#include "viewer/files/Sessions.h"
#include "viewer/model/Paths.h"
#include "viewer/model/SettingOwners.h"
#include "viewer/model/WayOutText.h"
#include "viewer/model/Workspace.h"
#include "viewer/panels/FileDialog.h"

namespace fenestra::viewer {
namespace {

/// The single-file formats in a file dialog's filter.
QString volumePatterns() {
  QStringList patterns;
  for (const std::string_view ending : io::volumeEndings)
    patterns << QStringLiteral("*") + QLatin1String(ending.data(), static_cast<qsizetype>(ending.size()));
  patterns << QStringLiteral("*.tif") << QStringLiteral("*.tiff");
  return patterns.join(QLatin1Char(' '));
}

}  // namespace

FileOpener::FileOpener(QWidget& window, Workspace& workspace, StudyLoader& loader, Sessions& sessions,
                       NoticeBar& notices)
    : QObject(&window),
      window_(window),
      document_(workspace.document),
      preferences_(workspace.preferences),
      cameras_(workspace.cameras),
      loader_(loader),
      sessions_(sessions),
      notices_(notices) {}

StudyLoader::Reader FileOpener::readerOf(const io::DataRequest& data) const {
  io::StudyRequest request;
  static_cast<io::DataRequest&>(request) = data;
  request.look = preferences_.startingLook(request.look);
  request.projection = cameras_.projection();
  return [request, chosen = chosenLook_](const io::Progress& progress) {
    io::Study study = io::readStudy(request, progress);
    if (chosen) startIn(study, *chosen);
    return study;
  };
}

void FileOpener::setChosenLook(const io::LookPreset* preset) {
  chosenLook_ = preset ? std::optional(*preset) : std::nullopt;
}

void FileOpener::open(const std::vector<std::filesystem::path>& paths) {
  if (!sessions_.mayGo()) return;
  if (paths.size() == 1 && io::isSession(paths.front())) {
    sessions_.open(paths.front());
    return;
  }
  try {
    load(io::interpret(paths));
  } catch (const io::Error& error) {
    notices_.addError(NoticeBar::Subject::Opening, windowText(error));
  }
}

void FileOpener::openSeries(const std::string& series) { openSeriesOf(document_.study(), series); }

void FileOpener::openSeriesOf(const io::Study& study, const std::string& series) {
  io::DataRequest chosen;
  chosen.path = study.session.volume.path;
  chosen.series = series;
  chosen.spacing = study.session.volume.spacing;
  if (!sessions_.mayGo()) return;
  load(chosen);
}

void FileOpener::load(const io::DataRequest& data) {
  loader_.open(readerOf(data), {}, [this, data](const io::SpacingMissing& missing) {
    io::DataRequest sized = data;
    sized.spacing = sessions_.questions().voxelSize(missing);
    if (sized.spacing) load(sized);
  });
}

void FileOpener::drop(const std::vector<std::filesystem::path>& paths, QPoint at) {
  if (!document_.hasVolume() || paths.size() > 1 || io::isSession(paths.front()) || !io::mayBeLabels(paths.front())) {
    open(paths);
    return;
  }
  // Asked from the event loop: the program that the file was dragged from waits until the drop has ended.
  QTimer::singleShot(0, this, [this, path = paths.front(), at] {
    QMenu menu;
    connect(menu.addAction(tr("Open as volume")), &QAction::triggered, this, [this, path] { open({path}); });
    connect(menu.addAction(tr("Open as labels of this volume")), &QAction::triggered, this,
            [this, path] { loader_.openLabels(path); });
    menu.exec(at);
  });
}

std::optional<std::filesystem::path> FileOpener::askForVolume() {
  const QString kinds = tr("Volumes (*.dcm %1);;All files (*)").arg(volumePatterns());
  return askForFile(&window_, {tr("Open a volume"), kinds});
}

void FileOpener::chooseFile() {
  if (const auto file = askForVolume()) open({*file});
}

void FileOpener::chooseFileBeside() {
  if (const auto file = askForVolume()) Q_EMIT besideWanted({*file});
}

void FileOpener::chooseFolderBeside() {
  if (const auto folder = askForFolder(&window_, {tr("Open a DICOM folder")})) Q_EMIT besideWanted({*folder});
}

void FileOpener::chooseFolder() {
  if (const auto folder = askForFolder(&window_, {tr("Open a DICOM folder")})) open({*folder});
}

void FileOpener::chooseLabels() {
  const QString kinds = tr("Label maps (*.dcm %1);;All files (*)").arg(volumePatterns());
  if (const auto file = askForFile(&window_, {tr("Open a label map"), kinds})) loader_.openLabels(*file);
}

void FileOpener::chooseMaskFolder() {
  if (const auto folder = askForFolder(&window_, {tr("Open a folder of masks")})) loader_.openLabels(*folder);
}

void FileOpener::chooseLabelTable() {
  const QString kinds = tr("Tables of labels (*.txt *.tsv *.csv *.label *.ctbl *.lut);;All files (*)");
  if (const auto file = askForFile(&window_, {tr("Open a table of labels"), kinds}))
    loader_.openLabels(document_.study().session.labels.path, *file);
}

void FileOpener::chooseVoxelSize() {
  SpacingDialog ask(tr("How large the voxels are:"), &window_, document_.scene().volume->grid.spacing);
  markAsStudyDialog(ask);
  if (ask.exec() != QDialog::Accepted || !sessions_.mayGo()) return;
  const io::Study& study = document_.study();
  io::DataRequest chosen;
  chosen.path = study.session.volume.path;
  chosen.series = study.series.id;
  chosen.spacing = ask.spacing();
  load(chosen);
}

void FileOpener::openNeighbour(int step) {
  const io::Study& study = document_.study();
  std::vector<const io::SeriesInfo*> all{&study.series};
  for (const io::SeriesInfo& other : study.otherSeries) all.push_back(&other);
  // Those without a number last, each in an order that does not depend on which one is open.
  const auto place = [](const io::SeriesInfo* series) {
    return std::tuple(series->study, series->number.value_or(std::numeric_limits<int>::max()), series->id);
  };
  std::sort(all.begin(), all.end(), [&](const auto* one, const auto* other) { return place(one) < place(other); });
  const auto count = static_cast<std::ptrdiff_t>(all.size());
  const std::ptrdiff_t now = std::find(all.begin(), all.end(), &study.series) - all.begin();
  if (count > 1) openSeries(std::string(all[static_cast<std::size_t>((now + step + count) % count)]->id));
}

std::vector<std::filesystem::path> localPaths(const QMimeData& data) {
  std::vector<std::filesystem::path> paths;
  for (const QUrl& url : data.urls())
    if (url.isLocalFile()) paths.push_back(toPath(url.toLocalFile()));
  return paths;
}

}  // namespace fenestra::viewer
