#pragma once
// Declares every setting of a look once: its name in files, on the command line and in the window, its meaning and its
// range. A setting's default is its member's initialiser. Session files and their published schema, the options of the
// command line and the controls of the window are made from these tables.

#include <concepts>
#include <limits>
#include <tuple>

#include "rendering/scene/SettingWords.h"

namespace fenestra {

/// A closed interval of finite numbers.
struct Range {
  double low = std::numeric_limits<double>::lowest(), high = std::numeric_limits<double>::max();
  constexpr bool contains(double number) const { return number >= low && number <= high; }
};
inline constexpr Range fraction{0.0, 1.0};
/// Coordinates and lengths in mm. The limit of 1000 km is far beyond any patient, and its square fits a float.
inline constexpr Range millimetres{-1e9, 1e9}, positiveMillimetres{1e-9, 1e9}, millimetresFromZero{0.0, 1e9};
/// Greatest error of a colour that sampling may leave, in 1/255; below the least, rounding of the voxels' float32 sums
/// dominates.
inline constexpr Range maxErrors{0.05, 255.0};

/// What a setting is called, means and may be.
struct Declaration {
  const char* key;               ///< in files
  const char* option = nullptr;  ///< on the command line; null: it has none
  const char* name;              ///< label in the window
  const char* description;       ///< a phrase for tool tips, --help and the schema
  const char* unit = "";
  Range range = {};      ///< of a number
  Range slider = range;  ///< the part of `range` that a slider spans
  double step = 0.0;     ///< of a slider
};

/// One member of `Owner`: a number, a switch (bool), a choice (an enumeration with wordsOf) or a colour (display RGB).
template <class Owner, class Value>
struct Setting : Declaration {
  constexpr Setting(Value Owner::*which, const Declaration& declaration) : Declaration(declaration), member(which) {}

  Value Owner::*member;
};

/// All settings of `Owner`, in the order in which files and panels show them; empty for other structs.
template <class Owner>
inline constexpr std::tuple settingsOf{};

template <>
inline constexpr std::tuple settingsOf<Method>{
    Setting(
        &Method::kind,
        {.key = "kind", .option = "--method", .name = "Method", .description = "How the view is opened to the focus"}),
    Setting(&Method::coneAngle,
            {.key = "cone_angle",
             .option = "--cone-angle",
             .name = "Cone's angle",
             .description = "Angle between the axis and the wall of the cone cutaway's cones: more opens wider",
             .unit = "°",
             .range = {1.0, 85.0},
             .slider = {5.0, 75.0},
             .step = 1.0}),
    Setting(&Method::importance, {.key = "importance",
                                  .option = "--importance",
                                  .name = "What hides the focus",
                                  .description = "What the importance-driven method does with what hides the focus"}),
    Setting(
        &Method::importanceAngle,
        {.key = "importance_angle",
         .option = "--importance-angle",
         .name = "Widening",
         .description = "Angle at which the importance-driven opening widens from the focus's outline towards the eye",
         .unit = "°",
         .range = {1.0, 85.0},
         .slider = {1.0, 60.0},
         .step = 1.0}),
    Setting(
        &Method::importanceOpacity,
        {.key = "importance_opacity",
         .option = "--importance-opacity",
         .name = "Opacity left",
         .description = "Factor of the opacity of what hides the focus, where the importance-driven method keeps it "
                        "faint; 0 removes it",
         .range = fraction,
         .step = 0.05}),
    Setting(&Method::sparseness, {.key = "sparseness",
                                  .option = "--importance-sparseness",
                                  .name = "Faint how",
                                  .description = "How what hides the focus is made faint"}),
    Setting(&Method::lensFade, {.key = "lens_fade",
                                .option = "--lens-fade",
                                .name = "Lens keeps",
                                .description = "What stays within ClearView's lens of what hides the focus, beside its "
                                               "bends"}),
    Setting(&Method::lensRadius,
            {.key = "lens_radius",
             .option = "--lens-radius",
             .name = "Lens",
             .description = "Radius of ClearView's lens, as a share of the volume's longest side; its authors use 18.2",
             .unit = "%",
             .range = {0.1, 1000.0},
             .slider = {2.0, 60.0},
             .step = 0.2}),
    Setting(&Method::lensBends,
            {.key = "lens_bends",
             .option = "--lens-bends",
             .name = "Bends kept",
             .description = "How much of the bends of what hides the focus stays within ClearView's lens; 0 keeps none",
             .range = {0.0, 100.0},
             .slider = {0.0, 4.0},
             .step = 0.1}),
    Setting(&Method::lensRim, {.key = "lens_rim",
                               .option = "--lens-rim",
                               .name = "Rim of the lens",
                               .description = "How thin the dark line around ClearView's lens is: more is thinner",
                               .range = {1.0, 1000.0}}),
    Setting(&Method::fadeReach,
            {.key = "fade_reach",
             .option = "--fade-reach",
             .name = "Reach",
             .description = "How deep the context-preserving method looks into the volume; 0 fades nothing (κt)",
             .range = {0.0, 100.0},
             .slider = {0.0, 10.0},
             .step = 0.1}),
    Setting(&Method::fadeSharpness,
            {.key = "fade_sharpness",
             .option = "--fade-sharpness",
             .name = "Sharpness",
             .description = "How sudden the context-preserving method changes from faded to shown along the line of "
                            "sight: more looks like a cut (κs)",
             .range = {0.05, 4.0},
             .slider = {0.1, 2.0},
             .step = 0.05}),
    Setting(&Method::focalShape, {.key = "focal_shape",
                                  .option = "--focal-shape",
                                  .name = "Region",
                                  .description = "Shape of the focal region, around the middle of the focus, or of the "
                                                 "volume without a focus"}),
    Setting(&Method::focalSize, {.key = "focal_size",
                                 .option = "--focal-size",
                                 .name = "Size of region",
                                 .description = "Radius of the focal region's sphere, or half the side of its box",
                                 .unit = "mm",
                                 .range = {0.1, 1e5},
                                 .slider = {5.0, 150.0},
                                 .step = 1.0}),
    Setting(&Method::focalFallOff,
            {.key = "focal_fall_off",
             .option = "--focal-fall-off",
             .name = "Fall-off",
             .description = "How far outside of the focal region edges are half as strong as at its border: more shows "
                            "more of what is around it",
             .unit = "mm",
             .range = {0.1, 1e5},
             .slider = {1.0, 200.0},
             .step = 1.0}),
    Setting(&Method::wallPlacement, {.key = "wall_placement",
                                     .option = "--wall-placement",
                                     .name = "Walls",
                                     .description = "Where the walls of slices stand"}),
    Setting(&Method::wallAxial, {.key = "wall_axial",
                                 .option = "--wall-axial",
                                 .name = "Axial",
                                 .description = "Whether the axial slice at the crosshair is a wall"}),
    Setting(&Method::wallSagittal, {.key = "wall_sagittal",
                                    .option = "--wall-sagittal",
                                    .name = "Sagittal",
                                    .description = "Whether the sagittal slice at the crosshair is a wall"}),
    Setting(&Method::wallCoronal, {.key = "wall_coronal",
                                   .option = "--wall-coronal",
                                   .name = "Coronal",
                                   .description = "Whether the coronal slice at the crosshair is a wall"}),
    Setting(&Method::wallOutlines, {.key = "wall_outlines",
                                    .option = "--wall-outlines",
                                    .name = "Outlines",
                                    .description = "Whether the labels' outlines are drawn on the walls"}),
    Setting(&Method::explosion, {.key = "explosion",
                                 .option = "--explosion",
                                 .name = "Explosion",
                                 .description = "How far the parts of an exploded view are moved apart (its degree of "
                                                "explosion): at 0 all are in their places",
                                 .range = fraction,
                                 .step = 0.05}),
    Setting(&Method::explosionPlanes,
            {.key = "explosion_planes",
             .option = "--explosion-planes",
             .name = "Parts",
             .description = "How many planes through the middle of the focus, or of the volume without a focus, cut "
                            "it into the parts of an exploded view"}),
    Setting(&Method::explosionAxes, {.key = "explosion_axes",
                                     .option = "--explosion-axes",
                                     .name = "Cut along",
                                     .description = "Whether the planes of an exploded view lie along the patient's "
                                                    "axes or the view's"}),
    Setting(&Method::ghostStrength,
            {.key = "ghost_strength",
             .option = "--ghost-strength",
             .name = "Ghosting",
             .description = "How much of what is flat in front of the selection gives way; 0 fades nothing",
             .range = fraction,
             .step = 0.05}),
    Setting(&Method::ghostEdge,
            {.key = "ghost_edge",
             .option = "--ghost-edge",
             .name = "Edges from",
             .description = "Gradient of which half stays in front of the selection, as a share of the steepest that "
                            "the volume can have: less keeps fainter edges",
             .unit = "%",
             .range = {0.01, 1000.0},
             .slider = {0.5, 50.0},
             .step = 0.5}),
    Setting(&Method::ghostOutline,
            {.key = "ghost_outline",
             .option = "--ghost-outline",
             .name = "Outlines",
             .description = "How much edges that face you give way, too, so that outlines stay in front of the "
                            "selection",
             .range = fraction,
             .step = 0.05}),
    Setting(&Method::peel, {.key = "peel",
                            .option = "--peel",
                            .name = "Peeled",
                            .description = "How far the layer in front of the focus is peeled away: at 0 it lies in "
                                           "its place, at 1 none of it lies in front of the focus",
                            .range = fraction,
                            .step = 0.05}),
    Setting(&Method::peelSide, {.key = "peel_side",
                                .option = "--peel-side",
                                .name = "Peel off",
                                .description = "Which side of the patient the layer is peeled off"}),
    Setting(&Method::peelTurn,
            {.key = "peel_turn",
             .option = "--peel-turn",
             .name = "Cut turned by",
             .description = "Turns the cut through the layer: at 0 it runs from head to foot, or from front to back "
                            "where the layer is peeled off above or below",
             .unit = "°",
             .range = {-180.0, 180.0},
             .slider = {-90.0, 90.0},
             .step = 5.0}),
    Setting(&Method::peelDepth,
            {.key = "peel_depth",
             .option = "--peel-depth",
             .name = "Layer down to",
             .description = "How deep the layer reaches: at 0 it ends just in front of the focus, at 1 just behind it",
             .range = fraction,
             .step = 0.05}),
    Setting(&Method::peelRadius,
            {.key = "peel_radius",
             .option = "--peel-radius",
             .name = "Roll",
             .description = "Radius of the hollow in the roll: less rolls the layer up more tightly",
             .unit = "mm",
             .range = {1.0, 1000.0},
             .slider = {1.0, 100.0},
             .step = 1.0}),
    Setting(&Method::peelMargin, {.key = "peel_margin",
                                  .option = "--peel-margin",
                                  .name = "Margin",
                                  .description = "How far the opened window reaches beyond the focus on all its sides",
                                  .unit = "mm",
                                  .range = {0.0, 1e5},
                                  .slider = {0.0, 100.0},
                                  .step = 1.0})};

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

/// Calls use(setting) for every setting of `Owner`.
template <class Owner>
constexpr void forEachSetting(auto&& use) {
  std::apply([&](const auto&... setting) { (use(setting), ...); }, settingsOf<Owner>);
}

/// The declaration of a member, as in settingOf(&Cutaway::openWidth).
template <class Owner, class Value>
constexpr const Setting<Owner, Value>& settingOf(Value Owner::*member) {
  const Setting<Owner, Value>* found = nullptr;
  forEachSetting<Owner>([&](const auto& setting) {
    if constexpr (std::same_as<decltype(setting), const Setting<Owner, Value>&>)
      if (setting.member == member) found = &setting;
  });
  return *found;
}

}  // namespace fenestra
