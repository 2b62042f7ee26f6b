#pragma once
// The document's brush strokes as rows, in the order they were painted, each with its effect and a tick to show it.

#include <QAbstractListModel>

namespace fenestra::viewer {

class Document;

class StrokeModel : public QAbstractListModel {
  Q_OBJECT
 public:
  explicit StrokeModel(Document& document, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 private:
  void follow();

  Document& document_;
  int rows_ = 0;
};

}  // namespace fenestra::viewer
