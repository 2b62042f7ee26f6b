#pragma once
// The geometric stages of the adaptive cutaway in double precision on the CPU: the truth that the GL passes are tested
// against. Shares no code with the shaders; depends on the scene alone. Written to be read, not to be fast, but uses
// all cores.

#include <optional>
#include <vector>

#include "rendering/scene/Scene.h"

namespace fenestra::reference {

/// A ray in world space: unit direction, t in mm from `origin` (the eye, or the plane through it; see Camera).
struct Ray {
  glm::dvec3 origin{0.0};
  glm::dvec3 direction{0.0};
};
/// The ray through the centre of pixel (i, j), j from the top.
Ray pixelRay(const Camera& camera, glm::ivec2 size, glm::ivec2 pixel);

/// Where a ray runs inside the grid's box [-½, dims-½], t ≥ 0.
struct Span {
  double tIn = 0.0, tOut = 0.0;
};
std::optional<Span> clip(const Ray& ray, const Grid& grid);

/// One value per pixel, row by row from the top; NaN where there is nothing.
using Image = std::vector<double>;

struct HitPoints {
  Image tContext, tFocus;
};

/// Stage 1: along each ray the first point of context or focus, and the first point of the focus. Cell by cell: inside
/// a cell the trilinear field along the ray is a cubic, whose first crossing is found between its extrema.
HitPoints hitPoints(const Scene& scene, const Camera& camera, glm::ivec2 size);
/// Stage 2: pyramid interpolation of the unknown pixels (Strengert, Kraus, Ertl, VMV 2006), known pixels untouched.
Image fill(const Image& tFocus, glm::ivec2 size);
/// Stage 3: Euclidean distance in pixels to the nearest known pixel of tFocus; +inf beyond `range`. Brute force.
Image distanceMap(const Image& tFocus, glm::ivec2 size, double range);
/// Stage 4. `openWidth` in rendered pixels.
Image rayStart(const HitPoints& hits, const Image& tFocusFilled, const Image& distance, double openWidth);

/// w_open and w_border in rendered pixels, whatever unit the scene gives them in (mm: at the depth of the focus's centre).
struct Widths {
  double open = 0.0, border = 0.0;
};
Widths widthsInPixels(const Scene& scene, const Camera& camera, glm::ivec2 size, double pixelScale);

}  // namespace fenestra::reference
