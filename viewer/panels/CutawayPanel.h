#pragma once
// How the view is opened to the focus: the method, its opening and its border. Both widths come first, so that they are
// always in sight.

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
  /// As high as with the adaptive cutaway, whichever method is chosen: rows of other methods scroll, so that nothing
  /// moves under the mouse when one is chosen.
  QSize sizeHint() const override;
  /// As wide as with the rows of all methods, for the same reason.
  QSize minimumSizeHint() const override;
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
  mutable int height_ = 0;  ///< of the hint
  int width_ = 0;           ///< of the least size
};

}  // namespace fenestra::viewer
