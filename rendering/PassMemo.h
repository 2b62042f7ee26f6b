#pragma once
// What each pass last ran with: a pass runs again when its key has changed. A version in a key is that of an earlier
// pass or of a part of the scene on the GPU.

#include <cstdint>
#include <optional>

#include "rendering/gpu/RayFrame.h"
#include "rendering/gpu/StrokeLines.h"
#include "rendering/passes/ConePass.h"
#include "rendering/passes/FocusLayerPass.h"
#include "rendering/passes/OcclusionPass.h"
#include "rendering/scene/Scene.h"
#include "rendering/scene/View.h"

namespace fenestra {

/// What a pass last ran with. Its version grows with every run, so that later passes can have it in their own keys.
template <class Key>
class Memo {
 public:
  bool isStale(const Key& key) const { return key_ != key; }
  void ran(Key key) {
    key_ = std::move(key);
    ++version_;
  }
  void forget() { key_.reset(); }
  const std::optional<Key>& key() const { return key_; }  ///< of the last run, unless forgotten
  std::uint64_t version() const { return version_; }

 private:
  std::optional<Key> key_;
  std::uint64_t version_ = 0;
};

struct HitKey {
  std::uint64_t volume, focus, gaps, importance;
  Camera camera;
  glm::ivec2 size;
  Clip clip;
  bool operator==(const HitKey&) const = default;
};
/// Of several levels of importance. Cones: the hits of each, for cones to stand on. Surfaces: what rays are opened to.
/// Topmost: the most important labels, where another camera cuts the opening.
struct ImportanceKey {
  enum class Found : std::uint8_t { Cones, Surfaces, Topmost };
  std::uint64_t hits;
  Found found;
  bool operator==(const ImportanceKey&) const = default;
};
struct FillKey {
  std::uint64_t hits;
  bool operator==(const FillKey&) const = default;
};
struct ConeKey {
  std::uint64_t hits;
  ConePass::Cones cones;
  bool operator==(const ConeKey&) const = default;
};
struct DistanceKey {
  std::uint64_t hits;
  std::uint64_t cones;  ///< whose opening the distance is to; 0: to the focus's projection
  int range;
  bool operator==(const DistanceKey&) const = default;
};
struct RayStartKey {
  std::uint64_t hits, fill, distance, cones;  ///< 0 for what does not decide on the starts
  double openWidth;
  bool operator==(const RayStartKey&) const = default;
};
/// Where another camera cuts the opening.
struct RemovedKey {
  std::uint64_t hits, openingStart;  ///< of the picture; of the opening's camera
  OpeningView opening;
  glm::dvec2 widths;
  ProjectedStrokes strokes;
  bool holes;
  bool operator==(const RemovedKey&) const = default;
};
struct OcclusionKey {
  std::uint64_t rayStart, hits;  ///< of the camera that cuts the opening; 0 without one
  std::optional<Camera> camera;  ///< that one
  std::uint64_t occluders;
  glm::dvec3 light;     ///< 0 without shadows
  glm::dvec2 strength;  ///< of occlusion and shadow
  Clip clip;
  occlusion::Directions directions;
  bool operator==(const OcclusionKey&) const = default;
};
struct FocusLayerKey {
  std::uint64_t rayStart;   ///< 0 without a cutaway; of the hits, where an exploded view has a focus
  std::uint64_t removed;    ///< 0 where the picture's own camera cuts the opening
  std::uint64_t occlusion;  ///< 0 without ambient occlusion and shadows
  std::uint64_t volume, focus, transfer, gradient, palette;
  double focusExtinction;
  std::optional<MethodStages::Fading> fading;
  std::optional<MethodStages::Explosion> explosion;
  Shading shading;
  Camera camera;
  glm::ivec2 size;
  FocusLayerPass::Sampling sampling;
  Clip clip;
  bool operator==(const FocusLayerKey&) const = default;
};
/// How the focus looks, where some of it is removed.
struct FocusLookKey {
  std::uint64_t focus, palette;
  double extinction;
  bool operator==(const FocusLookKey&) const = default;
};
/// Of the faint layer, too, which depends on no labels but those in focus.
struct ProtectedLayerKey {
  std::uint64_t rayStart, removed, occlusion, volume, protectedLabels, transfer, gradient;
  Shading shading;
  FocusLayerPass::Sampling sampling;
  std::optional<FocusLookKey> removedFocus;
  bool operator==(const ProtectedLayerKey&) const = default;
};
struct ContextLayerKey {
  std::uint64_t hits, cones, derivative;  ///< cones: 0 unless they decide on what rays are opened to
  Shading shading;
  bool operator==(const ContextLayerKey&) const = default;
};
struct LensKey {
  std::uint64_t hits, derivative;
  glm::dvec3 middle;
  bool operator==(const LensKey&) const = default;
};
struct ExemptKey {
  std::uint64_t focusLayer;
  std::optional<std::uint64_t> composite;
  std::uint64_t occlusion, volume, exemptLabels, transfer, gradient;
  Shading shading;
  Camera camera;
  glm::ivec2 size;
  FocusLayerPass::Sampling sampling;
  Clip clip;
  bool operator==(const ExemptKey&) const = default;
};
/// Around the volume, the parts below are those of the picture; inside the opening, those of the focus layer.
struct WallKey {
  std::uint64_t focusLayer = 0, start = 0, removed = 0;  ///< the last two inside the opening, 0 else
  std::optional<std::uint64_t> composite{}, exempt{};
  MethodStages::Walls walls{};
  ShownSlices slices{};
  std::shared_ptr<const Volume> volume{};
  std::shared_ptr<const LabelMap> labels{}, structures{};  ///< null without outlines
  LabelSettings settings{};
  Camera camera{};
  glm::ivec2 size{0};
  bool operator==(const WallKey&) const = default;
};
/// Smooth edges, of the picture that the rays through pixel centres make.
struct EdgeKey {
  std::uint64_t focusLayer;
  std::optional<std::uint64_t> composite, exempt;
  bool operator==(const EdgeKey&) const = default;
};
struct EdgeSampleKey {
  std::uint64_t edges;
  bool operator==(const EdgeSampleKey&) const = default;
};
struct CompositeKey {
  std::uint64_t focusLayer;
  std::uint64_t distance;
  std::optional<std::uint64_t> contextLayer, ownColours, protectedLayer, faintLayer, lens, walls;
  MethodStages method;
  glm::dvec2 widths;
  glm::dvec3 borderColour;
  ContextLayer look;
  bool operator==(const CompositeKey&) const = default;
  /// Whether both lay something over the same picture.
  bool sameBelow(const CompositeKey& other) const {
    return focusLayer == other.focusLayer && distance == other.distance && contextLayer == other.contextLayer &&
           protectedLayer == other.protectedLayer && faintLayer == other.faintLayer && lens == other.lens &&
           walls == other.walls && method == other.method;
  }
  double reach() const { return widths.x + widths.y + 1.0; }  ///< rendered pixels around the focus, its rim included
};

}  // namespace fenestra
