#pragma once
// How the view is opened to the focus: the method, its opening and its border. It is low and never scrolls, so that
// both widths are always in sight.

#include <QWidget>

#include "viewer/panels/LookControls.h"

namespace fenestra::viewer {

class Carving;
class CarvingRows;
class ImportanceList;

class CutawayPanel : public QWidget {
  Q_OBJECT
 public:
  CutawayPanel(Document& document, Carving& carving, QWidget* parent = nullptr);

  SliderSpin* openWidth() const { return openWidth_; }
  /// A button for the command that freezes the opening, beside the axis offset.
  void addFreeze(QAction* freeze);

 private:
  void layOut();
  void apply(int openingLook);
  void addMethod(QFormLayout& form);
  void show();
  void showMethod();

  Document& document_;
  LookControls<Cutaway> controls_;
  LookControls<Method> methodControls_;
  QCheckBox* enabled_;
  SliderSpin *openWidth_, *borderWidth_, *axisOffset_;
  QDoubleSpinBox* axisDirection_;
  QHBoxLayout *axis_, *importance_, *lens_, *wallPlanes_;
  QFormLayout* form_;
  QComboBox *method_, *importanceMode_, *sparseness_, *lensPlace_, *lensFade_, *focalShape_, *wallPlacement_,
      *explosionPlanes_, *explosionAxes_, *peelSide_;
  SliderSpin *coneAngle_, *importanceAngle_, *importanceOpacity_, *lensRadius_, *lensBends_, *fadeReach_,
      *fadeSharpness_, *focalSize_, *focalFallOff_, *explosion_, *ghostStrength_, *ghostEdge_, *ghostOutline_, *peel_,
      *peelTurn_, *peelDepth_, *peelRadius_, *peelMargin_;
  QDoubleSpinBox* lensRim_;
  QCheckBox *wallAxial_, *wallSagittal_, *wallCoronal_, *wallOutlines_;
  CarvingRows* carving_;
  ImportanceList* importanceLevels_;
  QComboBox *look_, *unit_;
  ColourButton* colour_;
};

}  // namespace fenestra::viewer
