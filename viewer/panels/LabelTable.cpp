#include "viewer/panels/LabelTable.h"

#include <algorithm>
#include <utility>

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "io/base/AtomicFile.h"
#include "rendering/volume/Threads.h"
#include "viewer/model/Document.h"
#include "viewer/model/MeasureText.h"
#include "viewer/model/NumberText.h"
#include "viewer/model/Paths.h"
#include "viewer/model/PlacementController.h"
#include "viewer/model/SliceCursor.h"
#include "viewer/model/WayOutText.h"
#include "viewer/panels/CopyRows.h"
#include "viewer/panels/FileDialog.h"
#include "viewer/style/Overlay.h"

namespace fenestra::viewer {
namespace {

constexpr int rowRole = Qt::UserRole + 1;    ///< its place in the table's rows
constexpr int orderRole = Qt::UserRole + 2;  ///< the number that a cell is sorted by
constexpr int swatchSide = 10;               // device-independent pixels

class TableRow : public QTreeWidgetItem {
 public:
  using QTreeWidgetItem::QTreeWidgetItem;

  void setNumber(int column, const QString& text, double number) {
    setText(column, text);
    setData(column, orderRole, number);
    setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  }
  void setNothing(int column) {
    setText(column, {});
    setData(column, orderRole, {});
  }
  bool operator<(const QTreeWidgetItem& other) const override {
    const int column = treeWidget()->sortColumn();
    if (column == LabelTable::Name) return text(column).localeAwareCompare(other.text(column)) < 0;
    // What is not known comes before all numbers.
    const QVariant own = data(column, orderRole), others = other.data(column, orderRole);
    if (!own.isValid() || !others.isValid()) return !own.isValid() && others.isValid();
    return own.toDouble() < others.toDouble();
  }
};

}  // namespace

LabelTable::LabelTable(const Document& document, const PlacementController& placement, SliceCursor& cursor,
                       QWidget* parent)
    : QWidget(parent),
      document_(document),
      placement_(placement),
      cursor_(cursor),
      list_(new QTreeWidget),
      says_(new QLabel),
      copy_(new QPushButton(tr("&Copy all (CSV)"))),
      save_(new QPushButton(tr("&Save…"))) {
  list_->setAccessibleName(tr("Label table"));
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setColumnCount(columns);
  list_->setSortingEnabled(true);
  list_->sortByColumn(Name, Qt::AscendingOrder);
  list_->header()->setStretchLastSection(false);
  new CopyRows(*list_);
  says_->setWordWrap(true);
  says_->setTextFormat(Qt::PlainText);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(copy_);
  buttons->addWidget(save_);
  buttons->addStretch();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  column->addWidget(says_);
  column->addWidget(list_, 1);
  column->addLayout(buttons);
  connect(list_, &QTreeWidget::itemClicked, this, &LabelTable::goTo);
  connect(list_, &QTreeWidget::itemActivated, this, &LabelTable::goTo);
  connect(copy_, &QPushButton::clicked, this, &LabelTable::copyCsv);
  connect(save_, &QPushButton::clicked, this, &LabelTable::saveCsv);
  connect(&document, &Document::volumeChanged, this, &LabelTable::forget);
  connect(&document, &Document::labelsChanged, this, &LabelTable::forget);
  connect(&document, &Document::labelSettingsChanged, this, &LabelTable::fill);
  connect(&placement, &PlacementController::changed, this, &LabelTable::showSeen);
  connect(&job_, &LoadJob::failed, this, [this](const QString& message) { problem_ = message; });
  connect(&job_, &LoadJob::ended, this, &LabelTable::fill);
  fill();
}

void LabelTable::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  compute();
  showSeen();
}

void LabelTable::forget() {
  job_.cancel();
  rows_ = {};
  isKnown_ = false;
  problem_.clear();
  fill();
  if (isVisible()) compute();
}

void LabelTable::compute() {
  if (std::exchange(isKnown_, true) || !document_.labels()) return;
  job_.start([this, labels = document_.labels(),
              volume = document_.study().scene.volume](const io::Progress& progress) -> LoadJob::Show {
    const Interruptible work([&progress] { return progress(0.0, {}); });
    auto rows = std::make_shared<std::vector<LabelRow>>(labelRows(*labels, *volume));
    return [this, rows] { rows_ = std::move(*rows); };
  });
  fill();
}

void LabelTable::fill() {
  const QString unit = document_.hasVolume() ? unitText(document_.study().scene.volume->unit) : QString();
  const QString mean = unit.isEmpty() ? tr("Mean") : tr("Mean, %1").arg(unit);
  list_->setHeaderLabels(
      {tr("Structure"), tr("Volume"), mean, tr("SD"), tr("Extent, mm"), tr("Seen, C1"), tr("Seen, C2")});
  list_->headerItem()->setToolTip(Extent, tr("Sides of its box along the patient: left to right, front to back, "
                                             "foot to head"));
  for (const int column : {SeenByC1, SeenByC2})
    list_->headerItem()->setToolTip(column, tr("Share of its surface that the camera sees; measured for labels in "
                                               "focus when cameras are placed"));
  list_->setSortingEnabled(false);
  list_->clear();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const LabelRow& of = rows_[i];
    auto* row = new TableRow(list_);
    row->setText(Name, of.name.empty() ? tr("Label %1").arg(of.label) : QString::fromStdString(of.name));
    row->setData(Name, rowRole, static_cast<int>(i));
    row->setNumber(Volume, volumeText(of.millilitres), of.millilitres);
    if (of.valued > 0) {
      const ValueRange range = document_.study().scene.volume->range;
      const int decimals = range.high - range.low < 20.0 ? 3 : 1;  // as measures have it
      row->setNumber(Mean, numberText(of.mean, decimals), of.mean);
      row->setNumber(Deviation, numberText(of.deviation, decimals), of.deviation);
    }
    const glm::dvec3 sides = of.high - of.low;
    row->setNumber(
        Extent,
        QStringLiteral("%1 × %2 × %3").arg(numberText(sides.x, 1), numberText(sides.y, 1), numberText(sides.z, 1)),
        std::max({sides.x, sides.y, sides.z}));
    if (const Label* label = document_.labels() ? document_.labels()->find(of.label) : nullptr) {
      QPixmap swatch(swatchSide, swatchSide);
      swatch.fill(toColour(document_.colourOf(*label)));
      row->setIcon(Name, swatch);
    }
  }
  list_->setSortingEnabled(true);
  showSeen();
  for (int column = 0; column < columns; ++column) list_->resizeColumnToContents(column);
  list_->setColumnWidth(Name, std::min(list_->columnWidth(Name), 220));
  say(problem_);
  if (document_.hasVolume() && !document_.labels())
    say(tr("This study has no labels. Open some from the File menu, or keep a grown region as a label."));
  else if (job_.isRunning() && rows_.empty())
    say(tr("Measuring the labels…"));
  copy_->setEnabled(!rows_.empty());
  save_->setEnabled(!rows_.empty());
}

SeenByCameras LabelTable::seenOf(std::uint16_t label) const {
  const auto share = placement_.share(label);
  return share ? SeenByCameras{share->c1, share->c2} : SeenByCameras{};
}

void LabelTable::showSeen() {
  if (rows_.empty() || !isVisible()) return;
  list_->setSortingEnabled(false);  // or rows would move while they are counted through
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    auto* row = static_cast<TableRow*>(list_->topLevelItem(i));
    const SeenByCameras seen = seenOf(rows_[row->data(Name, rowRole).toUInt()].label);
    for (const auto& [column, share] : {std::pair(SeenByC1, seen.c1), std::pair(SeenByC2, seen.c2)})
      if (share)
        row->setNumber(column, tr("%1 %").arg(numberText(100.0 * *share, 0)), *share);
      else
        row->setNothing(column);
  }
  list_->setSortingEnabled(true);
}

void LabelTable::say(const QString& text) {
  says_->setText(text);
  says_->setVisible(!text.isEmpty());
}

void LabelTable::goTo(const QTreeWidgetItem* row) { cursor_.moveTo(rows_[row->data(Name, rowRole).toUInt()].place); }

QString LabelTable::csv() const {
  std::vector<SeenByCameras> seen;
  for (const LabelRow& row : rows_) seen.push_back(seenOf(row.label));
  return labelsCsv(rows_, seen, document_.hasVolume() ? document_.study().scene.volume->unit : std::string());
}

void LabelTable::copyCsv() const {
  auto table = std::make_unique<QMimeData>();
  table->setData(QStringLiteral("text/csv"), csv().toUtf8());
  table->setText(csv());
  QGuiApplication::clipboard()->setMimeData(table.release());
}

void LabelTable::saveCsv() {
  const auto file = askForNewFile(this, tr("Save the label table"), {{tr("Table (CSV)"), QStringLiteral(".csv")}});
  if (!file) return;
  try {
    io::writeText(file->path, csv().toStdString());
    say(tr("Written to %1.").arg(toQString(file->path.filename())));
  } catch (const std::exception& error) {
    say(windowText(error));
  }
}

}  // namespace fenestra::viewer
