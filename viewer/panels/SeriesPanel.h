#pragma once
// The series of what is open, by patient and study, with small pictures. A series that is activated or dropped onto a
// view opens. While the panel is hidden it reads nothing and holds no picture.

#include <memory>
#include <string>
#include <vector>

#include <QHash>
#include <QPixmap>
#include <QString>
#include <QWidget>

#include "io/base/Reading.h"
#include "viewer/model/SeriesText.h"

class QMimeData;
class QTreeWidget;
class QTreeWidgetItem;

namespace fenestra::viewer {

class Document;
class Thumbnails;
class ViewOptions;

class SeriesPanel : public QWidget {
  Q_OBJECT
 public:
  /// Both outlive this.
  SeriesPanel(const Document& document, const ViewOptions& options, QWidget* parent = nullptr);
  ~SeriesPanel() override;

  QTreeWidget* list() const { return list_; }
  /// The rows of the series, from top to bottom.
  std::vector<QTreeWidgetItem*> rows() const;
  /// The id of the series that a drag brings; empty for any other drag.
  static QString seriesOf(const QMimeData& data);
  /// Whether the drag began in this panel.
  bool isSourceOf(const QMimeData& drag) const;

  /// Asks to open a series, unless it is the one that is open.
  void choose(const QString& series);

 Q_SIGNALS:
  /// `series` is an id; never that of the series that is open.
  void chosen(const QString& series);
  /// It is to be opened beside what is open.
  void besideChosen(const QString& series);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  /// Lists what is open; at once while visible, otherwise when the panel is shown.
  void follow();
  void fill();
  /// The row of the series' study, which is added where it is new.
  QTreeWidgetItem* parentOf(const io::SeriesInfo& series) const;
  SeriesNames names() const;
  void addRow(const io::SeriesInfo& series, QTreeWidgetItem* parent);
  void showMenu(QPoint at);
  void makePictures(const std::vector<io::SeriesInfo>& series);
  void showPicture(const QString& series);

  const Document& document_;
  const ViewOptions& options_;
  QTreeWidget* list_;
  std::unique_ptr<Thumbnails> thumbnails_;  ///< null while nothing is made
  std::string of_;                          ///< the place of the data that pictures_ shows
  QHash<QString, QPixmap> pictures_;        ///< by the series' id
};

}  // namespace fenestra::viewer
