#pragma once
// The choices among settings (Settings.h): the word of each value in files and on the command line, and its name and
// meaning in the window.

#include <array>

#include "rendering/settings/Camera.h"
#include "rendering/settings/Look.h"
#include "rendering/settings/Quality.h"

namespace fenestra {

/// One value of an enumeration.
template <class E>
struct Word {
  E value;
  const char* word;              ///< in files and on the command line
  const char* name = word;       ///< in the window
  const char* description = "";  ///< as in Declaration (Settings.h)
};

constexpr auto wordsOf(WidthUnit) {
  return std::to_array<Word<WidthUnit>>(
      {{WidthUnit::Pixel, "px", "pixels"}, {WidthUnit::Millimetre, "mm", "millimetres at the focus"}});
}
constexpr auto wordsOf(MethodKind) {
  return std::to_array<Word<MethodKind>>(
      {{MethodKind::Adaptive, "adaptive", "Adaptive cutaway",
        "An opening around the focus that rises to the surface over a width that you choose: the method of this "
        "program"},
       {MethodKind::Cone, "cone", "Cone cutaway",
        "A funnel around everything in focus, which widens towards you at one angle: the deeper the focus lies, the "
        "wider the opening (Burns and Finkelstein 2008)"},
       {MethodKind::Importance, "importance", "Importance-driven",
        "What hides the focus gives way to it because the focus is more important: it is removed, or stays faint "
        "(Viola, "
        "Kanitsar and Gröller 2004)"},
       {MethodKind::ClearView, "clearview", "ClearView",
        "A lens over the focus through which it shows, while what hides it fades towards the lens's middle and stays "
        "where it bends (Krüger, Schneider and Westermann 2006)"},
       {MethodKind::ContextPreserving, "context-preserving", "Context-preserving",
        "Nothing is cut away: what is flat, brightly lit and near to you fades, while edges stay, so that the inside "
        "shows; what is in focus stays as it is (Bruckner, Grimm, Kanitsar and Gröller 2006)"},
       {MethodKind::FocalRegion, "focal-region", "Focal region",
        "A region around the focus shows as it is; around it only the edges of what is there stay, the fainter the "
        "farther away; what is in focus stays as it is (Zhou, Hinz and Tönnies 2002)"},
       {MethodKind::Walls, "walls", "Walls of slices",
        "The adaptive cutaway with the slices at the crosshair as walls: behind the volume, or inside the opening "
        "(Tory and Swindells 2003)"},
       {MethodKind::Explode, "explode", "Exploded view",
        "What is around the focus is cut into parts, which move apart and out of your line of sight to it; what is in "
        "focus stays in its place (Bruckner and Gröller 2006)"},
       {MethodKind::Sculpt, "sculpt", "Sculpting",
        "Nothing opens by itself: you carve the volume with a ball, a box or a saw until the focus shows (Wang and "
        "Kaufman 1995)"},
       {MethodKind::Bend, "bend", "Deformable cutting plane",
        "Nothing opens by itself: a plane that you lay through a stroke and bend by dragging removes one side of it "
        "(Konrad-Verse, Preim and Littmann 2004)"},
       {MethodKind::Selection, "selection", "Ghosted selection",
        "Nothing is cut away: in front of the focus, and in the opening around it, what is flat gives way and edges "
        "stay, like a ghost of it; what is in focus stays as it is (Bruckner and Gröller 2005)"},
       {MethodKind::Peel, "peel", "Peeling",
        "A layer in front of the focus is cut in two, and its halves are rolled aside like a peel; what is in focus "
        "stays "
        "in its place (McGuffin et al. 2003; Correa et al. 2006)"}});
}
constexpr auto wordsOf(WallPlacement) {
  return std::to_array<Word<WallPlacement>>(
      {{WallPlacement::Around, "around", "Around the volume", "Behind the volume, like the walls of a room"},
       {WallPlacement::Inside, "inside", "Inside the opening",
        "Where the slices lie, in the space that the opening removed; before the focus there is none"}});
}
constexpr auto wordsOf(ExplosionPlanes) {
  return std::to_array<Word<ExplosionPlanes>>(
      {{ExplosionPlanes::One, "one", "Two halves", "One plane cuts the volume into left and right"},
       {ExplosionPlanes::Two, "two", "Four quarters", "Two planes: left and right, above and below"},
       {ExplosionPlanes::Three, "three", "Eight parts",
        "Three planes: left and right, above and below, front and back"}});
}
constexpr auto wordsOf(ExplosionAxes) {
  return std::to_array<Word<ExplosionAxes>>(
      {{ExplosionAxes::Patient, "patient", "The patient",
        "Planes along the patient's axes: left and right are the patient's"},
       {ExplosionAxes::View, "view", "The view", "Planes along the picture's axes, which turn with the camera"}});
}
constexpr auto wordsOf(PeelSide) {
  return std::to_array<Word<PeelSide>>({{PeelSide::Anterior, "anterior", "The front", "The patient's anterior side"},
                                        {PeelSide::Posterior, "posterior", "The back", "The patient's posterior side"},
                                        {PeelSide::Left, "left", "The left", "The patient's left side"},
                                        {PeelSide::Right, "right", "The right", "The patient's right side"},
                                        {PeelSide::Superior, "superior", "Above", "The patient's superior side"},
                                        {PeelSide::Inferior, "inferior", "Below", "The patient's inferior side"}});
}
constexpr auto wordsOf(RemovalShape) {
  return std::to_array<Word<RemovalShape>>(
      {{RemovalShape::Ball, "ball", "Ball", "A ball, where the mouse goes"},
       {RemovalShape::Box, "box", "Box", "A box that faces you, where the mouse goes"},
       {RemovalShape::Saw, "saw", "Saw",
        "A blade along the stroke, away from you; a stroke that comes back to its start takes out what it encloses"},
       {RemovalShape::Plane, "plane", "Plane",
        "A plane through the stroke that removes what lies to the right of it, and that you bend by dragging"}});
}
constexpr auto wordsOf(FocalShape) {
  return std::to_array<Word<FocalShape>>(
      {{FocalShape::Sphere, "sphere", "Sphere", "A ball around the middle of the focus"},
       {FocalShape::Box, "box", "Box", "A cube along the patient's axes, around the middle of the focus"},
       {FocalShape::Distance, "distance", "Distance", "Everything that lies near the focus, whatever its shape"}});
}
constexpr auto wordsOf(LensPlace) {
  return std::to_array<Word<LensPlace>>(
      {{LensPlace::OverFocus, "focus", "Focus", "The middle of the focus"},
       {LensPlace::OverCrosshair, "crosshair", "Crosshair", "The crosshair: the lens follows what you point at"}});
}
constexpr auto wordsOf(LensFade) {
  return std::to_array<Word<LensFade>>(
      {{LensFade::Distance, "distance", "To the rim", "The nearer to the lens's rim, the more of what hides the focus"},
       {LensFade::Curvature, "curvature", "Evenly", "Nothing but the bends of what hides the focus"},
       {LensFade::Depth, "depth", "With depth", "The more lies in front of the focus, the more of it"}});
}
constexpr auto wordsOf(ImportanceMode) {
  return std::to_array<Word<ImportanceMode>>(
      {{ImportanceMode::Maximum, "maximum", "Removed",
        "What hides the focus is removed, in a cone that widens from the focus's outline towards you (maximum "
        "importance "
        "projection)"},
       {ImportanceMode::Average, "average", "Faint",
        "What hides the focus stays, but faint (average importance compositing)"}});
}
constexpr auto wordsOf(Sparseness) {
  return std::to_array<Word<Sparseness>>(
      {{Sparseness::Opacity, "opacity", "See-through", "Less opaque, in its own colours"},
       {Sparseness::Colour, "colour", "Grey", "Less opaque, and grey, so that the colours are the focus's alone"},
       {Sparseness::ScreenDoor, "screen-door", "Dotted",
        "As it is on a few pixels in an even pattern, and left out on the others"}});
}
constexpr auto wordsOf(BrushMode) {
  return std::to_array<Word<BrushMode>>(
      {{BrushMode::Restore, "restore", "Restore", "Brings back what the opening removed"},
       {BrushMode::Open, "open", "Open", "Opens further, away from the eye"},
       {BrushMode::Fade, "fade", "Fade", "Shows less of the context's edges over the focus"},
       {BrushMode::Strengthen, "strengthen", "Strengthen", "Shows more of the context's edges over the focus"}});
}
constexpr auto wordsOf(LabelRole) {
  return std::to_array<Word<LabelRole>>(
      {{LabelRole::Context, "context", "Context", "Cut away where it hides the focus"},
       {LabelRole::Hidden, "hidden", "Hidden", "Left out of 3-D pictures; slices show its voxels"},
       {LabelRole::Protected, "protected", "Protected", "Never cut away, even where it hides the focus"}});
}
constexpr auto wordsOf(Reconstruction) {
  return std::to_array<Word<Reconstruction>>(
      {{Reconstruction::Linear, "linear", "Straight", "Straight lines between voxels: coarse scans show terraces"},
       {Reconstruction::Cubic, "cubic", "Curved",
        "Smooth curves through every voxel, its noise as well: takes more memory and time"},
       {Reconstruction::Smooth, "smooth", "Smoothed",
        "Smooth curves near the voxels: fewer terraces and less noise, but softer detail"},
       {Reconstruction::Smoother, "smoother", "Smoothed more",
        "Smooth curves near means over five voxels: no terraces in coarse scans, but fine detail is lost"},
       {Reconstruction::Auto, "auto", "Automatic",
        "Smoothed where voxels are coarse and not too many, else straight"}});
}
constexpr auto wordsOf(Backdrop) {
  return std::to_array<Word<Backdrop>>({{Backdrop::Plain, "plain", "One colour", "The background's colour everywhere"},
                                        {Backdrop::Gradient, "gradient", "Gradient",
                                         "From the background's colour at the bottom to another at the top"}});
}
constexpr auto wordsOf(LabelSmoothing) {
  return std::to_array<Word<LabelSmoothing>>(
      {{LabelSmoothing::Off, "off", "Exact", "As the labels have it, with the steps of their voxels"},
       {LabelSmoothing::Light, "light", "Lightly smoothed", "Without the steps of single voxels"},
       {LabelSmoothing::Strong, "strong", "Strongly smoothed", "Without terraces of several voxels"}});
}
constexpr auto wordsOf(Edges) {
  return std::to_array<Word<Edges>>(
      {{Edges::Off, "off", "One ray a pixel", "Edges show the steps of the pixels"},
       {Edges::Smooth, "smooth", "Smooth", "Several rays for each pixel that an edge runs through"}});
}
constexpr auto wordsOf(Projection) {
  return std::to_array<Word<Projection>>(
      {{Projection::Perspective, "perspective"}, {Projection::Orthographic, "orthographic"}});
}
constexpr auto wordsOf(Quality) {
  return std::to_array<Word<Quality>>(
      {{Quality::Draft, "draft"}, {Quality::Normal, "normal"}, {Quality::High, "high"}});
}

/// The entry of wordsOf() for a value.
template <class E>
constexpr Word<E> wordOf(E value) {
  for (const Word<E>& word : wordsOf(value))
    if (word.value == value) return word;
  return {value, ""};
}

}  // namespace fenestra
