#include "viewer/model/ActiveTool.h"

#include <algorithm>
#include <utility>

#include "viewer/model/StrokeMode.h"

namespace fenestra::viewer {

ActiveTool::ActiveTool(std::vector<StrokeMode*> modes, QObject* parent) : QObject(parent), modes_(std::move(modes)) {
  for (StrokeMode* mode : modes_) {
    connect(mode, &StrokeMode::activeChanged, this, [this, mode](bool active) {
      for (StrokeMode* other : modes_)
        if (active && other != mode) other->setActive(false);
    });
    connect(mode, &StrokeMode::changed, this, &ActiveTool::changed);
  }
}

StrokeMode* ActiveTool::mode() const {
  const auto active =
      std::find_if(modes_.begin(), modes_.end(), [](const StrokeMode* mode) { return mode->isActive(); });
  return active != modes_.end() ? *active : nullptr;
}

bool ActiveTool::putDown() {
  StrokeMode* active = mode();
  if (active) active->setActive(false);
  return active != nullptr;
}

}  // namespace fenestra::viewer
