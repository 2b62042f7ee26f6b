#pragma once
// How the mouse carves a volume, in all views alike. The document holds the removals.

#include <QObject>

#include "rendering/settings/Camera.h"
#include "rendering/settings/Removal.h"
#include "rendering/settings/Settings.h"
#include "viewer/model/StrokeMode.h"

namespace fenestra::viewer {

class Document;

struct CarvingSettings {
  RemovalShape shape = RemovalShape::Ball;
  double size = 10.0;     ///< mm: radius of a ball, half the side of a box, thickness of a saw, reach of a bend
  double softness = 0.0;  ///< mm, of the rim
  double depth = 0.0;     ///< mm, of saw and plane; 0: without an end
  bool operator==(const CarvingSettings&) const = default;
};

}  // namespace fenestra::viewer

namespace fenestra {

template <>
inline constexpr std::tuple settingsOf<viewer::CarvingSettings>{
    Setting(&viewer::CarvingSettings::size,
            {.key = "carving_size",
             .name = "Size",
             .description = "Radius of the ball, half the side of the box, thickness of the saw; of the plane, how far "
                            "around the mouse a drag bends it",
             .unit = "mm",
             .range = {0.5, 500.0},
             .slider = {1.0, 60.0},
             .step = 0.5}),
    Setting(&viewer::CarvingSettings::softness, {.key = "carving_softness",
                                                 .name = "Soft rim",
                                                 .description = "Width across which what is carved fades",
                                                 .unit = "mm",
                                                 .range = {0.0, 100.0},
                                                 .slider = {0.0, 30.0},
                                                 .step = 0.5}),
    Setting(&viewer::CarvingSettings::depth,
            {.key = "carving_depth",
             .name = "Depth",
             .description = "How deep the saw cuts, or how far the plane's side reaches; at 0 through everything",
             .unit = "mm",
             .range = {0.0, 2000.0},
             .slider = {0.0, 200.0},
             .step = 1.0})};

}  // namespace fenestra

namespace fenestra::viewer {

/// What a stroke over those points removes; `axes` are the view's, with forward along the line of sight. Between two
/// points a box leaves no gap. A saw's stroke that comes back to
/// within its thickness of where it began is closed. A plane removes what lies to the right of the stroke.
Removal carvedAlong(const std::vector<glm::dvec3>& stroke, const CarvingSettings& settings, const Camera::Axes& axes);

/// How a drag bends a plane: by how far `moved` (mm along the view's right and up) goes along its normal on the screen;
/// where that points to the eye or away from it, up on the screen is towards the eye.
double bentBy(const Removal& plane, glm::dvec2 moved, const Camera::Axes& axes);

class Carving : public StrokeMode {
  Q_OBJECT
 public:
  /// Carves `document`, which outlives this.
  explicit Carving(Document& document, QObject* parent = nullptr);

  const CarvingSettings& settings() const { return settings_; }
  void setSettings(const CarvingSettings& settings);

  /// The document's method opens the view by carving alone.
  bool isOffered() const;

 private:
  bool canBeUsed() const override { return isOffered(); }

  Document& document_;
  CarvingSettings settings_;
};

}  // namespace fenestra::viewer
