#include "viewer/model/StrokeMode.h"

namespace fenestra::viewer {

void StrokeMode::setActive(bool on) {
  if (on == active_ || (on && !canBeUsed())) return;
  active_ = on;
  Q_EMIT activeChanged(on);  // first, so that whoever hears of a change finds one active mode at most
  Q_EMIT changed();
}

}  // namespace fenestra::viewer
