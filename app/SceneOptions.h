#pragma once
// The options that describe what to show, common to the window and the command line, and how they become a scene.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/ClipOptions.h"
#include "io/VolumeReader.h"
#include "io/session/LookFile.h"
#include "io/session/Session.h"
#include "rendering/scene/Scene.h"
#include "rendering/scene/View.h"
#include "rendering/segmentation/RegionGrowing.h"

namespace CLI {
class App;
}

namespace fenestra::app {

/// The volume to open.
struct VolumeOptions {
  std::filesystem::path path;  ///< empty with a phantom; may be a session
  std::string phantom;         ///< name of a built-in phantom, or empty
  int phantomVoxels = 256;     ///< along its longest side
  std::string series;
  std::optional<int> time;  ///< time point, from 1
  std::optional<io::RawDescription> raw;
  bool allowOutside = false;                 ///< see io::OpenOptions
  std::optional<io::Regularise> regularise;  ///< unset: Automatic, or the session's
  std::optional<Modality> modality;          ///< unset: as the file says, or recognised
  std::filesystem::path data;                ///< where the volume of a session is now; empty: where the session says

  bool empty() const { return path.empty() && phantom.empty(); }
  /// Its name in errors and titles: the path, or "phantom NAME".
  std::string source() const;
};

/// Degrees, as Camera::fromAngles takes them.
struct ViewAngles {
  double azimuth = 0.0, elevation = 0.0;
};
/// A camera that is placed for the focus (rendering/placement): the best view, or the one that complements it.
enum class PlacedView : std::uint8_t { Best, Dual };
/// A standard view, angles, a camera file, or a placed camera.
using CameraChoice = std::variant<StandardView, ViewAngles, std::filesystem::path, PlacedView>;

/// Changes of how single labels are shown; labels by value or name.
struct LabelChanges {
  struct Function {
    std::string label;   ///< empty: all of the focus
    std::string source;  ///< preset or file, see io::loadContextFunction; empty: one material
  };
  std::vector<std::string> hidden, guarded;  ///< guarded: protected
  std::vector<std::pair<std::string, double>> opacities;
  std::vector<std::pair<std::string, glm::dvec3>> colours;
  std::vector<std::pair<std::string, int>> importance;  ///< levels
  std::vector<Function> functions;  ///< of the focus, applied in their order; not counted by empty()

  bool empty() const {
    return hidden.empty() && guarded.empty() && opacities.empty() && colours.empty() && importance.empty();
  }
};

/// All options of a scene; unset members take what suits the data.
struct SceneOptions : VolumeOptions {
  std::filesystem::path labels;
  std::vector<std::string> focusLabels;  ///< values or names
  LabelChanges labelChanges;
  ClipChanges clipChanges;
  std::optional<ValueRange> focusRange;
  double focusMinimumSize = ValueFocus{}.minimumComponent;  ///< mm³
  std::string transferFunction;                             ///< preset or file; empty: io::defaultPreset
  std::optional<CameraChoice> camera;
  std::optional<CameraChoice> frozen;  ///< the camera that the opening stays cut for; not a placed one
  std::optional<Projection> projection;
  std::optional<glm::ivec2> size;        ///< rendered pixels
  std::filesystem::path strokes;         ///< file of brush strokes; empty: those of the look
  RegionFocus region;                    ///< empty(): none
  std::optional<io::LookPreset> preset;  ///< `look` is in its style, and its transfer function stays
  Look look;  ///< starts as the session's; the members above override its focus, context, clipping and strokes
  Quality quality = Quality::Normal;
  std::optional<double> maxError;                  ///< in 1/255; see View
  ShownSlices slices;                              ///< of walls: those of a session, then of the options
  std::optional<double> windowWidth, windowLevel;  ///< in place of those of slices.window
  int viewOfSession = 0;  ///< whose camera and picture size are taken from a session: 0 is C1, 1 is C2
};

/// Adds PATH, --phantom, --series, --raw, --spacing, --regularise, --modality and --data. Values are checked while
/// parsing, and mistakes throw CLI::ParseError. Numbers have a decimal point in every locale. `options` must outlive
/// `command`.
void addVolumeOptions(CLI::App& command, VolumeOptions& options);
/// Adds the above and everything else in SceneOptions. When PATH is a session, parsing reads it first, which may throw
/// io::Error, and the session gives the defaults of all other options; `onSession` may set the caller's own options,
/// added later, in the same way.
void addSceneOptions(CLI::App& command, SceneOptions& options, std::function<void(const io::Session&)> onSession = {});

/// Adds the options of addVolumeOptions, --labels, --focus-labels and what else describes the focus.
void addLabelOptions(CLI::App& command, SceneOptions& options);

/// Opens the volume or that of the session, or makes the phantom (format "phantom"). Throws io::Error, io::Cancelled.
struct OpenedData {
  io::OpenedVolume volume;
  std::shared_ptr<const LabelMap> labels;  ///< a phantom's own, or the session's; null for files
  std::optional<io::Session> session;      ///< as opened
};
OpenedData openData(const VolumeOptions& options, const io::Progress& progress = {});
/// With the label map of a file, when `labels` names one; a session or phantom has its own otherwise.
OpenedData openData(const VolumeOptions& options, const std::filesystem::path& labels, const io::Progress& progress);

/// A focus of the kind that the scene will be drawn with, as far as the options tell before anything is read.
Focus expectedFocus(const SceneOptions& options);

struct LoadedScene {
  io::OpenedVolume volume;                             ///< its warnings moved to `warnings`
  Scene asSet;                                         ///< its focus may be a region
  std::shared_ptr<const segmentation::Growth> growth;  ///< of that region, or null
  Scene scene;                                         ///< as it is drawn
  View view;
  std::optional<PlacedView> placed;    ///< the caller must place view.camera, which needs an OpenGL context
  std::optional<io::Session> session;  ///< the session that this was made from, with the data that were opened
  std::vector<io::Warning> warnings;   ///< of volume, labels and focus
};
/// From options to a scene: opens the data, resolves labels and transfer function, places the camera. A phantom
/// without focus options gets the focus that shows the cutaway best. Throws io::Error, io::Cancelled.
LoadedScene loadScene(const SceneOptions& options, const io::Progress& progress = {});

}  // namespace fenestra::app
