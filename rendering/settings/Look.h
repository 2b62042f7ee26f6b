#pragma once
// How a volume is looked at: everything in a picture but the data and the camera. Plain data.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include <glm/glm.hpp>

#include "rendering/methods/Method.h"
#include "rendering/settings/BrushStroke.h"
#include "rendering/settings/Clipping.h"
#include "rendering/settings/Cutaway.h"
#include "rendering/settings/Focus.h"
#include "rendering/settings/LabelSettings.h"
#include "rendering/settings/LabelSmoothing.h"
#include "rendering/settings/Reconstruction.h"
#include "rendering/settings/Removal.h"
#include "rendering/settings/TransferFunction.h"

namespace fenestra {

/// How the focus looks. A label focus takes its labels' colours; a value focus takes `colour`. `extinction` is in 1/mm.
/// In place of this one material a value focus and a grown region may have a function of the values, as a label has its
/// own (see LabelSetting).
struct FocusAppearance {
  glm::dvec3 colour{0.93, 0.87, 0.75};
  double extinction = 2.0;
  std::optional<TransferFunction> function{};
  bool operator==(const FocusAppearance&) const = default;
};

/// The optical properties of everything that is not focus, and what they were made from.
struct ContextFunction {
  std::string preset;          ///< id of the built-in preset that `function` is, or empty
  std::filesystem::path file;  ///< the file that `function` was read from, absolute, or empty
  TransferFunction function;   ///< before the shift
  double shift = 0.0;          ///< added to the values of the nodes, in the volume's unit

  /// What pictures show.
  TransferFunction shifted() const;
  bool operator==(const ContextFunction&) const = default;
};

struct Shading {
  bool enabled = true;  ///< off: no gradient texture is made
  double ambient = 0.3;
  double diffuse = 0.7;
  double specular = 0.2;
  double shininess = 24.0;
  double lightAzimuth = -19.290046219188735;   ///< degrees; with the elevation, 0.35 to the left and 0.45 up for every
  double lightElevation = 23.012691498169566;  ///< 1 towards the viewer
  double occlusion = 0.0;                      ///< share of the ambient light that surroundings hide; see Occlusion.h
  double shadow = 0.0;                         ///< share of the source's light that the volume before a point hides
  bool operator==(const Shading&) const = default;
};

/// What lies behind the volume.
enum class Backdrop : std::uint8_t { Plain, Gradient };

/// How pictures show edges; hasSmoothEdges() of Edges.h says which pictures have them.
enum class Edges : std::uint8_t { Off, Smooth };

struct Look {
  Focus focus;
  LabelSettings labels;  ///< of the label map; empty until one is changed
  FocusAppearance focusAppearance;
  ContextFunction context;
  Method method;  ///< how the context is opened, where the cutaway is on
  Cutaway cutaway;
  ContextLayer contextLayer;
  Shading shading;
  glm::dvec3 background{0.0};  ///< display RGB 0..1; of a gradient, at the bottom
  Backdrop backdrop = Backdrop::Plain;
  glm::dvec3 backgroundTop{0.30, 0.36, 0.44};              ///< display RGB 0..1; of a gradient, at the top
  bool hideTable = true;                                   ///< of a CT, in 3-D pictures; see Scene::table
  Reconstruction reconstruction = Reconstruction::Linear;  ///< of 3-D pictures; slices are always trilinear
  LabelSmoothing labelSmoothing = LabelSmoothing::Off;     ///< of a label focus in 3-D pictures
  Edges edges = Edges::Off;                                ///< of pictures at rest; off, no pass runs for them
  Clipping clipping;     ///< with nothing to clip, no pass, no memory and no shader is used for it
  BrushStrokes strokes;  ///< edits of the opening; without any, no pass runs and no memory is used for them
  Removals removals;     ///< carved out of the volume; without any, no memory and no pass is used for them
  bool operator==(const Look&) const = default;
};

/// The colour behind a picture at a height between its bottom, 0, and its top, 1: linear in display RGB. A pixel of row
/// j from the top, of H rows, is at the height 1 - (j + ½)/H.
glm::dvec3 backgroundAt(const Look& look, double height);
/// The change of that colour from the bottom to the top; 0 where the backdrop is plain.
glm::dvec3 backgroundRise(const Look& look);

}  // namespace fenestra
