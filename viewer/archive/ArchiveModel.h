#pragma once
// What an archive answered, as a tree of patients, their studies and the series of these. Series are fetched when a
// study is unfolded. While the patient is hidden, no text names one.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QAbstractItemModel>
#include <QPixmap>

#include "io/archive/Records.h"

namespace fenestra::viewer {

/// A patient, study or series. Series have no children.
struct ArchiveNode {
  enum class Kind : std::uint8_t { Root, Patient, Study, Series };
  Kind kind = Kind::Root;
  io::archive::Attributes record;
  ArchiveNode* parent = nullptr;
  int row = 0;
  bool isFetched = false;  ///< of a study: its series are its children, or are on their way
  std::vector<std::unique_ptr<ArchiveNode>> children;

  std::string value(const char* keyword) const { return io::archive::valueOf(record, keyword); }
  ArchiveNode& add(Kind childKind, const io::archive::Attributes& childRecord);
};

/// The tree of answers at the level of studies: patients by name, studies from the latest on. Of any thread.
std::shared_ptr<ArchiveNode> treeOfStudies(const std::vector<io::archive::Attributes>& studies);

class ArchiveModel : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Column : int { Name, Date, Type, Images, ColumnCount };

  using QAbstractItemModel::QAbstractItemModel;

  void setTree(std::shared_ptr<ArchiveNode> tree);
  void setHidesPatient(bool hides);
  /// The series that were fetched, by number; nothing where the study is no longer in the tree.
  void setSeries(const std::string& study, std::vector<io::archive::Attributes> series);
  /// They could not be fetched, and are asked for again when the study is unfolded again.
  void forgetFetch(const std::string& study);
  /// What a series shows before its name; null: no picture and no room for one. Asked whenever it is drawn.
  using PictureOf = std::function<QPixmap(const ArchiveNode& series, bool hidesPatient)>;
  void setPictures(PictureOf pictureOf) { pictureOf_ = std::move(pictureOf); }
  /// Another picture of a series is there.
  void showPicture(const std::string& series);
  /// Null for the root.
  const ArchiveNode* nodeAt(const QModelIndex& index) const;
  /// What a list calls a study or series, with its patient: for the screen alone, while the patient is not hidden.
  static QString titleOf(const ArchiveNode& node);

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  bool hasChildren(const QModelIndex& parent = {}) const override;
  bool canFetchMore(const QModelIndex& parent) const override;
  void fetchMore(const QModelIndex& parent) override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QStringList mimeTypes() const override;
  QMimeData* mimeData(const QModelIndexList& indexes) const override;

  /// What a drag out of the tree carries; it says only that there is one.
  static const char* const dragType;

 Q_SIGNALS:
  void seriesWanted(const QString& study);

 private:
  ArchiveNode* node(const QModelIndex& index) const;
  ArchiveNode* findStudy(const std::string& study) const;
  QModelIndex indexOf(const ArchiveNode& node) const;
  static QString nameOf(const ArchiveNode& node, bool hidesPatient);
  QString toolTipOf(const ArchiveNode& node) const;

  PictureOf pictureOf_;
  std::shared_ptr<ArchiveNode> root_ = std::make_shared<ArchiveNode>();
  bool hidesPatient_ = false;
};

}  // namespace fenestra::viewer
