#include "viewer/panels/LabelList.h"

#include <algorithm>

#include <optional>

#include <QActionGroup>
#include <QColorDialog>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QMenu>
#include <QPainter>
#include <QRegularExpression>
#include <QSortFilterProxyModel>
#include <QSpinBox>
#include <QStyledItemDelegate>

#include "rendering/settings/Settings.h"
#include "viewer/model/Document.h"
#include "viewer/model/Translation.h"
#include "viewer/panels/LabelModel.h"
#include "viewer/style/Overlay.h"
#include "viewer/style/Style.h"

namespace fenestra::viewer {
namespace {

/// Icons in the middle of their column, and whole percents to edit.
class Delegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    if (index.column() != LabelModel::Opacity) return QStyledItemDelegate::createEditor(parent, option, index);
    auto* box = new QSpinBox(parent);
    box->setRange(0, 100);
    box->setSingleStep(5);
    box->setFrame(false);
    return box;
  }
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    if (index.column() == LabelModel::Name) return;
    option->decorationAlignment = Qt::AlignCenter;
    option->decorationPosition = QStyleOptionViewItem::Top;
  }
};

}  // namespace

LabelList::LabelList(Document& document, const PlacementController& placement, QWidget* parent)
    : QTreeView(parent),
      document_(document),
      labels_(new LabelModel(document, placement, this)),
      shown_(new QSortFilterProxyModel(this)) {
  shown_->setSourceModel(labels_);
  shown_->setRecursiveFilteringEnabled(true);
  setModel(shown_);
  setItemDelegate(new Delegate(this));
  setUniformRowHeights(true);
  setIconSize({14, 14});
  setIndentation(12);
  setExpandsOnDoubleClick(false);
  setEditTriggers(EditKeyPressed);
  setAccessibleName(tr("Structures"));
  arrangeColumns();
  connect(this, &QTreeView::clicked, this, &LabelList::clickedAt);
  const auto arrange = [this] {
    const QModelIndex folded = shown_->mapFromSource(labels_->absentRow());
    setRootIsDecorated(folded.isValid());
    if (folded.isValid()) setFirstColumnSpanned(folded.row(), {}, true);
  };
  connect(labels_, &QAbstractItemModel::modelReset, this, arrange);
  arrange();
}

void LabelList::arrangeColumns() {
  QHeaderView& header = *this->header();
  header.setStretchLastSection(false);
  header.setMinimumSectionSize(16);
  header.setSectionResizeMode(LabelModel::Name, QHeaderView::Stretch);
  const int icons = iconSize().width() + 8, numbers = fontMetrics().horizontalAdvance(QStringLiteral("100 %")) + 12;
  for (const int column : {LabelModel::Colour, LabelModel::Visible, LabelModel::Role}) {
    header.setSectionResizeMode(column, QHeaderView::Fixed);
    header.resizeSection(column, icons);
  }
  for (const int column : {LabelModel::Opacity, LabelModel::Seen}) {
    header.setSectionResizeMode(column, QHeaderView::Fixed);
    header.resizeSection(column, std::max(numbers, header.sectionSizeHint(column)));
  }
  header.setSectionsClickable(false);
}

std::uint16_t LabelList::labelAt(const QModelIndex& row) const { return labels_->label(shown_->mapToSource(row)); }

void LabelList::filter(const QString& text) {
  // Segmentations write "kidney_left" for the left kidney: each word is looked for by itself.
  static const QRegularExpression between(QStringLiteral("[\\s_]+"));
  QString pattern;
  for (const QString& word : text.split(between, Qt::SkipEmptyParts))
    pattern += QStringLiteral("(?=.*%1)").arg(QRegularExpression::escape(word));
  shown_->setFilterRegularExpression(
      QRegularExpression(QLatin1Char('^') + pattern, QRegularExpression::CaseInsensitiveOption));
}

QString LabelList::emptyText() const {
  const bool nothingFound = shown_->rowCount() == 0 && labels_->rowCount() > 0;
  return nothingFound ? tr("No structure's name has these words.") : QString();
}

void LabelList::paintEvent(QPaintEvent* event) {
  QTreeView::paintEvent(event);
  const QString text = emptyText();
  if (text.isEmpty()) return;
  QPainter painter(viewport());
  painter.setPen(palette().color(QPalette::PlaceholderText));
  const int margin = fontMetrics().height() / 2;
  painter.drawText(viewport()->rect().adjusted(margin, margin, -margin, -margin), Qt::AlignTop | Qt::TextWordWrap,
                   text);
}

bool LabelList::isEmpty() const { return labels_->rowCount() == 0; }

int LabelList::leastHeight() const {
  constexpr int rows = 8;
  QStyleOptionViewItem option;
  initViewItemOption(&option);
  const int row = std::max(sizeHintForRow(0), itemDelegate()->sizeHint(option, {}).height());
  return 2 * frameWidth() + header()->sizeHint().height() + rows * row;
}

void LabelList::scrollToLabel(std::uint16_t label) {
  for (int row = 0; row < shown_->rowCount(); ++row)
    if (const QModelIndex index = shown_->index(row, 0); labelAt(index) == label) scrollTo(index);
}

void LabelList::clickedAt(const QModelIndex& index) {
  const std::uint16_t label = labelAt(index);
  if (label == 0) {
    setExpanded(index.siblingAtColumn(0), !isExpanded(index.siblingAtColumn(0)));
    return;
  }
  LabelSetting setting = document_.labelSetting(label);
  switch (index.column()) {
    case LabelModel::Colour:
      return chooseColour(index);
    case LabelModel::Visible:
      setting.visible = !setting.visible;
      return document_.setLabelSetting(setting, setting.visible ? tr("Show the label") : tr("Do not show the label"));
    case LabelModel::Role:
      return chooseRole(label, viewport()->mapToGlobal(visualRect(index).bottomLeft()));
    case LabelModel::Opacity:
      return edit(index);
    default:
      return;
  }
}

void LabelList::chooseColour(const QModelIndex& index) {
  const QColor now = index.siblingAtColumn(LabelModel::Colour).data(Qt::DecorationRole).value<QColor>();
  const QColor chosen = QColorDialog::getColor(now, this, tr("Colour of the label"));
  if (chosen.isValid()) shown_->setData(index.siblingAtColumn(LabelModel::Colour), chosen);
}

void LabelList::addRoles(QMenu& menu, std::uint16_t label) {
  menu.setToolTipsVisible(true);
  auto* group = new QActionGroup(&menu);
  const auto add = [&](std::optional<LabelRole> role, const char* iconName, const QString& name, const QString& tip) {
    QAction* action =
        menu.addAction(icon(iconName), name, this, [this, label, role] { document_.setRole(label, role); });
    action->setToolTip(tip);
    action->setCheckable(true);
    action->setActionGroup(group);
    action->setChecked(document_.roleOf(label) == role);
  };
  add(std::nullopt, "role-focus", tr("Focus"), tr("What the view opens to"));
  for (const Word<LabelRole>& each : wordsOf(LabelRole{}))
    add(each.value, (std::string("role-") + each.word).c_str(), translated(each.name), translated(each.description));
  menu.addSeparator();
  QAction* exempt =
      menu.addAction(tr("Never clipped"), this, [this, label](bool on) { document_.setExempt(label, on); });
  exempt->setToolTip(tr("Stays outside the crop box and behind clip planes, as part of the context"));
  exempt->setCheckable(true);
  const std::vector<std::uint16_t>& labels = document_.clipping().exempt;
  exempt->setChecked(std::binary_search(labels.begin(), labels.end(), label));
}

void LabelList::chooseRole(std::uint16_t label, QPoint at) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  addRoles(*menu, label);
  menu->popup(at);
}

void LabelList::contextMenuEvent(QContextMenuEvent* event) {
  const QModelIndex index = indexAt(event->pos());
  const std::uint16_t label = labelAt(index);
  if (label == 0) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  addRoles(*menu, label);
  menu->addSeparator();
  const QPersistentModelIndex row = index.siblingAtColumn(LabelModel::Name);
  menu->addAction(tr("Rename"), this, [this, row] { edit(row); });
  menu->addAction(tr("Colour…"), this, [this, row] { chooseColour(row); });
  const LabelSetting setting = document_.labelSetting(label);
  menu->addAction(tr("The label map's own colour"), this,
                  [this, setting] {
                    LabelSetting plain = setting;
                    plain.colour.reset();
                    document_.setLabelSetting(plain, tr("Colour"));
                  })
      ->setEnabled(setting.colour.has_value());
  menu->popup(event->globalPos());
}

}  // namespace fenestra::viewer
