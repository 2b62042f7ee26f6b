#pragma once
// The geometric stages of the adaptive cutaway in double precision on the CPU: the truth that the GL passes are tested
// against. Shares no code with the shaders; depends on the scene alone. Written to be read, not to be fast, but uses
// all cores.

#include <optional>
#include <vector>

#include "rendering/scene/Scene.h"
#include "rendering/scene/View.h"

namespace fenestra::reference {

/// A ray in world space: unit direction, t in mm from `origin` (the eye, or the plane through it; see Camera).
struct Ray {
  glm::dvec3 origin{0.0};
  glm::dvec3 direction{0.0};
};
/// The ray through a place of the picture, in pixels from its top left.
Ray rayThrough(const Camera& camera, glm::ivec2 size, glm::dvec2 place);
/// The ray through the centre of pixel (i, j), j from the top.
Ray pixelRay(const Camera& camera, glm::ivec2 size, glm::ivec2 pixel);
/// The centres of all pixels, row by row from the top.
std::vector<glm::dvec2> centresOf(glm::ivec2 size);

/// A ray in index space; t is still in mm, so the direction is not a unit vector.
Ray indexRay(const Ray& ray, const Grid& grid);

/// Where a ray runs inside the grid's box [-½, dims-½], t ≥ 0.
struct Span {
  double tIn = 0.0, tOut = 0.0;
};
std::optional<Span> clip(const Ray& ray, const Grid& grid);
/// Where a ray runs inside the part of the box that half-spaces keep; empty where it misses that part.
std::optional<Span> clip(const Ray& ray, const Grid& grid, const std::vector<HalfSpace>& kept);
/// The normal of the half-space by whose plane the ray enters that span; empty where it enters by the box, or starts
/// inside.
std::optional<glm::dvec3> capNormal(const Ray& ray, const Grid& grid, const std::vector<HalfSpace>& kept);

/// One value per pixel, row by row from the top; NaN where there is nothing.
using Image = std::vector<double>;

struct HitPoints {
  Image tContext, tFocus;
  Image tOut;  ///< where the ray leaves the grid's box, or what clips it
};

/// Stage 1: along each ray the first point of context or focus, and the first point of the focus; tIn where the ray
/// already starts in it, or enters through a capped face (Clipping.h). Cell by cell, with no step: inside a cell the
/// trilinear field along the ray is a cubic, whose first crossing is found between its extrema.
///
/// Context is every value whose opacity over 1 mm exceeds 1/255 in the function of the point (FaintLabels.h). Values
/// that are not numbers count as the volume's least finite value, infinite ones as its least or greatest, so that
/// neither makes a surface of its own.
HitPoints hitPoints(const Scene& scene, const Camera& camera, glm::ivec2 size);
/// First hits of the rays through some places of the picture, one element each.
HitPoints hitPoints(const Scene& scene, const Camera& camera, glm::ivec2 size, const std::vector<glm::dvec2>& places);

/// Stage 2: pyramid interpolation of the unknown pixels (Strengert, Kraus, Ertl, VMV 2006), known pixels untouched.
/// Level by level, each half the size rounded up, a pixel is the mean of the known pixels in its 2×2 block; back from
/// the 1×1 level, unknown pixels take the biquadratic B-spline subdivision of the coarser level (weights 9/16, 3/16,
/// 3/16, 1/16), clamped to the edge. All NaN when nothing is known.
Image fill(const Image& tFocus, glm::ivec2 size);

/// Stage 3: Euclidean distance in pixels to the centre of the nearest known pixel of tFocus, exact; +inf beyond
/// `range`.
Image distanceMap(const Image& tFocus, glm::ivec2 size, double range);

/// Stage 4: tFocus where the ray hits the focus; from the filled tFocus to tContext over `openWidth` (rendered pixels)
/// around it; tContext elsewhere. Within [tContext, tOut]; NaN where the ray meets nothing.
Image rayStart(const HitPoints& hits, const Image& tFocusFilled, const Image& distance, double openWidth);

/// Stage 4 of the methods that stand cones on the focus (rendering/passes/ConePass.h): `slope` and `onSilhouette` as in
/// MethodStages. The focus hit where the ray meets the focus; NaN where it meets nothing.
Image coneStart(const HitPoints& hits, const Camera& camera, glm::ivec2 size, double slope, bool onSilhouette);

/// w_open and w_border in rendered pixels, whatever unit the scene gives them in. Millimetres are measured at the depth
/// of the centre of the focus's bounding box (of its voxels, or of the cells that hold its values); of the volume's
/// centre when there is no focus before the camera.
struct Widths {
  double open = 0.0, border = 0.0;
};
Widths widthsInPixels(const Scene& scene, const Camera& camera, glm::ivec2 size, double pixelScale);

/// Centre of that box, or of the volume when there is no focus; world, mm.
glm::dvec3 focusCentre(const Scene& scene);

/// What another camera's opening does to a picture; see rendering/passes/RemovedPass.h. One element a pixel.
struct Apart {
  Image holeBegin, holeEnd;  ///< t from where to where the ray sees nothing again; infinite where there is no hole
  Image distance;            ///< of the opening's picture, in its pixels, where the border is projected; +inf elsewhere
  Widths widths;             ///< in the opening's pixels
  OpeningView opening{};     ///< the picture that the opening is cut for, and of its rays:
  Image openingContext{}, openingStart{};
};

/// Stages 1 to 4 in one go, with the scene's brush strokes (see Strokes.h for what they edit). Without a cutaway,
/// tFocusFilled and distance are empty and tStart is tContext; without strokes, the edits are empty.
struct Stages {
  HitPoints hits;  ///< with levels of importance (rendering/scene/Importance.h) tFocus is what rays are opened to
  Image tFocusFilled, distance, tStart;
  Image tCones;  ///< where the method stands cones, in place of tFocusFilled: the starts before the brush
  Image editOffset, editFactor;
  std::optional<Apart> apart;  ///< where another camera cuts the opening
};
/// The area that the border runs around: its values are known where the ray meets the focus, or a cone opens it.
Image openedBy(const Stages& stages);
Stages geometricStages(const Scene& scene, const Camera& camera, glm::ivec2 size, double pixelScale = 1.0);
/// Stages 1 to 4 of a view, whose opening may be frozen or have an axis offset. Where another camera cuts the opening,
/// tFocusFilled, distance and editOffset stay empty.
Stages geometricStages(const Scene& scene, const View& view);
/// Stages 1 to 4 of the rays through some places of a picture, whose pixels have the stages `pixels`: as EdgeRays.h (in
/// rendering/scene) defines them. One element a ray; `distance` decides where the line around the opening runs.
Stages stagesBetween(const Scene& scene, const Camera& camera, glm::ivec2 size, const Stages& pixels, double pixelScale,
                     const std::vector<glm::dvec2>& places);

}  // namespace fenestra::reference
