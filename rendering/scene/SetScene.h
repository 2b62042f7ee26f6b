#pragma once
// A scene as a user has set it: what panels edit and sessions keep; plain data. segmentation::DrawnScene makes of it
// the Scene that pictures are drawn from.

#include <memory>

#include "rendering/scene/Scene.h"

namespace fenestra {

struct SetScene {
  std::shared_ptr<const Volume> volume;
  std::shared_ptr<const LabelMap> labels;             ///< may be null; same grid dims as the volume
  Look look;                                          ///< its focus may be a region, which has to be grown
  std::shared_ptr<const CoarseMask> table = nullptr;  ///< see Scene::table

  bool operator==(const SetScene&) const = default;
};

/// The set scene without what takes work: a region in the focus shows nothing, and nothing is carved out.
inline Scene sceneOf(const SetScene& set) { return {set.volume, set.labels, set.look, set.table}; }

}  // namespace fenestra
