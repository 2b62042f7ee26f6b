#pragma once
// How the brush paints, in both 3-D views alike. The document holds the painted strokes.

#include <QString>

#include "rendering/settings/Settings.h"
#include "viewer/model/StrokeMode.h"

namespace fenestra::viewer {

struct BrushSettings {
  BrushMode mode = BrushMode::Restore;
  double radius = 24.0;   ///< device-independent pixels on what is painted
  double softness = 0.5;  ///< this and all below as in BrushStroke
  double depth = 10.0;    ///< mm
  double amount = 0.5;
  bool toSurface = true;
  bool coversFocus = true;
  bool thisViewOnly = false;
  bool operator==(const BrushSettings&) const = default;
};

}  // namespace fenestra::viewer

namespace fenestra {

template <>
inline constexpr std::tuple settingsOf<viewer::BrushSettings>{
    Setting(&viewer::BrushSettings::radius,
            {.key = "radius",
             .name = "Radius",
             .description = "Radius on the screen where a stroke begins; there it is fixed in millimetres ([ and ])",
             .unit = "px",
             .range = {2.0, 200.0},
             .slider = {2.0, 100.0},
             .step = 1.0}),
    Setting(&viewer::BrushSettings::softness, {.key = "softness",
                                               .name = "Softness",
                                               .description = settingOf(&BrushStroke::softness).description,
                                               .range = fraction,
                                               .step = 0.05}),
    Setting(&viewer::BrushSettings::depth,
            {.key = "depth",
             .name = "Depth",
             .description = "How far what is seen moves along the line of sight at most (Shift+wheel, Shift+drag)",
             .unit = "mm",
             .range = {0.5, 200.0},
             .slider = {0.5, 60.0},
             .step = 0.5}),
    Setting(&viewer::BrushSettings::amount,
            {.key = "amount",
             .name = "Amount",
             .description = "How much of the context's edges goes or is added (Shift+wheel, Shift+drag)",
             .range = fraction,
             .step = 0.05})};

}  // namespace fenestra

namespace fenestra::viewer {

/// Whether a mode moves the ray start, by `depth`; the others change the context layer, by `amount`.
bool movesRayStart(BrushMode mode);
/// Whether strokes go by `depth`: not those that change the context layer or reach to the context's surface.
bool usesDepth(const BrushSettings& settings);
QString nameOf(BrushMode mode);
/// The mode that reverses another: Restore and Open, Fade and Strengthen.
BrushMode opposite(BrushMode mode);

class Brush : public StrokeMode {
  Q_OBJECT
 public:
  using StrokeMode::StrokeMode;

  const BrushSettings& settings() const { return settings_; }
  void setSettings(const BrushSettings& settings);
  void scaleRadius(double factor);
  /// Scales the depth, or the amount in modes without depth. Restore then goes by the depth, no longer to the surface.
  void scaleDepth(double factor);

  /// Presses the key of the brush, or of its opposite (`otherWay`): activates the brush in a mode of that direction, or
  /// deactivates it when it is active in that direction already.
  void toggle(bool otherWay);

 private:
  BrushSettings settings_;
};

}  // namespace fenestra::viewer
