#pragma once
// The passes of the method in their order, each run when what it depends on has changed. Renderer is the interface to
// it.

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "rendering/PassMemo.h"
#include "rendering/Renderer.h"
#include "rendering/gl/Context.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/passes/CompositePass.h"
#include "rendering/passes/ContextLayerPass.h"
#include "rendering/passes/DistanceMapPass.h"
#include "rendering/passes/EditMapPass.h"
#include "rendering/passes/FocusLayerPass.h"
#include "rendering/passes/HitPointPass.h"
#include "rendering/passes/PullPushPass.h"
#include "rendering/passes/RayStartPass.h"

namespace fenestra {

using Regions = std::span<const gl::Region>;

/// Keeps each stage's images from one picture to the next. Needs a current context.
struct PassChain {
  std::shared_ptr<GpuScene> gpu;

  HitPointPass hitPointPass;
  PullPushPass pullPushPass;
  DistanceMapPass distanceMapPass;
  EditMapPass editMapPass;
  RayStartPass rayStartPass;
  FocusLayerPass focusLayerPass;
  ContextLayerPass contextLayerPass;
  CompositePass compositePass;
  gl::ShaderProgram presentProgram;

  gl::Texture hitPoints, focusFilled, distances, editMap, rayStart, focusLayer, contextLayer, silhouette, composed;
  gl::Texture pickedHit;

  Memo<HitKey> hits;
  Memo<FillKey> fill;
  Memo<DistanceKey> distance;
  Memo<RayStartKey> edits, start;
  Memo<FocusLayerKey> focus;
  Memo<ContextLayerKey> context;
  Memo<CompositeKey> composite;

  /// What the images were last edited by, in the last picture's view; unknown after an error stopped a picture.
  std::optional<ProjectedStrokes> strokes{std::in_place};

  std::optional<RayFrame> rays;  ///< of the last picture
  double pixelScale = 1.0;
  glm::dvec2 widths{0.0};
  glm::vec3 background{0.0f};
  bool timing = false;
  std::array<PassStats, passCount> stats{};

  /// One picture on its way through the stages.
  struct Frame {
    const Scene& scene;
    const View& view;
    FocusLayerPass::Sampling sampling;
    bool hasCutaway = false, hasContextLayer = false;
    ProjectedStrokes strokes{};
    std::vector<gl::Region> changed{};  ///< where strokes changed
    std::uint64_t startBefore = 0;    ///< version of the ray starts of the last picture
    /// How far from the focus, in pixels, rays start elsewhere than before, where nothing but the opening moved.
    std::optional<double> moved{};
  };

  /// Runs what the picture needs.
  void draw(const Scene& scene, const View& view);

  Frame begin(const Scene& scene, const View& view);
  // Stages 1 to 7 of the method, and the brush.
  void findHitPoints(const Frame& frame);
  void fillFocusHits();
  void mapDistances(const Frame& frame);
  void startRays(Frame& frame);
  void drawFocusLayer(const Frame& frame);
  void drawContextLayer(const Frame& frame);
  void compose(const Frame& frame);
  void dropCutaway();

  /// What of the picture lies within so many pixels of the focus, where it is known to end.
  std::optional<gl::Region> nearFocus(double reach) const;

  /// Runs body(regions) over the whole picture, or the part of it that depends on what the key is known to have changed
  /// in, when the key changed; and over `changed`, where strokes changed.
  template <class Key, class Body>
  void runIfStale(Pass pass, Memo<Key>& memo, Key key, Regions changed, const Body& body,
                  const std::optional<gl::Region>& part = std::nullopt) {
    const bool stale = memo.isStale(key);
    if (!stale && changed.empty()) return;
    const gl::Region whole{glm::ivec2(0), rays->size()};
    std::vector<gl::Region> regions;
    if (stale) regions.push_back(part ? *part : whole);
    if (!stale || part) regions.insert(regions.end(), changed.begin(), changed.end());
    PassStats& mine = stats[static_cast<std::size_t>(pass)];
    if (timing) {
      gl::TimerQuery timer;
      body(regions);
      mine.milliseconds = timer.elapsedMilliseconds();
    } else {
      body(regions);
    }
    ++mine.runs;
    mine.pixels = 0;
    for (const gl::Region& region : regions) mine.pixels += std::uint64_t(region.size.x) * std::uint64_t(region.size.y);
    if (stale) memo.ran(std::move(key));
  }

  void releaseEdits() {
    editMap = {};
    editMapPass.release();
    edits.forget();
  }
  /// Everything that strokes show in.
  void forgetEdited() {
    edits.forget();
    start.forget();
    focus.forget();
    composite.forget();
  }

  glm::dvec2 widthsInPixels(const Scene& scene) const;
  /// What is seen, without the background; a plain volume rendering has nothing laid over it.
  const gl::Texture& picture() const { return composed ? composed : focusLayer; }
  bool shows(glm::ivec2 pixel) const;
  /// First hits (context or focus, focus) on the ray of a pixel of the picture.
  glm::vec2 hitAt(glm::ivec2 pixel);
  /// Where the ray starts to see; `nothing` where it meets nothing.
  float startAt(glm::ivec2 pixel) { return rayStart ? rayStart.readTexel(pixel).x : hitAt(pixel).x; }
};

}  // namespace fenestra
