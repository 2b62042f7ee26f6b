#pragma once
// The DICOM attributes of the file that the slice in view was read from, to search and to copy. It follows the active
// slice and the crosshair. Files are read in the background; while the panel is hidden it reads nothing and holds
// nothing.

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <QTimer>
#include <QWidget>

#include "io/dicom/TagList.h"
#include "rendering/volume/Slice.h"

class QLabel;
class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace fenestra::viewer {

class Document;
class LoadJob;
class SliceCursor;
class SlicePlanes;
class ViewOptions;

class TagsPanel : public QWidget {
  Q_OBJECT
 public:
  /// All outlive this.
  TagsPanel(const Document& document, const SliceCursor& cursor, const SlicePlanes& planes, const ViewOptions& options,
            QWidget* parent = nullptr);
  ~TagsPanel() override;

  /// The slice view that is active; empty while a 3-D view is.
  void setPlane(std::optional<SlicePlane> plane);

  /// The rows: tag, VR, name, value. Items of sequences are rows of their own below them.
  QTreeWidget* list() const { return list_; }
  QLineEdit* search() const { return search_; }
  /// Which slice and file the list is of, or why there is none.
  QString text() const;

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  /// Where the shown slice was read from, or why it has no file.
  struct Place {
    std::filesystem::path file;  ///< empty: none
    std::size_t frame = 0;
    int slice = 0;  ///< from 0
    QString reason;
    bool operator==(const Place&) const = default;
  };
  Place wanted() const;
  /// Goes to the slice that is in view now, a moment after the last change.
  void follow();
  void read();
  void fill();
  void say();
  void addRows(const std::vector<io::DicomTag>& tags, QTreeWidgetItem* parent, const QString& path) const;

  const Document& document_;
  const SliceCursor& cursor_;
  const SlicePlanes& planes_;
  const ViewOptions& options_;
  std::optional<SlicePlane> plane_;
  QLineEdit* search_;
  QLabel* says_;
  QTreeWidget* list_;
  QTimer soon_;
  std::unique_ptr<LoadJob> job_;  ///< null while the panel is hidden
  std::optional<Place> place_;    ///< what the list is of, or is being read for
  QString problem_;               ///< why it cannot be read; empty: it can
  std::vector<io::DicomTag> tags_;
};

}  // namespace fenestra::viewer
