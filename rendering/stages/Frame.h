#pragma once
// One picture on its way through the stages: the scene, the cameras, and what follows from both for every stage.

#include <memory>
#include <optional>
#include <vector>

#include "rendering/gpu/GpuScene.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/gpu/StrokeLines.h"
#include "rendering/passes/FocusLayerPass.h"
#include "rendering/scene/Explosion.h"
#include "rendering/scene/PeeledScene.h"
#include "rendering/scene/Scene.h"
#include "rendering/scene/View.h"

namespace fenestra {

/// Whose rays a stage follows: the picture's, or those of another camera that cuts the opening in its place.
enum class Eye : std::uint8_t { Picture, Opening };

/// What one of these cameras sees.
struct Sight {
  View view;
  RayFrame rays;
  glm::dvec2 widths{0.0};  ///< w_open, w_border in rendered pixels; 0 where this camera cuts no opening

  /// Brush strokes in this view. There are some only where this camera cuts the opening. Never null.
  std::shared_ptr<const ProjectedStrokes> strokes;
  /// Those of the picture begun before (`strokes` itself where they are the same), and where the two differ.
  std::shared_ptr<const ProjectedStrokes> strokesBefore;
  std::vector<gl::Region> changed{};
  int strokeMargin = 0;  ///< pixels around a stroke that depend on it

  /// Where strokes differ from those of an earlier picture of the same rays.
  std::vector<gl::Region> changedSince(const std::shared_ptr<const ProjectedStrokes>& earlier) const;
};

/// The rays of an exploded view (rendering/scene/Explosion.h).
struct ExplodedRays {
  ExplodedView view;
  bool hasFocus = false;                                     ///< the parts lie around a focus
  std::vector<FocusLayerPass::ExplodedStretch> stretches{};  ///< from the front to the back
};

/// Stays what it is until the next picture is begun: steps refer to it. Once the picture is done, `scene` is empty, so
/// that voxels are not kept for it, and the rest tells picks how the picture came about.
struct Frame {
  Scene scene;  ///< as it is drawn: with its layer peeled off
  Sight own;    ///< the picture's camera
  /// Another camera, which cuts the opening in place of the picture's.
  std::optional<Sight> other{};
  FocusLayerPass::Sampling sampling{};
  bool hasCutaway = false, hasContextLayer = false;
  MethodStages method{};  ///< that of no opening where there is none
  std::optional<ExplodedRays> exploded{};
  std::shared_ptr<const PeeledScene> peeled{};  ///< in whose place `scene` is drawn; null where nothing is peeled
  glm::vec3 background{0.0f}, backgroundRise{0.0f};
  GpuScene::Versions drawn{};  ///< the scene on the GPU when the picture was begun

  const View& view() const { return own.view; }
  const Look& look() const { return scene.look; }
  const Sight& sight(Eye eye) const { return eye == Eye::Opening ? *other : own; }
  /// The camera that cuts the opening.
  const Sight& cutting() const { return other ? *other : own; }
  /// Whether that is this one.
  bool isCutFor(Eye eye) const { return hasCutaway && (eye == Eye::Opening) == other.has_value(); }
  /// w_open, w_border in rendered pixels of the picture that the opening is cut for.
  glm::dvec2 widths() const { return cutting().widths; }
  /// Whether the opening lies within w_open of the focus's projection, but for strokes.
  bool opensNearFocus() const { return !other && method.start == MethodStages::Start::Blend; }
  bool explodesAroundFocus() const { return exploded && exploded->hasFocus; }
};

/// What of a camera's picture lies within so many pixels of what rays are opened to, where it is known to end.
std::optional<gl::Region> nearFocus(const GpuScene& gpu, const Sight& sight, double reach);
/// What of the picture shows the volume, and so many pixels around it.
gl::Region nearVolume(const GpuScene& gpu, const Frame& frame, double reach);

}  // namespace fenestra
