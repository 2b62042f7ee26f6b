#pragma once
// The curved reformat: the volume straightened along the path (PathMode), the section across it at the chosen place,
// and the length, area and radius there. By the same code as `fenestra-cli reformat`.

#include <memory>
#include <optional>

#include <QTimer>
#include <QWidget>

#include "rendering/reformat/Region.h"
#include "viewer/jobs/LoadJob.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace fenestra::viewer {

class Document;
class PathCameras;
class PathMode;
class PathOpening;
class ReformatPicture;
class ViewOptions;

class ReformatPanel : public QWidget {
  Q_OBJECT
 public:
  struct Parts {
    Document& document;
    PathMode& mode;
    PathCameras& cameras;
    PathOpening& opening;
    const ViewOptions& options;
  };
  /// All outlive this. Nothing is computed while the panel is hidden.
  explicit ReformatPanel(const Parts& parts, QWidget* parent = nullptr);

  ReformatPicture& straight() const { return *straight_; }
  ReformatPicture& across() const { return *across_; }
  QString text() const;
  /// The structure's cross-section at the place; empty without one, or until it is known.
  std::optional<reformat::Section> section() const { return section_; }
  /// Finds the centre line of the structure in focus in the background, and makes it the path.
  void followFocus();
  QCheckBox* camerasFollow() const { return camerasFollow_; }
  QCheckBox* opensAlong() const { return opensAlong_; }
  QDoubleSpinBox* tubeRadius() const { return tubeRadius_; }
  bool isBusy() const { return job_.isRunning() || soon_.isActive(); }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void layOut();
  void connectAll();
  void connectCameras(PathCameras& cameras, const ViewOptions& options);
  void connectOpening();
  /// Reads the structure in focus anew, where one shows. The tube around the path is none: the structure before stays.
  void followFocusChange();
  void forgetRegion();
  void readRegion();
  /// Brings the pictures up to date, from the event loop.
  void show(bool straight);
  void draw();
  void drawStraight();
  void drawAcross();
  void say();
  /// The finest of the volume's voxel sides, or so coarse that the picture has no more pixels than a screen shows.
  double spacing() const;

  Document& document_;
  PathMode& mode_;
  PathOpening& opening_;
  LoadJob job_;                                          ///< reads the region, or finds its centre line
  std::shared_ptr<const reformat::VoxelRegion> region_;  ///< of the focus; null until it is read
  std::optional<reformat::Section> section_;
  bool isStraightOld_ = true;
  QString problem_;
  QTimer soon_;
  QToolButton* draw_;
  QPushButton *follow_, *delete_;
  QDoubleSpinBox *width_, *angle_;
  QCheckBox *camerasFollow_, *opensAlong_;
  QDoubleSpinBox* tubeRadius_;
  ReformatPicture *straight_, *across_;
  QLabel* says_;
};

}  // namespace fenestra::viewer
