#pragma once
// Declares every setting of a look once, but those of the methods, which rendering/methods has: its name in files, on
// the command line and in the window, its meaning and its range. A setting's default is its member's initialiser. Session files and their published schema, the options of the
// command line and the controls of the window are made from these tables.

#include <tuple>

#include "rendering/settings/SettingWords.h"
#include "rendering/vocabulary/Setting.h"

namespace fenestra {

template <>
inline constexpr std::tuple settingsOf<Cutaway>{
    Setting(&Cutaway::enabled, {.key = "enabled",
                                .option = "--cutaway",
                                .name = "Open the context around the focus",
                                .description = "Whether the context is cut away around the focus"}),
    Setting(&Cutaway::openWidth, {.key = "open_width",
                                  .option = "--w-open",
                                  .name = "Opening",
                                  .description = "How far the opening reaches beyond the focus (w_open)",
                                  .range = {0.0, 1e5},
                                  .slider = {0.0, 120.0},
                                  .step = 1.0}),
    Setting(&Cutaway::borderWidth, {.key = "border_width",
                                    .option = "--w-border",
                                    .name = "Border",
                                    .description = "Width of the line around the opening (w_border)",
                                    .range = {0.0, 1e5},
                                    .slider = {0.0, 20.0},
                                    .step = 0.5}),
    Setting(
        &Cutaway::unit,
        {.key = "unit",
         .option = "--width-unit",
         .name = "Unit",
         .description = "Unit of both widths: pixels of the screen, or mm at the depth of the focus, which keep the "
                        "opening still while zooming"}),
    Setting(&Cutaway::borderColour, {.key = "border_colour",
                                     .option = "--border-colour",
                                     .name = "Border colour",
                                     .description = "Colour of the line around the opening"}),
    Setting(&Cutaway::axisOffset,
            {.key = "axis_offset",
             .option = "--axis-offset",
             .name = "Axis offset",
             .description = "Angle between the opening's axis and the line of sight, so that its depth shows",
             .unit = "°",
             .range = {0.0, 80.0},
             .slider = {0.0, 60.0},
             .step = 1.0}),
    Setting(&Cutaway::axisDirection,
            {.key = "axis_direction",
             .option = "--axis-direction",
             .name = "Direction",
             .description = "To which side of the picture the opening's axis leans: 0 is the right, 90 the top",
             .unit = "°",
             .range = {-180.0, 180.0}})};

template <>
inline constexpr std::tuple settingsOf<ContextLayer>{
    Setting(&ContextLayer::strength,
            {.key = "strength",
             .option = "--context-layer",
             .name = "Strength",
             .description = "How strongly the edges of the removed context are drawn over the focus; 0 draws none",
             .range = fraction,
             .step = 0.05}),
    Setting(&ContextLayer::curvatureWeight,
            {.key = "curvature_weight",
             .option = "--context-curvature",
             .name = "Curvature",
             .description = "How much bends of the context's surface count as edges: eyes, nose, ears",
             .range = {0.0, 100.0},
             .slider = {0.0, 2.0},
             .step = 0.05}),
    Setting(&ContextLayer::silhouetteWeight,
            {.key = "silhouette_weight",
             .option = "--context-silhouette",
             .name = "Silhouette",
             .description = "How much the context's outlines, where its surface is seen edge-on, count as edges",
             .range = {0.0, 100.0},
             .slider = {0.0, 2.0},
             .step = 0.05}),
    Setting(&ContextLayer::illuminationWeight,
            {.key = "illumination_weight",
             .option = "--context-illumination",
             .name = "Illumination",
             .description = "How much the light on the context's surface shades its edges; 0 draws them flat",
             .range = fraction,
             .step = 0.05}),
    Setting(&ContextLayer::valueWeight, {.key = "value_weight",
                                         .option = "--context-value",
                                         .name = "Value",
                                         .description = "How much the edges take the context's own colour",
                                         .range = fraction,
                                         .step = 0.05}),
    Setting(&ContextLayer::colour, {.key = "colour",
                                    .option = "--context-colour",
                                    .name = "Colour",
                                    .description = "Colour of the context's edges"})};

template <>
inline constexpr std::tuple settingsOf<Shading>{
    Setting(&Shading::enabled, {.key = "enabled",
                                .option = "--shading",
                                .name = "Shading",
                                .description = "Whether surfaces are lit by the gradient of the values"}),
    Setting(&Shading::ambient,
            {.key = "ambient", .name = "Ambient", .description = "Light from all sides", .range = {0.0, 100.0}}),
    Setting(&Shading::diffuse, {.key = "diffuse",
                                .name = "Diffuse",
                                .description = "Light that a matt surface scatters",
                                .range = {0.0, 100.0}}),
    Setting(
        &Shading::specular,
        {.key = "specular", .name = "Specular", .description = "Strength of the highlights", .range = {0.0, 100.0}}),
    Setting(&Shading::shininess,
            {.key = "shininess",
             .name = "Shininess",
             .description = "Exponent of the highlights: a larger one makes them smaller and sharper",
             .range = {0.0, 1e4}}),
    Setting(&Shading::lightAzimuth,
            {.key = "light_azimuth",
             .name = "Light azimuth",
             .description = "Where the light comes from: 0 is behind the viewer, 90 the right of the picture",
             .unit = "°",
             .range = {-180.0, 180.0},
             .step = 1.0}),
    Setting(&Shading::lightElevation,
            {.key = "light_elevation",
             .name = "Light elevation",
             .description = "How high the light stands: 90 is the top of the picture, -90 the bottom",
             .unit = "°",
             .range = {-90.0, 90.0},
             .step = 1.0}),
    Setting(&Shading::occlusion,
            {.key = "occlusion",
             .option = "--occlusion",
             .name = "Occlusion",
             .description = "How dark hollows are, which what is around them hides from the light from all sides; "
                            "0 leaves them as bright as the rest and costs nothing",
             .range = fraction,
             .step = 0.05}),
    Setting(&Shading::shadow,
            {.key = "shadow",
             .option = "--shadow",
             .name = "Soft shadow",
             .description = "How dark the shadows are that the volume, as it is cut open, casts on itself; "
                            "0 casts none and costs nothing",
             .range = fraction,
             .step = 0.05})};

template <>
inline constexpr std::tuple settingsOf<FocusAppearance>{
    Setting(&FocusAppearance::colour, {.key = "colour",
                                       .name = "Colour",
                                       .description = "Colour of a focus of values; labels have colours of their own"}),
    Setting(&FocusAppearance::extinction, {.key = "extinction",
                                           .name = "Extinction",
                                           .description = "Extinction coefficient of the focus",
                                           .unit = "1/mm",
                                           .range = {0.0, 1e9}})};

template <>
inline constexpr std::tuple settingsOf<ValueFocus>{Setting(
    &ValueFocus::minimumComponent, {.key = "minimum_component",
                                    .option = "--focus-min-size",
                                    .name = "Smallest island",
                                    .description = "Volume below which an island of a focus of values is left out",
                                    .unit = "mm³",
                                    .range = {0.0, 1e12},
                                    .slider = {0.0, 5000.0},
                                    .step = 10.0})};

template <>
inline constexpr std::tuple settingsOf<ContextFunction>{
    Setting(&ContextFunction::shift,
            {.key = "shift", .name = "Shift", .description = "Moves the whole transfer function along the values"})};

template <>
inline constexpr std::tuple settingsOf<Look>{
    Setting(&Look::background, {.key = "background",
                                .option = "--background",
                                .name = "Background",
                                .description = "Colour behind the volume; of a gradient, at the bottom"}),
    Setting(&Look::backdrop, {.key = "backdrop",
                              .option = "--backdrop",
                              .name = "Backdrop",
                              .description = "Whether one colour is behind the volume, or a gradient of two"}),
    Setting(&Look::backgroundTop, {.key = "background_top",
                                   .option = "--background-top",
                                   .name = "Top of the gradient",
                                   .description = "Colour of a gradient behind the volume at the top"}),
    Setting(&Look::hideTable,
            {.key = "hide_table",
             .option = "--hide-table",
             .name = "Hide the table",
             .description = "Whether 3-D pictures of a CT leave out the scanner's table, head rest and cushions"}),
    Setting(&Look::reconstruction, {.key = "reconstruction",
                                    .option = "--reconstruction",
                                    .name = "Between voxels",
                                    .description = "How 3-D pictures fill in the values between the voxels"}),
    Setting(&Look::labelSmoothing,
            {.key = "label_smoothing",
             .option = "--label-smoothing",
             .name = "Label surfaces",
             .description = "How far 3-D pictures smooth the surface of labels in focus: it stays within the voxels "
                            "that it passes through, and keeps its volume"}),
    Setting(&Look::edges, {.key = "edges",
                           .option = "--edges",
                           .name = "Edges",
                           .description = "Whether 3-D pictures at rest smooth outlines and the rims of what is cut"})};

template <>
inline constexpr std::tuple settingsOf<BrushStroke>{
    Setting(&BrushStroke::mode, {.key = "mode", .name = "Mode", .description = "What the stroke does"}),
    Setting(&BrushStroke::radius, {.key = "radius",
                                   .name = "Radius",
                                   .description = "Radius of the brush",
                                   .unit = "mm",
                                   .range = positiveMillimetres}),
    Setting(&BrushStroke::softness, {.key = "softness",
                                     .name = "Softness",
                                     .description = "Share of the radius over which the effect fades out",
                                     .range = fraction}),
    Setting(&BrushStroke::depth, {.key = "depth",
                                  .name = "Depth",
                                  .description = "How far along the ray Restore and Open move its start at most",
                                  .unit = "mm",
                                  .range = {0.0, 1e9}}),
    Setting(&BrushStroke::amount, {.key = "amount",
                                   .name = "Amount",
                                   .description = "How much of the context's edges Fade takes or Strengthen adds",
                                   .range = fraction}),
    Setting(&BrushStroke::toSurface,
            {.key = "to_surface",
             .name = "To the surface",
             .description = "Whether Restore reaches to the context's first surface, however deep that lies"}),
    Setting(&BrushStroke::coversFocus, {.key = "covers_focus",
                                        .name = "May cover the focus",
                                        .description = "Whether restored context may hide the focus"}),
    Setting(&BrushStroke::hidden,
            {.key = "hidden", .name = "Hidden", .description = "Whether the stroke is kept without effect"}),
    Setting(&BrushStroke::view, {.key = "view",
                                 .name = "View",
                                 .description = "View in which it shows: 0 for C1, 1 for C2, -1 for both",
                                 .range = {-1.0, 1.0}})};

}  // namespace fenestra
