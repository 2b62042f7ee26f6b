#pragma once
// The opening around the focus and its border.

#include <QCheckBox>
#include <QComboBox>

#include "viewer/panels/ScrollingPanel.h"

namespace fenestra::viewer {

class ColourButton;
class Document;
class SliderSpin;

class CutawayPanel : public ScrollingPanel {
  Q_OBJECT
 public:
  explicit CutawayPanel(Document& document, QWidget* parent = nullptr);

  QComboBox* look() const { return look_; }
  QCheckBox* enabledBox() const { return enabled_; }
  SliderSpin* openWidth() const { return openWidth_; }
  SliderSpin* borderWidth() const { return borderWidth_; }
  QComboBox* unit() const { return unit_; }

 private:
  void show();

  Document& document_;
  QCheckBox* enabled_;
  SliderSpin *openWidth_, *borderWidth_;
  QComboBox *look_, *unit_;
  ColourButton* colour_;
};

}  // namespace fenestra::viewer
