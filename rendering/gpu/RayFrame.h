#pragma once
// The camera as the shaders see it: one ray set-up for every pass (shaders/lib/PixelRay.glsl).

#include <algorithm>
#include <optional>
#include <vector>

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gpu/Bricks.h"
#include "rendering/gpu/Uniforms.h"
#include "rendering/settings/Camera.h"
#include "rendering/settings/Clipping.h"

namespace fenestra {

/// What clips a picture.
struct Clip {
  std::vector<HalfSpace> kept;          ///< mostHalfSpaces at most; empty: nothing
  std::optional<glm::dvec2> grey = {};  ///< of capped faces: coded value · x + y, 0..1; see Clipping::grey
  bool operator==(const Clip&) const = default;

  /// <clip> of shaders (rendering/gpu/SceneVariant.h), and unless nothing clips, the struct of uniforms.
  gl::Choice choice() const {
    return {"clip", kept.empty() ? "lib/clip/None.glsl" : grey ? "lib/clip/GreyFaces.glsl" : "lib/clip/Faces.glsl"};
  }
  ClipUniforms uniforms(const Grid& grid) const;
};

/// Pixels of a list that several rays each are drawn for, between pixel centres (rendering/scene/EdgeRays.h). They
/// belong to images in which each listed pixel has a block of 2×2, blocksAcross in a row.
struct Scatter {
  static constexpr unsigned binding = 7;  ///< of the list's storage block, shaders/lib/EdgeList.glsl
  static constexpr int blocksAcross = 256;
  const gl::Buffer* list = nullptr;
  int first = 0, count = 0;  ///< of the list

  /// Blocks, as many as hold the pixels.
  glm::ivec2 blocks() const { return {std::min(count, blocksAcross), (count + blocksAcross - 1) / blocksAcross}; }
  void bind(gl::ShaderProgram& program) const;
};

/// Rays are anchored on a plane near the volume; positions along them are s = t - distance (mm). Computed in double and
/// handed over relative to the volume, so that neither far cameras nor far origins cost precision.
class RayFrame {
 public:
  /// `grid` is the volume's, of which shaders walk a finer one (see RefinedVolume.h).
  RayFrame(const Camera& camera, glm::ivec2 size, const Grid& grid, Clip clip = {}, int refinement = 1);

  /// For lib/PixelRay.glsl; `program` was compiled with variant().
  void setUniforms(gl::ShaderProgram& program) const;
  /// <clip> and <places>.
  gl::Variant variant() const { return {{}, {clip_.choice(), placesChoice()}}; }
  gl::Choice placesChoice() const {
    return {"places", isScattered() ? "lib/places/Scattered.glsl" : "lib/places/Centres.glsl"};
  }
  /// The rays of this picture between pixel centres.
  RayFrame scattered(const Scatter& scatter) const;
  bool isScattered() const { return scatter_.has_value(); }
  const Clip& clip() const { return clip_; }
  bool isClipped() const { return !clip_.kept.empty(); }

  glm::ivec2 size() const { return size_; }
  const Camera& camera() const { return camera_; }
  const Camera::Axes& axes() const { return axes_; }
  double distance() const { return distance_; }
  /// World from the cell frame of shaders (shaders/lib/Ray.glsl).
  glm::dmat4 worldFromCells() const;
  /// For shaders/RemovedParts.comp: how rays of `other`, of a camera on the same volume, run through this picture.
  OpeningCameraUniforms seenFrom(const RayFrame& other) const;
  bool perspective() const { return camera_.projection == Projection::Perspective; }
  /// World position of s on pixel (i, j)'s ray, and t there.
  glm::dvec3 worldPosition(glm::dvec2 pixel, double s) const;
  /// World position at a view depth (mm from the eye along the view) on the ray through (i, j).
  glm::dvec3 worldPositionAtDepth(glm::dvec2 pixel, double depth) const;
  /// Where on the picture, in pixels from its top left, a point before the eye shows.
  glm::dvec2 pixelOf(glm::dvec3 world) const;
  /// mm per rendered pixel at a view depth (mm from the eye along the view).
  double pixelSize(double depth) const;
  double depthOf(glm::dvec3 world) const;
  /// What of the picture lies within `reach` pixels of a box of voxels.
  gl::Region around(const IndexBox& box, double reach) const;

 private:
  glm::ivec2 size_;
  Camera camera_;
  Grid grid_;
  Clip clip_;
  int refinement_;
  Camera::Axes axes_;
  std::optional<Scatter> scatter_;
  double distance_ = 0.0;     // eye to anchor plane
  glm::dvec2 halfSize_{0.0};  // mm at the anchor plane
};

}  // namespace fenestra
