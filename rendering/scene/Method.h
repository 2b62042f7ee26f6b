#pragma once
// The ways to open the view to a focus: the adaptive cutaway and the methods that its paper compares it with, their
// parameters, and which stages of a picture each one puts in the place of the adaptive cutaway's.

#include <cstdint>

namespace fenestra {

/// Adaptive: the paper's own. Cone: M. Burns, A. Finkelstein: Adaptive cutaways for comprehensible rendering of
/// polygonal scenes, SIGGRAPH Asia 2008. Importance: I. Viola, A. Kanitsar, M. E. Gröller: Importance-driven volume
/// rendering, IEEE Visualization 2004.
enum class MethodKind : std::uint8_t { Adaptive, Cone, Importance };

/// Maximum importance projection removes what hides the focus, in cones that widen towards the eye. Average importance
/// compositing keeps it, faintly, on the rays that meet the focus.
enum class ImportanceMode : std::uint8_t { Maximum, Average };

/// How what lies before the focus is made faint.
enum class Sparseness : std::uint8_t { Opacity, Colour, ScreenDoor };

struct Method {
  MethodKind kind = MethodKind::Adaptive;
  double coneAngle = 30.0;  ///< degrees between the axis and the wall of the cones of Cone, 1 to 85
  ImportanceMode importance = ImportanceMode::Maximum;
  double importanceAngle = 15.0;    ///< degrees, of the cones of Maximum, 1 to 85; 15 is its authors'
  double importanceOpacity = 0.05;  ///< of Average: the factor of the opacity of what lies before the focus, 0..1
  Sparseness sparseness = Sparseness::Opacity;  ///< of Average
  bool operator==(const Method&) const = default;
};

/// What a method decides on in a picture of an opening. All else is the same for every method: hits, brush, integral,
/// context layer, border.
struct MethodStages {
  /// Where rays start. Blend: stages 2 to 4 of the adaptive cutaway. Cones: on cones that stand on the focus (stated in
  /// rendering/passes/ConePass.h), which replace the filled focus hits and the distance map to the focus; the border
  /// follows the rim of what the cones open.
  enum class Start : std::uint8_t { Blend, Cones };
  Start start = Start::Blend;
  bool hasWidth = true;       ///< w_open says how wide the opening is; else it counts as 0
  double slope = 0.0;         ///< of cones: depth in mm per mm beside the axis, the cotangent of their half angle
  bool onSilhouette = false;  ///< cones stand on the silhouette of the focus's projection alone
  double faintOpacity = 0.0;  ///< the factor of the opacity of what the opening removes; 0: nothing of it shows
  Sparseness sparseness = Sparseness::Opacity;

  bool operator==(const MethodStages&) const = default;
};
MethodStages stagesOf(const Method& method);

/// The share of what the opening removes that shows at a pixel, (i, j) from the top left: of ScreenDoor 1 on as many
/// pixels of each 8×8 square as `opacity` asks for, in the order of Bayer's ordered dither, and 0 on the others; else
/// `opacity`.
double faintShare(Sparseness sparseness, double opacity, int i, int j);

}  // namespace fenestra
