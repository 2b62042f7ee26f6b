#include "viewer/panels/CopyRows.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QTreeView>

namespace fenestra::viewer {

CopyRows::CopyRows(QTreeView& list) : QObject(&list), list_(list) {
  list.setSelectionMode(QAbstractItemView::ExtendedSelection);
  list.setSelectionBehavior(QAbstractItemView::SelectRows);
  list.setContextMenuPolicy(Qt::ActionsContextMenu);
  auto* value = new QAction(tr("Copy the &value"), this);
  auto* rows = new QAction(tr("&Copy the rows"), this);
  connect(value, &QAction::triggered, this, &CopyRows::copyValue);
  connect(rows, &QAction::triggered, this, &CopyRows::copyRows);
  list.addActions({value, rows});
  list.installEventFilter(this);
}

QString CopyRows::rows() const {
  QStringList lines;
  // From the top of the list on: the order in which rows were selected says nothing.
  for (QModelIndex row = list_.model()->index(0, 0); row.isValid(); row = list_.indexBelow(row)) {
    if (!list_.selectionModel()->isSelected(row)) continue;
    QStringList cells;
    for (int column = 0; column < list_.model()->columnCount(); ++column)
      if (!list_.isColumnHidden(column)) cells << row.siblingAtColumn(column).data().toString();
    lines << cells.join(QLatin1Char('\t'));
  }
  return lines.join(QLatin1Char('\n'));
}

void CopyRows::copyRows() const { QGuiApplication::clipboard()->setText(rows()); }

void CopyRows::copyValue() const { QGuiApplication::clipboard()->setText(list_.currentIndex().data().toString()); }

bool CopyRows::eventFilter(QObject* watched, QEvent* event) {
  const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (!isKey || !static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy))
    return QObject::eventFilter(watched, event);
  event->accept();  // of an override: the key comes here in place of the menu
  if (event->type() == QEvent::KeyPress) copyRows();
  return true;
}

}  // namespace fenestra::viewer
