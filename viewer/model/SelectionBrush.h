#pragma once
// How the mouse paints the region in focus, in all views alike. The document holds the strokes.

#include <QObject>

#include "viewer/model/StrokeMode.h"

namespace fenestra::viewer {

struct SelectionBrushSettings {
  double radius = 10.0;  ///< mm
  double softness = 0.0;
  bool operator==(const SelectionBrushSettings&) const = default;
};

class SelectionBrush : public StrokeMode {
  Q_OBJECT
 public:
  using StrokeMode::StrokeMode;

  const SelectionBrushSettings& settings() const { return settings_; }
  void setSettings(const SelectionBrushSettings& settings);

 private:
  SelectionBrushSettings settings_;
};

}  // namespace fenestra::viewer
