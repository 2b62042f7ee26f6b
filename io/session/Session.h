#pragma once
// Everything a user did to a study, and where the study is; plain data. SessionFile keeps it in one file.
//
// Nothing in it comes from what the data say about a patient: the series is named by a hash of its UID, because a UID
// leads whoever has the archive to the patient. Paths are the names that the user gave to files and folders; they are
// kept relative to the session's file, so folders above both are not named. A folder named after a patient names them.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/Contents.h"
#include "io/VolumeReader.h"
#include "rendering/scene/Camera.h"
#include "rendering/scene/Look.h"
#include "rendering/scene/PlacementOptions.h"
#include "rendering/scene/Quality.h"

namespace fenestra::io {

/// A file or folder that a session needs.
struct SessionData {
  std::filesystem::path path;                ///< absolute; empty: none
  Contents contents;                         ///< what it held when the session was saved; no hash: not known
  std::vector<std::filesystem::path> files;  ///< what `contents` is of, while the data are open; not kept
  bool operator==(const SessionData&) const = default;
};

struct SessionVolume : SessionData {
  std::string series;                 ///< seriesKey() of its id; empty where the file holds one volume
  std::optional<RawDescription> raw;  ///< how its bytes are read
  bool operator==(const SessionVolume&) const = default;
};

/// A built-in phantom in place of a volume.
struct SessionPhantom {
  std::string name;
  int voxels = 256;  ///< along its longest side
  bool operator==(const SessionPhantom&) const = default;
};

/// One 3-D view: its camera, and the picture that was last seen there.
struct SessionView {
  Camera camera;
  glm::ivec2 size{960, 720};  ///< pixels
  double pixelScale = 1.0;    ///< pixels per device-independent pixel
  /// In a picture higher than wide the field of view is widened so that what fits across still does, as in the window.
  bool fitsWidth = true;
  bool operator==(const SessionView&) const = default;
};

/// How cameras are placed; see rendering/placement.
struct SessionPlacement {
  int samples = 192;
  bool refined = false;
  placement::Weights weights;
  bool inStream = false;  ///< C2 in the band around C1's great circle, not in the half sphere
  double streamHalfWidth = placement::Options().streamHalfWidth;
  double shareWeight = placement::Options().shareWeight;
  bool joint = false;
  bool follow = true;
  bool automatic = true;
  bool operator==(const SessionPlacement&) const = default;
};

/// What is drawn over the pictures.
struct SessionOverlays {
  bool crosshair = true, text = true, labels = true;
  bool operator==(const SessionOverlays&) const = default;
};

struct Session {
  SessionVolume volume;
  std::optional<SessionPhantom> phantom;
  SessionData labels;
  Look look;
  Quality quality = Quality::Normal;
  std::optional<double> maxError;    ///< see View::maxError
  std::array<SessionView, 2> views;  ///< C1 and C2
  std::array<Camera, 2> home;        ///< where resetting the views goes
  bool linked = true;
  std::optional<WindowLevel> window;  ///< of the slices; unset: as the data ask
  std::optional<glm::dvec3> crosshair;
  SessionOverlays overlays;
  std::string maximised;  ///< the view that has the whole area: "C1", "C2", "axial", …; empty: none
  std::string layout;     ///< the window's own, in Base64
  SessionPlacement placement;

  /// The session that this one, saved by itself, is ahead of; empty: it has no file yet, or is no automatic copy.
  std::filesystem::path autosaveOf;
  /// What the file held that this version does not know, as JSON text: it is written back. Empty: nothing.
  std::string unknown;

  bool operator==(const Session&) const = default;
};

/// The camera that makes a view's picture of that size.
Camera shownCamera(const SessionView& view, glm::ivec2 size);

}  // namespace fenestra::io
