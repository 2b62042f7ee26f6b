#pragma once
// How the mouse paints the region in focus, in all views alike. The document holds the strokes.

#include <QObject>

#include "rendering/settings/Settings.h"
#include "viewer/model/StrokeMode.h"

namespace fenestra::viewer {

struct SelectionBrushSettings {
  double radius = 10.0;  ///< mm
  double softness = 0.0;
  bool operator==(const SelectionBrushSettings&) const = default;
};

}  // namespace fenestra::viewer

namespace fenestra {

template <>
inline constexpr std::tuple settingsOf<viewer::SelectionBrushSettings>{
    Setting(&viewer::SelectionBrushSettings::radius, {.key = "selection_radius",
                                                      .name = "Radius",
                                                      .description = "Radius of the ball that paints the region",
                                                      .unit = "mm",
                                                      .range = {0.1, 1000.0},
                                                      .slider = {1.0, 60.0},
                                                      .step = 0.5}),
    Setting(&viewer::SelectionBrushSettings::softness,
            {.key = "selection_softness",
             .name = "Softness",
             .description = "The outer share of the ball that paints only where values are like those inside",
             .range = fraction,
             .step = 0.05})};

}  // namespace fenestra

namespace fenestra::viewer {

class SelectionBrush : public StrokeMode {
  Q_OBJECT
 public:
  using StrokeMode::StrokeMode;

  const SelectionBrushSettings& settings() const { return settings_; }
  void setSettings(const SelectionBrushSettings& settings);

 private:
  SelectionBrushSettings settings_;
};

}  // namespace fenestra::viewer
