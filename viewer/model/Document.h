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

#include "io/study/Study.h"
#include "rendering/segmentation/LabelEdit.h"
#include "rendering/segmentation/RegionFacts.h"
#include "rendering/volume/SliceMeasure.h"
#include "viewer/model/DocumentParts.h"
#include "viewer/model/History.h"

namespace fenestra::viewer {

class Document : public QObject, private DocumentParts {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// Shows a study with its scene's look and, where it comes from a session, that session's display window. Clears the
  /// history.
  void open(io::Study study);
  /// Lets the study go: nothing is open afterwards, as before the first study, and volumeChanged() and all else is
  /// reported.
  void close();
  /// Sets a label map on the volume's grid, or none. Clears the old labels' settings, a focus made of them, and the
  /// history.
  void setLabels(std::shared_ptr<const LabelMap> labels, io::SessionLabels from = {});
  /// Changes the labels, with another focus, as one step. `after` is what `edit` makes of labels().
  void editLabels(const QString& name, segmentation::LabelEdit edit, std::shared_ptr<const LabelMap> after,
                  Focus focus);
  /// The number of the labels' state: a new one after each edit, the earlier one after an undo.
  std::uint64_t labelsRevision() const { return labelsRevision_; }
  /// Whether study().session names a file that holds the labels as they are; true without labels.
  bool labelsAreInFile() const { return !labels() || labelsRevision_ == filedRevision_; }
  /// Notes that the labels of that revision are in a file, or in none where `file` is empty.
  void noteLabelsFile(std::uint64_t revision, const io::SessionLabels& file);
  /// Takes over the hashes of the data's contents, where `session` is of the same data.
  void noteContents(const io::Session& session);

  bool hasVolume() const { return study_.scene.volume != nullptr; }
  /// The scene as it is drawn; study().scene is the one that the user has set.
  const Scene& scene() const { return study_.drawn.scene(); }
  const io::Study& study() const { return study_; }
  /// "CT · 512×512×245 · 1.00×1.00×1.00 mm": nothing that could name a patient.
  QString description() const;

  /// What the user edits: undo and redo change it, and a session keeps it.
  const Look& look() const override { return study_.scene.look; }
  /// Changes the look as one step, named as the Edit menu shows it ("Undo NAME"). All setters below that change the
  /// look call this; window and level, crosshair and how a view is turned by hand are no steps.
  void edit(const QString& name, Look look);
  History& history() { return history_; }
  QUndoStack& undoStack() { return history_.stack(); }

  WindowLevel window() const { return window_; }
  void setWindow(WindowLevel window);
  /// Whether the slices show low values bright, where the data's own way is dark, and the other way round.
  bool isInverted() const { return inverted_; }
  void setInverted(bool inverted);
  /// To the data's own window; inverted for emission alone.
  void resetWindow();

  const Focus& focus() const { return look().focus; }
  void setFocus(Focus focus);
  /// The region in the focus, or null.
  const RegionFocus* region() const { return std::get_if<RegionFocus>(&focus()); }
  /// The growth of region(); isWhole() tells whether it is complete. Null without a region, and until a first part is
  /// grown; until then the scene shows the focus before it.
  const segmentation::Growth* growth() const;
  bool isWhole() const { return whole() != nullptr; }
  /// The region in the focus has to be grown: see RegionGrower.
  bool awaitsGrowth() const { return region() && !isWhole(); }
  /// The pictures show growth(). They keep the focus before while there is one and the region is not whole, and while
  /// asksToOpen().
  bool showsGrowth() const;
  /// Why a region is hardly what was meant: it is too large a share of the body (segmentation::largeShareOfBody), or
  /// its border is doubtful.
  enum class Doubt : std::uint8_t { Share, Border };
  /// What is doubtful about a whole region that the user has not said to open to. A border is doubted only while the
  /// program chooses the tolerance and no ball bounds the region, and what corrects a region that shows is not doubted
  /// again unless it grows.
  std::optional<Doubt> doubt() const;
  /// Whether the pictures wait for an answer because of doubt().
  bool asksToOpen() const { return doubt().has_value(); }
  /// The user's answer: the pictures open to the region.
  void openToRegion();
  /// mm³ of the region; growth() must be there. Its share of the body, where that is known.
  double regionVolume() const { return growth()->curve.volume[static_cast<std::size_t>(regionStep())]; }
  std::optional<double> regionShareOfBody() const { return segmentation::shareOfBody(*growth(), regionStep()); }
  /// What region() is; empty while it grows.
  std::optional<segmentation::RegionFacts> regionFacts() const;
  /// A growth with what is known of it; `facts` is null for a first part.
  struct Growing {
    std::shared_ptr<const segmentation::Growth> growth;
    std::shared_ptr<const segmentation::GrowthFacts> facts;
  };
  /// What the opened region grew from, once.
  segmentation::GrowthMemory takeMemory() { return std::exchange(study_.memory, {}); }
  /// Sets what grew from `seeds`: the whole, or without facts a first part of it.
  void setGrowth(const RegionFocus& seeds, Growing grown);
  /// The focus becomes the region around a world position, no farther from it than `ball` mm where that is not 0, or
  /// gets another seed.
  void growFrom(glm::dvec3 world, double ball = 0.0);
  /// Bounds the region in the focus by a ball around its first seed; 0: no bound.
  void setBall(double radius);
  void addSeed(glm::dvec3 world, bool inside);
  /// A stroke over the region in the focus, which begins with it where another focus is there; one that takes away
  /// changes a region alone.
  void paintSelection(SelectionStroke stroke);
  /// The latest region that `wanted` continues by more strokes, with its growth.
  std::optional<std::pair<RegionFocus, std::shared_ptr<const segmentation::Growth>>> grownBefore(
      const RegionFocus& wanted) const;
  /// Sets the tolerance of the region in the focus; empty: chosen from the plateaus.
  void setTolerance(std::optional<double> tolerance);
  /// Moves the tolerance by steps of segmentation::Levels, within those that are there.
  void moveTolerance(int steps);
  /// The step that region() shows; growth() must be there.
  int regionStep() const { return growth()->stepOf(*region()); }

  /// The focus becomes that label alone.
  void focusOn(std::uint16_t label);
  /// Adds a label to a label focus or takes it out; the last one out leaves no focus.
  void setFocused(std::uint16_t label, bool focused);
  bool isFocused(std::uint16_t label) const;

  /// How a label of labels() is shown beside being in focus or not.
  LabelSetting labelSetting(std::uint16_t label) const { return settingFor(look().labels, label); }
  void setLabelSetting(const LabelSetting& setting, const QString& name);
  /// The role of a label, as one step; empty: in focus.
  std::optional<LabelRole> roleOf(std::uint16_t label) const;
  void setRole(std::uint16_t label, std::optional<LabelRole> role);
  /// The colour of a label of labels(), its own or the user's.
  glm::dvec3 colourOf(const Label& label) const { return labelSetting(label.value).colour.value_or(label.colour); }
  void renameLabel(std::uint16_t label, const QString& name);

  /// A built-in preset's id or a file. Throws io::Error; nothing changes then.
  void setPreset(const std::string& presetOrPath);
  std::string preset() const;
  /// Moves the whole transfer function along the value axis, in the volume's unit.
  void setShift(double shift);
  double shift() const { return look().context.shift; }

  const Clipping& clipping() const { return look().clipping; }
  void setClipping(Clipping clipping, const QString& name);
  /// Whether clipping leaves a label whole.
  void setExempt(std::uint16_t label, bool exempt);

  const BrushStrokes& strokes() const { return look().strokes; }
  void setStrokes(BrushStrokes strokes, const QString& name);

  /// The removals carved out of the volume.
  const Removals& removals() const { return look().removals; }
  void setRemovals(Removals removals, const QString& name);

  /// Distances, angles and regions drawn on the slices, and their values.
  const std::vector<Measure>& measures() const { return measures_; }
  const MeasureValues& measured(std::size_t index) const { return measured_.at(index); }
  /// Sets them as one step, named as the Edit menu shows it.
  void setMeasures(std::vector<Measure> measures, const QString& name);

  /// The points that the straightened picture follows (PathMode), LPS in mm, two or more; empty: none.
  const std::vector<glm::dvec3>& path() const { return path_; }
  /// Sets them as one step. A focus that is the tube around the path (PathTube.h) goes along, and ends with the path.
  void setPath(std::vector<glm::dvec3> path, const QString& name);

  /// States of the window that the user keeps, in the user's order; see KeyImages.
  const std::vector<io::KeyImage>& keyImages() const { return keyImages_; }
  /// Sets them as one step.
  void setKeyImages(std::vector<io::KeyImage> images, const QString& name);

  /// The study's labels; null without any.
  const std::shared_ptr<const LabelMap>& labels() const override { return study_.scene.labels; }
  /// The label of the nearest voxel; null for background, outside and without labels.
  const Label* labelAt(glm::dvec3 world) const;
  /// The nearest voxel's index, or empty outside the volume.
  std::optional<glm::ivec3> voxelAt(glm::dvec3 world) const;

 Q_SIGNALS:
  void volumeChanged();
  void labelsChanged();
  void focusChanged();
  /// Settings of single labels, the focus excepted.
  void labelSettingsChanged();
  void windowChanged();  ///< or inverted
  void transferFunctionChanged();
  /// The cutaway or the context layer.
  void cutawayChanged();
  void shadingChanged();
  void clippingChanged();
  /// Brush strokes: a small part of a 3-D picture.
  void strokesChanged();
  /// The removals carved out of the volume.
  void removalsChanged();
  void measuresChanged();
  void pathChanged();
  void keyImagesChanged();
  /// After any of the above, strokes and measures excepted, that changes a 3-D picture.
  void sceneChanged();

 private:
  /// Reports all that another study, or none, changes.
  void reportAll();
  struct Grown : Growing {
    RegionFocus seeds;
  };
  /// The whole growth of region(), or null.
  const Grown* whole() const;
  /// Drops the oldest growths beyond mostGrownBytes.
  void limitGrown();
  DocumentParts& parts() { return *this; }
  void show(Look look) override;
  void showLabels(std::shared_ptr<const LabelMap> labels, std::uint64_t revision, Focus focus) override;
  void showMeasures(std::vector<Measure> measures) override;
  void showPath(std::vector<glm::dvec3> path) override;
  void showKeyImages(std::vector<io::KeyImage> images) override;
  /// Brings the scene that is drawn up to date with the one that is set. True: its focus is another.
  bool updateDrawn();

  io::Study study_;                  ///< its `scene` and `drawn` follow what the user does
  Grown preview_;                    ///< a first part
  bool showsPreview_ = false;        ///< nothing else was in focus when it came
  std::vector<Grown> grown_;         ///< complete ones for undo, the latest last; see mostGrownBytes
  std::vector<RegionFocus> opened_;  ///< regions that the pictures have opened to, the latest last
  double openedVolume_ = 0.0;        ///< mm³ of the latest of them, as it showed last
  std::uint64_t labelsRevision_ = 0, filedRevision_ = 0, lastRevision_ = 0;
  WindowLevel window_;
  bool inverted_ = false;
  std::vector<Measure> measures_;
  std::vector<MeasureValues> measured_;  ///< the values of each of measures_
  std::vector<glm::dvec3> path_;
  std::vector<io::KeyImage> keyImages_;
  History history_;
};

}  // namespace fenestra::viewer
