#pragma once
// What the user may set of how a candidate for a camera is judged, its weights and habits: how they are stored and
// shown.

#include <array>

#include <QtGlobal>

#include "rendering/settings/PlacementOptions.h"

namespace fenestra::viewer {

struct PlacementWeight {
  const char* key;             ///< in the file of settings
  const char *name, *meaning;  ///< label and tool tip of its slider, to be translated for "PlacementForm"
  double low, high, step;      ///< the slider's range and step; files may hold other values
  double placement::Weights::*member;
};

/// The most important ones first.
inline constexpr std::size_t mainPlacementWeights = 4;
inline constexpr std::array<PlacementWeight, 8> placementWeights{{
    {"weightDepth", QT_TRANSLATE_NOOP("Settings", "Depth"),
     QT_TRANSLATE_NOOP("Settings",
                       "How deep the focus lies; below 0 prefers views with little in front of it.\n"
                       "vd1 = mean depth of the focus's pixels / diameter of the model's sphere"),
     -2.0, 2.0, 0.05, &placement::Weights::visibility},
    {"weightCoverage", QT_TRANSLATE_NOOP("Settings", "Size"),
     QT_TRANSLATE_NOOP("Settings",
                       "How large the focus is in the picture.\nvd2 = pixels of the focus / pixels of the picture"),
     0.0, 16.0, 0.1, &placement::Weights::coverage},
    {"weightLocation", QT_TRANSLATE_NOOP("Settings", "Centring"),
     QT_TRANSLATE_NOOP("Settings",
                       "How near to the middle of the picture it is.\nvd3 = 1 − distance of its centroid from the "
                       "middle / distance of a corner"),
     0.0, 2.0, 0.05, &placement::Weights::location},
    {"weightEndFace", QT_TRANSLATE_NOOP("Settings", "Cut ends"),
     QT_TRANSLATE_NOOP("Settings",
                       "Below 0 avoids looking at the focus through a face where the scan cuts the body off.\n"
                       "Share of the focus's pixels whose rays enter the volume inside the body"),
     -2.0, 0.0, 0.05, &placement::Weights::endFace},
    {"weightEntropy", QT_TRANSLATE_NOOP("Settings", "Evenness"),
     QT_TRANSLATE_NOOP("Settings",
                       "How much of its surface is seen.\nViewpoint entropy −Σ p log p of the seen surface points, "
                       "over its maximum (Bordoloi, Shen 2005)"),
     0.0, 2.0, 0.05, &placement::Weights::entropy},
    {"weightTypical", QT_TRANSLATE_NOOP("Settings", "Typical"),
     QT_TRANSLATE_NOOP("Settings",
                       "How typical the view is of all views.\n1 − Σ p(o|v) log(p(o|v) / p(o)) over its maximum "
                       "(Viola et al. 2006)"),
     0.0, 2.0, 0.05, &placement::Weights::mutualInformation},
    {"weightStability", QT_TRANSLATE_NOOP("Settings", "Steady"),
     QT_TRANSLATE_NOOP("Settings",
                       "How little changes when the camera moves a bit.\n1 − Jensen–Shannon divergence to the eight "
                       "nearest views"),
     0.0, 2.0, 0.05, &placement::Weights::stability},
    {"weightOrientation", QT_TRANSLATE_NOOP("Settings", "Standard view"),
     QT_TRANSLATE_NOOP("Settings",
                       "How near the view is to anterior, left, superior …: a little decides between equally good "
                       "views.\nCosine of the angle to the nearest of the six"),
     0.0, 2.0, 0.01, &placement::Weights::orientation},
}};

struct PlacementHabit {
  const char* key;             ///< in the file of settings
  const char *name, *meaning;  ///< label and tool tip of its box, to be translated for "PlacementForm"
  bool placement::Habits::*member;
};

inline constexpr std::array<PlacementHabit, 4> placementHabits{{
    {"avoidCutEnds", QT_TRANSLATE_NOOP("Settings", "Not through cut ends"),
     QT_TRANSLATE_NOOP("Settings",
                       "No view within 45° of an end of the scan where the body goes on, while another one shows at "
                       "least two thirds as much of the focus"),
     &placement::Habits::avoidCutEnds},
    {"uprightFirst", QT_TRANSLATE_NOOP("Settings", "From around before from above"),
     QT_TRANSLATE_NOOP("Settings",
                       "From the front, from behind, the left or the right rather than from above or below, where "
                       "both show about as much"),
     &placement::Habits::uprightFirst},
    {"flatFromFront", QT_TRANSLATE_NOOP("Settings", "Thin stacks from the front"),
     QT_TRANSLATE_NOOP("Settings",
                       "A stack of a few slices, or one much thinner than wide, is seen from the side from which its "
                       "slices are shown, not edge-on"),
     &placement::Habits::flatFromFront},
    {"nearSideFirst", QT_TRANSLATE_NOOP("Settings", "From the near side"),
     QT_TRANSLATE_NOOP(
         "PlacementForm",
         "From the side of the body that the focus is nearer to, rather than through the body, where both "
         "show about as much"),
     &placement::Habits::nearSideFirst},
}};

}  // namespace fenestra::viewer
