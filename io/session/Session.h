#pragma once
// Everything a user did to a study, and where the study is; plain data. SessionFile keeps it in one file.
//
// It takes nothing from the data that identifies a patient: a hash of its UID names the series, because the UID itself
// identifies the patient to anyone with access to the archive. Paths are the user's names of files and folders; they
// are kept relative to the session's file, so it does not name the folders above both. A folder named after a patient
// does name the patient.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/base/Contents.h"
#include "io/base/Reading.h"
#include "rendering/scene/View.h"
#include "rendering/settings/Camera.h"
#include "rendering/settings/Look.h"
#include "rendering/settings/PlacementOptions.h"
#include "rendering/settings/Quality.h"
#include "rendering/volume/ObliqueSlice.h"
#include "rendering/volume/Slab.h"
#include "rendering/volume/SliceMeasure.h"

namespace fenestra::io {

/// A file or folder that a session needs.
struct SessionData {
  std::filesystem::path path;                ///< absolute; empty: none
  Contents contents;                         ///< when the session was saved; no hash: not known
  std::vector<std::filesystem::path> files;  ///< the files that `contents` hashes, while the data are open; not saved
  bool operator==(const SessionData&) const = default;
};

struct SessionLabels : SessionData {
  std::filesystem::path table;  ///< of names and colours, chosen for them; absolute; empty: none
  bool operator==(const SessionLabels&) const = default;
};

struct SessionVolume : SessionData {
  std::string series;                 ///< seriesKey() of its id; empty where the file holds one volume
  int time = 1;                       ///< time point outside DICOM, where each is a series
  std::optional<RawDescription> raw;  ///< how its bytes are read
  std::optional<glm::dvec3> spacing;  ///< mm, told for a file that does not say it
  Regularise regularise = Regularise::Automatic;
  std::optional<Modality> modality;  ///< as in OpenedVolume
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
  /// Whether a picture higher than wide gets a wider field of view, as in the window; see Camera::fittedTo.
  bool fitsWidth = true;
  std::optional<OpeningView> frozen = std::nullopt;  ///< see View::frozen
  bool operator==(const SessionView&) const = default;
};

/// How cameras are placed; see rendering/placement.
struct SessionPlacement {
  int samples = 192;
  bool refined = false;
  placement::Weights weights;
  placement::Habits habits;
  bool inStream = false;  ///< C2 in the band around C1's great circle, not in the half sphere
  double streamHalfWidth = placement::Options().streamHalfWidth;
  double shareWeight = placement::Options().shareWeight;
  bool joint = placement::jointByDefault;
  bool follow = true;
  bool automatic = true;
  bool byPick = false;  ///< cameras for points clicked on slices, by LiveSync
  placement::LiveSyncOptions liveSync;
  bool operator==(const SessionPlacement&) const = default;
};

/// The camera that a slice faces.
enum class PlaneFollow : std::uint8_t { None, C1, C2 };

/// The thickest slab, in mm.
inline constexpr double mostSlab = 100.0;

/// How the slices of an anatomical plane's view lie, and how thick they are.
struct SessionPlane {
  std::optional<PlaneAxes> axes;  ///< unset: the volume's own slices
  PlaneFollow follow = PlaneFollow::None;
  Slab slab;
  bool operator==(const SessionPlane&) const = default;
};

/// What is drawn over the pictures.
struct SessionOverlays {
  bool crosshair = true, text = true, labels = true, measures = true, planes = false;
  bool operator==(const SessionOverlays&) const = default;
};

/// A 3-D view of a key image.
struct KeyView {
  Camera camera;
  std::optional<OpeningView> frozen = std::nullopt;  ///< see View::frozen
  bool operator==(const KeyView&) const = default;
};

/// A state of the window to return to: all that its pictures are made of, but for the data, the labels and the
/// measures, which stay as they are.
struct KeyImage {
  static constexpr std::size_t longestName = 200;         ///< bytes of UTF-8
  static constexpr std::size_t largestPicture = 1 << 18;  ///< bytes of Base64
  static constexpr std::size_t most = 500;                ///< in a session

  std::string name;
  std::string picture;  ///< a small one to find it by: PNG in Base64; empty: none
  Look look;
  std::array<KeyView, 2> views;  ///< C1 and C2
  WindowLevel window;            ///< of the slices
  bool inverted = false;
  glm::dvec3 crosshair{0.0};           ///< world (LPS), mm
  std::array<SessionPlane, 3> planes;  ///< axial, sagittal, coronal
  bool operator==(const KeyImage&) const = default;
};

struct Session {
  SessionVolume volume;
  std::optional<SessionPhantom> phantom;
  SessionLabels labels;
  Look look;
  Quality quality = Quality::Normal;
  std::optional<double> maxError;    ///< see View::maxError
  std::array<SessionView, 2> views;  ///< C1 and C2
  std::array<Camera, 2> home;        ///< where resetting the views goes
  bool linked = true;
  std::optional<WindowLevel> window;  ///< of the slices; unset: Volume::defaultWindow
  bool inverted = false;              ///< the slices show low values bright
  std::optional<glm::dvec3> crosshair;
  SessionOverlays overlays;
  std::array<SessionPlane, 3> planes;  ///< axial, sagittal, coronal
  std::vector<Measure> measures;       ///< on the slices
  std::vector<glm::dvec3> path;        ///< of the straightened picture, LPS, mm; empty: none
  bool followsPath = false;            ///< both cameras go along the path with its place
  std::vector<KeyImage> keyImages;     ///< in the user's order
  std::string maximised;               ///< the view that has the whole area: "C1", "C2", "axial", …; empty: none
  std::string layout;                  ///< the window's own, in Base64
  SessionPlacement placement;

  /// In an automatic copy, the file of the session that it is newer than; empty: there is none, or this is no copy.
  std::filesystem::path autosaveOf;
  /// Read from a file of before version 3, whose Automatic reconstruction smoothed less; readStudy() makes a choice of
  /// it that draws as before. Not saved.
  bool formerAutomatic = false;
  /// Members of the file that this version does not know, as JSON text, to be written back. Empty: none.
  std::string unknown;

  bool operator==(const Session&) const = default;
};

/// The most points of a path.
inline constexpr std::size_t mostPathPoints = 10'000;

/// The camera that makes a view's picture of that size.
Camera shownCamera(const SessionView& view, glm::ivec2 size);

}  // namespace fenestra::io
