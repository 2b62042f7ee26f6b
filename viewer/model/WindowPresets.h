#pragma once
// Ready display windows by modality, on number keys where radiologists know them.

#include <array>

#include <QtGlobal>

#include "rendering/volume/Volume.h"

namespace fenestra::viewer {

struct WindowPreset {
  int key;  ///< number key; -1: none
  const char* name;
  WindowLevel window;  ///< HU
};

/// Keys 3 to 7: keys and figures of Weasis and OsiriX-like viewers. The others: Radiopaedia's article "Windowing (CT)",
/// where it gives a range its middle (subdural: width 130 to 300, level 50 to 100).
inline constexpr std::array ctWindowPresets{
    WindowPreset{3, QT_TRANSLATE_NOOP("fenestra::viewer::Actions", "Brain"), {110.0, 35.0}},
    WindowPreset{4, QT_TRANSLATE_NOOP("fenestra::viewer::Actions", "Abdomen"), {320.0, 50.0}},
    WindowPreset{5, QT_TRANSLATE_NOOP("fenestra::viewer::Actions", "Mediastinum"), {400.0, 80.0}},
    WindowPreset{6, QT_TRANSLATE_NOOP("fenestra::viewer::Actions", "Bone"), {2000.0, 350.0}},
    WindowPreset{7, QT_TRANSLATE_NOOP("fenestra::viewer::Actions", "Lung"), {1500.0, -500.0}},
    WindowPreset{8, QT_TRANSLATE_NOOP("fenestra::viewer::Actions", "Stroke"), {40.0, 40.0}},
    WindowPreset{9, QT_TRANSLATE_NOOP("fenestra::viewer::Actions", "Subdural"), {215.0, 75.0}},
    WindowPreset{0, QT_TRANSLATE_NOOP("fenestra::viewer::Actions", "Liver"), {150.0, 30.0}},
    WindowPreset{-1, QT_TRANSLATE_NOOP("fenestra::viewer::Actions", "Temporal bone"), {2800.0, 600.0}},
    WindowPreset{-1, QT_TRANSLATE_NOOP("fenestra::viewer::Actions", "Spine, soft tissue"), {250.0, 50.0}},
    WindowPreset{-1, QT_TRANSLATE_NOOP("fenestra::viewer::Actions", "Spine, bone"), {1800.0, 400.0}},
};

/// Values of MR have no unit: its windows span shares of the volume's own values, from one percentile to another.
struct PercentilePreset {
  const char* name;
  double low, high;  ///< percent
};
inline constexpr std::array percentilePresets{
    PercentilePreset{QT_TRANSLATE_NOOP("fenestra::viewer::Actions", "Usual"), 1.0, 99.0},
    PercentilePreset{QT_TRANSLATE_NOOP("fenestra::viewer::Actions", "All but outliers"), 0.1, 99.9},
    PercentilePreset{QT_TRANSLATE_NOOP("fenestra::viewer::Actions", "High contrast"), 25.0, 95.0},
    PercentilePreset{QT_TRANSLATE_NOOP("fenestra::viewer::Actions", "Bright structures"), 75.0, 99.9},
};

/// The window that spans a volume's finite values from one percentile to another, shares from 0 to 1; of a million
/// voxels spread over a larger volume, which gives percentiles to a thousandth. `low` and `high` are apart, or else the
/// window is 1 wide.
WindowLevel windowOfPercentiles(const Volume& volume, double lowShare, double highShare);

/// Upper ends of windows from 0 for PET in standardised uptake values, g/ml: those that workstations offer for FDG,
/// from faint uptake to tumours, brain and bladder.
inline constexpr std::array petWindowEnds{2.5, 5.0, 7.0, 10.0, 15.0};

}  // namespace fenestra::viewer
