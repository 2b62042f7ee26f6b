#pragma once
// The document's labels as rows: a tick that makes a label part of the focus and its name, then its colour, whether it
// is visible, its role, its opacity and how much of it the cameras see. Labels without voxels are children of one last
// row.

#include <memory>
#include <vector>

#include <QAbstractItemModel>
#include <QFutureWatcher>

#include "rendering/volume/LabelMap.h"

namespace fenestra::viewer {

class Document;
class PlacementController;

class LabelModel : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Column { Name, Colour, Visible, Role, Opacity, Seen, columns };

  LabelModel(Document& document, const PlacementController& placement, QObject* parent = nullptr);

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  /// Takes the tick and the name in column Name, a QColor in Colour, and whole percents in Opacity.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// The label's value; 0 for the row of labels without voxels, and for an invalid index.
  std::uint16_t label(const QModelIndex& index) const;
  /// The row of labels without voxels; invalid where there are none.
  QModelIndex absentRow() const;
  /// To be called when the cameras may see more or less of the labels in focus.
  void refreshSeen();

 private:
  void readLabels();
  /// Splits the labels of `listed_` into those with voxels and those without.
  void part(const std::vector<bool>& present);
  QVariant nameData(std::size_t label, int role) const;
  QVariant settingData(std::size_t label, int column, int role) const;
  QVariant seenData(std::size_t label, int role) const;
  void refresh(int first, int last, const QList<int>& roles);
  /// The place in the label map's list of a label's row.
  std::size_t at(const QModelIndex& index) const;
  bool isAbsentRow(const QModelIndex& index) const;

  Document& document_;
  const PlacementController& placement_;
  /// The map whose labels are listed. A new study's labels replace them only a moment after it is open.
  std::shared_ptr<const LabelMap> listed_;
  QFutureWatcher<std::vector<bool>> counting_;  ///< finds which labels of listed_ have voxels, in the background
  std::vector<std::size_t> present_, absent_;   ///< places in the label map's list
};

}  // namespace fenestra::viewer
