#pragma once
// The opening around the focus, and the context's edges drawn over it.

#include <QCheckBox>
#include <QComboBox>
#include <QToolButton>
#include <QWidget>

namespace fenestra::viewer {

class Document;
class SliderSpin;

class CutawayPanel : public QWidget {
  Q_OBJECT
 public:
  explicit CutawayPanel(Document& document, QWidget* parent = nullptr);

  QCheckBox* enabledBox() const { return enabled_; }
  SliderSpin* openWidth() const { return openWidth_; }
  SliderSpin* borderWidth() const { return borderWidth_; }
  QComboBox* unit() const { return unit_; }
  SliderSpin* contextLayer() const { return contextLayer_; }

 private:
  void show();
  void chooseColour();

  Document& document_;
  QCheckBox* enabled_;
  SliderSpin *openWidth_, *borderWidth_, *contextLayer_;
  QComboBox* unit_;
  QToolButton* colour_;
};

}  // namespace fenestra::viewer
