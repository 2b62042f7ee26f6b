#include "viewer/results/DeidentifyDialog.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "io/LabelWriter.h"
#include "viewer/archive/Conversation.h"
#include "viewer/archive/OutcomeRows.h"
#include "viewer/archive/SentAnswers.h"
#include "viewer/model/Document.h"
#include "viewer/model/Paths.h"
#include "viewer/model/WayOutText.h"
#include "viewer/panels/FileDialog.h"

namespace fenestra::viewer {
namespace {

namespace fs = std::filesystem;
using io::deidentify::Action;

QString becomes(Action action) {
  switch (action) {
    case Action::Remove:
      return DeidentifyDialog::tr("removed");
    case Action::Empty:
      return DeidentifyDialog::tr("emptied");
    case Action::Dummy:
      return DeidentifyDialog::tr("replaced by a dummy");
    case Action::NewUid:
      return DeidentifyDialog::tr("replaced by a new UID");
    case Action::Clean:
      return DeidentifyDialog::tr("cleaned");
    case Action::Keep:
      break;
  }
  return {};
}

/// FOLDER/de-identified, or de-identified-2 and so on.
fs::path newFolderIn(const fs::path& folder) {
  fs::path place = folder / "de-identified";
  std::error_code unknown;
  for (int number = 2; fs::exists(fs::symlink_status(place, unknown)); ++number)
    place = folder / ("de-identified-" + std::to_string(number));
  return place;
}

}  // namespace

DeidentifyDialog::DeidentifyDialog(Archives& archives, const Document& document, QWidget* parent)
    : QDialog(parent), archives_(archives), document_(document) {
  setWindowTitle(tr("De-identify"));
  auto* column = new QVBoxLayout(this);
  addWhat(*column);
  addTable(*column);
  addPlaces(*column);
  addOutcome(*column);
  connect(&document, &Document::volumeChanged, this, [this] {
    preview_.cancel();
    job_.cancel();
    QDialog::reject();
  });
  connect(&preview_, &LoadJob::failed, status_, &QLabel::setText);
  connect(&job_, &LoadJob::failed, status_, &QLabel::setText);
  connect(&job_, &LoadJob::progressed, this, [this](double fraction, const QString& doing) {
    progress_->setValue(static_cast<int>(1000.0 * fraction));
    status_->setText(doing.isEmpty() ? tr("Writing…") : doing);
  });
  connect(&job_, &LoadJob::ended, this, [this] {
    progress_->setVisible(job_.isRunning());
    enable();
  });
  for (QCheckBox* each : {dates_, uids_, descriptors_, graphics_})
    connect(each, &QCheckBox::toggled, this, &DeidentifyDialog::showPreview);
  constexpr int width = 640, height = 640;  // device-independent pixels; the table takes what the rest leaves
  resize(width, std::max(height, column->totalHeightForWidth(width)));
  showPreview();
  enable();
}

QCheckBox* DeidentifyDialog::addBox(const char* name, const QString& text, const QString& toolTip) {
  auto* box = new QCheckBox(text);
  box->setObjectName(QLatin1String(name));
  box->setToolTip(toolTip);
  connect(box, &QCheckBox::toggled, this, &DeidentifyDialog::enable);
  return box;
}

void DeidentifyDialog::addWhat(QVBoxLayout& column) {
  column.addWidget(new QLabel(tr("Copies of the open series, images: %1").arg(document_.study().series.files.size())));
  labels_ = addBox("deidentifyLabels", tr("All labels, as a DICOM segmentation"),
                   tr("Their names go with the descriptions, unless these are cleaned"));
  labels_->setEnabled(document_.labels() != nullptr);
  dates_ = addBox("deidentifyDates", tr("Keep dates and times"), tr("As they are; with them a patient may be found"));
  uids_ =
      addBox("deidentifyUids", tr("Keep UIDs"), tr("As they are; whoever has the originals can tell which is which"));
  descriptors_ = addBox("deidentifyDescriptors", tr("Clean descriptions"),
                        tr("Of descriptions, the words stay that say nothing about a person; otherwise they go"));
  graphics_ = addBox("deidentifyGraphics", tr("Clean graphics"),
                     tr("The shapes of annotations stay; overlays and curves go in any case"));
  face_ =
      addBox("deidentifyFace", tr("Remove the face, from a head in CT or MR"),
             tr("All in front of a plane from the brow to the chin is blanked. Look at the copies, as slices and in "
                "3-D: a nodded or turned head may keep a part of its face, or lose some brain"));
  auto* grid = new QGridLayout;
  const std::array boxes{labels_, face_, dates_, uids_, descriptors_, graphics_};
  for (std::size_t i = 0; i < boxes.size(); ++i)
    grid->addWidget(boxes[i], static_cast<int>(i / 2), static_cast<int>(i % 2));
  column.addLayout(grid);
  auto* note = new QLabel(
      tr("Look at the copies before you give them away: no program finds a name that is written into a picture, or "
         "knows whether all of a face is gone."));
  note->setWordWrap(true);
  column.addWidget(note);
}

void DeidentifyDialog::addTable(QVBoxLayout& column) {
  table_ = new QTreeWidget;
  table_->setObjectName(QStringLiteral("deidentifyTable"));
  table_->setAccessibleName(tr("What changes"));
  table_->setRootIsDecorated(false);
  table_->setUniformRowHeights(true);
  table_->setHeaderLabels({tr("Attribute"), tr("Becomes"), tr("Times")});
  table_->header()->setStretchLastSection(false);
  table_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  for (const int section : {1, 2}) table_->header()->setSectionResizeMode(section, QHeaderView::ResizeToContents);
  column.addWidget(table_, 1);
}

QPushButton* DeidentifyDialog::addPlace(QGridLayout& grid, QCheckBox* box, QLineEdit*& edit, const QString& name) {
  const int line = grid.rowCount();
  edit = new QLineEdit;
  edit->setReadOnly(true);
  edit->setAccessibleName(name);
  auto* choose = new QPushButton(tr("Choose…"));
  choose->setAccessibleName(name);
  choose->setAutoDefault(false);
  grid.addWidget(box, line, 0);
  grid.addWidget(edit, line, 1);
  grid.addWidget(choose, line, 2);
  return choose;
}

void DeidentifyDialog::addPlaces(QVBoxLayout& column) {
  auto* grid = new QGridLayout;
  toFolder_ = addBox("deidentifyToFolder", tr("To a new folder in"), tr("A folder named de-identified is made there"));
  connect(addPlace(*grid, toFolder_, folder_, tr("Folder")), &QPushButton::clicked, this,
          &DeidentifyDialog::chooseFolder);
  toArchive_ = addBox("deidentifyToArchive", tr("To the archive"), tr("The server answers for each object"));
  servers_ = new QComboBox;
  servers_->setObjectName(QStringLiteral("deidentifyServers"));
  servers_->setAccessibleName(tr("Server"));
  for (const ServerEntry& each : archives_.servers()) servers_->addItem(each.name, each.id);
  const int line = grid->rowCount();
  grid->addWidget(toArchive_, line, 0);
  grid->addWidget(servers_, line, 1, 1, 2);
  toMap_ = addBox("deidentifyToMap", tr("Keep a map in the file"),
                  tr("Old and new UIDs and patients' numbers, readable by you alone. Without it nobody can tell which "
                     "was which"));
  connect(addPlace(*grid, toMap_, map_, tr("File of the map")), &QPushButton::clicked, this,
          &DeidentifyDialog::chooseMap);
  connect(toFolder_, &QCheckBox::clicked, this, [this](bool on) {
    if (on && folder_->text().isEmpty()) chooseFolder();
  });
  connect(toMap_, &QCheckBox::clicked, this, [this](bool on) {
    if (on && map_->text().isEmpty()) chooseMap();
  });
  grid->setColumnStretch(1, 1);
  column.addLayout(grid);
}

void DeidentifyDialog::addOutcome(QVBoxLayout& column) {
  const OutcomeRows rows = addOutcomeRows(column, *this, tr("Save"), QStringLiteral("deidentify"));
  progress_ = rows.progress;
  status_ = rows.status;
  answers_ = rows.answers;
  answers_->hide();
  save_ = rows.start;
  save_->setObjectName(QStringLiteral("deidentifySave"));
  connect(save_, &QPushButton::clicked, this, &DeidentifyDialog::save);
}

void DeidentifyDialog::reject() {
  // The first time it stops what is being done.
  if (isBusy()) return job_.cancel();
  preview_.cancel();
  QDialog::reject();
}

void DeidentifyDialog::setFolder(const QString& folder) {
  folder_->setText(QDir::toNativeSeparators(folder));
  toFolder_->setChecked(!folder.isEmpty());
  enable();
}

void DeidentifyDialog::setMap(const QString& file) {
  map_->setText(QDir::toNativeSeparators(file));
  toMap_->setChecked(!file.isEmpty());
  enable();
}

void DeidentifyDialog::chooseFolder() {
  if (const auto folder = askForFolder(this, {tr("Folder of the copies")}))
    setFolder(toQString(*folder));
  else if (folder_->text().isEmpty())
    toFolder_->setChecked(false);
}

void DeidentifyDialog::chooseMap() {
  if (const auto file =
          askForNewFile(this, tr("File of the map"), {{tr("Tables"), QStringLiteral(".tsv")}}, QStringLiteral("uids")))
    setMap(toQString(file->path));
  else if (map_->text().isEmpty())
    toMap_->setChecked(false);
}

io::deidentify::Options DeidentifyDialog::options() const {
  return {.retainDates = dates_->isChecked(),
          .retainUids = uids_->isChecked(),
          .cleanDescriptors = descriptors_->isChecked(),
          .cleanGraphics = graphics_->isChecked(),
          .removeFace = face_->isChecked()};
}

void DeidentifyDialog::showPreview() {
  io::deidentify::Request request{.inputs = document_.study().series.files, .options = options()};
  // Which attributes change does not depend on it, and it reads all pixels.
  request.options.removeFace = false;
  preview_.start([this, request](const io::Progress& progress) -> LoadJob::Show {
    const auto changes =
        std::make_shared<io::deidentify::Changes>(io::deidentify::deidentify(request, progress).changes);
    return [this, changes] { fill(*changes); };
  });
}

void DeidentifyDialog::fill(const io::deidentify::Changes& changes) {
  table_->clear();
  QList<QTreeWidgetItem*> rows;
  for (const auto& [key, change] : changes.all()) {
    const QString tag = QStringLiteral("(%1,%2)")
                            .arg(key.first >> 16, 4, 16, QLatin1Char('0'))
                            .arg(key.first & 0xffff, 4, 16, QLatin1Char('0'));
    rows << new QTreeWidgetItem({QStringLiteral("%1 %2").arg(tag, QString::fromStdString(change.keyword)),
                                 becomes(key.second), QString::number(change.count)});
    rows.back()->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
  }
  table_->addTopLevelItems(rows);
}

io::deidentify::Outcome DeidentifyDialog::copy(const Order& order, const fs::path& place,
                                               const io::Progress& progress) {
  io::deidentify::Request request{.inputs = order.series, .output = place, .map = order.map, .options = order.options};
  const QTemporaryDir folder;  // for its owner alone, and removed when all is written
  if (order.labels) {
    if (!folder.isValid()) throw io::Error("labels", "cannot be written for copying", "make room for temporary files");
    request.inputs.push_back(toPath(folder.path()) / "labels.dcm");
    io::writeLabels(*order.labels, request.inputs.back(), {.only = {}, .series = order.series, .namesPatient = true},
                    io::partOf(progress, 0.0, 0.1));
  }
  return io::deidentify::deidentify(request, io::partOf(progress, order.labels ? 0.1 : 0.0, 1.0));
}

void DeidentifyDialog::save() {
  Order order{document_.study().series.files, labels_->isChecked() ? document_.labels() : nullptr, options(), {}, {}};
  if (toFolder_->isChecked()) order.folder = toPath(QDir::fromNativeSeparators(folder_->text()));
  if (toMap_->isChecked()) order.map = toPath(QDir::fromNativeSeparators(map_->text()));
  std::optional<Conversation> talk;
  if (toArchive_->isChecked()) {
    const ServerEntry* entry = archives_.find(servers_->currentData().toString());
    const std::optional<AnyServer> reached = entry ? archives_.reach(*entry) : std::nullopt;
    if (!reached) return;
    talk.emplace(archives_, entry->id, *reached);
  }
  answers_->clear();
  answers_->hide();
  status_->clear();
  progress_->setValue(0);
  progress_->show();
  job_.start([this, order, talk](const io::Progress& progress) -> LoadJob::Show {
    const QTemporaryDir temporary;  // of copies that are sent alone
    if (order.folder.empty() && !temporary.isValid())
      throw io::Error("copies", "cannot be written for sending", "make room for temporary files");
    const fs::path place = order.folder.empty() ? toPath(temporary.path()) / "copies" : newFolderIn(order.folder);
    const auto outcome = std::make_shared<Outcome>();
    outcome->copies = copy(order, place, io::partOf(progress, 0.0, talk ? 0.5 : 1.0));
    if (!order.folder.empty()) outcome->folder = place;
    outcome->isSent = talk.has_value();
    if (talk)
      outcome->sent = talk->run([&](const auto& server) {
        return io::archive::send(server, io::archive::filesToSend({place}), io::partOf(progress, 0.5, 1.0));
      });
    return [this, outcome] { tell(*outcome); };
  });
  enable();
}

void DeidentifyDialog::tell(const Outcome& outcome) {
  fill(outcome.copies.changes);
  QStringList lines;
  if (!outcome.folder.empty())
    lines << tr("%1 copies are in %2.")
                 .arg(outcome.copies.objects)
                 .arg(QDir::toNativeSeparators(toQString(outcome.folder)));
  if (outcome.isSent) {
    lines << SentAnswers::summaryOf(outcome.sent);
    QStringList names;
    for (std::size_t i = 0; i < outcome.sent.size(); ++i) names << tr("Copy %1").arg(i + 1);
    answers_->fill(names, outcome.sent, {});
    answers_->show();
  }
  if (face_->isChecked()) lines << tr("Copies without the face: %1. Look at each of them.").arg(outcome.copies.faces);
  for (const io::Warning& warning : outcome.copies.warnings) lines << windowText(warning);
  status_->setText(lines.join(QLatin1Char('\n')));
}

void DeidentifyDialog::enable() {
  // Other pixels are other objects, which must not have the UIDs of the originals.
  uids_->setEnabled(!face_->isChecked());
  face_->setEnabled(!uids_->isChecked());
  toArchive_->setEnabled(servers_->count() > 0);
  servers_->setEnabled(toArchive_->isChecked());
  const bool hasPlace = (toFolder_->isChecked() && !folder_->text().isEmpty()) || toArchive_->isChecked();
  const bool isMapNamed = !toMap_->isChecked() || !map_->text().isEmpty();
  save_->setEnabled(hasPlace && isMapNamed && !isBusy());
}

}  // namespace fenestra::viewer
