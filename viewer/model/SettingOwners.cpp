#include "viewer/model/SettingOwners.h"

#include <array>
#include <utility>

namespace fenestra::viewer {
namespace {

constexpr std::array settings{
    OwnedSetting{"Focus", SettingOwner::Data},
    OwnedSetting{"Roles, colours and opacity of structures", SettingOwner::Data},
    OwnedSetting{"Crop box and clip planes", SettingOwner::Data},
    OwnedSetting{"Brush strokes", SettingOwner::Data},
    OwnedSetting{"Carved parts", SettingOwner::Data},
    OwnedSetting{"Measures", SettingOwner::Data},
    OwnedSetting{"Path of the curved reformat", SettingOwner::Data},
    OwnedSetting{"Window and level, inverted greys", SettingOwner::Data},
    OwnedSetting{"Crosshair", SettingOwner::Data},
    OwnedSetting{"Turned and thick slices", SettingOwner::Data},
    OwnedSetting{"Cameras and frozen openings", SettingOwner::Data},
    OwnedSetting{"Flips and turns of slices", SettingOwner::Data},
    OwnedSetting{"Undo", SettingOwner::Data},
    OwnedSetting{"Notices", SettingOwner::Data},
    OwnedSetting{"Transfer function and shift", SettingOwner::Look},
    OwnedSetting{"Method", SettingOwner::Look},
    OwnedSetting{"Opening, border and axis", SettingOwner::Look},
    OwnedSetting{"Context edges", SettingOwner::Look},
    OwnedSetting{"Light, occlusion and shadows", SettingOwner::Look},
    OwnedSetting{"Between voxels", SettingOwner::Look},
    OwnedSetting{"Smoothing of labels", SettingOwner::Look},
    OwnedSetting{"Edges", SettingOwner::Look},
    OwnedSetting{"Hide the table", SettingOwner::Look},
    OwnedSetting{"Unit of widths, background", SettingOwner::Habit},
    OwnedSetting{"Quality at rest", SettingOwner::Habit},
    OwnedSetting{"Linked views", SettingOwner::Habit},
    OwnedSetting{"Cameras that follow the path", SettingOwner::Habit},
    OwnedSetting{"How cameras are placed", SettingOwner::Habit},
    OwnedSetting{"Cross, text, label colours, measures, planes shown", SettingOwner::Habit},
    OwnedSetting{"Click chooses the focus", SettingOwner::Habit},
    OwnedSetting{"Size and softness of brushes", SettingOwner::Habit},
    OwnedSetting{"Hide the patient", SettingOwner::Habit},
    OwnedSetting{"Neurological convention", SettingOwner::Habit},
    OwnedSetting{"Layout of the window", SettingOwner::Habit},
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
