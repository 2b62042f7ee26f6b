#include "viewer/panels/LabelModel.h"

#include <algorithm>
#include <cmath>

#include <QColor>
#include <QIcon>
#include <QtConcurrentRun>

#include "rendering/settings/Settings.h"
#include "viewer/model/Document.h"
#include "viewer/model/LabelName.h"
#include "viewer/model/PlacementController.h"
#include "viewer/model/Translation.h"
#include "viewer/style/Overlay.h"
#include "viewer/style/Style.h"

namespace fenestra::viewer {
namespace {

/// Internal id of the children of the row of labels without voxels.
constexpr quintptr absentChild = 1;

QString percent(double share) { return QStringLiteral("%1 %").arg(std::lround(100.0 * share)); }

QIcon roleIcon(std::optional<LabelRole> role) {
  if (!role) return icon("role-focus");
  return icon(*role == LabelRole::Hidden      ? "role-hidden"
              : *role == LabelRole::Protected ? "role-protected"
                                              : "role-context");
}

}  // namespace

LabelModel::LabelModel(Document& document, const PlacementController& placement, QObject* parent)
    : QAbstractItemModel(parent), document_(document), placement_(placement) {
  connect(&document, &Document::labelsChanged, this, [this] {
    beginResetModel();
    readLabels();
    endResetModel();
  });
  connect(&document, &Document::focusChanged, this, [this] { refresh(Name, Seen, {}); });
  connect(&document, &Document::labelSettingsChanged, this, [this] { refresh(Name, Seen, {}); });
  connect(&placement, &PlacementController::changed, this, &LabelModel::refreshSeen);
  connect(&counting_, &QFutureWatcherBase::finished, this, [this] {
    if (counting_.future().resultCount() == 0) return;
    const std::vector<bool> present = counting_.result();
    const auto isAbsent = [&](const Label& label) { return !present[label.value]; };
    if (std::none_of(listed_->labels.begin(), listed_->labels.end(), isAbsent)) return;
    beginResetModel();
    part(present);
    endResetModel();
  });
  readLabels();
}

void LabelModel::readLabels() {
  present_.clear();
  absent_.clear();
  counting_.setFuture({});  // drops the answer for another map
  listed_ = document_.labels();
  if (!listed_) return;
  // A map of up to this many voxels is read within a few milliseconds. The labels of a larger one are all listed first.
  constexpr std::size_t readAtOnce = std::size_t{1} << 22;
  if (listed_->voxels.count() <= readAtOnce) return part(labelsWithVoxels(*listed_));
  part(std::vector<bool>(std::size_t{1} << 16, true));
  counting_.setFuture(QtConcurrent::run([map = listed_] { return labelsWithVoxels(*map); }));
}

void LabelModel::part(const std::vector<bool>& present) {
  present_.clear();
  absent_.clear();
  const std::vector<Label>& labels = listed_->labels;
  for (std::size_t i = 0; i < labels.size(); ++i) (present[labels[i].value] ? present_ : absent_).push_back(i);
}

void LabelModel::refresh(int first, int last, const QList<int>& roles) {
  if (!present_.empty()) Q_EMIT dataChanged(index(0, first), index(static_cast<int>(present_.size()) - 1, last), roles);
  if (const QModelIndex folded = absentRow(); folded.isValid())
    Q_EMIT dataChanged(index(0, first, folded), index(static_cast<int>(absent_.size()) - 1, last, folded), roles);
}

void LabelModel::refreshSeen() { refresh(Seen, Seen, {Qt::DisplayRole, Qt::ToolTipRole}); }

QModelIndex LabelModel::absentRow() const {
  return absent_.empty() ? QModelIndex() : createIndex(static_cast<int>(present_.size()), 0, quintptr{0});
}

bool LabelModel::isAbsentRow(const QModelIndex& index) const {
  return index.isValid() && index.internalId() != absentChild && index.row() == static_cast<int>(present_.size());
}

std::size_t LabelModel::at(const QModelIndex& index) const {
  return (index.internalId() == absentChild ? absent_ : present_)[static_cast<std::size_t>(index.row())];
}

QModelIndex LabelModel::index(int row, int column, const QModelIndex& parent) const {
  if (row < 0 || column < 0 || column >= columns || row >= rowCount(parent)) return {};
  return createIndex(row, column, parent.isValid() ? absentChild : quintptr{0});
}

QModelIndex LabelModel::parent(const QModelIndex& child) const {
  return child.isValid() && child.internalId() == absentChild ? absentRow() : QModelIndex();
}

int LabelModel::rowCount(const QModelIndex& parent) const {
  if (!parent.isValid()) return static_cast<int>(present_.size()) + (absent_.empty() ? 0 : 1);
  return isAbsentRow(parent) && parent.column() == 0 ? static_cast<int>(absent_.size()) : 0;
}

int LabelModel::columnCount(const QModelIndex&) const { return columns; }

QVariant LabelModel::nameData(std::size_t label, int role) const {
  const Label& of = listed_->labels[label];
  switch (role) {
    case Qt::DisplayRole:
      return of.name.empty() ? tr("Label %1").arg(of.value) : QString::fromStdString(of.name);
    case Qt::EditRole:
      return QString::fromStdString(of.name);
    case Qt::ToolTipRole:
      return tr("Label %1. Tick it to open the view to it; double-click to focus on it alone and go there; F2 renames "
                "it.")
          .arg(of.value);
    case Qt::CheckStateRole:
      return document_.isFocused(of.value) ? Qt::Checked : Qt::Unchecked;
    default:
      return {};
  }
}

QVariant LabelModel::settingData(std::size_t label, int column, int role) const {
  const Label& of = listed_->labels[label];
  const LabelSetting setting = document_.labelSetting(of.value);
  const std::optional<LabelRole> labelRole = document_.roleOf(of.value);
  const bool tip = role == Qt::ToolTipRole, drawn = role == Qt::DecorationRole;
  switch (column) {
    case Colour:
      if (drawn) return toColour(document_.colourOf(of));
      return tip ? tr("Click to choose another colour") : QVariant();
    case Visible:
      if (drawn) return icon(setting.visible ? "eye" : "eye-off");
      return tip ? tr("Click to show it or not: slices tint what is visible, and 3-D pictures draw it while it is in "
                      "focus or protected")
                 : QVariant();
    case Role:
      if (drawn) return roleIcon(labelRole);
      if (!tip) return {};
      return labelRole
                 ? tr("%1: %2").arg(translated(wordOf(*labelRole).name), translated(wordOf(*labelRole).description))
                 : tr("Focus: what the view opens to");
    case Opacity:
      if (role == Qt::DisplayRole) return percent(setting.opacity);
      if (role == Qt::EditRole) return static_cast<int>(std::lround(100.0 * setting.opacity));
      return tip ? tr("Opacity of its surface, however thick it is, and of its tint on slices; click to change it. "
                      "At 0 % it is left out of the 3-D pictures.")
                 : QVariant();
    default:
      return {};
  }
}

QVariant LabelModel::seenData(std::size_t label, int role) const {
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  const auto share = placement_.share(listed_->labels[label].value);
  if (role == Qt::DisplayRole) return share ? percent(share->both) : QString();
  return share ? tr("C1 sees %1 of its surface, C2 %2, both together %3: measured where cameras are tried, nearest to "
                    "these")
                     .arg(percent(share->c1), percent(share->c2), percent(share->both))
               : tr("Share of its surface that C1 and C2 see; measured for labels in focus when cameras are placed");
}

QVariant LabelModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (isAbsentRow(index)) {
    if (index.column() == Name && role == Qt::DisplayRole)
      return tr("%n label(s) without voxels", nullptr, static_cast<int>(absent_.size()))
          .replace(QStringLiteral("(s)"), absent_.size() == 1 ? QString() : QStringLiteral("s"));
    return {};
  }
  if (role == Qt::TextAlignmentRole && (index.column() == Opacity || index.column() == Seen))
    return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
  if (index.column() == Name) return nameData(at(index), role);
  if (index.column() == Seen) return seenData(at(index), role);
  return settingData(at(index), index.column(), role);
}

QVariant LabelModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case Name:
      return tr("Structure");
    case Opacity:
      return tr("Opacity");
    case Seen:
      return tr("Seen");
    default:
      return QString();
  }
}

bool LabelModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const std::uint16_t which = label(index);
  if (which == 0) return false;
  if (index.column() == Name && role == Qt::CheckStateRole) {
    document_.setFocused(which, value.toInt() == Qt::Checked);
    return true;
  }
  LabelSetting setting = document_.labelSetting(which);
  if (index.column() == Name && role == Qt::EditRole) {
    const QString name = value.toString().simplified();
    if (name.isEmpty()) return false;
    // Later, once the editor is closed: new labels reset the model.
    QMetaObject::invokeMethod(
        this, [this, which, name] { document_.renameLabel(which, name); }, Qt::QueuedConnection);
    return true;
  }
  if (role != Qt::EditRole) return false;
  if (index.column() == Colour) {
    setting.colour = fromColour(value.value<QColor>());
    document_.setLabelSetting(setting, tr("Colour"));
    return true;
  }
  if (index.column() == Opacity) {
    setting.opacity = std::clamp(value.toInt(), 0, 100) / 100.0;
    document_.setLabelSetting(setting, tr("Opacity"));
    return true;
  }
  return false;
}

Qt::ItemFlags LabelModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = QAbstractItemModel::flags(index);
  if (!index.isValid() || isAbsentRow(index)) return flags;
  if (index.column() == Name) flags |= Qt::ItemIsUserCheckable | Qt::ItemIsEditable;
  if (index.column() == Opacity) flags |= Qt::ItemIsEditable;
  return flags;
}

std::uint16_t LabelModel::label(const QModelIndex& index) const {
  return index.isValid() && !isAbsentRow(index) ? listed_->labels[at(index)].value : std::uint16_t{0};
}

}  // namespace fenestra::viewer
