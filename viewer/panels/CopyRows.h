#pragma once
// Copying rows of a list: by the keyboard's own key for it, which is the menu's for the picture elsewhere, and by the
// menu of the right mouse button.

#include <QObject>
#include <QString>

class QTreeView;

namespace fenestra::viewer {

class CopyRows : public QObject {
  Q_OBJECT
 public:
  /// The list owns this; its rows are selected as a whole from now on.
  explicit CopyRows(QTreeView& list);

  /// The selected rows in the order of the list, their columns parted by tabs; hidden columns are left out.
  QString rows() const;
  void copyRows() const;
  /// The current cell.
  void copyValue() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QTreeView& list_;
};

}  // namespace fenestra::viewer
