#include "viewer/model/Brush.h"

#include <algorithm>

namespace fenestra::viewer {

bool movesRayStart(BrushMode mode) { return mode == BrushMode::Restore || mode == BrushMode::Open; }

QString nameOf(BrushMode mode) {
  switch (mode) {
    case BrushMode::Restore:
      return Brush::tr("Restore");
    case BrushMode::Open:
      return Brush::tr("Open");
    case BrushMode::Fade:
      return Brush::tr("Fade");
    case BrushMode::Strengthen:
      break;
  }
  return Brush::tr("Strengthen");
}

BrushMode opposite(BrushMode mode) {
  switch (mode) {
    case BrushMode::Restore:
      return BrushMode::Open;
    case BrushMode::Open:
      return BrushMode::Restore;
    case BrushMode::Fade:
      return BrushMode::Strengthen;
    case BrushMode::Strengthen:
      break;
  }
  return BrushMode::Fade;
}

void Brush::setSettings(const BrushSettings& settings) {
  BrushSettings within = settings;
  within.radius = std::clamp(within.radius, leastRadius, greatestRadius);
  within.softness = std::clamp(within.softness, 0.0, 1.0);
  within.depth = std::clamp(within.depth, leastDepth, greatestDepth);
  within.amount = std::clamp(within.amount, 0.0, 1.0);
  if (within == settings_) return;
  settings_ = within;
  Q_EMIT changed();
}

void Brush::scaleRadius(double factor) {
  BrushSettings settings = settings_;
  settings.radius *= factor;
  setSettings(settings);
}

void Brush::scaleDepth(double factor) {
  BrushSettings settings = settings_;
  (movesRayStart(settings.mode) ? settings.depth : settings.amount) *= factor;
  // Scaling could not raise an amount of 0.
  settings.amount = std::max(settings.amount, 0.05);
  setSettings(settings);
}

void Brush::setActive(bool on) {
  if (on == active_) return;
  active_ = on;
  Q_EMIT changed();
  Q_EMIT activeChanged(on);
}

void Brush::toggle(bool otherWay) {
  const bool isOther = settings_.mode == BrushMode::Open || settings_.mode == BrushMode::Strengthen;
  if (isOther == otherWay) {
    setActive(!active_);
    return;
  }
  BrushSettings settings = settings_;
  settings.mode = opposite(settings.mode);
  setSettings(settings);
  setActive(true);
}

}  // namespace fenestra::viewer
