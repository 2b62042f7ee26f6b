#pragma once
// What the integral of each ray of a picture reads.

#include <optional>
#include <vector>

#include "rendering/reference/Alone.h"
#include "rendering/reference/ContextLabels.h"
#include "rendering/reference/Field.h"
#include "rendering/reference/FocalRegion.h"
#include "rendering/reference/FocusShows.h"
#include "rendering/reference/Ghosting.h"
#include "rendering/reference/Light.h"
#include "rendering/reference/Occlusion.h"
#include "rendering/scene/Fading.h"
#include "rendering/scene/Importance.h"
#include "rendering/scene/Lighting.h"

namespace fenestra::reference {

/// What all rays of a picture share.
struct Medium {
  const Scene& scene;
  Field field;
  FocusField focus;        ///< or the protected labels, of which the context shows
  bool onlyFocus = false;  ///< nothing else shows
  std::optional<Alone> alone{};
  FocusShows focusShows;
  Light light;
  VoxelNormals normals;
  std::optional<SplineVectors> splineNormals;  ///< of a lit spline
  std::optional<FocusNormals> focusNormals;
  ContextLabels context;
  std::vector<std::uint16_t> labelsAlone{};  ///< with onlyFocus
  std::vector<ValueGap> clear;               ///< values without any extinction
  double wallDepth;                          ///< mm
  double bodyGap;                            ///< mm that end a body
  const Occlusion* occlusion;                ///< null: none
  std::optional<MethodStages::Fading> fading;
  std::optional<FocalRegion> region;  ///< around which it fades
  std::optional<Ghosting> ghosting;   ///< of what an opening would remove
  EyeRange eyeRange;
  double steepest;

  Medium(const Scene& what, const Camera& camera, const Occlusion* occluded)
      : Medium(what, camera, FocusField(what), occluded) {
    fading = fadingOf(what.look);
    if (fading && fading->region) region.emplace(*fading->region, what);
    if (fading && fading->ghost) ghosting.emplace(*fading->ghost);
    if (scene.look.shading.enabled && focus.hasLabels()) focusNormals.emplace(scene.volume->grid, focus);
  }
  /// The medium of some labels alone, as part of the context.
  static Medium ofLabels(const Scene& what, const Camera& camera, const std::vector<std::uint16_t>& labels,
                         const Occlusion* occluded) {
    Medium medium(what, camera, FocusField(*structuresOf(what), labels), occluded);
    medium.onlyFocus = true;
    medium.labelsAlone = labels;
    return medium;
  }

  Medium(const Scene& what, const Camera& camera, FocusField held, const Occlusion* occluded)
      : scene(what),
        field(what),
        focus(std::move(held)),
        focusShows(what),
        light(camera, what.look.shading),
        normals(*what.volume),
        context(what),
        clear(context.function().transparentGaps(0.0)),
        occlusion(occluded),
        eyeRange(eyeRangeOf(camera, what.volume->grid)),
        steepest(steepestSlope(*what.volume)) {
    const Grid& grid = scene.volume->grid;
    bodyGap = std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z});
    wallDepth = lighting::wallDepthVoxels * bodyGap;
    if (scene.look.shading.enabled && field.spline())
      splineNormals.emplace(
          grid.dims, [&](glm::ivec3 voxel) { return normals.gated(field.spline()->gradient(glm::dvec3(voxel))); });
  }

  bool leavesOut(bool held) const { return alone && (*alone == Alone::InFocus) != held; }
  bool isClear(ValueRange range) const {
    return std::any_of(clear.begin(), clear.end(),
                       [&](const ValueGap& gap) { return gap.low < range.low && range.high < gap.high; });
  }
};

}  // namespace fenestra::reference
