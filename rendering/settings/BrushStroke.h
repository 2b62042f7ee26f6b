#pragma once
// What the 2.5-D brush painted, kept in world space: a stroke survives camera moves and shows in every view.
//
// What a stroke does to a picture. Its anchors that lie before the camera are projected onto the picture; consecutive
// ones are joined by straight lines there, one alone is a dab. Radius (mm at each anchor's view depth, in pixels) and
// view depth run linearly along a line. An anchor nearer to the eye of a perspective camera than the radius, or not
// before a parallel camera's plane, is left out and breaks the polyline. With d the distance of a pixel's centre from
// the nearest point of a line over the radius there, the profile is 1 for d ≤ 1 - softness and falls to 0 at d = 1 by
// a smoothstep.
//
// A stroke acts on what it was painted on and on nothing that happens to lie before or behind it: the profile is
// multiplied by 1 - smoothstep(1, 2, e / radius), e being how far in mm the line's depth on the pixel's ray lies from
// the context's first surface (Restore, Fade, Strengthen), or outside the stretch from there to where the ray starts
// (Open). Seen from the far side, or hidden by something nearer, a stroke therefore does nothing there. (At the rim of
// the focus the cuts from both sides meet: what Open takes there it takes from both.)
//
// The weight w of a stroke at a pixel is the greatest over its lines: dabs of one stroke do not add up. Strokes follow
// one another in the order they were painted. Restore takes depth·w from the ray start, Open adds it, each clamped
// right away: never before the context's first surface, nor beyond the focus or the volume's end. A Restore that
// reaches to the surface takes w times the way from the ray start to there instead. On rays that meet the
// focus, Restore acts only if the stroke covers the focus. Fade multiplies the context layer's share by 1 - amount·w,
// Strengthen by 1 + amount·w. What Restore brings back over the focus needs no context layer: that gives way by the
// share of the removed stretch that is back. The border marks the cut's own edge and not the brush's: Restore and Open
// multiply it by 1 - w.

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace fenestra {

enum class BrushMode : std::uint8_t {
  Restore,     ///< brings the ray start back towards the eye: what the cutaway removed returns (an ear over a brain)
  Open,        ///< pushes the ray start away from the eye
  Fade,        ///< the context layer shows less under the stroke
  Strengthen,  ///< the context layer shows more under the stroke
};

/// A circular brush drawn along a polyline of points on what was seen.
struct BrushStroke {
  BrushMode mode = BrushMode::Restore;
  std::vector<glm::dvec3> anchors;  ///< world, mm; one point is a dab
  double radius = 5.0;              ///< mm, > 0
  double softness = 0.5;            ///< share of the radius, from the rim, over which the effect fades; 0..1
  double depth = 10.0;              ///< mm along the ray, ≥ 0: how far Restore and Open move the ray start at most
  double amount = 0.5;              ///< 0..1: how much of the context layer Fade and Strengthen take or add
  bool toSurface = false;           ///< Restore reaches to the context's first surface, however deep that lies
  bool coversFocus = false;         ///< may hide the focus; otherwise rays that meet it keep seeing it
  bool hidden = false;              ///< kept, without effect
  int view = -1;                    ///< painted for one view alone (0: C1, 1: C2), as in the paper; -1: for all
  bool operator==(const BrushStroke&) const = default;
};

/// Where a brush touches what a picture shows (Renderer::pickBrush).
struct BrushPoint {
  glm::dvec3 anchor;  ///< world, mm: what BrushStroke::anchors holds
  double pixelSize =
      0.0;  ///< mm per device-independent pixel at its depth: a brush of r such pixels has r·pixelSize mm
  bool hitsContext = true;  ///< the ray there meets the context's surface; otherwise the anchor continues a stroke
  bool meetsFocus = false;  ///< and the focus
  double removed = 0.0;  ///< mm of that ray from the context's surface to where the ray starts: what Restore can take
  double beforeFocus = 0.0;  ///< mm from there to the focus: what Open can take where the ray meets the focus
};

/// In the order they were painted, which is the order they apply in.
using BrushStrokes = std::vector<BrushStroke>;

/// Whether a stroke can change a picture: not hidden, its numbers in their ranges and finite, and with an effect.
/// Pictures leave out all others.
bool isEffective(const BrushStroke& stroke);

/// The strokes that apply in a view (0: C1, 1: C2): those for it alone and those for all. A renderer applies all it is
/// given.
BrushStrokes strokesIn(int view, const BrushStrokes& strokes);

/// Lengthens a stroke by a point on what was seen (Renderer::pickBrush). False, and nothing done, for a point that is
/// not finite, or so near to the last one (1/16 of the radius) that it would hardly change the stroke.
bool extend(BrushStroke& stroke, glm::dvec3 anchor);

}  // namespace fenestra
