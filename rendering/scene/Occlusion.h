#pragma once
// Ambient occlusion and the soft shadow: how much of the light that the lighting model (Lighting.h) has falls on a
// point through the volume as it is cut open. The renderer and its reference share what is computed here.
//
// Medium. Cells of whole voxels, mostCells of them at most along an axis, hold the mean extinction (1/mm) of their
// voxels: each counts with the extinction of its own value, of the focus or of the context's function at it; what lies
// outside the volume counts as empty. The mean counts up to mostDepth a cell: more is as good as opaque. Hidden labels
// and the table are air. What an opening removes does not count, nor does what is clipped, unless its label is
// protected from the one or exempt from the other: both are found at eight points of a cell (see visibleShare() and
// clippedShare()), and the cell's extinction is the mean of what is seen there.
//
// Field. At the centre x of each cell, with the side h of a cubic cell of the same volume,
//
//   T(x, ω, w) = exp(-∫ w(s) κ(x + s ω) ds)
//   A(x) = min(1, 2 · mean of T(x, ω, w_near) over directions all around)
//   S(x) = mean of T(x, ω, w_far) over directions towards the light's disc, lightRadius in radius
//
// Between the centres of cells A and S are interpolated trilinearly. The weights w leave out the nearest medium, where
// the cells are too coarse to tell a surface from what lies behind it: they rise from 0 at begin·h to 1 at full·h.
// w_near falls from 1 at fade·h to 0 at end·h, so that a wide hollow gets light; w_far stays 1. The factor 2 is for
// surfaces, which hide half of all directions themselves. Where no cell within one of a centre holds anything,
// A = S = 1, because nothing shows there.
//
// Light. Ambient light is multiplied by 1 - occlusion · (1 - A), diffuse and specular light by 1 - shadow · (1 - S).
// The edges of the removed context that are drawn over the focus are not dimmed: they are a drawing, without a place in
// the scene.
//
// The means are over a fixed number of directions, which makes the integrals exact sums along straight lines through
// cells. They differ from the continuous integrals, as tests/unit/OcclusionTest measures: on the surface of a bumpy
// body with a pit, A differs from the mean over all directions by 0.04 RMS, S by 0.005. Cells blur a surface that runs
// through them: near it the mean of T is off by up to 0.014 where a cell's side has an optical depth of 0.2, and by up
// to 0.08 where it has 2.

#include <array>
#include <functional>
#include <vector>

#include "rendering/scene/Scene.h"

namespace fenestra {

/// Whether a look's pictures have ambient occlusion or a soft shadow. A context that fades has neither: how much of it
/// shows depends on the ray. Nor has an exploded view, whose parts would bring along the shade of their old places, or
/// a context that shows by its greatest values, which have no light.
bool hasOcclusion(const Look& look);

namespace occlusion {

inline constexpr int mostCells = 64;
/// Optical depth of the side of a cell.
inline constexpr double mostDepth = 8.0;
/// Distances in sides of a cell.
inline constexpr double begin = 1.5, full = 3.5, fade = 6.0, end = 12.0;
/// Half the angle that the light's disc spans, degrees.
inline constexpr double lightRadius = 7.0;

/// Numbers of directions.
struct Directions {
  int around = 24, towardsLight = 8;
  bool operator==(const Directions&) const = default;
};
/// Fewer directions, for a picture that is soon replaced.
inline constexpr Directions draftDirections{10, 3};

/// Unit vectors, spread evenly (spherical Fibonacci points): all around, or within `radius` degrees of a direction.
std::vector<glm::dvec3> allAround(int count);
std::vector<glm::dvec3> towards(glm::dvec3 direction, double radius, int count);

/// Rises from 0 at `from` to 1 at `to` and, where there is an end, falls back from `fadeFrom` to `fadeTo`; mm.
struct Weight {
  double from, to, fadeFrom, fadeTo;
  /// Its integral from 0 to s.
  double upTo(double s) const { return ramp(s, from, to) - ramp(s, fadeFrom, fadeTo); }
  static double ramp(double s, double from, double to);
};
/// End of a weight that never fades: farther than any ray gets.
inline constexpr double nowhere = 1e30;
Weight nearWeight(double side);
Weight farWeight(double side);

/// Where in a cell, 0 to 1 along each axis, point i of eight lies: in the middle of an eighth but for an amount that no
/// grid of pixels shares, so that in a view along the volume's axes no plane of points lies between two rows of pixels.
glm::dvec3 pointInCell(int i);

/// Share of a point's surroundings that the opening leaves, 0 to 1. `start` and `context`: where the ray that runs
/// through the point starts to see and where it meets the context; `at`: where on it the point lies; all in mm along
/// the ray. `width`: mm over which an edge is softened, so that rounding cannot switch a point.
double visibleShare(double at, double start, double context, double width);
/// Share of them that clipping leaves. `distance`: mm before a plane.
double clippedShare(double distance, double width);

}  // namespace occlusion

/// The medium before anything is cut.
struct OccluderCells {
  glm::ivec3 dims{0};      ///< cells
  glm::ivec3 side{1};      ///< voxels
  struct Extinction {      ///< 1/mm
    float context = 0.0f;  ///< what an opening removes
    float kept = 0.0f;     ///< what it never removes: focus and protected labels
    float exempt = 0.0f;   ///< what shows where it is clipped
    float unused = 0.0f;
  };
  std::vector<Extinction> extinction;  ///< x fastest

  /// Side of a cubic cell of the same volume, mm.
  double sideLength(const Grid& grid) const;
};
/// Whether FocusCells keep a cell of the volume, or the one nearest to it; called from all cores.
using KeepsCell = std::function<bool(glm::ivec3 cell)>;
/// Uses all cores. Four voxels at most along each axis of a cell, spread evenly, stand for all; a function of values is
/// looked up in a table of 4096 steps from its first to its last node. `keeps`: of a focus of values; empty where those
/// cells are to be found, which takes a pass over the voxels.
OccluderCells occluderCells(const Scene& scene, KeepsCell keeps = {});
/// Voxels along each axis of a cell.
glm::ivec3 occluderSide(const Grid& grid);

}  // namespace fenestra
