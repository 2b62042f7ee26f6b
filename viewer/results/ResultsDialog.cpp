#include "viewer/results/ResultsDialog.h"

#include <algorithm>
#include <utility>

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "viewer/archive/OutcomeRows.h"
#include "viewer/archive/SentAnswers.h"
#include "viewer/model/Document.h"
#include "viewer/model/Paths.h"
#include "viewer/panels/FileDialog.h"

namespace fenestra::viewer {
namespace {

constexpr int longestSeriesDescription = 64;  // characters of a long string (LO, PS3.5 6.2)
constexpr int choiceIndent = 22;              // device-independent pixels, below the text of a check box

}  // namespace

ResultsDialog::ResultsDialog(const Parts& parts, QWidget* parent)
    : QDialog(parent),
      parts_(parts),
      pictures_(PictureDialog::choices(PictureDialog::What::Picture, parts.views)),
      maker_(parts.views) {
  setWindowTitle(tr("Save results"));
  auto* column = new QVBoxLayout(this);
  addKinds(*column);
  addPlaces(*column);
  addOutcome(*column);

  const Document& document = parts_.document;
  for (const auto& changed : {&Document::labelsChanged, &Document::focusChanged, &Document::measuresChanged,
                              &Document::keyImagesChanged, &Document::sceneChanged})
    connect(&document, changed, this, &ResultsDialog::refresh);
  connect(&document, &Document::volumeChanged, this, [this] {
    maker_.cancel();
    job_.cancel();
    QDialog::reject();
  });
  connect(&maker_, &PictureMaker::made, this, [this](const QImage& picture) {
    waiting_.picture = picture;
    waiting_.fidelity = maker_.fidelity();
    start(std::exchange(waiting_, {}));
  });
  const auto fail = [this](const QString& problem) {
    isTold_ = true;
    status_->setText(problem);
    progress_->hide();
    enable();
  };
  connect(&maker_, &PictureMaker::failed, this, fail);
  connect(&job_, &LoadJob::failed, this, fail);
  connect(&job_, &LoadJob::progressed, this, [this](double fraction, const QString& doing) {
    progress_->setValue(static_cast<int>(1000.0 * fraction));
    status_->setText(doing.isEmpty() ? tr("Writing…") : doing);
  });
  connect(&job_, &LoadJob::ended, this, [this] {
    progress_->setVisible(job_.isRunning());
    if (!job_.isRunning() && !isTold_)
      status_->setText(tr("Stopped. Nothing was written; an archive keeps what it had taken."));
    enable();
  });
  refresh();
  for (const Choice* each : {&measures_, &labels_}) each->box->setChecked(each->box->isEnabled());
  // With the reasons that it begins with: lines break at this width.
  constexpr int width = 600;  // device-independent pixels
  resize(width, std::max(sizeHint().height(), column->totalHeightForWidth(width)));
}

ResultsDialog::Choice ResultsDialog::addChoice(QVBoxLayout& column, const char* name, const QString& text,
                                               const QString& toolTip) {
  Choice choice{new QCheckBox(text), new QLabel};
  choice.box->setObjectName(QLatin1String(name));
  choice.box->setToolTip(toolTip);
  choice.reason->setWordWrap(true);
  choice.reason->setTextFormat(Qt::PlainText);
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  policy.setHeightForWidth(true);
  choice.reason->setSizePolicy(policy);
  choice.box->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  choice.reason->setContentsMargins(choiceIndent, 0, 0, 0);
  connect(choice.box, &QCheckBox::toggled, this, &ResultsDialog::enable);
  column.addWidget(choice.box);
  column.addWidget(choice.reason);
  return choice;
}

void ResultsDialog::offer(const Choice& choice, const QString& problem) {
  choice.box->setEnabled(problem.isEmpty());
  if (!problem.isEmpty()) choice.box->setChecked(false);
  choice.reason->setText(problem);
  choice.reason->setVisible(!problem.isEmpty());
}

void ResultsDialog::addKinds(QVBoxLayout& column) {
  measures_ =
      addChoice(column, "resultMeasures", tr("Measures and the table of labels, as a report"),
                tr("A structured report (TID 1500): distances, angles, areas and values of the measures, volume "
                   "and values of each label, and the segmentation that these refer to"));
  labels_ = addChoice(column, "resultLabels", tr("All labels, as a segmentation"), tr("With their names and colours"));
  focus_ = addChoice(column, "resultFocus", tr("The focus, as a segmentation"),
                     tr("Labels as they are; a region or a range of values as one segment"));
  picture_ = addChoice(column, "resultPicture", tr("A picture of"),
                       tr("A secondary capture, which says what makes the picture less than exact"));
  views_ = new QComboBox;
  views_->setObjectName(QStringLiteral("resultViews"));
  views_->setAccessibleName(tr("Views in the picture"));
  for (const PictureDialog::Choice& each : pictures_) views_->addItem(each.name);
  if (!pictures_.empty()) views_->setCurrentIndex(PictureDialog::activeOf(pictures_, parts_.views));
  auto* row = new QHBoxLayout;
  column.removeWidget(picture_.box);
  row->addWidget(picture_.box);
  row->addWidget(views_, 1);
  column.insertLayout(column.indexOf(picture_.reason), row);
  keys_ = addChoice(column, "resultKeys", {}, tr("A key object selection, which names slices of the series"));
  description_ = new QLineEdit;
  description_->setObjectName(QStringLiteral("resultDescription"));
  description_->setMaxLength(longestSeriesDescription);
  description_->setPlaceholderText(tr("by the kind of object"));
  auto* form = new QFormLayout;
  form->addRow(tr("Description of the series"), description_);
  column.addLayout(form);
}

void ResultsDialog::addPlaces(QVBoxLayout& column) {
  folder_ = addChoice(column, "resultToFolder", tr("To the folder"), tr("A file for each object"));
  path_ = new QLineEdit;
  path_->setObjectName(QStringLiteral("resultFolder"));
  path_->setAccessibleName(tr("Folder"));
  path_->setReadOnly(true);
  browse_ = new QPushButton(tr("Choose…"));
  browse_->setObjectName(QStringLiteral("resultBrowse"));
  archive_ = addChoice(column, "resultToArchive", tr("To the archive"), tr("The server answers for each object"));
  servers_ = new QComboBox;
  servers_->setObjectName(QStringLiteral("resultServers"));
  servers_->setAccessibleName(tr("Server"));
  for (const ServerEntry& each : parts_.archives.servers()) servers_->addItem(each.name, each.id);
  auto* grid = new QGridLayout;
  int line = 0;
  for (const Choice* each : {&folder_, &archive_}) {
    column.removeWidget(each->box);
    column.removeWidget(each->reason);
    grid->addWidget(each->box, line, 0);
    grid->addWidget(each->reason, line + 1, 0, 1, 3);
    line += 2;
  }
  grid->addWidget(path_, 0, 1);
  grid->addWidget(browse_, 0, 2);
  grid->addWidget(servers_, 2, 1, 1, 2);
  commits_ = new QCheckBox(tr("Ask the archive to confirm that it keeps them"));
  commits_->setObjectName(QStringLiteral("resultCommit"));
  grid->addWidget(commits_, line, 1, 1, 2);
  connect(servers_, &QComboBox::currentIndexChanged, this, &ResultsDialog::enable);
  grid->setColumnStretch(1, 1);
  column.addLayout(grid);
  connect(browse_, &QPushButton::clicked, this, &ResultsDialog::chooseFolder);
  connect(folder_.box, &QCheckBox::clicked, this, [this](bool on) {
    if (on && path_->text().isEmpty()) chooseFolder();
  });
  auto* note =
      new QLabel(tr("The objects hold the patient's name and ID, also while the window hides them: archives and "
                    "other programs file them by these."));
  note->setWordWrap(true);
  column.addWidget(note);
}

void ResultsDialog::addOutcome(QVBoxLayout& column) {
  const OutcomeRows rows = addOutcomeRows(column, *this, tr("Save"), QStringLiteral("result"));
  progress_ = rows.progress;
  status_ = rows.status;
  answers_ = rows.answers;
  answers_->hide();
  column.insertStretch(column.indexOf(rows.buttons));  // takes the height that is left while there are no answers
  save_ = rows.start;
  save_->setObjectName(QStringLiteral("resultSave"));
  connect(save_, &QPushButton::clicked, this, &ResultsDialog::save);
}

void ResultsDialog::reject() {
  // The first time it stops what is being done, so that its end is told.
  if (isBusy()) {
    maker_.cancel();
    job_.cancel();
    if (!job_.isRunning()) {
      progress_->hide();
      status_->setText(tr("Stopped. Nothing was written; an archive keeps what it had taken."));
      enable();
    }
    return;
  }
  QDialog::reject();
}

void ResultsDialog::setFolder(const QString& folder) {
  path_->setText(QDir::toNativeSeparators(folder));
  folder_.box->setChecked(!folder.isEmpty());
  enable();
}

void ResultsDialog::chooseFolder() {
  if (const auto folder = askForFolder(this, {tr("Folder of the results")}))
    setFolder(toQString(*folder));
  else if (path_->text().isEmpty())
    folder_.box->setChecked(false);
}

void ResultsDialog::enable() {
  const auto any = [](std::initializer_list<const Choice*> choices) {
    return std::any_of(choices.begin(), choices.end(), [](const Choice* each) { return each->box->isChecked(); });
  };
  const bool hasPlace = any({&folder_, &archive_}) && (!folder_.box->isChecked() || !path_->text().isEmpty());
  views_->setEnabled(picture_.box->isChecked());
  servers_->setEnabled(archive_.box->isChecked());
  const ServerEntry* entry = parts_.archives.find(servers_->currentData().toString());
  const bool isWeb = entry && entry->kind == ServerEntry::Kind::Web;
  commits_->setEnabled(archive_.box->isChecked() && entry && !isWeb);
  commits_->setToolTip(isWeb ? tr("DICOMweb has no such confirmation")
                             : tr("A storage commitment: the archive says of each object whether it is stored safely. "
                                  "Most connect to our address and port for that, which are open meanwhile"));
  save_->setEnabled(any({&measures_, &labels_, &focus_, &picture_, &keys_}) && hasPlace && !isBusy());
}

}  // namespace fenestra::viewer
