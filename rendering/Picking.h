#pragma once
// What of the volume a place of a picture shows, and where a picture shows a place of the volume.

#include <optional>

#include "rendering/Chain.h"
#include "rendering/PickedPlace.h"
#include "rendering/settings/BrushStroke.h"

namespace fenestra {

/// In the last picture of a chain, whose context is current. Renderer.h says what each call answers; `pixel` is (i, j)
/// from the top, in rendered pixels.
class Picking {
 public:
  explicit Picking(const Chain& chain) : chain_(chain), hitPointPass_(chain.gpu().programs()) {}

  std::optional<PickedPlace> place(glm::dvec2 pixel);
  std::optional<BrushPoint> brushPoint(glm::dvec2 pixel, BrushMode mode, std::optional<glm::dvec3> before);
  /// The picture is an exploded view, or a layer is peeled off.
  bool movesContext() const;
  glm::dvec3 shownAt(glm::dvec3 world) const;
  std::size_t bytes() const { return hit_.bytes(); }

 private:
  bool shows(glm::ivec2 pixel) const;
  /// First hits (context or focus, focus) on one ray.
  glm::vec2 traceHit(const RayFrame& rays, glm::ivec2 pixel);
  /// Context hit, and what the ray is opened to.
  glm::vec2 hitAt(glm::ivec2 pixel);
  /// Where the ray starts to see; `nothing` where it meets nothing.
  float startAt(glm::ivec2 pixel);
  /// How far strokes have moved a ray's start, in mm.
  float editAt(glm::ivec2 pixel) const;
  /// In an exploded view: world position in the volume; empty for the background, and in the hollow that the focus
  /// leaves in the parts.
  std::optional<glm::dvec3> pickExploded(glm::ivec2 pixel);
  /// With a layer peeled off: what the picture shows at a place where a ray starts to see.
  std::optional<PickedPlace> pickPeeled(glm::dvec3 seen, glm::dvec3 ray) const;
  /// In an exploded view: where a place of the volume is, with its part.
  glm::dvec3 explodedPosition(glm::dvec3 world) const;

  const Chain& chain_;
  HitPointPass hitPointPass_;
  gl::Texture hit_;  ///< RG32F, 1×1: hits of a ray that the stages did not trace
};

}  // namespace fenestra
