#pragma once
// What is open and how it is shown: the scene, its display window and where the data came from. Every panel and view
// reads it and listens to it; none holds state of its own.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QObject>
#include <QString>

#include "io/VolumeReader.h"
#include "io/session/Session.h"
#include "rendering/scene/Scene.h"
#include "viewer/model/History.h"

namespace fenestra::viewer {

/// A data set as read, ready to be shown.
struct Study {
  Scene scene;
  std::string transferFunction;  ///< preset or file that made scene.look.context.function
  std::optional<Camera> camera;  ///< where to look from first; unset: from anterior
  bool placeCameras = false;     ///< place both for the focus once the study is open
  std::filesystem::path path;    ///< what the user opened; empty for a phantom
  io::SeriesInfo series;
  std::vector<io::SeriesInfo> otherSeries;
  std::vector<io::Warning> warnings;
  io::Session session;                ///< where the data are; all of the session that the study was opened from
  bool restoresSession = false;       ///< there is one: the window becomes what it says
  std::filesystem::path sessionFile;  ///< its file; empty without one
  bool isRecovered = false;           ///< it was saved after a crash by none but the program
};

/// What the user edits of a study: what undo and redo move through, and what a session keeps. The data is not in it.
struct Edits {
  Focus focus;
  FocusAppearance focusAppearance;
  std::string preset;        ///< built-in preset's id or file that `context` came from
  TransferFunction context;  ///< before the shift
  double shift = 0.0;        ///< moves `context` along the values, in the volume's unit
  Cutaway cutaway;
  ContextLayer contextLayer;
  BrushStrokes strokes;
  bool operator==(const Edits&) const = default;
};

class Document : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// Nothing of what was open before can be undone then.
  void open(Study study);
  /// A label map on the volume's grid, or null. A focus made of the old map's labels goes with it, and so does what
  /// could be undone.
  void setLabels(std::shared_ptr<const LabelMap> labels, io::SessionData from = {});
  /// Takes over the hashes of the data's contents, where `session` is of the same data.
  void noteContents(const io::Session& session);

  bool hasVolume() const { return study_.scene.volume != nullptr; }
  const Scene& scene() const { return study_.scene; }
  const Study& study() const { return study_; }
  /// "CT · 512×512×245 · 1.00×1.00×1.00 mm": nothing that could name a patient.
  QString description() const;

  const Edits& edits() const { return edits_; }
  /// Makes it so as when a study is opened: nothing done before can be undone. Tells what changed.
  void setEdits(Edits edits);
  /// Makes it so as one step, named as the Edit menu shows it ("Undo NAME"). All setters below that change the edits do
  /// so by this; window and level, crosshair and how a view is turned by hand are no steps.
  void edit(const QString& name, Edits edits);
  History& history() { return history_; }
  QUndoStack& undoStack() { return history_.stack(); }

  WindowLevel window() const { return window_; }
  void setWindow(WindowLevel window);
  void resetWindow();

  const Focus& focus() const { return edits_.focus; }
  void setFocus(Focus focus);
  /// The focus becomes that label alone.
  void focusOn(std::uint16_t label);
  /// Adds a label to a label focus or takes it out; the last one out leaves no focus.
  void setFocused(std::uint16_t label, bool focused);
  bool isFocused(std::uint16_t label) const;

  /// The middle of the focus's voxels, in world mm; empty without a focus or when no voxel belongs to it.
  std::optional<glm::dvec3> focusCentre() const;

  /// A built-in preset's id or a file. Throws io::Error; nothing changes then.
  void setPreset(const std::string& presetOrPath);
  const std::string& preset() const { return edits_.preset; }
  /// Moves the whole transfer function along the value axis, in the volume's unit.
  void setShift(double shift);
  double shift() const { return edits_.shift; }

  /// `name` is the step's.
  void setCutaway(const Cutaway& cutaway, const QString& name = tr("Cutaway"));
  void setContextLayer(const ContextLayer& layer, const QString& name = tr("Context layer"));
  const BrushStrokes& strokes() const { return edits_.strokes; }
  void setStrokes(BrushStrokes strokes, const QString& name);

  /// The label of the nearest voxel; null for background, outside and without labels.
  const Label* labelAt(glm::dvec3 world) const;
  /// The nearest voxel's index, or empty outside the volume.
  std::optional<glm::ivec3> voxelAt(glm::dvec3 world) const;

 Q_SIGNALS:
  void volumeChanged();
  void labelsChanged();
  void focusChanged();
  void windowChanged();
  void transferFunctionChanged();
  void cutawayChanged();
  /// Brush strokes: a small part of a 3-D picture.
  void strokesChanged();
  /// After any of the above, strokes excepted, that changes a 3-D picture.
  void sceneChanged();

 private:
  class EditsChange;
  void show(Edits edits);

  Study study_;
  Edits edits_;  ///< study_.scene shows them
  WindowLevel window_;
  History history_;
};

}  // namespace fenestra::viewer
