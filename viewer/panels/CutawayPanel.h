#pragma once
// How the view is opened to the focus: the method, its opening and its border. It is low and never scrolls, so that
// both widths are always in sight.

#include <QWidget>

#include "viewer/panels/LookControls.h"

namespace fenestra::viewer {

class CutawayPanel : public QWidget {
  Q_OBJECT
 public:
  explicit CutawayPanel(Document& document, QWidget* parent = nullptr);

  SliderSpin* openWidth() const { return openWidth_; }
  /// A button for the command that freezes the opening, beside the axis offset.
  void addFreeze(QAction* freeze);

 private:
  void addMethod(QFormLayout& form);
  void show();
  void showMethod();

  Document& document_;
  LookControls<Cutaway> controls_;
  LookControls<Method> methodControls_;
  QCheckBox* enabled_;
  SliderSpin *openWidth_, *borderWidth_, *axisOffset_;
  QDoubleSpinBox* axisDirection_;
  QHBoxLayout *axis_, *importance_, *lens_;
  QFormLayout* form_;
  QComboBox *method_, *importanceMode_, *sparseness_, *lensFade_, *focalShape_;
  SliderSpin *coneAngle_, *importanceAngle_, *importanceOpacity_, *lensRadius_, *lensBends_, *fadeReach_,
      *fadeSharpness_, *focalSize_, *focalFallOff_, *ghostStrength_, *ghostEdge_, *ghostOutline_;
  QDoubleSpinBox* lensRim_;
  QComboBox *look_, *unit_;
  ColourButton* colour_;
};

}  // namespace fenestra::viewer
