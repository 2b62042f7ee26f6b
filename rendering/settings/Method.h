#pragma once
// The ways to open the view to a focus: the adaptive cutaway and the methods that its paper compares it with, their
// parameters, and which stages of a picture each one puts in the place of the adaptive cutaway's.

#include <cstdint>
#include <optional>

#include "rendering/volume/Grid.h"

namespace fenestra {

/// Adaptive: the paper's own. Cone: M. Burns, A. Finkelstein: Adaptive cutaways for comprehensible rendering of
/// polygonal scenes, SIGGRAPH Asia 2008. Importance: I. Viola, A. Kanitsar, M. E. Gröller: Importance-driven volume
/// rendering, IEEE Visualization 2004. ClearView: J. Krüger, J. Schneider, R. Westermann: ClearView: An interactive
/// context preserving hotspot visualization technique, IEEE Visualization 2006. ContextPreserving: S. Bruckner, S.
/// Grimm, A. Kanitsar, M. E. Gröller: Illustrative context-preserving exploration of volume data, IEEE TVCG 12(6),
/// 2006. FocalRegion: J. Zhou, M. Hinz, K. D. Tönnies: Focal region-guided feature-based volume rendering, 3D Data
/// Processing, Visualization and Transmission 2002. Walls: M. Tory, C. Swindells: Comparing ExoVis, orientation icon,
/// and in-place 3D visualization techniques, Graphics Interface 2003. Explode: S. Bruckner, M. E. Gröller: Exploded
/// views for volume data, IEEE TVCG 12(5) (IEEE Visualization), 2006. Sculpt and Bend open nothing themselves: what the
/// user carves out of the volume is the opening, by the tools of Wang and Kaufman, or by the plane of Konrad-Verse et
/// al. (Removal.h). Selection: S. Bruckner, M. E. Gröller: VolumeShop: An interactive
/// system for direct volume illustration, IEEE Visualization 2005. Peel: M. J. McGuffin, L. Tancau, R. Balakrishnan:
/// Using deformations for browsing volumetric data, IEEE Visualization 2003; that the focus is left out of the
/// deformation: C. D. Correa, D. Silver, M. Chen: Feature aligned volume manipulation for illustration and
/// visualization, IEEE TVCG 12(5), 2006.
enum class MethodKind : std::uint8_t {
  Adaptive,
  Cone,
  Importance,
  ClearView,
  ContextPreserving,
  FocalRegion,
  Walls,
  Explode,
  Sculpt,
  Bend,
  Selection,
  Peel
};

/// Maximum importance projection removes what hides the focus, in cones that widen towards the eye. Average importance
/// compositing keeps it, faintly, on the rays that meet the focus.
enum class ImportanceMode : std::uint8_t { Maximum, Average };

/// How what lies before the focus is made faint.
enum class Sparseness : std::uint8_t { Opacity, Colour, ScreenDoor };

/// What decides how much of the context stays within ClearView's lens, beside the context's bends: its distance from
/// the lens's middle; nothing else; how much of it lies in front of the focus.
enum class LensFade : std::uint8_t { Distance, Curvature, Depth };

/// Whether ClearView's lens lies over the middle of the focus or over the crosshair, which follows the last pick.
enum class LensPlace : std::uint8_t { OverFocus, OverCrosshair };

/// Shape of a focal region. The box is a cube along the patient's axes; Distance follows the shape of the focus.
enum class FocalShape : std::uint8_t { Sphere, Box, Distance };

/// Where the slices of Walls stand: around the volume (ExoVis of its authors), or where they lie in the patient, inside
/// the opening (in-place).
enum class WallPlacement : std::uint8_t { Around, Inside };
/// How many planes cut the volume of an exploded view into parts, and what the planes follow.
enum class ExplosionPlanes : std::uint8_t { One, Two, Three };
enum class ExplosionAxes : std::uint8_t { Patient, View };
/// The side of the patient that a layer is peeled off.
enum class PeelSide : std::uint8_t { Anterior, Posterior, Left, Right, Superior, Inferior };

struct Method {
  MethodKind kind = MethodKind::Adaptive;
  double coneAngle = 30.0;  ///< degrees between the axis and the wall of the cones of Cone, 1 to 85
  ImportanceMode importance = ImportanceMode::Maximum;
  double importanceAngle = 15.0;    ///< degrees, of the cones of Maximum, 1 to 85; 15 is its authors'
  double importanceOpacity = 0.05;  ///< of Average: the factor of the opacity of what lies before the focus, 0..1
  Sparseness sparseness = Sparseness::Opacity;  ///< of Average
  LensFade lensFade = LensFade::Distance;       ///< of ClearView
  LensPlace lensPlace = LensPlace::OverFocus;
  /// % of the volume's longest side, 0.1 to 1000: 100 by what ClearView's authors call the lens's size, in units of one
  /// divided by the longest side of the volume. Theirs is 5.5.
  double lensRadius = 18.2;
  double lensBends = 1.0;  ///< contextScale of ClearView's authors, 0 to 100
  double lensRim = 60.0;   ///< border of ClearView's authors, 1 to 1000
  /// κt and κs of ContextPreserving. Its authors name no defaults; these are those of CAMPVis, an implementation by TU
  /// München.
  double fadeReach = 3.0;                      ///< 0 to 100; 0 fades nothing
  double fadeSharpness = 0.5;                  ///< 0.05 to 4
  FocalShape focalShape = FocalShape::Sphere;  ///< of FocalRegion
  double focalSize = 50.0;     ///< mm, 0.1 to 1e5: the radius of the sphere, half the side of the box, the distance
  double focalFallOff = 50.0;  ///< mm, 0.1 to 1e5: the distance over which what lies outside fades to a half
  WallPlacement wallPlacement = WallPlacement::Around;  ///< of Walls
  bool wallAxial = true, wallSagittal = true, wallCoronal = true;
  bool wallOutlines = true;  ///< the labels' outlines on the walls
  double explosion = 0.5;    ///< of Explode, the degree of explosion: 0, all parts in their places, to 1
  ExplosionPlanes explosionPlanes = ExplosionPlanes::Two;
  ExplosionAxes explosionAxes = ExplosionAxes::Patient;
  double ghostStrength = 1.0;  ///< of Selection, 0..1: the share of what is flat that gives way; 0 fades nothing
  double ghostEdge = 10.0;     ///< % of the steepest gradient, 0.01 to 1000: half of it stays
  double ghostOutline = 0.5;   ///< 0..1: the share of edges that face the eye that gives way, too
  double peel = 1.0;           ///< of Peel: 0, the layer lies in its place, to 1, nothing of it lies before the focus
  PeelSide peelSide = PeelSide::Anterior;
  double peelTurn = 0.0;     ///< degrees, -180 to 180, of the cut around the side's axis
  double peelDepth = 0.5;    ///< 0, the layer ends just before the focus, to 1, just behind it
  double peelRadius = 15.0;  ///< mm, 1 to 1000: of the hollow in the roll
  double peelMargin = 10.0;  ///< mm, 0 to 1e5: how far the opening reaches beyond the focus
  bool operator==(const Method&) const = default;
};

/// What a method decides on in a picture of an opening. All else is the same for every method: hits, brush, integral,
/// context layer, border.
///
/// A method may keep a share w per pixel of what the opening removes, E (premultiplied colour, of opacity a). It is
/// laid over what the ray shows behind it, F:
///
///   w E + (1 - w a) F  =  w (E + (1 - a) F) + (1 - w) F
///
/// As E over F is the picture in which nothing is removed behind the context's first hit, this is also the mix of that
/// picture and of the opened one.
struct MethodStages {
  /// Where rays start. Blend: stages 2 to 4 of the adaptive cutaway. Cones: on cones that stand on the focus (stated in
  /// rendering/passes/ConePass.h), which replace the filled focus hits and the distance map to the focus; the border
  /// follows the rim of what the cones open.
  /// Entry: where they enter the volume; nothing is opened, and all that belongs to an opening is left out (see
  /// hasCutaway).
  enum class Start : std::uint8_t { Blend, Cones, Entry };
  Start start = Start::Blend;
  bool hasWidth = true;       ///< w_open says how wide the opening is; else it counts as 0
  double slope = 0.0;         ///< of cones: depth in mm per mm beside the axis, the cotangent of their half angle
  bool onSilhouette = false;  ///< cones stand on the silhouette of the focus's projection alone
  bool hasLevels = false;     ///< labels may have several levels of importance (Importance.h); else the focus has one
  double faintOpacity = 0.0;  ///< w, the same everywhere; 0: nothing of what the opening removes shows
  Sparseness sparseness = Sparseness::Opacity;
  /// Where a lens decides on w: with P the place where the ray meets the context's first surface, and n the surface's
  /// normal in the view's axes, or 0 where it has none,
  ///
  ///   κ = ‖Σ |n_i - n|‖     over the four pixels beside, those beyond the picture left out, |·| of each component
  ///   d = ‖P - middle‖ / radius
  ///   b = clamp(d, 0, 1)                                            Distance
  ///       0 where d < 1, else 1                                     Curvature
  ///       clamp((t_focus - t_context) / radius, 0, 1) where d < 1, else 1; t_focus infinite beside the focus   Depth
  ///   w = clamp(max(κ · bends, b), 0, 1)
  ///
  /// The middle is where the line of sight to the middle of the focus (FocusIndex::centre), or to the crosshair, first
  /// meets context or focus, as a pick there would be; that point itself where the line meets nothing, or it lies
  /// behind the eye. Where the ray meets the focus within half the finest spacing of the context, there is no surface:
  /// w = 1. A surface has no normal this near to where its ray enters the volume, or what clips it. The context layer's
  /// opacity is multiplied by 1 - w, because it shows edges of what was removed. At last the line around the lens
  /// darkens the premultiplied picture of opacity A wherever there is a surface, as far as the brush does not fade it:
  ///
  ///   C := max(C - A · ½ (1 - clamp(|d - 1| · rim, 0, 1)), 0)
  struct Lens {
    LensPlace place = LensPlace::OverFocus;  ///< a crosshair that is not set (ShownSlices) leaves it over the focus
    LensFade fade = LensFade::Distance;
    double radius = 0.0;  ///< of the volume's longest side
    double bends = 1.0, rim = 1.0;
    bool operator==(const Lens&) const = default;
  };
  std::optional<Lens> lens{};
  /// Where the context fades. The picture is the volume rendering integral of all of the volume, focus and context as
  /// everywhere, but for the context's extinction: at t mm along a ray, A the opacity of what lies before,
  ///
  ///   A' = (1 - A) κ m,  C' = (1 - A) κ m c shade,   A = C = 0 where the ray enters
  ///   m = g^((reach · s · (1 - d) · (1 - A))^sharpness)   in the context, x^0 = 1 for any x;   1 in the focus
  ///
  /// which is the limit of its authors' α · m for short steps, α the opacity of one. A counts all before, the focus
  /// too.
  ///
  ///   g = min(‖∇f‖ / steepestSlope(), 1)
  ///   s = min(diffuse |n·l| + specular |n·h|^shininess, 1) as Lighting.h has it for the context, faded towards the
  ///   light
  ///       of average orientation where the normal is uncertain, without ambient light, caps and occlusion; 1 without
  ///       shading
  ///   d = the distance from the eye, or from the plane of the eye, 0 to 1 over the volume's bounding sphere, or over
  ///       what of it lies before the eye (EyeRange)
  ///
  /// ∇f is the world gradient by central differences at the voxels, one-sided at the border and trilinear between, or
  /// the spline's own.
  ///
  /// Around a focal region, m depends on the place alone, in place of light, d and A. c is its middle, that of the box
  /// around the focus (FocusIndex::centre), or of the volume without a focus; δ is how many mm a place p lies outside,
  /// components along the world's axes:
  ///
  ///   δ = max(‖p - c‖ - size, 0)       Sphere
  ///       ‖max(|p - c| - size, 0)‖     Box
  ///       max(D(p) - size, 0)          Distance; D, mm to the focus, is FocusDistances.h's
  ///   m = 1 where δ = 0, else g · 2^(-δ / fallOff)   in the context;   1 in the focus
  ///
  /// So the region shows as it is, and around it the contours, in proportion to the gradient, the fainter the farther
  /// outside. Its authors, too, draw contours by the gradient outside of the region; this formula is the program's own.
  ///
  /// With a ghost, m is less than 1 only where the opening removes something, before the ray's start: on rays that meet
  /// the focus, and on those that start behind the context's first surface; where another camera cuts the opening, also
  /// in the hole behind that (rendering/passes/RemovedPass.h). There, with v the ray's direction and ‖∇f‖ not limited
  /// to 1,
  ///
  ///   e = (‖∇f‖² - outline · (∇f·v)²) / (‖∇f‖² + edge²)        0 for a volume of one value
  ///   m = 1 - strength · (1 - e)   in the context;   1 in the focus
  ///
  /// ∇f in units of steepestSlope(). So what is flat gives way, edges stay, and with `outline` those that face the eye
  /// give way in favour of those seen from the side: 1 - (n·v)² of them stays. A quotient of polynomials along the ray
  /// has no kink where a gradient is 0, saturates, or is seen edge on. Its authors, too, keep a selection in sight by
  /// ghosting what lies before it, and let edges decide what stays of that. This formula is the program's own, and so
  /// is the shape of the ghost: it fills the opening that rises from the selection to the surface around it.
  struct Fading {
    double reach = 0.0, sharpness = 1.0;  ///< neither around a region nor of a ghost
    struct Region {
      FocalShape shape = FocalShape::Sphere;
      double size = 0.0, fallOff = 1.0;  ///< mm
      bool operator==(const Region&) const = default;
    };
    std::optional<Region> region{};
    struct Ghost {
      double strength = 0.0, edge = 1.0, outline = 0.0;  ///< edge: of steepestSlope()
      bool operator==(const Ghost&) const = default;
    };
    std::optional<Ghost> ghost{};  ///< instead of a region
    /// Whether light, nearness and what lies before decide; else m depends on the place and the view alone.
    bool followsLight() const { return !region && !ghost; }
    bool operator==(const Fading&) const = default;
  };
  std::optional<Fading> fading{};
  /// Slices that stand in the picture of the adaptive cutaway as walls; rendering/scene/Walls.h has where, and what
  /// they show. W is the premultiplied colour of the nearest wall on a pixel's ray, of opacity a; P, of opacity A, the
  /// picture, or the focus layer.
  ///
  ///   P + (1 - A) W     Around: behind the finished picture
  ///   W + (1 - a) P     Inside: before the focus layer, beneath what is laid over that
  ///
  /// Inside, walls show only at t_context ≤ t < t_start, in the space that the opening removed, and only on rays that
  /// do not meet the focus: like everything else that is not in focus, they give way to it. Where another camera cuts
  /// the opening, that space is what lies before the ray's start; holes behind it hold no walls.
  struct Walls {
    WallPlacement placement = WallPlacement::Around;
    bool axial = true, sagittal = true, coronal = true, outlines = true;
    bool operator==(const Walls&) const = default;
  };
  std::optional<Walls> walls{};
  /// Where the context is drawn in parts that are moved apart; rendering/scene/Explosion.h defines the picture.
  struct Explosion {
    double degree = 0.0;  ///< above 0, at most 1
    int planes = 1;       ///< 1 to 3
    ExplosionAxes axes = ExplosionAxes::Patient;
    bool operator==(const Explosion&) const = default;
  };
  std::optional<Explosion> explosion{};
  /// Where a layer of the context is peeled off; rendering/scene/Peel.h defines where to.
  struct Peel {
    double amount = 0.0;  ///< above 0, at most 1
    PeelSide side = PeelSide::Anterior;
    double turn = 0.0;                  ///< degrees
    double depth = 0.0;                 ///< 0..1
    double radius = 1.0, margin = 0.0;  ///< mm
    bool operator==(const Peel&) const = default;
  };
  std::optional<Peel> peel{};
  bool hasBorder = true;  ///< w_border says how wide the line around the opening is; else it counts as 0

  /// Whether some of what the opening removes may show.
  bool keepsRemoved() const { return faintOpacity > 0.0 || lens; }
  bool operator==(const MethodStages&) const = default;
};
MethodStages stagesOf(const Method& method);

/// mm. The volume's longest side is that of its box along an index axis, half a voxel around the voxels' centres.
double radiusOf(const MethodStages::Lens& lens, const Grid& grid);

/// The share of what the opening removes that shows at a pixel, (i, j) from the top left: with ScreenDoor 1 on as many
/// pixels of each 8×8 square as `opacity` asks for, in the order of Bayer's ordered dither, and 0 on the others; else
/// `opacity`.
double faintShare(Sparseness sparseness, double opacity, int i, int j);

}  // namespace fenestra
