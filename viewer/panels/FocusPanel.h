#pragma once
// The open study, and its focus: a list of labels to tick, or a range of values.

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QWidget>

namespace fenestra::viewer {

class Document;
class LabelEditPanel;
class LabelList;
class PlacementController;
class RegionPanel;
class SelectionBrush;
class SliderSpin;
class ViewLink;

class FocusPanel : public QWidget {
  Q_OBJECT
 public:
  FocusPanel(Document& document, const PlacementController& placement, const ViewLink& cameras,
             SelectionBrush& selection, QWidget* parent = nullptr);

  LabelList* list() const { return list_; }
  QLineEdit* filter() const { return filter_; }
  QCheckBox* byValue() const { return byValue_; }
  QDoubleSpinBox* low() const { return low_; }
  QDoubleSpinBox* high() const { return high_; }
  SliderSpin* islands() const { return islands_; }
  RegionPanel* region() const { return region_; }
  LabelEditPanel* labelEdits() const { return labelEdits_; }
  QToolButton* paint() const { return paint_; }
  SliderSpin* paintRadius() const { return paintRadius_; }
  SliderSpin* paintSoftness() const { return paintSoftness_; }

 Q_SIGNALS:
  /// The user picked one structure, which is the focus now.
  void structureChosen();

 private:
  /// The ends of a range of values, which the check box above makes the focus.
  QLayout* makeRange();
  void makeIslandsRow();
  /// The button that takes up the region's brush, and below it the brush's rows.
  void makePainting();
  void showStudy();
  void showFocus();
  void applyRange();

  Document& document_;
  SelectionBrush& selection_;
  QLabel* study_;
  QLineEdit* filter_;
  LabelList* list_;
  QLabel* noLabels_;
  QCheckBox* byValue_;
  QDoubleSpinBox *low_, *high_;
  QWidget* islandsRow_;  ///< shown with a range of values
  SliderSpin* islands_;
  RegionPanel* region_;
  LabelEditPanel* labelEdits_;
  QToolButton* paint_;
  QWidget* painting_;  ///< the brush's rows, shown while it is up
  SliderSpin *paintRadius_, *paintSoftness_;
};

}  // namespace fenestra::viewer
