#pragma once
// M. Tory, C. Swindells: Comparing ExoVis, orientation icon, and in-place 3D visualization techniques, Graphics
// Interface 2003. rendering/scene/Walls.h says where the walls stand and what they show, MethodStages::Walls how they
// are laid.

#include "rendering/vocabulary/MethodStages.h"
#include "rendering/vocabulary/Setting.h"

namespace fenestra {

constexpr auto wordsOf(WallPlacement) {
  return std::to_array<Word<WallPlacement>>(
      {{WallPlacement::Around, "around", "Around the volume", "Behind the volume, like the walls of a room"},
       {WallPlacement::Inside, "inside", "Inside the opening",
        "Where the slices lie, in the space that the opening removed; before the focus there is none"}});
}

namespace methods {

struct Walls {
  static constexpr const char* word = "walls";
  static constexpr const char* name = "Walls of slices";
  static constexpr const char* description =
      "The adaptive cutaway with the slices at the crosshair as walls: behind the volume, or inside the opening (Tory "
      "and Swindells 2003)";

  WallPlacement placement = WallPlacement::Around;
  bool axial = true, sagittal = true, coronal = true;
  bool outlines = true;  ///< the labels' outlines on the walls

  /// All that decides on programs.
  Walls programs() const { return {.placement = placement}; }

  MethodStages stages() const {
    MethodStages stages;
    stages.walls = {placement, axial, sagittal, coronal, outlines};
    return stages;
  }
  bool operator==(const Walls&) const = default;
};

}  // namespace methods

template <>
inline constexpr std::tuple settingsOf<methods::Walls>{
    Setting(&methods::Walls::placement, {.key = "wall_placement",
                                         .option = "--wall-placement",
                                         .name = "Walls",
                                         .description = "Where the walls of slices stand"}),
    Setting(&methods::Walls::axial, {.key = "wall_axial",
                                     .option = "--wall-axial",
                                     .name = "Axial",
                                     .description = "Whether the axial slice at the crosshair is a wall"}),
    Setting(&methods::Walls::sagittal, {.key = "wall_sagittal",
                                        .option = "--wall-sagittal",
                                        .name = "Sagittal",
                                        .description = "Whether the sagittal slice at the crosshair is a wall"}),
    Setting(&methods::Walls::coronal, {.key = "wall_coronal",
                                       .option = "--wall-coronal",
                                       .name = "Coronal",
                                       .description = "Whether the coronal slice at the crosshair is a wall"}),
    Setting(&methods::Walls::outlines, {.key = "wall_outlines",
                                        .option = "--wall-outlines",
                                        .name = "Outlines",
                                        .description = "Whether the labels' outlines are drawn on the walls"})};

}  // namespace fenestra
