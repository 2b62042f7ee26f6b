#pragma once
// The words of the choices among a look's settings (Settings.h); those of a method are in its folder.

#include "rendering/settings/Camera.h"
#include "rendering/settings/Look.h"
#include "rendering/settings/Quality.h"
#include "rendering/vocabulary/Word.h"

namespace fenestra {

constexpr auto wordsOf(WidthUnit) {
  return std::to_array<Word<WidthUnit>>(
      {{WidthUnit::Pixel, "px", "pixels"}, {WidthUnit::Millimetre, "mm", "millimetres at the focus"}});
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
constexpr auto wordsOf(RegionRule) {
  return std::to_array<Word<RegionRule>>(
      {{RegionRule::Values, "values", "Values", "What is connected to the click by values near its own"},
       {RegionRule::Tissues, "tissues", "Tissues",
        "What belongs to the clicked tissue more than to any other of the volume"}});
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

}  // namespace fenestra
