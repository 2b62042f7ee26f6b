#include "viewer/panels/StrokeModel.h"

#include "viewer/model/Brush.h"
#include "viewer/model/Document.h"

namespace fenestra::viewer {

StrokeModel::StrokeModel(Document& document, QObject* parent) : QAbstractListModel(parent), document_(document) {
  connect(&document, &Document::strokesChanged, this, &StrokeModel::follow);
}

void StrokeModel::follow() {
  const int now = static_cast<int>(document_.strokes().size());
  // Rows are inserted rather than reset, so that painting a stroke keeps the selection.
  if (now == rows_ + 1) {
    beginInsertRows({}, rows_, rows_);
    rows_ = now;
    endInsertRows();
  } else if (now != rows_) {
    beginResetModel();
    rows_ = now;
    endResetModel();
  }
  if (rows_ > 0) Q_EMIT dataChanged(index(0), index(rows_ - 1));
}

int StrokeModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : rows_; }

QVariant StrokeModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rows_) return {};
  const BrushStroke& stroke = document_.strokes()[static_cast<std::size_t>(index.row())];
  if (role == Qt::CheckStateRole) return stroke.hidden ? Qt::Unchecked : Qt::Checked;
  if (role != Qt::DisplayRole) return {};
  QStringList parts{QStringLiteral("%1  %2").arg(index.row() + 1).arg(nameOf(stroke.mode))};
  if (!movesRayStart(stroke.mode))
    parts << tr("%1 %").arg(100.0 * stroke.amount, 0, 'f', 0);
  else if (stroke.toSurface && stroke.mode == BrushMode::Restore)
    parts << tr("to the surface");
  else
    parts << tr("%1 mm deep").arg(stroke.depth, 0, 'f', 1);
  if (stroke.coversFocus) parts << tr("over the focus");
  if (stroke.view >= 0) parts << tr("C%1 only").arg(stroke.view + 1);
  return parts.join(QStringLiteral(", "));
}

bool StrokeModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::CheckStateRole || !index.isValid()) return false;
  BrushStrokes strokes = document_.strokes();
  BrushStroke& stroke = strokes[static_cast<std::size_t>(index.row())];
  stroke.hidden = value.toInt() != Qt::Checked;
  const QString step = stroke.hidden ? tr("Hide stroke") : tr("Show stroke");
  document_.setStrokes(std::move(strokes), step);
  return true;
}

Qt::ItemFlags StrokeModel::flags(const QModelIndex& index) const {
  return QAbstractListModel::flags(index) | (index.isValid() ? Qt::ItemIsUserCheckable : Qt::NoItemFlags);
}

}  // namespace fenestra::viewer
