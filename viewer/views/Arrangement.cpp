#include "viewer/views/Arrangement.h"

#include <algorithm>

namespace fenestra::viewer {
namespace {

// What users of Slicer, Weasis and Horos look for: conventional, two pictures, four up, one large with small ones, and
// slices alone.
constexpr std::array readyArrangements{
    Arrangement{"five",
                QT_TRANSLATE_NOOP("ViewArea", "&Five views"),
                Qt::Vertical,
                {{{"C1", "C2"}, {"axial", "sagittal", "coronal"}}},
                {56, 44}},
    Arrangement{"pair", QT_TRANSLATE_NOOP("ViewArea", "C&1 and C2"), Qt::Vertical, {{{"C1", "C2"}, {}}}, {100, 0}},
    Arrangement{"large3d",
                QT_TRANSLATE_NOOP("ViewArea", "&3-D large, three slices"),
                Qt::Horizontal,
                {{{"C1"}, {"axial", "sagittal", "coronal"}}},
                {70, 30}},
    Arrangement{"slices",
                QT_TRANSLATE_NOOP("ViewArea", "&Slices alone"),
                Qt::Vertical,
                {{{"axial", "sagittal", "coronal"}, {}}},
                {100, 0}},
    Arrangement{"axial",
                QT_TRANSLATE_NOOP("ViewArea", "&Axial large"),
                Qt::Horizontal,
                {{{"axial"}, {"C1", "sagittal", "coronal"}}},
                {70, 30}},
    Arrangement{"four",
                QT_TRANSLATE_NOOP("ViewArea", "Four: C1 and slices"),
                Qt::Vertical,
                {{{"axial", "C1"}, {"coronal", "sagittal"}}},
                {50, 50}},
    Arrangement{
        "beside", QT_TRANSLATE_NOOP("ViewArea", "C1 &beside axial"), Qt::Vertical, {{{"C1", "axial"}, {}}}, {100, 0}}};

}  // namespace

bool Arrangement::shows(std::string_view view) const {
  return std::any_of(groups.begin(), groups.end(), [view](const auto& group) {
    return std::any_of(group.begin(), group.end(), [view](const char* each) { return each && view == each; });
  });
}

std::span<const Arrangement> arrangements() { return readyArrangements; }

const Arrangement* findArrangement(std::string_view id) {
  const auto found = std::find_if(readyArrangements.begin(), readyArrangements.end(),
                                  [id](const Arrangement& each) { return id == each.id; });
  return found == readyArrangements.end() ? nullptr : &*found;
}

}  // namespace fenestra::viewer
