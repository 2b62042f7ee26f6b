#include "viewer/model/SelectionBrush.h"

namespace fenestra::viewer {

void SelectionBrush::setSettings(const SelectionBrushSettings& settings) {
  if (settings == settings_) return;
  settings_ = settings;
  Q_EMIT changed();
}

}  // namespace fenestra::viewer
