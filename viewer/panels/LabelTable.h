#pragma once
// A table of the labels: volume, values, extent, and how much of each the cameras see. It is computed in the
// background, not before it is first shown, and kept until the labels or the volume change.

#include <memory>
#include <vector>

#include <QWidget>

#include "viewer/jobs/LoadJob.h"
#include "viewer/model/LabelRows.h"

class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace fenestra::viewer {

class Document;
class PlacementController;
class SliceCursor;

class LabelTable : public QWidget {
  Q_OBJECT
 public:
  /// All outlive this.
  LabelTable(const Document& document, const PlacementController& placement, SliceCursor& cursor,
             QWidget* parent = nullptr);

  enum Column { Name, Volume, Mean, Deviation, Extent, SeenByC1, SeenByC2, columns };
  QTreeWidget* list() const { return list_; }
  /// The table as a file has it; rows by the labels' values.
  QString csv() const;
  /// Computed, or there is nothing to compute.
  bool isDone() const { return !job_.isRunning(); }

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void forget();
  void compute();
  void fill();
  void showSeen();
  void say(const QString& text);
  SeenByCameras seenOf(std::uint16_t label) const;
  void goTo(const QTreeWidgetItem* row);
  void copyCsv() const;
  void saveCsv();

  const Document& document_;
  const PlacementController& placement_;
  SliceCursor& cursor_;
  QTreeWidget* list_;
  QLabel* says_;
  QPushButton *copy_, *save_;
  std::vector<LabelRow> rows_;
  QString problem_;       ///< why they could not be measured; empty: they could
  bool isKnown_ = false;  ///< rows_ is of the present labels
  LoadJob job_;
};

}  // namespace fenestra::viewer
