#pragma once
// Placing the cameras: the button, the best viewpoints, the map of all viewpoints, and the settings.

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "viewer/panels/BestViews.h"
#include "viewer/panels/PlacementForm.h"
#include "viewer/panels/ScrollingPanel.h"

namespace fenestra::viewer {

class Document;
class PlacementController;
class SphereMap;
class ViewLink;

class CamerasPanel : public ScrollingPanel {
  Q_OBJECT
 public:
  CamerasPanel(Document& document, ViewLink& cameras, PlacementController& placement, QWidget* parent = nullptr);

  QPushButton* placeButton() const { return place_; }
  QLabel* share() const { return share_; }
  BestViews& bestViews() const { return *best_; }
  SphereMap* map() const { return map_; }
  PlacementForm& form() const { return *form_; }
  /// Down to the map of viewpoints.
  int usefulHeight() const override;

 private:
  QWidget* makeBody();
  void show();
  void showShare();

  PlacementController& placement_;
  QPushButton *place_, *cancel_;
  QProgressBar* progress_;
  QLabel *share_, *note_;
  BestViews* best_;
  SphereMap* map_;
  PlacementForm* form_;
};

}  // namespace fenestra::viewer
