#pragma once
// How the brush paints, and the strokes that it has painted.

#include <array>
#include <functional>

#include <QCheckBox>
#include <QToolButton>

#include "viewer/model/Brush.h"
#include "viewer/panels/ScrollingPanel.h"

class QLayout;

namespace fenestra::viewer {

class Document;
class SliderSpin;
class StrokeList;

class BrushPanel : public ScrollingPanel {
  Q_OBJECT
 public:
  BrushPanel(Document& document, Brush& brush, QWidget* parent = nullptr);

  QToolButton* modeButton(BrushMode mode) const { return modes_[static_cast<std::size_t>(mode)]; }
  SliderSpin* depth() const { return depth_; }
  StrokeList& strokes() const { return *strokes_; }

 private:
  QLayout* makeModes();
  QWidget* makeBody();
  void connectSettings();
  void edit(const std::function<void(BrushSettings&)>& change);
  void showBrush();

  Brush& brush_;
  QToolButton* paint_;
  std::array<QToolButton*, 4> modes_{};
  SliderSpin *radius_, *softness_, *depth_, *amount_;
  QCheckBox *toSurface_, *coversFocus_, *thisViewOnly_;
  StrokeList* strokes_;
};

}  // namespace fenestra::viewer
