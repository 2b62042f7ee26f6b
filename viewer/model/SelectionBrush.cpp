#include "viewer/model/SelectionBrush.h"

namespace fenestra::viewer {

void SelectionBrush::setSettings(const SelectionBrushSettings& settings) {
  if (settings == settings_) return;
  settings_ = settings;
  Q_EMIT changed();
}

void SelectionBrush::setActive(bool on) {
  if (on == active_) return;
  active_ = on;
  Q_EMIT changed();
  Q_EMIT activeChanged(on);
}

}  // namespace fenestra::viewer
