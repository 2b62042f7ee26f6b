#pragma once
// Declarations of the settings of the tools that draw strokes, for the panels that show them (see Settings.h).

#include "rendering/scene/Settings.h"
#include "viewer/model/Brush.h"
#include "viewer/model/Carving.h"
#include "viewer/model/SelectionBrush.h"

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
