#pragma once
// The document's labels as rows: colour, name, and a tick that makes a label part of the focus.

#include <QAbstractListModel>

namespace fenestra::viewer {

class Document;

class LabelModel : public QAbstractListModel {
  Q_OBJECT
 public:
  explicit LabelModel(Document& document, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// The label's value, 0 for an invalid index.
  std::uint16_t label(const QModelIndex& index) const;

 private:
  Document& document_;
};

}  // namespace fenestra::viewer
