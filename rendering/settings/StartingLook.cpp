#include "rendering/settings/StartingLook.h"

#include <algorithm>
#include <string_view>

namespace fenestra {
namespace {

void applyOpening(std::string_view id, Look& look) {
  const auto all = openingLooks();
  std::find_if(all.begin(), all.end(), [&](const OpeningLook& each) {
    return each.id == id;
  })->applyTo(look.cutaway, look.contextLayer);
}

}  // namespace

Look startingLook() {
  Look look;
  look.reconstruction = Reconstruction::Auto;
  look.labelSmoothing = LabelSmoothing::Light;
  look.edges = Edges::Smooth;
  // More of either blackens a structure at the bottom of a narrow opening.
  look.shading.occlusion = 0.35;
  look.shading.shadow = 0.3;
  // Nearer to the line of sight than the plain look's, so that light falls to the bottom of the opening.
  look.shading.lightAzimuth = -15.0;
  look.shading.lightElevation = 20.0;
  applyOpening("full", look);
  return look;
}

Look bareLook() {
  Look look;
  applyOpening("bare", look);
  return look;
}

}  // namespace fenestra
