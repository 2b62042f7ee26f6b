#pragma once
// Placing the cameras: how candidates are measured and judged, the best viewpoints, and where the cameras are among
// them.

#include <array>
#include <functional>
#include <vector>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>

#include "viewer/panels/ScrollingPanel.h"

namespace fenestra::viewer {

class Document;
class PlacementController;
struct PlacementSettings;
class SliderSpin;
class SphereMap;
class ViewLink;

class CamerasPanel : public ScrollingPanel {
  Q_OBJECT
 public:
  static constexpr std::size_t thumbnailCount = 4;
  static constexpr std::size_t weightCount = 7;

  CamerasPanel(Document& document, ViewLink& cameras, PlacementController& placement, QWidget* parent = nullptr);

  QPushButton* placeButton() const { return place_; }
  QComboBox* sampling() const { return sampling_; }
  QComboBox* region() const { return region_; }
  SliderSpin* streamHalfWidth() const { return streamHalfWidth_; }
  QCheckBox* joint() const { return joint_; }
  QCheckBox* follow() const { return follow_; }
  QCheckBox* automatic() const { return automatic_; }
  /// Depth, size, centring; then the further ones.
  SliderSpin* weight(std::size_t which) const { return weights_.at(which); }
  SphereMap* map() const { return map_; }
  QToolButton* thumbnail(std::size_t rank) const { return thumbnails_.at(rank); }
  QLabel* share() const { return share_; }

  /// Thumbnails are still to be drawn.
  bool isDrawing() const { return drawing_.isActive(); }

 Q_SIGNALS:
  /// The user changed this of the settings, here.
  void edited(const std::function<void(PlacementSettings&)>& change);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void show();
  void showShare();
  /// The best viewpoints have changed, or may have.
  void listBest();
  /// Draws the thumbnails anew, after a moment.
  void drawBest();
  /// One thumbnail, so that the window answers in between.
  void drawNext();

  ViewLink& cameras_;
  PlacementController& placement_;
  QPushButton *place_, *cancel_;
  QProgressBar* progress_;
  QLabel *share_, *note_;
  QComboBox *sampling_, *region_;
  SliderSpin *streamHalfWidth_, *shareWeight_;
  QCheckBox *joint_, *follow_, *automatic_;
  std::array<SliderSpin*, weightCount> weights_{};
  SphereMap* map_;
  std::array<QToolButton*, thumbnailCount> thumbnails_{};
  std::vector<std::size_t> best_;  ///< the candidates that the thumbnails show
  std::size_t drawn_ = 0;          ///< of them
  QTimer drawing_;
};

}  // namespace fenestra::viewer
