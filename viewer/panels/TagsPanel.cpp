#include "viewer/panels/TagsPanel.h"

#include <algorithm>
#include <set>
#include <utility>

#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QScrollBar>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QVBoxLayout>

#include "viewer/jobs/LoadJob.h"
#include "viewer/model/Document.h"
#include "viewer/model/Paths.h"
#include "viewer/model/SliceCursor.h"
#include "viewer/model/SlicePlanes.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/panels/CopyRows.h"

namespace fenestra::viewer {
namespace {

constexpr int tagPathRole = Qt::UserRole;
constexpr int widestName = 130;         // device-independent pixels; longer ones are cut, so that values are in sight
constexpr int tagDelay = 80;            // ms: scrolling through slices reads none that is passed over
constexpr qsizetype longestTip = 2000;  // characters
constexpr int tagScannedAxis = 2;       // of the volume: its slices are counted along it

QString tagSize(std::uint64_t bytes) { return QLocale().formattedDataSize(static_cast<qint64>(bytes)); }

/// "EchoTime", "EchoTime [SIEMENS MR HEADER]" or "[SIEMENS MR HEADER]".
QString tagName(const io::DicomTag& tag) {
  const QString name = QString::fromStdString(tag.name);
  if (tag.creator.empty()) return name;
  return QStringLiteral("%1 [%2]").arg(name, QString::fromStdString(tag.creator)).trimmed();
}

}  // namespace

TagsPanel::TagsPanel(const Document& document, const SliceCursor& cursor, const SlicePlanes& planes,
                     const ViewOptions& options, QWidget* parent)
    : QWidget(parent),
      document_(document),
      cursor_(cursor),
      planes_(planes),
      options_(options),
      search_(new QLineEdit),
      says_(new QLabel),
      list_(new QTreeWidget) {
  search_->setPlaceholderText(tr("Search tags, names and values"));
  search_->setAccessibleName(tr("Search tags, names and values"));
  search_->setClearButtonEnabled(true);
  says_->setWordWrap(true);
  says_->setTextFormat(Qt::PlainText);
  list_->setAccessibleName(tr("DICOM tags"));
  list_->setHeaderLabels({tr("Tag"), tr("VR"), tr("Name"), tr("Value")});
  list_->setUniformRowHeights(true);
  list_->setIndentation(12);
  list_->header()->setStretchLastSection(true);
  new CopyRows(*list_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  column->addWidget(search_);
  column->addWidget(says_);
  column->addWidget(list_, 1);
  soon_.setSingleShot(true);
  soon_.setInterval(tagDelay);
  connect(&soon_, &QTimer::timeout, this, &TagsPanel::read);
  connect(search_, &QLineEdit::textChanged, this, &TagsPanel::fill);
  connect(&cursor, &SliceCursor::moved, this, &TagsPanel::follow);
  connect(&planes, &SlicePlanes::changed, this, &TagsPanel::follow);
  connect(&document, &Document::volumeChanged, this, [this] {
    // At once: nothing of the study before may stay in sight.
    place_.reset();
    tags_.clear();
    if (job_) job_->cancel();
    fill();
    follow();
  });
  connect(&options, &ViewOptions::changed, this, &TagsPanel::fill);
}

TagsPanel::~TagsPanel() = default;

QString TagsPanel::text() const { return says_->text(); }

void TagsPanel::setPlane(std::optional<SlicePlane> plane) {
  plane_ = plane;
  follow();
}

void TagsPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!job_) {
    job_ = std::make_unique<LoadJob>();
    connect(job_.get(), &LoadJob::failed, this, [this](const QString& message) {
      problem_ = message;
      fill();
    });
  }
  read();
}

void TagsPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  soon_.stop();
  job_.reset();
  place_.reset();
  tags_ = {};
  list_->clear();
}

void TagsPanel::follow() {
  if (job_) soon_.start();
}

TagsPanel::Place TagsPanel::wanted() const {
  Place place;
  if (!document_.hasVolume()) return place;
  const io::Study& study = document_.study();
  const auto planes = static_cast<std::size_t>(study.scene.volume->grid.dims[tagScannedAxis]);
  const std::optional<glm::ivec3> voxel = document_.voxelAt(cursor_.position());
  if (study.format != "DICOM")
    place.reason = tr("This study is no DICOM series: its format is %1, which has no DICOM tags.")
                       .arg(QString::fromStdString(study.format));
  else if (study.slices.empty())
    place.reason = tr("This series was read from an archive. Unpack it and open the folder to see its tags.");
  else if (study.slices.size() != planes || (study.geometry && study.geometry->applied != io::Regularise::Off))
    place.reason =
        tr("The slices of this series do not lie evenly. What is shown is interpolated between them, and no "
           "file holds it.");
  else if (plane_ && planes_.isTurned(*plane_))
    place.reason =
        tr("This plane is turned and crosses several files. Reset it (View → Slices), or click another view.");
  else if (voxel) {
    place.slice = (*voxel)[tagScannedAxis];
    const io::SliceSource source = study.slices[static_cast<std::size_t>(place.slice)];
    place.file = study.series.files.at(source.file);
    place.frame = source.frame;
  }
  return place;
}

void TagsPanel::read() {
  if (!job_) return;
  const Place place = wanted();
  if (place == place_) return say();  // another view may show it
  place_ = place;
  problem_.clear();
  tags_.clear();
  if (place.file.empty()) {
    job_->cancel();
    return fill();
  }
  job_->start([this, place](const io::Progress&) -> LoadJob::Show {
    auto tags = std::make_shared<std::vector<io::DicomTag>>(io::readDicomTags(place.file, place.frame));
    return [this, tags] {
      tags_ = std::move(*tags);
      fill();
    };
  });
  say();
}

void TagsPanel::say() {
  // A problem names the file, and files are often named after their patient.
  QString text = options_.hidesPatient() ? tr("The file of this slice cannot be read.") : problem_;
  if (problem_.isEmpty()) text.clear();
  if (place_ && problem_.isEmpty()) {
    text = place_->reason;
    if (!place_->file.empty()) {
      text = tr("Slice %1 of %2").arg(place_->slice + 1).arg(document_.study().slices.size());
      if (plane_ && planes_.geometry(*plane_).axis != tagScannedAxis) text = tr("%1, at the crosshair").arg(text);
      if (!options_.hidesPatient()) text += QStringLiteral(" · ") + toQString(place_->file.filename());
    }
  }
  says_->setText(text);
  says_->setVisible(!text.isEmpty());
}

void TagsPanel::fill() {
  if (!job_) return;
  std::set<QString> open;
  const QString current = list_->currentItem() ? list_->currentItem()->data(0, tagPathRole).toString() : QString();
  for (QTreeWidgetItemIterator it(list_); *it; ++it)
    if ((*it)->isExpanded()) open.insert((*it)->data(0, tagPathRole).toString());
  const int scrolled = list_->verticalScrollBar()->value();
  const bool wasEmpty = list_->topLevelItemCount() == 0;
  list_->clear();
  const std::string words = search_->text().trimmed().toStdString();
  std::vector<io::DicomTag> shown = tags_;
  // Before the search: what is hidden must not be found by guessing.
  if (options_.hidesPatient()) io::hidePatient(shown);
  addRows(io::tagsHolding(shown, words), list_->invisibleRootItem(), {});
  for (QTreeWidgetItemIterator it(list_); *it; ++it) {
    const QString path = (*it)->data(0, tagPathRole).toString();
    if (!words.empty() || open.contains(path)) (*it)->setExpanded(true);
    if (path == current) list_->setCurrentItem(*it);
  }
  if (wasEmpty) {
    for (int each = 0; each < 3; ++each) list_->resizeColumnToContents(each);
    list_->setColumnWidth(2, std::min(list_->columnWidth(2), widestName));
  }
  list_->verticalScrollBar()->setValue(scrolled);
  say();
}

void TagsPanel::addRows(const std::vector<io::DicomTag>& tags, QTreeWidgetItem* parent, const QString& path) const {
  for (const io::DicomTag& tag : tags) {
    const QString number = QString::fromStdString(tag.number()), own = path + QLatin1Char('/') + number;
    const auto items = static_cast<int>(tag.itemCount);
    QString value = QString::fromStdString(tag.value);
    if (tag.isSequence())
      value = items == 1 ? tr("1 item") : tr("%n items", nullptr, items);
    else if (tag.identifies && options_.hidesPatient())
      value = tr("hidden");
    else if (!tag.hasText)
      value = tagSize(tag.bytes);
    auto* row = new QTreeWidgetItem(
        parent, {QStringLiteral("(%1)").arg(number), QString::fromStdString(tag.vr), tagName(tag), value});
    row->setData(0, tagPathRole, own);
    row->setToolTip(2, tagName(tag));
    row->setToolTip(3, value.left(longestTip));
    for (const io::DicomTagItem& item : tag.items) {
      auto* group = new QTreeWidgetItem(row, {tr("Item %1").arg(item.number)});
      const QString inner = own + QLatin1Char('#') + QString::number(item.number);
      group->setData(0, tagPathRole, inner);
      addRows(item.tags, group, inner);
    }
  }
}

}  // namespace fenestra::viewer
