#include "viewer/model/UserWork.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QCoreApplication>

namespace fenestra::viewer {
namespace {

/// Names of steps with the context that translates them.
using Name = std::pair<const char*, const char*>;
constexpr std::array cameraSteps{
    Name("fenestra::viewer::MainWindow", "Place cameras"), Name("fenestra::viewer::ViewCommands", "Standard view"),
    Name("fenestra::viewer::ViewCommands", "Reset view"), Name("fenestra::viewer::ViewCommands", "Reset views")};
constexpr std::array focusSteps{Name("fenestra::viewer::Document", "Focus"),
                                Name("fenestra::viewer::Document", "Region")};

template <class Names>
bool isOneOf(const Names& names, const QString& step) {
  return std::any_of(names.begin(), names.end(),
                     [&](const Name& name) { return step == QCoreApplication::translate(name.first, name.second); });
}

bool isOneClick(const Focus& focus) {
  if (const auto* labels = std::get_if<LabelFocus>(&focus)) return labels->labels.size() == 1;
  if (const auto* region = std::get_if<RegionFocus>(&focus))
    return region->inside.size() == 1 && region->outside.empty() && region->painted.empty() && !region->tolerance;
  return std::holds_alternative<std::monostate>(focus);
}

}  // namespace

bool isWork(const QString& step, const Focus& present) {
  if (isOneOf(cameraSteps, step)) return false;
  return !isOneOf(focusSteps, step) || !isOneClick(present);
}

}  // namespace fenestra::viewer
