#pragma once
// What a method may decide on in a picture, in the place of the adaptive cutaway's stages. The stages and the reference
// ask this alone: they know of no method (rendering/methods).

#include <cstdint>
#include <optional>

#include "rendering/volume/Grid.h"

namespace fenestra {

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
/// What the planes that cut an exploded view into parts follow.
enum class ExplosionAxes : std::uint8_t { Patient, View };
/// The side of the patient that a layer is peeled off.
enum class PeelSide : std::uint8_t { Anterior, Posterior, Left, Right, Superior, Inferior };

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
  /// Where a lens decides on w of each pixel: rendering/methods/clearview/ClearView.h has the formula.
  struct Lens {
    LensPlace place = LensPlace::OverFocus;  ///< a crosshair that is not set (ShownSlices) leaves it over the focus
    LensFade fade = LensFade::Distance;
    double radius = 0.0;  ///< of the volume's longest side
    double bends = 1.0, rim = 1.0;
    bool operator==(const Lens&) const = default;
  };
  std::optional<Lens> lens{};
  /// Where the context fades. The picture is the volume rendering integral of all of the volume, focus and context as
  /// everywhere, but for the context's extinction, which is multiplied by a factor m at each place. m is
  ///
  /// - by `reach` and `sharpness`: rendering/methods/context-preserving/ContextPreserving.h,
  /// - around a region: rendering/methods/focal-region/FocalRegion.h,
  /// - of a ghost: rendering/methods/selection/Selection.h.
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
  /// Where the context shows by the greatest of its values along a ray; rendering/passes/MaximumPass.h defines the
  /// picture.
  struct Maximum {
    double thickness = 0.0;  ///< mm, of the layer that is shown of that value
    bool operator==(const Maximum&) const = default;
  };
  std::optional<Maximum> maximum{};
  bool hasBorder = true;  ///< w_border says how wide the line around the opening is; else it counts as 0

  /// Stages that cut nothing away: rays start where they enter the volume.
  static MethodStages withoutOpening();
  /// Cones of a half angle in degrees.
  static MethodStages onCones(double angle, bool onSilhouette);

  /// Whether the opening, if any, is defined between pixels, too, so that its edges can be smooth: that of the adaptive
  /// cutaway is, without walls in it, and with a context that is integrated.
  bool opensBetweenPixels() const { return start == Start::Blend && hasWidth && !keepsRemoved() && !walls && !maximum; }
  /// Whether some of what the opening removes may show.
  bool keepsRemoved() const { return faintOpacity > 0.0 || lens; }
  bool operator==(const MethodStages&) const = default;
};

/// mm. The volume's longest side is that of its box along an index axis, half a voxel around the voxels' centres.
double radiusOf(const MethodStages::Lens& lens, const Grid& grid);

/// The share of what the opening removes that shows at a pixel, (i, j) from the top left: with ScreenDoor 1 on as many
/// pixels of each 8×8 square as `opacity` asks for, in the order of Bayer's ordered dither, and 0 on the others; else
/// `opacity`.
double faintShare(Sparseness sparseness, double opacity, int i, int j);

}  // namespace fenestra
