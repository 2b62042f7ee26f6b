#include "viewer/model/Brush.h"

#include <algorithm>

#include "viewer/model/Translation.h"

namespace fenestra::viewer {

bool movesRayStart(BrushMode mode) { return mode == BrushMode::Restore || mode == BrushMode::Open; }

bool usesDepth(const BrushSettings& settings) {
  return movesRayStart(settings.mode) && !(settings.mode == BrushMode::Restore && settings.toSurface);
}

QString nameOf(BrushMode mode) { return translated(wordOf(mode).name); }

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
  forEachSetting<BrushSettings>([&](const auto& setting) {
    double& value = within.*setting.member;
    value = std::clamp(value, setting.range.low, setting.range.high);
  });
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
  if (settings.mode == BrushMode::Restore) settings.toSurface = false;
  // Scaling could not raise an amount of 0.
  settings.amount = std::max(settings.amount, 0.05);
  setSettings(settings);
}

void Brush::toggle(bool otherWay) {
  const bool isOther = settings_.mode == BrushMode::Open || settings_.mode == BrushMode::Strengthen;
  if (isOther == otherWay) {
    setActive(!isActive());
    return;
  }
  BrushSettings settings = settings_;
  settings.mode = opposite(settings.mode);
  setSettings(settings);
  setActive(true);
}

}  // namespace fenestra::viewer
