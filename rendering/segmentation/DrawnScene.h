#pragma once
// The scene as it is drawn, made from the scene as it is set: a region in the focus becomes labels, and what the look
// removes is carved out.

#include "rendering/scene/RemovedVoxels.h"
#include "rendering/scene/SetScene.h"

namespace fenestra::segmentation {

struct Growth;

/// Keeps what has not changed since the last update, which makes the next one quick. Copies share it.
class DrawnScene {
 public:
  /// `growth` was grown from the region in the focus; null without a region, or while it is being grown: the focus of
  /// the update before stays until then.
  void update(const SetScene& set, const Growth* growth);

  const Scene& scene() const { return scene_; }
  /// The focus that shows, in labels() before anything is carved out of them.
  const Focus& focus() const { return focus_; }
  const std::shared_ptr<const LabelMap>& labels() const { return labels_; }
  /// It is a region: labels() are the steps of its growth.
  bool showsRegion() const { return isRegion_; }

 private:
  Scene scene_;
  Sculptor sculptor_;
  std::shared_ptr<const LabelMap> labels_;  ///< of the last update, before carving
  Focus focus_;                             ///< in those labels
  bool isRegion_ = false;
};

}  // namespace fenestra::segmentation
