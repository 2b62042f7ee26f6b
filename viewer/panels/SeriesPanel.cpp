#include "viewer/panels/SeriesPanel.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include <QCoreApplication>
#include <QHeaderView>
#include <QMenu>
#include <QMimeData>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QVBoxLayout>

#include "viewer/jobs/Thumbnails.h"
#include "viewer/model/Document.h"
#include "viewer/model/PatientLines.h"
#include "viewer/model/SeriesText.h"
#include "viewer/model/ViewOptions.h"

namespace fenestra::viewer {
namespace {

constexpr int seriesPictureSide = 64;  ///< device-independent pixels
constexpr int seriesIdRole = Qt::UserRole;
constexpr const char* seriesMime = "application/x-fenestra-series";
/// Names the list that a drag began in: series of the same id may be in several windows, and in several programs.
constexpr const char* sourceMime = "application/x-fenestra-series-list";

QByteArray nameOf(const QTreeWidget& list) {
  return QByteArray::number(QCoreApplication::applicationPid()) + ' ' +
         QByteArray::number(static_cast<qulonglong>(reinterpret_cast<quintptr>(&list)));
}

class SeriesTree : public QTreeWidget {
 protected:
  QStringList mimeTypes() const override { return {QLatin1String(seriesMime)}; }
  QMimeData* mimeData(const QList<QTreeWidgetItem*>& items) const override {
    const QString id = items.isEmpty() ? QString() : items.front()->data(0, seriesIdRole).toString();
    if (id.isEmpty()) return nullptr;
    auto* drag = new QMimeData;
    drag->setData(QLatin1String(seriesMime), id.toUtf8());
    drag->setData(QLatin1String(sourceMime), nameOf(*this));
    return drag;
  }
};

/// By patient, date of the study, number. The order must not depend on which series is open.
std::vector<io::SeriesInfo> sortedSeries(const io::Study& study) {
  std::vector<io::SeriesInfo> series{study.series};
  series.insert(series.end(), study.otherSeries.begin(), study.otherSeries.end());
  const auto key = [](const io::SeriesInfo& each) {
    return std::tuple(patientTitle(each.patient), each.date, each.studyUid,
                      each.number.value_or(std::numeric_limits<std::int64_t>::max()), each.time, each.part, each.id);
  };
  std::sort(series.begin(), series.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  return series;
}

/// The last group under `parent`, if it holds what `key` names, or a new one, whose title is title(its number from 1).
template <class Title>
QTreeWidgetItem* groupOf(QTreeWidgetItem* parent, const QString& key, Title&& title) {
  QTreeWidgetItem* last = parent->childCount() > 0 ? parent->child(parent->childCount() - 1) : nullptr;
  constexpr int keyRole = Qt::UserRole + 1;
  if (last && last->data(0, keyRole).toString() == key) return last;
  auto* group = new QTreeWidgetItem(parent, {title(parent->childCount() + 1)});
  group->setData(0, keyRole, key);
  group->setFlags(Qt::ItemIsEnabled);
  return group;
}

}  // namespace

SeriesPanel::SeriesPanel(const Document& document, const ViewOptions& options, QWidget* parent)
    : QWidget(parent), document_(document), options_(options), list_(new SeriesTree) {
  list_->setHeaderHidden(true);
  list_->setIndentation(10);
  list_->setIconSize({seriesPictureSide, seriesPictureSide});
  list_->setDragDropMode(QAbstractItemView::DragOnly);
  list_->setTextElideMode(Qt::ElideRight);
  list_->setAccessibleName(tr("Series"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(list_);
  connect(&document, &Document::volumeChanged, this, &SeriesPanel::follow);
  connect(&options, &ViewOptions::changed, this, &SeriesPanel::follow);
  list_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(list_, &QTreeWidget::customContextMenuRequested, this, &SeriesPanel::showMenu);
  connect(list_, &QTreeWidget::itemActivated, this,
          [this](QTreeWidgetItem* row) { choose(row->data(0, seriesIdRole).toString()); });
}

void SeriesPanel::showMenu(QPoint at) {
  const QTreeWidgetItem* row = list_->itemAt(at);
  const QString series = row ? row->data(0, seriesIdRole).toString() : QString();
  if (series.isEmpty()) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  connect(menu->addAction(tr("Open")), &QAction::triggered, this, [this, series] { choose(series); });
  connect(menu->addAction(tr("Open beside")), &QAction::triggered, this,
          [this, series] { Q_EMIT besideChosen(series); });
  menu->popup(list_->viewport()->mapToGlobal(at));
}

void SeriesPanel::choose(const QString& series) {
  if (!series.isEmpty() && series.toStdString() != document_.study().series.id) Q_EMIT chosen(series);
}

SeriesPanel::~SeriesPanel() = default;

QString SeriesPanel::seriesOf(const QMimeData& data) { return QString::fromUtf8(data.data(QLatin1String(seriesMime))); }

bool SeriesPanel::isSourceOf(const QMimeData& drag) const {
  return drag.data(QLatin1String(sourceMime)) == nameOf(*list_);
}

std::vector<QTreeWidgetItem*> SeriesPanel::rows() const {
  std::vector<QTreeWidgetItem*> rows;
  for (QTreeWidgetItemIterator it(list_); *it; ++it)
    if (!(*it)->data(0, seriesIdRole).isNull()) rows.push_back(*it);
  return rows;
}

void SeriesPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  fill();
}

void SeriesPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  thumbnails_.reset();
  pictures_.clear();
  list_->clear();
}

void SeriesPanel::follow() {
  if (isVisible()) fill();
}

void SeriesPanel::fill() {
  list_->clear();
  thumbnails_.reset();
  if (!document_.hasVolume()) return;
  const io::Study& study = document_.study();
  if (const std::string place = study.session.volume.path.string(); place != of_) {
    of_ = place;
    pictures_.clear();
  }
  const std::vector<io::SeriesInfo> series = sortedSeries(study);
  for (const io::SeriesInfo& each : series) addRow(each, parentOf(each));
  list_->expandAll();
  if (list_->currentItem()) list_->scrollToItem(list_->currentItem(), QAbstractItemView::PositionAtCenter);
  makePictures(series);
}

QTreeWidgetItem* SeriesPanel::parentOf(const io::SeriesInfo& series) const {
  QTreeWidgetItem* root = list_->invisibleRootItem();
  if (series.studyUid.empty()) return root;  // only DICOM knows patients and studies
  const QString patient = patientTitle(series.patient);
  QTreeWidgetItem* ofPatient = groupOf(root, patient, [&](int number) {
    if (options_.hidesPatient()) return tr("Patient %1").arg(number);
    return patient.isEmpty() ? tr("Patient without a name") : patient;
  });
  return groupOf(ofPatient, QString::fromStdString(series.studyUid),
                 [&](int number) { return studyTitle(series, names(), number); });
}

SeriesNames SeriesPanel::names() const { return options_.hidesPatient() ? SeriesNames::Hidden : SeriesNames::Shown; }

void SeriesPanel::addRow(const io::SeriesInfo& series, QTreeWidgetItem* parent) {
  const QString title = seriesTitle(series, names()), kind = seriesKind(series);
  const QString size = QStringLiteral("%1×%2×%3").arg(series.dims.x).arg(series.dims.y).arg(series.dims.z);
  const int count = static_cast<int>(series.files.size());
  // A phantom has no files.
  const QString images = count == 0 ? QString() : count == 1 ? tr("1 image") : tr("%n images", nullptr, count);
  QStringList lines{title, kind, images};
  lines.removeAll(QString());
  auto* row = new QTreeWidgetItem(parent, {lines.join(QLatin1Char('\n'))});
  row->setData(0, seriesIdRole, QString::fromStdString(series.id));
  row->setToolTip(0, (QStringList(lines) << size).join(QLatin1Char('\n')));
  const bool isOpen = series.id == document_.study().series.id;
  if (isOpen) {
    QFont bold = list_->font();
    bold.setBold(true);
    row->setFont(0, bold);
    list_->setCurrentItem(row);
  }
  row->setData(0, Qt::AccessibleTextRole,
               isOpen ? tr("%1, open").arg(lines.join(QStringLiteral(", "))) : lines.join(QStringLiteral(", ")));
  // Rows have their height before the pictures are there, so that nothing moves under the pointer.
  QPixmap blank(list_->iconSize() * devicePixelRatio());
  blank.setDevicePixelRatio(devicePixelRatio());
  blank.fill(Qt::transparent);
  row->setIcon(0, blank);
}

void SeriesPanel::makePictures(const std::vector<io::SeriesInfo>& series) {
  std::vector<io::SeriesInfo> missing;
  for (const io::SeriesInfo& each : series)
    if (const QString id = QString::fromStdString(each.id); pictures_.contains(id))
      showPicture(id);
    else
      missing.push_back(each);
  if (missing.empty()) return;
  QStringList ids;
  for (const io::SeriesInfo& each : missing) ids << QString::fromStdString(each.id);
  thumbnails_ =
      std::make_unique<Thumbnails>(std::move(missing), static_cast<int>(seriesPictureSide * devicePixelRatio()));
  connect(thumbnails_.get(), &Thumbnails::made, this, [this, ids](int index, const QImage& made) {
    QPixmap picture = QPixmap::fromImage(made);
    picture.setDevicePixelRatio(devicePixelRatio());
    pictures_.insert(ids[index], picture);
    showPicture(ids[index]);
  });
}

void SeriesPanel::showPicture(const QString& series) {
  for (QTreeWidgetItem* row : rows())
    if (row->data(0, seriesIdRole).toString() == series) row->setIcon(0, pictures_.value(series));
}

}  // namespace fenestra::viewer
