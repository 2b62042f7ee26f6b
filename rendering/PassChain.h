#pragma once
// The passes of the method in their order, each run when what it depends on has changed. Renderer is the interface to
// it.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "rendering/EdgeSamples.h"
#include "rendering/PassMemo.h"
#include "rendering/Renderer.h"
#include "rendering/gl/Context.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/passes/CompositePass.h"
#include "rendering/passes/ConePass.h"
#include "rendering/passes/ContextLayerPass.h"
#include "rendering/passes/DistanceMapPass.h"
#include "rendering/passes/EditMapPass.h"
#include "rendering/passes/ExemptPass.h"
#include "rendering/passes/FocusLayerPass.h"
#include "rendering/passes/HitPointPass.h"
#include "rendering/passes/ImportancePass.h"
#include "rendering/passes/LensPass.h"
#include "rendering/passes/OcclusionPass.h"
#include "rendering/passes/ProtectedLayerPass.h"
#include "rendering/passes/PullPushPass.h"
#include "rendering/passes/RayStartPass.h"
#include "rendering/passes/RemovedPass.h"
#include "rendering/passes/Steps.h"
#include "rendering/passes/WallPass.h"
#include "rendering/scene/Explosion.h"

namespace fenestra {

/// A picture-sized image that lasts until the size changes or it is no longer used.
inline gl::Texture& sized(gl::Texture& texture, gl::Format format, glm::ivec2 size,
                          gl::Filter filter = gl::Filter::Nearest) {
  if (!texture || glm::ivec2(texture.size()) != size) texture = gl::Texture::make2D(format, size, filter);
  return texture;
}

/// Of images that may be presented: a draft is smaller than the rectangle it fills.
inline constexpr gl::Filter presented = gl::Filter::Linear;

/// Keeps each stage's images from one picture to the next. Needs a current context.
struct PassChain {
  explicit PassChain(std::shared_ptr<GpuScene> scene) : gpu(std::move(scene)) {}

  std::shared_ptr<GpuScene> gpu;

  HitPointPass hitPointPass{gpu->programs()};
  ImportancePass importancePass{gpu->programs()};
  PullPushPass pullPushPass{gpu->programs()};
  ConePass conePass{gpu->programs()};
  DistanceMapPass distanceMapPass{gpu->programs()};
  EditMapPass editMapPass{gpu->programs()};
  RayStartPass rayStartPass{gpu->programs()};
  RemovedPass removedPass{gpu->programs()};
  OcclusionPass occlusionPass{gpu->programs()};
  FocusLayerPass focusLayerPass{gpu->programs()};
  ProtectedLayerPass protectedLayerPass{gpu->programs()};
  ContextLayerPass contextLayerPass{gpu->programs()};
  LensPass lensPass{gpu->programs()};
  WallPass wallPass{gpu->programs()};
  CompositePass compositePass{gpu->programs()};
  ExemptPass exemptPass{gpu->programs()};

  gl::Texture hitPoints, focusFilled, coneStart, distances, editMap, rayStart, focusLayer, faintLayer, protectedLayer,
      contextLayer, silhouette, lensSurface, composed, exempted;
  gl::Texture wallLayer, walledLayer, walledPicture;  ///< of WallPass; the last two inside the opening, and around it
  /// Of pictures with several levels of importance: the hits of each, where cones stand on them, from the lowest level
  /// up; context hits, and what rays are opened to in place of the focus.
  std::vector<gl::Texture> importantHits;
  gl::Texture openedHits;
  gl::Texture pickedHit;
  gl::Texture faces, hole;                   ///< of RemovedPass
  gl::Texture occlusionNodes;                ///< of OcclusionPass; empty without ambient occlusion and shadows
  std::unique_ptr<EdgeSamples> edgeSamples;  ///< null where edges are not smooth

  /// Stages 1 to 4 of the camera that cuts the opening, where that is another than the picture's.
  std::unique_ptr<PassChain> opening;
  bool onlyStarts = false;  ///< this chain is another one's `opening`

  Memo<HitKey> hits;
  Memo<ImportanceKey> importance;
  Memo<FillKey> fill;
  Memo<ConeKey> cones;
  Memo<DistanceKey> distance;
  Memo<RayStartKey> edits, start;
  Memo<RemovedKey> removed;
  Memo<OcclusionKey> occlusion;
  Memo<FocusLayerKey> focus;
  Memo<ProtectedLayerKey> faint, guard;
  Memo<ContextLayerKey> context;
  Memo<LensKey> lens;
  Memo<WallKey> walls;
  Memo<CompositeKey> composite;
  Memo<ExemptKey> exempt;
  Memo<EdgeKey> edgePixels;
  Memo<EdgeSampleKey> edgeRays;

  /// What the images were last edited by, in the last picture's view; unknown after an error stopped a picture.
  std::optional<ProjectedStrokes> strokes{std::in_place};

  std::optional<RayFrame> rays;                            ///< of the last picture
  std::optional<ExplodedView> exploded;                    ///< the same, where it is an exploded view
  std::vector<FocusLayerPass::ExplodedStretch> stretches;  ///< of its rays, from the front to the back
  std::shared_ptr<const PeeledScene> peeled;  ///< in whose place that is drawn; null where nothing is peeled
  double pixelScale = 1.0;
  glm::dvec2 widths{0.0};
  glm::vec3 background{0.0f}, backgroundRise{0.0f};
  bool timing = false;
  std::shared_ptr<std::array<PassStats, passCount>> stats = std::make_shared<std::array<PassStats, passCount>>();

  /// One picture on its way through the stages.
  struct Frame {
    Scene scene;
    View view;
    FocusLayerPass::Sampling sampling;
    bool hasCutaway = false, hasContextLayer = false;
    MethodStages method{};
    std::optional<OpeningView> opening{};  ///< cut by another camera
    ProjectedStrokes strokes{};
    std::vector<gl::Region> changed{};  ///< where strokes changed
    std::uint64_t startBefore = 0;      ///< version of the ray starts of the last picture
    /// How far from the focus, in pixels, rays start elsewhere than before, where nothing but the opening moved.
    std::optional<double> moved{};
    GpuScene::Versions drawn{};  ///< of the scene on the GPU when the picture was begun
    std::size_t stagesBegun = 0;
  };
  /// The picture under way, which `steps` and the stages not yet begun belong to.
  std::optional<Frame> frame;
  Steps steps;

  void begin(const Scene& scene, const View& view);
  /// The same of a scene that is drawn as it is.
  void beginAsDrawn(const Scene& scene, const View& view);
  /// Runs what the picture under way needs, for about so many milliseconds; true when it is done.
  bool advance(std::optional<double> milliseconds);
  void drop();

  // Stages 1 to 7 of the method, and the brush: each adds its steps. A stage is begun when the one before is done.
  void findHitPoints();
  void findImportantHits();
  /// The filled focus hits or the cones, as the method has it.
  void shapeOpening();
  void fillFocusHits();
  void standCones();
  void mapDistances();
  void startRays();
  /// Instead of the last three, where another camera cuts the opening.
  void startRaysApart();
  void occlude();
  void drawFocusLayer();
  void drawFaintLayer();
  void drawProtectedLayer();
  void drawRemoved(Pass pass, Memo<ProtectedLayerKey>& memo, const ProtectedLayerKey& key, gl::Texture& texture,
                   ProtectedLayerPass::Shown shown);
  void drawContextLayer();
  void findLens();
  /// Walls inside the opening, and around the volume.
  void standWallsInside();
  void standWallsAround();
  void standWalls(WallKey key, const std::optional<WallPass::Opening>& opening, const gl::Texture& below,
                  gl::Texture& picture);
  void dropWalls();
  // Of an exploded view (PassChainExploded.cpp).
  void explode();
  bool explodesAroundFocus() const { return exploded && gpu->focusKind() != FocusIndex::Kind::None; }
  /// What of the picture shows the volume, and so many pixels around it.
  gl::Region nearVolume(double reach) const;
  /// World position in the volume of what a pixel shows first; empty for the background, and in the hollow that the
  /// focus leaves in the parts.
  std::optional<glm::dvec3> pickExploded(glm::ivec2 pixel);
  /// Where a point of the volume is in the picture: with its part, or within a voxel of the focus, in its place; on the
  /// roll, where it is peeled off.
  glm::dvec3 movedPosition(glm::dvec3 world) const;
  /// Of a picture with a layer peeled off: what it shows at a place where a ray starts to see.
  std::optional<PickedPlace> pickPeeled(glm::dvec3 seen, glm::dvec3 ray) const;
  void compose();
  void addExempt();
  // Smooth edges: which pixels they run through, and what their rays see.
  void findEdges();
  void drawEdges();
  void beginStage();
  void dropCutaway();
  void dropOpening();
  void beginOpening(const OpeningView& view);

  /// What of the picture lies within so many pixels of what rays are opened to, where it is known to end.
  std::optional<gl::Region> nearFocus(double reach) const;

  /// Adds a pass's steps by add(regions), over the whole picture, or the part of it that depends on what the key is
  /// known to have changed in, when the key changed; and over `changed`, where strokes changed. From here on until the
  /// steps are done the pass's images are of no key.
  template <class Key, class Add>
  void addIfStale(Pass pass, Memo<Key>& memo, Key key, Regions changed, const Add& add,
                  const std::optional<gl::Region>& part = std::nullopt) {
    const bool stale = memo.isStale(key);
    if (!stale && changed.empty()) return;
    const gl::Region whole{glm::ivec2(0), rays->size()};
    std::vector<gl::Region> regions;
    if (stale) regions.push_back(part ? *part : whole);
    if (!stale || part) regions.insert(regions.end(), changed.begin(), changed.end());
    if (stale) memo.forget();
    std::uint64_t pixels = 0;
    for (const gl::Region& region : regions) pixels += std::uint64_t(region.size.x) * std::uint64_t(region.size.y);
    const auto timer = timing ? std::make_shared<gl::TimerQuery>() : nullptr;
    steps.beginPass(static_cast<std::size_t>(pass));
    add(regions);
    steps.then([this, pass, &memo, kept = std::make_shared<Key>(std::move(key)), stale, pixels, timer] {
      PassStats& mine = (*stats)[static_cast<std::size_t>(pass)];
      ++mine.runs;
      mine.pixels = pixels;
      if (timer) mine.milliseconds = timer->elapsedMilliseconds();
      if (stale) memo.ran(*kept);
    });
  }

  void dropFill() {
    focusFilled = {};
    pullPushPass.release();
    fill.forget();
  }
  void dropCones() {
    coneStart = {};
    conePass.release();
    cones.forget();
  }
  /// Whether the opening lies within w_open of the focus's projection, but for strokes.
  bool opensNearFocus() const { return !opening && frame->method.start == MethodStages::Start::Blend; }
  /// Of the camera that cuts the opening: the deepest that rays of its picture start, beside the focus's projection.
  const gl::Texture& cutSurface() const { return coneStart ? coneStart : focusFilled; }
  void dropImportance() {
    importantHits.clear();
    openedHits = {};
    importance.forget();
  }
  /// Context hits, and what rays are opened to: the focus, or what is important.
  const gl::Texture& hitsToOpen() const { return openedHits ? openedHits : hitPoints; }
  void releaseEdits() {
    editMap = {};
    editMapPass.release();
    edits.forget();
  }
  /// Everything that strokes show in.
  void forgetEdited() {
    edits.forget();
    start.forget();
    occlusion.forget();
    focus.forget();
    faint.forget();
    guard.forget();
    walls.forget();
    composite.forget();
    exempt.forget();
    edgePixels.forget();
    edgeRays.forget();
  }

  /// What the passes that draw light read of it.
  const gl::Texture* occlusionOfFrame() const { return occlusionNodes ? &occlusionNodes : nullptr; }
  std::uint64_t occlusionVersion() const { return occlusionNodes ? occlusion.version() : 0; }
  glm::dvec2 widthsInPixels(const Scene& scene) const;
  /// What the rays through the pixels' centres see, without the background; a plain volume rendering has nothing laid
  /// over it.
  const gl::Texture& unsmoothed() const { return walledPicture ? walledPicture : unwalled(); }
  /// The same without walls around the volume.
  const gl::Texture& unwalled() const { return exempted ? exempted : composed ? composed : focusLayer; }
  /// What stage 7 lays its layers over.
  const gl::Texture& composedOver() const { return walledLayer ? walledLayer : focusLayer; }
  const gl::Texture& picture() const {
    return edgeSamples && edgeSamples->picture() ? edgeSamples->picture() : unsmoothed();
  }
  /// What another camera's opening is to RemovedPass.
  RemovedPass::Opening cutOpening() const;
  bool hasHoles() const { return !gpu->protectedLabels().any() && !frame->method.keepsRemoved(); }
  double shortestVoxelSide() const;
  bool shows(glm::ivec2 pixel) const;
  /// First hits (context or focus, focus) on the ray of a pixel of the picture.
  glm::vec2 hitAt(glm::ivec2 pixel);
  /// Where the ray starts to see; `nothing` where it meets nothing.
  float startAt(glm::ivec2 pixel) { return rayStart ? rayStart.readTexel(pixel).x : hitAt(pixel).x; }
};

}  // namespace fenestra
