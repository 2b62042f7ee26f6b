#pragma once
// Small pictures of series in the tree of results, where the server speaks DICOMweb: fetched one after the other for
// the rows in sight alone, and no more for rows that have left it. Nothing is asked of another server.

#include <deque>
#include <string>

#include <QCache>
#include <QImage>
#include <QObject>
#include <QPixmap>
#include <QTimer>

#include "viewer/archive/Archives.h"
#include "viewer/jobs/LoadJob.h"

class QTreeView;

namespace fenestra::viewer {

class ArchiveModel;
struct ArchiveNode;

class ArchivePictures : public QObject {
  Q_OBJECT
 public:
  /// All outlive this. It gives the model its pictures.
  ArchivePictures(Archives& archives, QTreeView& view, ArchiveModel& model);
  ~ArchivePictures() override;

  /// The server that the model's tree is from, by its entry's id; what was fetched is forgotten.
  void setServer(const QString& id);
  /// Whether a picture is being fetched, or soon will be.
  bool isBusy() const { return job_.isRunning() || look_.isActive() || !wanted_.empty(); }
  /// Bytes that the pictures hold, and how many they may.
  qsizetype bytes() const { return kept_.totalCost(); }
  static constexpr qsizetype mostBytes = 16 << 20;

  /// The picture in the bytes of a server, at most `side` pixels wide and high; null when it is none, or claims a size
  /// out of proportion. Of any thread.
  static QImage pictureIn(const std::string& bytes, int side);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// What came of a series; without a picture where the server has none, so that it is asked once.
  struct Kept {
    QPixmap picture;
    bool couldShowNames = true;
  };
  struct Wanted {
    std::string study, series;
    std::size_t objects = 0;
  };

  QPixmap pictureOf(const ArchiveNode& node, bool hidesPatient) const;
  void lookAtRows();
  void fetchNext();
  void keep(const QString& series, const QImage& picture, bool couldShowNames);

  Archives& archives_;
  QTreeView& view_;
  ArchiveModel& model_;
  QString server_;  ///< empty: one without DICOMweb
  QCache<QString, Kept> kept_{mostBytes};
  std::deque<Wanted> wanted_;  ///< in sight, in their order
  std::string fetching_;       ///< the series whose picture is on its way
  QPixmap blank_;              ///< where there is none yet, so that no row moves
  QTimer look_;
  LoadJob job_{archiveThreads()};
};

}  // namespace fenestra::viewer
