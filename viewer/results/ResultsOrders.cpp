// What can be written of the study as it is now, and what is written.

#include <algorithm>
#include <set>

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>

#include "viewer/archive/CommitQuestion.h"
#include "viewer/archive/Conversation.h"
#include "viewer/archive/SentAnswers.h"
#include "viewer/model/Document.h"
#include "viewer/model/Paths.h"
#include "viewer/model/PatientLines.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/results/ResultsDialog.h"
#include "viewer/views/ViewArea.h"

namespace fenestra::viewer {
namespace {

constexpr int axisOfScan = 2;  ///< of the volume: its slices are counted along it

}  // namespace

QString ResultsDialog::problemOfDicom() const {
  const io::Study& study = parts_.document.study();
  if (study.format == "DICOM" && !study.series.files.empty()) return {};
  return tr("This study is not from DICOM files, so there is no DICOM study that this could belong to.");
}

QString ResultsDialog::problemOfFocus() const {
  const Document& document = parts_.document;
  if (std::holds_alternative<std::monostate>(document.focus())) return tr("Nothing is in focus.");
  if (document.region() && (!document.isWhole() || !document.showsGrowth()))
    return tr("The region in focus is not complete yet.");
  return {};
}

QString ResultsDialog::problemOfKeys() const {
  const Document& document = parts_.document;
  const io::Study& study = document.study();
  if (const QString problem = problemOfDicom(); !problem.isEmpty()) return problem;
  if (study.slices.empty()) return tr("This series was read from an archive file. Unpack it and open the folder.");
  const auto planes = static_cast<std::size_t>(study.scene.volume->grid.dims[axisOfScan]);
  if (study.slices.size() != planes || (study.geometry && study.geometry->applied != io::Regularise::Off))
    return tr("The slices of this series do not lie evenly: what is shown is interpolated between them.");
  if (document.keyImages().empty()) return tr("There are no key images (View → Keep a key image).");
  if (keySlices().empty()) return tr("The crosshair of no key image lies in the volume.");
  return {};
}

std::vector<int> ResultsDialog::keySlices() const {
  std::set<int> slices;
  for (const io::KeyImage& image : parts_.document.keyImages())
    if (const auto voxel = parts_.document.voxelAt(image.crosshair)) slices.insert((*voxel)[axisOfScan]);
  return {slices.begin(), slices.end()};
}

QString ResultsDialog::keyText() const {
  QStringList names;
  for (const io::KeyImage& image : parts_.document.keyImages())
    if (parts_.document.voxelAt(image.crosshair)) names << QString::fromStdString(image.name);
  const QString all = names.join(QStringLiteral("; "));
  return description_->text().isEmpty() ? all : description_->text() + QStringLiteral(": ") + all;
}

void ResultsDialog::refresh() {
  const Document& document = parts_.document;
  if (!document.hasVolume()) return;
  const QString notDicom = problemOfDicom();
  const auto& drawn = document.measures();
  const bool hasMeasures =
      std::any_of(drawn.begin(), drawn.end(), [](const Measure& each) { return !isMark(each.kind); });
  offer(measures_, !notDicom.isEmpty()                           ? notDicom
                   : hasMeasures || document.labels() != nullptr ? QString()
                                                                 : tr("There are neither measures nor labels."));
  offer(labels_, document.labels() ? QString() : tr("There are no labels."));
  offer(focus_, problemOfFocus());
  offer(picture_, pictures_.empty() ? tr("No view is on screen.") : QString());
  const QString keyProblem = problemOfKeys();
  offer(keys_, keyProblem);
  keys_.box->setText(keyProblem.isEmpty() ? tr("Slices of the key images: %1").arg(keySlices().size())
                                          : tr("Slices of the key images"));
  offer(folder_, {});
  offer(archive_, !notDicom.isEmpty()
                      ? tr("This study is not from DICOM files, and archives file by patient and study.")
                  : servers_->count() == 0 ? tr("No server is entered yet (View → Archive).")
                                           : QString());
  enable();
}

PictureMaker::Request ResultsDialog::pictureRequest() const {
  PictureMaker::Request request = pictures_.at(static_cast<std::size_t>(views_->currentIndex())).views;
  request.scale = devicePixelRatioF();
  request.causes = true;  // a file has no tool tip
  return request;
}

bool ResultsDialog::picturesPatient(const PictureMaker::Request& request) const {
  const io::Study& study = parts_.document.study();
  const auto shows = [](const auto& views) {
    return std::any_of(views.begin(), views.end(), [](const auto* view) { return view->showsText(); });
  };
  return !parts_.options.hidesPatient() && (shows(request.volumes) || shows(request.slices)) &&
         !patientLines(study.patient, study.series).isEmpty();
}

ResultsOrder ResultsDialog::order() const {
  const Document& document = parts_.document;
  ResultsOrder order;
  order.source = io::resultSourceOf(document.study(), document.study().session.volume.path);
  order.source.measures = document.measures();
  order.description = description_->text().simplified();
  order.measures = measures_.box->isChecked();
  order.labels = labels_.box->isChecked();
  order.focus = focus_.box->isChecked();
  if (const auto* labels = std::get_if<LabelFocus>(&document.focus())) order.focusLabels = labels->labels;
  order.scene = document.scene();
  order.focusName = document.region() ? tr("Region") : tr("Values");
  if (const auto* values = std::get_if<ValueFocus>(&document.focus()))
    order.focusName = tr("Values %1 to %2 %3")
                          .arg(QLocale().toString(values->values.low), QLocale().toString(values->values.high),
                               QString::fromStdString(document.scene().volume->unit))
                          .trimmed();
  if (keys_.box->isChecked()) {
    order.keySlices = keySlices();
    order.keyText = keyText();
  }
  if (folder_.box->isChecked()) order.folder = toPath(QDir::fromNativeSeparators(path_->text()));
  return order;
}

void ResultsDialog::save() {
  if (isBusy() || !save_->isEnabled()) return;
  ResultsOrder wanted = order();
  if (archive_.box->isChecked()) {
    const ServerEntry* entry = parts_.archives.find(servers_->currentData().toString());
    const std::optional<AnyServer> reached = entry ? parts_.archives.reach(*entry) : std::nullopt;
    if (!reached) return;
    const Conversation talk(parts_.archives, entry->id, *reached);
    wanted.send = [talk](const auto& files, const auto& progress) {
      return talk.run([&](const auto& server) { return io::archive::send(server, files, progress); });
    };
    if (commits_->isEnabled() && commits_->isChecked())
      wanted.commit = [talk](const auto& sent, auto& commitments, const auto& progress) {
        return askToCommit(talk, sent, commitments, progress);
      };
  }
  isTold_ = false;
  answers_->clear();
  answers_->hide();
  progress_->setValue(0);
  progress_->show();
  if (!picture_.box->isChecked()) return start(std::move(wanted));
  waiting_ = std::move(wanted);
  const PictureMaker::Request request = pictureRequest();
  waiting_.pictureNamesPatient = picturesPatient(request);
  status_->setText(tr("Drawing the picture…"));
  maker_.start(request);
  enable();
}

void ResultsDialog::start(ResultsOrder order) {
  job_.start([this, order = std::move(order)](const io::Progress& progress) -> LoadJob::Show {
    const auto outcome = std::make_shared<ResultsOutcome>(writeResults(order, progress));
    return [this, outcome] { tell(*outcome); };
  });
  enable();
}

void ResultsDialog::tell(const ResultsOutcome& outcome) {
  isTold_ = true;
  QStringList lines;
  if (!outcome.written.empty()) {
    QStringList files;
    for (const std::filesystem::path& each : outcome.written) files << toQString(each.filename());
    lines << tr("Wrote %1.").arg(files.join(QStringLiteral(", ")));
  }
  if (!outcome.sent.empty()) {
    lines << SentAnswers::summaryOf(outcome.sent);
    answers_->fill(outcome.names, outcome.sent, outcome.commitments);
    if (!outcome.commitments.empty()) lines << SentAnswers::summaryOf(outcome.sent, outcome.commitments);
    if (!outcome.commitProblem.isEmpty()) lines << tr("None is confirmed to be kept: %1").arg(outcome.commitProblem);
    answers_->setVisible(true);
  }
  if (!outcome.sendingProblem.isEmpty()) lines << tr("Nothing was sent: %1").arg(outcome.sendingProblem);
  status_->setText(lines.join(QLatin1Char('\n')));
}

}  // namespace fenestra::viewer
