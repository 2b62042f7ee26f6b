#pragma once
// What a user asks for: which data, and what is to be other than suits them. The options of the command line and the
// dialogs of the window fill a request; readStudy() makes a Study of it.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "io/session/LookFile.h"
#include "io/session/Session.h"
#include "io/study/Study.h"
#include "rendering/scene/View.h"
#include "rendering/settings/StartingLook.h"

namespace fenestra::io {

/// The data to open.
struct DataRequest {
  std::filesystem::path path;  ///< of a volume or a session; empty with a phantom
  std::string phantom;         ///< name of a built-in phantom, or empty
  int phantomVoxels = 256;     ///< along its longest side
  std::string series;          ///< as in OpenOptions
  std::optional<int> time;     ///< time point, from 1
  std::optional<RawDescription> raw;
  std::optional<glm::dvec3> spacing;     ///< see OpenOptions
  bool allowOutside = false;             ///< see OpenOptions
  std::optional<Regularise> regularise;  ///< unset: Automatic, or the session's
  std::optional<Modality> modality;      ///< unset: as the file says, or recognised
  std::filesystem::path labels;          ///< file of a label map; empty: the session's or phantom's own
  std::filesystem::path labelTable;      ///< of names and colours; empty: the map's own, or the session's
  std::optional<Session> session;        ///< that `path` was read as, or that lay in the folder of `path`
  std::filesystem::path data;            ///< where a session's volume is now; empty: where it says
  /// The session is an automatic copy that was not saved. It takes the place of the session that `autosaveOf` names.
  bool isRecovered = false;

  bool empty() const { return path.empty() && phantom.empty(); }
  /// Its name in errors and titles: the path, or "phantom NAME".
  std::string source() const;
  /// What errors about labels name: their file, or else source().
  std::filesystem::path labelSource() const;
};

/// Degrees, as Camera::fromAngles takes them.
struct ViewAngles {
  double azimuth = 0.0, elevation = 0.0;
};
/// A standard view, angles, a camera file, or a placed camera.
using CameraChoice = std::variant<StandardView, ViewAngles, std::filesystem::path, PlacedView>;

/// Changes of how single labels are shown; labels by value or name.
struct LabelChanges {
  struct Function {
    std::string label;   ///< empty: all of the focus
    std::string source;  ///< preset or file, see loadContextFunction; empty: one material
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

/// Changes of what clips the scene.
struct ClipChanges {
  /// Low and high end along L, P and S, mm; a missing one is the volume's.
  using Ends = std::array<std::array<std::optional<double>, 2>, 3>;
  std::optional<Ends> crop;
  std::vector<std::string> exempt;  ///< labels by value or name
};

/// Data, and how to look at them; unset members take what suits the data.
struct StudyRequest : DataRequest {
  Look look = startingLook();  ///< starts as the session's, where there is one; the members below override its focus,
                               ///< context, clipping and strokes
  std::vector<std::string> focusLabels;  ///< values or names
  LabelChanges labelChanges;
  ClipChanges clipChanges;
  std::optional<ValueRange> focusRange;
  double focusMinimumSize = ValueFocus{}.minimumComponent;  ///< mm³
  RegionFocus region;                                       ///< empty(): none
  /// For users who can change a session's region: seeds outside the volume are left out of it, and it may come out
  /// empty. Errors otherwise.
  bool acceptsAnyRegion = false;
  std::string transferFunction;      ///< preset or file; empty: defaultPreset, or plainPreset
  bool startsPlain = false;          ///< plainPreset takes the place of defaultPreset
  bool startsContextAnew = false;    ///< defaultPreset takes the place of a session's transfer function
  std::filesystem::path strokes;     ///< file of brush strokes; empty: those of the look
  std::optional<LookPreset> preset;  ///< `look` is in its style, and its transfer function stays

  std::optional<CameraChoice> camera;
  std::optional<CameraChoice> frozen;  ///< the camera that the opening stays cut for; not a placed one
  std::optional<Projection> projection;
  std::optional<glm::ivec2> size;  ///< rendered pixels
  int viewIndex = 0;               ///< whose camera and picture size are taken from a session: 0 is C1, 1 is C2
  Quality quality = Quality::Normal;
  std::optional<double> maxError;                  ///< in 1/255; see View
  ShownSlices slices;                              ///< of walls
  std::optional<double> windowWidth, windowLevel;  ///< in place of those of slices.window

  /// The plain look (Look's initialisers) and preset in place of the starting ones, for scripts and measurements. A
  /// session keeps its transfer function.
  void makePlain();
  /// The starting look and preset again; a session keeps its transfer function.
  void makeStarting();
  /// The bare look and the plain preset in place of the starting ones. A session keeps its own but for border and
  /// edges.
  void makeBare();
  /// Takes over a session's look, sampling and slices, for other choices to override, and opens its data.
  void startFrom(Session from);
};

/// For what a session's file says. Throws Error.
StudyRequest requestOfSession(const std::filesystem::path& file);

/// A focus of the kind that the study will be drawn with, as far as the request tells before anything is read.
Focus expectedFocus(const StudyRequest& request);

}  // namespace fenestra::io
