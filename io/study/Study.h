#pragma once
// What was opened, ready to be drawn, edited and saved: the data, how they are looked at, and the session that keeps
// both. Plain data; copies are cheap, because they share the voxels.

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "io/session/Session.h"
#include "rendering/scene/View.h"
#include "rendering/segmentation/DrawnScene.h"
#include "rendering/segmentation/RegionGrowing.h"
#include "rendering/settings/Framing.h"

namespace fenestra::io {

/// A camera that is placed for the focus (rendering/placement): the best view, or the one that complements it.
enum class PlacedView : std::uint8_t { Best, Dual };

struct Study : VolumeInfo {
  SetScene scene;                                      ///< as it is set: its focus may be a region
  std::shared_ptr<const segmentation::Growth> growth;  ///< of that region, or null
  segmentation::GrowthMemory memory;                   ///< for users who can change that region: what it grew from
  segmentation::DrawnScene drawn;                      ///< what pictures show of both
  std::vector<Warning> warnings;                       ///< of volume, labels and focus

  /// Places of the data and choices about them; the whole session where the study was opened from one.
  Session session;
  bool restoresSession = false;       ///< `session` was opened, and a window becomes what it says
  std::filesystem::path sessionFile;  ///< of that session; empty without one
  bool isRecovered = false;           ///< not saved yet; see DataRequest::isRecovered

  std::optional<View> view;          ///< the first picture to make; unset: from anterior
  int viewIndex = 0;                 ///< which of the session's views that is: 0 is C1, 1 is C2
  std::optional<PlacedView> placed;  ///< view->camera has yet to be placed, which needs an OpenGL context

  std::optional<Framing> visible;         ///< the part that `scene` shows, for a camera to frame; see visibleOf()
  std::optional<glm::dvec3> crosshair;    ///< for windows: where it goes first, on the focus of `scene`; world mm
};

/// study.visible, found when it is first asked for: a look at all voxels.
const Framing& visibleOf(Study& study);

/// Puts into `study` what a reader gives; warnings go behind those that are there.
void takeVolume(OpenedVolume opened, Study& study);

/// The session of a study as it was read, with its first view. noteContents must add the data's contents before
/// writeSession.
Session sessionOf(const Study& study);

}  // namespace fenestra::io
