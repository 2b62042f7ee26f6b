#include "viewer/model/SettingOwners.h"

#include <array>
#include <utility>

namespace fenestra::viewer {
namespace {

using enum SettingOwner;
constexpr std::array settings{
    OwnedSetting{"Focus", Data},
    OwnedSetting{"Roles, colours and opacity of structures", Data},
    OwnedSetting{"Crop box and clip planes", Data},
    OwnedSetting{"Brush strokes", Data},
    OwnedSetting{"Carved parts", Data},
    OwnedSetting{"Measures", Data},
    OwnedSetting{"Window and level, inverted greys", Data},
    OwnedSetting{"Crosshair", Data},
    OwnedSetting{"Turned and thick slices", Data},
    OwnedSetting{"Cameras and frozen openings", Data},
    OwnedSetting{"Flips and turns of slices", Data},
    OwnedSetting{"Undo", Data},
    OwnedSetting{"Notices", Data},
    OwnedSetting{"Transfer function and shift", Look},
    OwnedSetting{"Method", Look},
    OwnedSetting{"Opening, border and axis", Look},
    OwnedSetting{"Context edges", Look},
    OwnedSetting{"Light, occlusion and shadows", Look},
    OwnedSetting{"Between voxels", Look},
    OwnedSetting{"Smoothing of labels", Look},
    OwnedSetting{"Edges", Look},
    OwnedSetting{"Hide the table", Look},
    OwnedSetting{"Unit of widths, background", Habit},
    OwnedSetting{"Quality at rest", Habit},
    OwnedSetting{"Linked views", Habit},
    OwnedSetting{"How cameras are placed", Habit},
    OwnedSetting{"Cross, text, label colours, measures, planes shown", Habit},
    OwnedSetting{"Click chooses the focus", Habit},
    OwnedSetting{"Size and softness of brushes", Habit},
    OwnedSetting{"Hide the patient", Habit},
    OwnedSetting{"Neurological convention", Habit},
    OwnedSetting{"Layout of the window", Habit},
};

}  // namespace

std::span<const OwnedSetting> ownedSettings() { return settings; }

const char* nameOf(SettingOwner owner) {
  return owner == SettingOwner::Data ? "data" : owner == SettingOwner::Look ? "look" : "habit";
}

void startIn(io::Study& study, const io::LookPreset& preset) {
  ContextFunction own = study.scene.look.context;
  study.scene.look = io::restyled(study.scene, preset);
  if (!io::mismatchOf(preset, study.scene.volume->unit).empty()) study.scene.look.context = std::move(own);
  study.drawn.update(study.scene, study.growth.get());
}

}  // namespace fenestra::viewer
