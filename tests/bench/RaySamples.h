#pragma once
// The structures that rays meet in a volume, in short stretches, for statistics over many rays, where the reference's
// exact pieces would take too long. On the CPU, in double precision, with the parts of the reference; trilinear values
// alone.

#include <cstdint>
#include <optional>
#include <vector>

#include "rendering/reference/ContextLabels.h"
#include "rendering/reference/FocusField.h"
#include "rendering/reference/FocusShows.h"
#include "rendering/reference/Light.h"

namespace fenestra::bench {

/// A part of a ray that counts as uniform, with the values of its middle.
struct Stretch {
  double begin = 0.0, end = 0.0;  ///< t, mm
  double extinction = 0.0;        ///< 1/mm, > 0
  bool isFocus = false;           ///< else context
  std::uint16_t label = 0;        ///< of the nearest voxel, in the focus of one around that is; 0 without labels
  glm::dvec3 gradient{0.0};       ///< of the context, in world space, of length 1 where the volume is steepest
  double slope = 0.0;             ///< its length, g of MethodStages::Fading
  double light = 0.0;             ///< of the context, s of MethodStages::Fading

  double middle() const { return 0.5 * (begin + end); }
  double length() const { return end - begin; }
  /// Optical depth.
  double depth() const { return extinction * length(); }
};

struct SampledRay {
  reference::Ray ray;
  std::vector<Stretch> stretches;  ///< those with something in them, from the eye on
};

class RaySampler {
 public:
  /// `scene` must outlive it.
  explicit RaySampler(const Scene& scene);

  /// From `from` mm on, in stretches of at most half the finest spacing. Context is, as everywhere, a value with an
  /// opacity above 1/255 over 1 mm; fainter ones are left out. `light` is that of the camera. Empty where `from` is
  /// NaN.
  SampledRay along(const reference::Ray& ray, double from, const reference::Light& light) const;

  const Scene& scene() const { return scene_; }
  double finestSpacing() const { return finestSpacing_; }
  glm::dvec3 focusCentre() const { return focusCentre_; }

 private:
  std::uint16_t labelAt(glm::dvec3 index, bool isFocus) const;
  template <class ValueAt>
  std::optional<Stretch> stretchAt(glm::dvec3 index, const reference::Ray& ray, const reference::Light& light,
                                   const ValueAt& valueAt) const;
  template <class ValueAt>
  void findSlope(Stretch& stretch, glm::dvec3 index, const reference::Ray& ray, const reference::Light& light,
                 const ValueAt& valueAt) const;

  const Scene& scene_;
  ShownVolume shown_;
  reference::FocusField focus_;
  reference::FocusShows focusShows_;
  reference::ContextLabels context_;
  reference::VoxelNormals normals_;
  double finestSpacing_, steepest_;
  glm::dvec3 focusCentre_;
};

}  // namespace fenestra::bench
