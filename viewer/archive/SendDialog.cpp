#include "viewer/archive/SendDialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTemporaryDir>
#include <QVBoxLayout>

#include "io/LabelWriter.h"
#include "io/base/Reading.h"
#include "viewer/archive/CommitQuestion.h"
#include "viewer/archive/Conversation.h"
#include "viewer/archive/OutcomeRows.h"
#include "viewer/model/Document.h"
#include "viewer/model/Paths.h"

namespace fenestra::viewer {
QString SendDialog::problemOf(const Document& document) {
  if (!document.hasVolume()) return tr("Nothing is open.");
  if (document.study().format != "DICOM") return tr("What is open is not DICOM, and archives keep nothing else.");
  return {};
}

SendDialog::SendDialog(Archives& archives, const Document& document, QWidget* parent)
    : QDialog(parent), archives_(archives), document_(document) {
  setWindowTitle(tr("Send to an archive"));
  auto* form = new QFormLayout;
  addChoices(*form);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  const OutcomeRows rows = addOutcomeRows(*column, *this, tr("Send"), QStringLiteral("send"));
  progress_ = rows.progress;
  status_ = rows.status;
  answers_ = rows.answers;
  send_ = rows.start;
  send_->setObjectName(QStringLiteral("sendNow"));
  connect(send_, &QPushButton::clicked, this, &SendDialog::send);
  resize(560, 420);

  connect(this, &QDialog::finished, &job_, &LoadJob::cancel);
  connect(&job_, &LoadJob::progressed, this, [this](double fraction, const QString& doing) {
    progress_->setValue(static_cast<int>(1000.0 * fraction));
    status_->setText(doing);
  });
  connect(&job_, &LoadJob::failed, status_, &QLabel::setText);
  connect(&job_, &LoadJob::ended, this, [this] {
    progress_->setVisible(job_.isRunning());
    enable();
  });
  enable();
}

void SendDialog::addChoices(QFormLayout& form) {
  servers_ = new QComboBox;
  servers_->setToolTip(tr("The server that gets the objects"));
  for (const ServerEntry& each : archives_.servers()) servers_->addItem(each.name, each.id);
  series_ = new QCheckBox(tr("The open series, images: %1").arg(document_.study().series.files.size()));
  series_->setObjectName(QStringLiteral("sendSeries"));
  series_->setToolTip(tr("Its files as they are"));
  labels_ = new QCheckBox(tr("All labels, as a DICOM segmentation"));
  labels_->setObjectName(QStringLiteral("sendLabels"));
  labels_->setToolTip(tr("With their names and colours, for the patient and the series that are open"));
  labels_->setEnabled(document_.labels() != nullptr);
  labels_->setChecked(labels_->isEnabled());
  auto* note = new QLabel(tr("The objects hold the patient's name and ID: an archive files them by these."));
  note->setWordWrap(true);
  form.addRow(tr("Server"), servers_);
  form.addRow(series_);
  form.addRow(labels_);
  commits_ = new QCheckBox(tr("Ask the archive to confirm that it keeps them"));
  commits_->setObjectName(QStringLiteral("sendCommit"));
  form.addRow(commits_);
  form.addRow(note);
  connect(servers_, &QComboBox::currentIndexChanged, this, &SendDialog::enable);
  for (QCheckBox* each : {series_, labels_}) connect(each, &QCheckBox::toggled, this, &SendDialog::enable);
}

void SendDialog::enable() {
  const bool some = series_->isChecked() || labels_->isChecked();
  send_->setEnabled(some && servers_->count() > 0 && !job_.isRunning());
  const ServerEntry* entry = archives_.find(servers_->currentData().toString());
  const bool isWeb = entry && entry->kind == ServerEntry::Kind::Web;
  commits_->setEnabled(entry && !isWeb);
  commits_->setToolTip(isWeb ? tr("DICOMweb has no such confirmation")
                             : tr("A storage commitment: the archive says of each object whether it is stored safely. "
                                  "Most connect to our address and port for that, which are open meanwhile"));
}

void SendDialog::send() {
  const ServerEntry* entry = archives_.find(servers_->currentData().toString());
  const std::optional<AnyServer> reached = entry ? archives_.reach(*entry) : std::nullopt;
  if (!reached) return;
  answers_->clear();
  progress_->setValue(0);
  progress_->show();
  const std::vector<std::filesystem::path> series = document_.study().series.files;
  const auto labels = labels_->isChecked() ? document_.labels() : nullptr;
  const bool sendsSeries = series_->isChecked();
  job_.start([this, series, labels, sendsSeries, commits = commits_->isEnabled() && commits_->isChecked(),
              talk = Conversation(archives_, entry->id, *reached)](const io::Progress& progress) -> LoadJob::Show {
    std::vector<std::filesystem::path> files;
    if (sendsSeries) files = series;
    const QTemporaryDir folder;  // for its owner alone, and removed when all is sent
    if (labels) {
      if (!folder.isValid())
        throw io::Error("labels", "cannot be written for sending", "make room for temporary files");
      files.push_back(toPath(folder.path()) / "labels.dcm");
      io::writeLabels(*labels, files.back(), {.only = {}, .series = series, .namesPatient = true},
                      io::partOf(progress, 0.0, 0.2));
    }
    const auto outcome = std::make_shared<Outcome>();
    outcome->sent = talk.run([&](const auto& each) {
      return io::archive::send(each, files, io::partOf(progress, labels ? 0.2 : 0.0, 1.0));
    });
    outcome->isCommitmentAsked = commits;
    // What was sent is told whatever becomes of the question.
    if (commits) outcome->problem = askToCommit(talk, outcome->sent, outcome->commitments, progress);
    return [this, outcome, images = sendsSeries ? series.size() : 0] { show(*outcome, images); };
  });
  enable();
}

void SendDialog::show(const Outcome& outcome, std::size_t images) {
  QStringList names;
  for (std::size_t i = 0; i < outcome.sent.size(); ++i)
    names << (i < images ? tr("Image %1").arg(i + 1) : tr("Labels"));
  answers_->fill(names, outcome.sent, outcome.commitments);
  QStringList lines{SentAnswers::summaryOf(outcome.sent)};
  if (outcome.isCommitmentAsked)
    lines << (outcome.problem.isEmpty() ? SentAnswers::summaryOf(outcome.sent, outcome.commitments)
                                        : tr("None is confirmed to be kept: %1").arg(outcome.problem));
  status_->setText(lines.join(QLatin1Char('\n')));
}

}  // namespace fenestra::viewer
