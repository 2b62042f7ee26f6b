#pragma once
// How candidates for the cameras are measured and judged.

#include <array>
#include <functional>

#include <QCheckBox>
#include <QComboBox>
#include <QWidget>

#include "viewer/model/PlacementWeights.h"

class QFormLayout;

namespace fenestra::viewer {

class PlacementController;
struct PlacementSettings;
class SliderSpin;

class PlacementForm : public QWidget {
  Q_OBJECT
 public:
  explicit PlacementForm(PlacementController& placement, QWidget* parent = nullptr);

  QComboBox* sampling() const { return sampling_; }
  QComboBox* region() const { return region_; }
  /// Whether cameras are placed for the focus or for a point clicked on a slice.
  QComboBox* subject() const { return subject_; }
  QCheckBox* joint() const { return joint_; }
  QCheckBox* follow() const { return follow_; }
  /// Depth, size, centring, cut ends; then the further ones.
  SliderSpin* weight(std::size_t which) const { return weights_.at(which); }
  /// As placementHabits lists them.
  QCheckBox* habit(std::size_t which) const { return habits_.at(which); }

 Q_SIGNALS:
  /// The user changed a setting; `change` applies the same change to other settings.
  void edited(const std::function<void(PlacementSettings&)>& change);

 private:
  void makeChoices();
  void makeRows();
  void addWeights(QFormLayout& form);
  void addHabits(QFormLayout& form);
  QWidget* makePickRows();
  void connectChoices();
  void edit(const std::function<void(PlacementSettings&)>& change);
  void show();

  PlacementController& placement_;
  QCheckBox *automatic_, *follow_, *joint_;
  QComboBox *subject_, *sampling_, *region_;
  QWidget* pickRows_;
  std::array<SliderSpin*, 4> pickWeights_{};
  SliderSpin* reach_;
  SliderSpin *streamHalfWidth_, *shareWeight_;
  std::array<SliderSpin*, placementWeights.size()> weights_{};
  std::array<QCheckBox*, placementHabits.size()> habits_{};
};

}  // namespace fenestra::viewer
