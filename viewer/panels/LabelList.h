#pragma once
// The list of labels; a click on a column changes it.

#include <QTreeView>

class QSortFilterProxyModel;

namespace fenestra::viewer {

class Document;
class LabelModel;
class PlacementController;

class LabelList : public QTreeView {
  Q_OBJECT
 public:
  LabelList(Document& document, const PlacementController& placement, QWidget* parent = nullptr);

  LabelModel& labels() const { return *labels_; }
  /// The label of a row of the list, 0 for none.
  std::uint16_t labelAt(const QModelIndex& row) const;
  /// Shows the rows whose name holds all words of the text.
  void filter(const QString& text);
  /// The text shown where the filter leaves no row; else empty.
  QString emptyText() const;
  void scrollToLabel(std::uint16_t label);
  bool isEmpty() const;
  /// With the header and eight rows.
  int leastHeight() const;

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void arrangeColumns();
  void clickedAt(const QModelIndex& index);
  void chooseColour(const QModelIndex& index);
  void chooseRole(std::uint16_t label, QPoint at);
  void addRoles(QMenu& menu, std::uint16_t label);

  Document& document_;
  LabelModel* labels_;
  QSortFilterProxyModel* shown_;
};

}  // namespace fenestra::viewer
