#pragma once
// A scene's voxels and tables as GPU objects, made when a picture first needs them, remade when the part of the scene
// behind them changes, and dropped when the scene no longer uses them.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rendering/gl/Buffer.h"
#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/Bricks.h"
#include "rendering/gpu/FaintIndex.h"
#include "rendering/gpu/FittedScene.h"
#include "rendering/gpu/FocalDistances.h"
#include "rendering/gpu/GpuFocus.h"
#include "rendering/gpu/Occluders.h"
#include "rendering/gpu/RefinedVolume.h"
#include "rendering/gpu/Schedule.h"
#include "rendering/gpu/TransferTables.h"
#include "rendering/gpu/VolumeTexture.h"
#include "rendering/scene/BoundChoice.h"
#include "rendering/scene/Fading.h"
#include "rendering/scene/PeeledScene.h"
#include "rendering/scene/Scene.h"

namespace fenestra {

/// Where labels are that pictures keep: those that the opening never removes, or those that are never clipped. Or those
/// of a level of importance or more.
struct KeptLabels {
  gl::Texture bricks, skip;  ///< as focusBricks() and focusSkip()
  gl::Buffer cells;
  std::optional<IndexBox> box{};  ///< of their voxels
  bool smoothed = false;          ///< `cells` hold a smoothed indicator
  FaintIndex faint;               ///< where they are translucent
  // What it was made of.
  std::vector<std::uint16_t> labels;
  std::shared_ptr<const LabelMap> map;
  LabelSmoothing smoothing = LabelSmoothing::Off;

  bool any() const { return static_cast<bool>(bricks); }
};

class GpuScene {
 public:
  /// With programs that other scenes draw by, too: not at the same time.
  explicit GpuScene(gl::SharedPrograms programs = std::make_shared<gl::ComputePrograms>())
      : programs_(std::move(programs)) {}

  /// What is drawn: pictures, pictures without occlusion and shadow (View::occlusion), or first hits alone, as for
  /// placing cameras. What only pictures need is not made for first hits; where it is there, it follows the scene.
  /// Occluders alone do not: they take long in large volumes and stay as they are until a picture needs them.
  enum class Use : std::uint8_t { Pictures, WithoutOcclusion, FirstHits };
  /// Brings everything up to date. Needs a current context, as does destruction. A volume that the device has no room
  /// for is thinned by whole factors, the same for either use. Throws RenderError, gl::AllocationError.
  void update(const Scene& scene, Use use = Use::Pictures);
  /// What takes long to make of this scene is there: its voxels, its focus, what its light and its context layer need.
  /// peeled() and update() are quick then. Of a scene with a layer peeled off: what takes long to make of peeled().
  /// Occluders count where `occlusion` is true, and as those of the scene that was last brought up to date.
  bool holds(const Scene& scene, bool occlusion = true) const;
  /// The scene with its layer peeled off, in place of which pictures draw it; null where nothing is peeled.
  std::shared_ptr<const PeeledScene> peeled(const Scene& scene) { return peeler_.of(scene); }
  /// The scene whose voxels are on the device, of the volume that was last brought up to date: `scene` itself, or its
  /// voxels thinned.
  Scene drawn(const Scene& scene) { return fitted_.of(scene); }
  /// Voxels along each axis that one voxel on the device stands for.
  glm::ivec3 reduction() const { return fitted_.factor(); }
  /// A sentence for the user about the reduction, or about a spline that has no room; empty where there is neither.
  std::string reductionNotice() const;
  /// Replaces the device's own limits, for the next volume on.
  void setLimits(const DeviceLimits& limits) { limits_ = limits; }

  /// How the shaders that draw this scene lay out their work; the usual schedule of the machine until one is set.
  Schedule schedule() const { return schedule_.value_or(Schedule::Plain); }
  void setSchedule(Schedule schedule) { schedule_ = schedule; }

  /// The programs that draw this scene, shared by all renderers of it.
  const gl::SharedPrograms& programs() const { return programs_; }
  /// The program that shows a picture, apart from those: a window's contexts show pictures while others are drawn, and
  /// drivers fail where another context deletes a program that they have used.
  gl::ShaderProgram& presentation(bool enlarged);

  /// GPU memory by resource, for reports.
  struct Resource {
    std::string name;
    std::size_t bytes = 0;
  };
  std::vector<Resource> resources() const;

  // What the passes bind. A version grows whenever what it names was remade.
  struct Versions {
    std::uint64_t volume = 0, gradient = 0, focus = 0, gaps = 0, transfer = 0, derivative = 0, palette = 0,
                  protectedLabels = 0, exemptLabels = 0, importance = 0, occluders = 0;
    bool operator==(const Versions&) const = default;
  };
  const Versions& versions() const { return versions_; }

  const Grid& grid() const { return shown_.volume->grid; }  ///< of the voxels that are drawn
  /// Cells of the drawn grid along the side of a voxel. With a spline the device holds samples on a finer grid (see
  /// RefinedVolume.h), on which bricks, skips and gradients lie, too; otherwise this is 1. The focus always lies in
  /// cells of grid().
  int refinement() const { return refinement_; }
  Grid drawnGrid() const { return refinement_ > 1 ? refined(grid(), refinement_) : grid(); }
  /// A position in the cell frame of drawnGrid(), from that of grid().
  glm::dvec3 drawnCells(glm::dvec3 position) const {
    return static_cast<double>(refinement_) * position - 0.5 * (refinement_ - 1);
  }
  double steepestSlope() const { return fenestra::steepestSlope(*shown_.volume); }  ///< of Fading.h
  bool lowIsWhite() const { return shown_.volume->lowIsWhite; }
  const VolumeTexture& volume() const { return volumeTexture_; }
  /// With a spline, its coefficients in coded values, R32F; the first texel along each axis is that of index -1.
  const gl::Texture& splineCoefficients() const { return coefficients_; }
  const gl::Texture& gradient() const { return gradient_.texture; }
  /// With a spline, the coefficients of the gated normals, RGBA32F; texels as in splineCoefficients().
  const gl::Texture& normalCoefficients() const { return normalCoefficients_; }
  glm::ivec3 gradientOrigin() const { return gradient_.origin; }  ///< index of its first texel
  const DerivativeVolume& derivative() const { return derivative_; }

  /// Transparent gaps of the context in coded values, clipped to float's range: gapCount() vec2 for what no translucent
  /// label covers and for each of those labels, by number, of which some may hold no value.
  const gl::Buffer& gaps() const { return gapBuffer_; }
  int gapCount() const { return static_cast<int>(gaps_.size() / (1 + faintLabels_.opacities.size())); }
  /// TransferTables of the context, and below them those of the focus's functions, two rows each. An entry of the
  /// context's = coded value · map.x + map.y.
  static constexpr int tableSize = 16384, rowsPerFunction = 2;
  const gl::Texture& transferTables() const { return transferTables_; }
  /// The functions of transferTables() from node to node, one behind the other; see shaders/lib/TransferSegments.glsl.
  static constexpr int segmentsPerRow = 256;
  const gl::Texture& transferSegments() const { return transferSegments_; }
  const gl::Buffer& segmentOfEntry() const { return segmentOfEntry_; }
  /// The volume's transfer function as PreIntegration, for its texels and its first level. Made when it is first asked
  /// for, because pictures within a bound do without.
  const gl::Texture& preIntegration() const;
  int preIntegrationLevel() const { return preIntegrationLevel_; }  ///< of the one made last
  /// The bound of a picture of this scene, or of one that is about to be brought up to date, in 1/255; see BoundChoice.
  std::optional<double> chosenBound(const Scene& scene, const View& view) const {
    return boundChoice_.boundFor(scene, view);
  }
  glm::vec2 transferMap() const { return transferMap_; }
  glm::vec4 firstMaterial() const { return firstMaterial_; }  ///< the tables' first entry
  glm::vec4 lastMaterial() const { return lastMaterial_; }
  glm::vec2 visibleEntries() const { return visibleEntries_; }  ///< nothing shows up to x nor from y on
  /// skipTexels() of the bricks in which anything of the context shows; anything at all; the focus.
  const gl::Texture& contextSkip() const { return contextSkip_; }
  const gl::Texture& occupiedSkip() const { return focusSkip_ ? occupiedSkip_ : contextSkip_; }

  /// Where labels of the context are translucent, and the opacities of their numbers, R32F.
  const FaintIndex& faint() const { return faint_; }
  const gl::Texture& faintOpacities() const { return faintOpacities_; }

  FocusIndex::Kind focusKind() const { return focus_.index().kind; }
  const FocusIndex& focus() const { return focus_.index(); }
  bool focusIsSmoothed() const { return focus_.index().smoothed != nullptr; }
  ValueRange focusValues() const { return std::get<ValueFocus>(focusWanted_).values; }  ///< of a value focus, real
  const gl::Texture& focusBricks() const { return focus_.bricks(); }
  const gl::Texture& focusSkip() const { return focusSkip_; }
  const gl::Buffer& focusCells() const { return focus_.cells(); }
  /// Whether some of the focus is shown by value, see focusFunction().
  bool focusByValue() const { return !focusFunctions_.empty(); }
  /// Whether some of the focus is of an opacity below 1.
  bool focusIsTranslucent() const { return focusIsTranslucent_; }
  /// Per-voxel palette entries around a label focus of several looks; empty when one does for all. The palette's rows:
  /// colours and opacities; with functions, what focusTable() is.
  const gl::Texture& focusPaletteIndex() const { return focusPaletteIndex_; }
  const gl::Texture& focusPalette() const { return focusPalette_; }
  glm::ivec3 focusOrigin() const { return focusOrigin_; }  ///< index of focusPaletteIndex's first texel
  glm::vec3 focusColour() const { return focusColour_; }   ///< where one does
  /// Where one does: the first row of its function in transferTables() and the map to its entries, or 0 for a material;
  /// and its opacity.
  glm::vec4 focusTable() const { return focusTable_; }
  /// Only while there is an opening, and something that is protected from it.
  const KeptLabels& protectedLabels() const { return protected_; }
  /// Only while something is clipped, and labels are exempt from it.
  const KeptLabels& exemptLabels() const { return exempt_; }
  /// importanceLevels(): the labels of each level of importance or more, from the lowest level up, smoothed as the
  /// focus.
  const std::vector<KeptLabels>& importance() const { return importance_; }
  /// Box of what pictures are opened to: of the focus, or of all that is important.
  const std::optional<IndexBox>& openedBox() const {
    return importance_.empty() ? focus_.index().box : importance_.front().box;
  }
  /// Only while pictures have ambient occlusion or shadows.
  const Occluders& occluders() const { return occluders_; }
  /// Only while pictures show a focal region of this shape.
  const FocalDistances& focalDistances() const { return focalDistances_; }
  /// Smoothed indicator around a label focus, for its normals; only while shading is on.
  const gl::Texture& focusSmooth() const { return focus_.smooth(); }
  glm::ivec3 focusSmoothOrigin() const { return focus_.smoothOrigin(); }  ///< index of its first texel

 private:
  void release();
  bool holdsAsDrawn(const Scene& scene, bool occlusion) const;
  Occluders::Key occludersKey(const Scene& scene) const;
  void chooseRefinement(const Scene& scene, const DeviceLimits& limits);
  /// By brick of the drawn grid: wholeBrick where some of the focus lies in it, else 0.
  std::vector<OctantMask> drawnOccupied(const FocusIndex& focus) const;
  void updateAll(const Scene& scene, Use use);
  void updateLight(const Scene& scene, Use use, const GpuFocus::Change& focus, bool occupancyChanged);
  void updateVolume(ShownVolume shown);
  /// Which bricks' occupation has changed.
  GpuFocus::Change updateFocus(const Scene& scene);
  /// The context's function and its translucent labels; returns whether they have changed.
  bool updateContext(const Scene& scene);
  void updateFocusColours(const Scene& scene);
  void updateFocusTables(std::vector<TransferFunction> functions);
  void uploadFocusTable(std::size_t i);
  void uploadTables(const TransferTables& tables, std::size_t function);
  void updateSegments();
  /// The texture of palette entries, by label, around the focus.
  void makePaletteIndex(const LabelMap& labels, const std::vector<std::uint8_t>& entryOf);
  void updateSkips(const GpuFocus::Change& focus, bool occupancyChanged);
  void updateKeptLabels(const Scene& scene, bool volumeChanged);
  /// Makes the index of `wanted`, unless it is there.
  void updateKept(KeptLabels& kept, std::vector<std::uint16_t> wanted, LabelSmoothing smoothing, const Scene& scene,
                  std::uint64_t& version);
  /// Returns whether other bricks than before hold something of the context.
  bool updateTransfer();
  void updateGaps();
  void updateFaintOpacities();
  bool updateOccupancy();
  void updateGradient(const GpuFocus::Change& focus, bool occupancyChanged);
  /// The voxels of the bricks whose values vary by more than noise; `shown`: of those in which something shows.
  std::optional<IndexBox> variedBox(bool shown) const;
  /// Whether the gradients cover those bricks where lighting asks for any.
  bool isLitFor(const std::vector<std::size_t>& bricks) const;
  /// The least change of value in a brick that can lift a central difference over lighting's gate.
  double leastChange() const;

  gl::ShaderProgram presentProgram_, enlargeProgram_;
  gl::SharedPrograms programs_;
  std::optional<Schedule> schedule_;
  std::optional<DeviceLimits> limits_;
  Peeler peeler_;
  FittedScene fitted_;
  ShownVolume shown_;
  std::shared_ptr<const LabelMap> labels_, labelSource_;  ///< as drawn, and as given
  Focus focusWanted_;
  LabelSmoothing labelSmoothing_ = LabelSmoothing::Off;  ///< of that focus
  TransferFunction context_;                             ///< shifted
  FaintLabels faintLabels_;                              ///< none where none has a voxel
  FocusAppearance appearance_;
  LabelSettings focusSettings_;  ///< of the labels in focus
  Versions versions_;

  int refinement_ = 1;
  std::size_t refusedBytes_ = 0;        ///< what a spline would have taken; 0: none was refused
  std::optional<SplineVolume> spline_;  ///< where it is drawn
  VolumeTexture volumeTexture_;
  gl::Texture coefficients_, normalCoefficients_;
  BrickRanges bricks_;       ///< of the drawn grid
  BrickRanges voxelBricks_;  ///< of the volume's own, where that is another
  GradientTexture gradient_;
  std::optional<IndexBox> gradientBox_;  ///< voxels that it holds the normals of
  bool gradientIsWhole_ = false;         ///< it has all that any transfer function or focus can ask for
  DerivativeVolume derivative_;

  std::vector<glm::vec2> gaps_;
  gl::Buffer gapBuffer_;
  gl::Texture transferTables_, transferSegments_;
  mutable gl::Texture preIntegration_;  ///< empty until it is asked for, and after a change
  mutable int preIntegrationLevel_ = 0;
  mutable BoundChoice boundChoice_;
  gl::Buffer segmentOfEntry_;
  glm::vec2 transferMap_{0.0f}, visibleEntries_{0.0f};
  glm::vec4 firstMaterial_{0.0f}, lastMaterial_{0.0f};
  std::vector<OctantMask> contextOccupied_;  ///< per brick
  gl::Texture contextSkip_, occupiedSkip_;

  FaintIndex faint_;
  gl::Texture faintOpacities_;
  GpuFocus focus_;
  gl::Texture focusSkip_;
  gl::Texture focusPaletteIndex_, focusPalette_;
  std::vector<std::uint8_t> paletteEntries_;    ///< by label: what focusPaletteIndex_ was made of
  std::shared_ptr<const LabelMap> paletteMap_;  ///< and the map of those labels
  glm::ivec3 focusOrigin_{0};
  glm::vec3 focusColour_{1.0f};
  glm::vec4 focusTable_{0.0f, 0.0f, 0.0f, 1.0f};
  bool focusIsTranslucent_ = false;
  std::vector<TransferFunction> focusFunctions_;  ///< each once, in the order of their tables

  KeptLabels protected_, exempt_;
  std::vector<KeptLabels> importance_;
  Occluders occluders_;
  FocalDistances focalDistances_;
};

}  // namespace fenestra
