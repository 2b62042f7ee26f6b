#pragma once
// How the view is opened to the focus: the method, its opening and its border. It is low and never scrolls, so that
// both widths are always in sight.

#include <optional>

#include <QWidget>

#include "viewer/panels/LookControls.h"
#include "viewer/panels/MethodRows.h"

namespace fenestra::viewer {

class Carving;
class CarvingRows;

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
  void show();
  void showMethod();

  Document& document_;
  LookControls<Cutaway> controls_;
  LookControls<Method> methodControls_;
  QCheckBox* enabled_;
  SliderSpin *openWidth_, *borderWidth_, *axisOffset_;
  QDoubleSpinBox* axisDirection_;
  QHBoxLayout* axis_;
  QFormLayout* form_;
  QComboBox* method_;
  std::optional<MethodRows> methodRows_;
  CarvingRows* carving_;
  QComboBox *look_, *unit_;
  ColourButton* colour_;
};

}  // namespace fenestra::viewer
