#include "viewer/panels/ImportanceList.h"

#include <algorithm>
#include <vector>

#include <QHeaderView>
#include <QPixmap>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include "viewer/model/Document.h"
#include "viewer/model/LabelName.h"
#include "viewer/style/Overlay.h"

namespace fenestra::viewer {
namespace {

constexpr int mostRows = 3;  // in sight; the panel never scrolls, and the other panels need their height

int levelOf(const Document& document, std::uint16_t label) {
  return document.labelSetting(label).importance.value_or(document.isFocused(label) ? mostImportant : 0);
}

}  // namespace

ImportanceList::ImportanceList(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), table_(new QTableWidget), more_(new QComboBox) {
  table_->setColumnCount(2);
  table_->horizontalHeader()->hide();
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setMinimumSectionSize(0);
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  table_->setShowGrid(false);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->setIconSize({10, 10});
  table_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // rows that appear must not widen the panel
  table_->setToolTip(
      tr("What hides a label of a higher level is opened for it; what has the same level or a higher one "
         "never is. All else has level 0."));
  more_->setPlaceholderText(tr("Another label…"));
  more_->setToolTip(tr("Gives a label that is not in focus a level of importance"));
  more_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  more_->setMinimumContentsLength(5);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(table_);
  layout->addWidget(more_);
  connect(more_, &QComboBox::activated, this,
          [this](int which) { setLevel(static_cast<std::uint16_t>(more_->itemData(which).toUInt()), 1); });
  for (const auto signal : {&Document::labelsChanged, &Document::focusChanged, &Document::labelSettingsChanged})
    connect(&document_, signal, this, &ImportanceList::show);
  show();
}

void ImportanceList::setLevel(std::uint16_t label, int level) {
  LabelSetting setting = document_.labelSetting(label);
  setting.importance = level;
  if (level == (document_.isFocused(label) ? mostImportant : 0)) setting.importance.reset();
  if (setting != document_.labelSetting(label)) document_.setLabelSetting(setting, tr("Level of importance"));
}

void ImportanceList::show() {
  std::vector<const Label*> listed, others;
  if (document_.labels())
    for (const Label& label : document_.labels()->labels)
      (document_.isFocused(label.value) || levelOf(document_, label.value) > 0 ? listed : others).push_back(&label);
  // Boxes stay while the labels do: the user may be turning one of them.
  const auto labelOf = [this](int row) { return table_->item(row, 0)->data(Qt::UserRole).toUInt(); };
  bool same = table_->rowCount() == static_cast<int>(listed.size());
  for (int row = 0; same && row < table_->rowCount(); ++row)
    same = labelOf(row) == listed[static_cast<std::size_t>(row)]->value;
  if (!same) table_->setRowCount(0);
  table_->setRowCount(static_cast<int>(listed.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const Label& label = *listed[static_cast<std::size_t>(row)];
    if (!same) {
      auto* item = new QTableWidgetItem;
      item->setData(Qt::UserRole, label.value);
      table_->setItem(row, 0, item);
      auto* box = new QSpinBox;
      box->setRange(0, mostImportant);
      box->setFrame(false);
      table_->setCellWidget(row, 1, box);
      // Queued, because level 0 deletes the box.
      connect(
          box, &QSpinBox::valueChanged, this, [this, value = label.value](int level) { setLevel(value, level); },
          Qt::QueuedConnection);
    }
    QPixmap colour(table_->iconSize());
    colour.fill(toColour(document_.colourOf(label)));
    table_->item(row, 0)->setText(nameOf(label));
    table_->item(row, 0)->setIcon(colour);
    auto* box = static_cast<QSpinBox*>(table_->cellWidget(row, 1));
    const QSignalBlocker blocker(box);
    box->setValue(levelOf(document_, label.value));
  }
  const int rows = std::clamp(table_->rowCount(), 1, mostRows);
  table_->setFixedHeight(rows * table_->verticalHeader()->defaultSectionSize() + 2 * table_->frameWidth());
  // A focus of values and a region have one level.
  for (QWidget* widget : std::initializer_list<QWidget*>{table_, more_})
    widget->setEnabled(std::holds_alternative<LabelFocus>(document_.focus()));
  more_->clear();
  for (const Label* label : others) more_->addItem(nameOf(*label), label->value);
  more_->setCurrentIndex(-1);
}

}  // namespace fenestra::viewer
