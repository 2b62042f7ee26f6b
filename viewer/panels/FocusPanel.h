#pragma once
// The open study, and its focus: a list of labels to tick, or a range of values.
//
// The list has the height that the rows which are always there leave, and never less than eight rows; other rows come
// below it and scroll. So a row that comes or goes does not move the control that was clicked.

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

#include "viewer/panels/ScrollingPanel.h"

namespace fenestra::viewer {

class Document;
class LabelEditPanel;
class LabelList;
class PlacementController;
class RegionPanel;
class SelectionBrush;
class SliderSpin;
class ViewLink;

class FocusPanel : public ScrollingPanel {
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
  /// That of the list with its least rows, and of what is above it; also while there are no labels.
  int usefulHeight() const override;

 Q_SIGNALS:
  /// The user picked one structure, which is the focus now.
  void structureChosen();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void layOut();
  /// Gives the list its height.
  void fitList();
  /// Scrolls to the rows of a region when it begins and when it has been grown: they are below the list.
  void showRegionsRows();
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
  QWidget* islandsRow_;  ///< for a range of values
  SliderSpin* islands_;
  RegionPanel* region_;
  int regionState_ = 0;  ///< which showRegionsRows() has scrolled to: 1 growing, 2 grown, 0 none
  LabelEditPanel* labelEdits_;
  QToolButton* paint_;
  QWidget* painting_;  ///< the brush's rows, shown while it is up
  SliderSpin *paintRadius_, *paintSoftness_;
};

}  // namespace fenestra::viewer
