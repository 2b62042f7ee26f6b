#include "viewer/panels/LabelModel.h"

#include "viewer/model/Document.h"
#include "viewer/style/Overlay.h"

namespace fenestra::viewer {
namespace {

const std::vector<Label>& labelsOf(const Document& document) {
  static const std::vector<Label> none;
  return document.labels() ? document.labels()->labels : none;
}

}  // namespace

LabelModel::LabelModel(Document& document, QObject* parent) : QAbstractListModel(parent), document_(document) {
  connect(&document, &Document::labelsChanged, this, [this] {
    beginResetModel();
    endResetModel();
  });
  connect(&document, &Document::focusChanged, this, [this] {
    if (rowCount() > 0) Q_EMIT dataChanged(index(0), index(rowCount() - 1), {Qt::CheckStateRole});
  });
}

int LabelModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(labelsOf(document_).size());
}

QVariant LabelModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Label& label = labelsOf(document_)[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return label.name.empty() ? tr("Label %1").arg(label.value) : QString::fromStdString(label.name);
    case Qt::ToolTipRole:
      return tr("Label %1").arg(label.value);
    case Qt::DecorationRole:
      return toColour(label.colour);
    case Qt::CheckStateRole:
      return document_.isFocused(label.value) ? Qt::Checked : Qt::Unchecked;
    default:
      return {};
  }
}

bool LabelModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::CheckStateRole || !index.isValid()) return false;
  document_.setFocused(label(index), value.toInt() == Qt::Checked);
  return true;
}

Qt::ItemFlags LabelModel::flags(const QModelIndex& index) const {
  return QAbstractListModel::flags(index) | (index.isValid() ? Qt::ItemIsUserCheckable : Qt::NoItemFlags);
}

std::uint16_t LabelModel::label(const QModelIndex& index) const {
  return index.isValid() ? labelsOf(document_)[static_cast<std::size_t>(index.row())].value : std::uint16_t{0};
}

}  // namespace fenestra::viewer
