#pragma once
// The region in the focus: its tolerance by slider, by number and in a plot of its volume, and the label that it is
// kept as. Hidden without a region.

#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include "viewer/panels/ColourButton.h"
#include "viewer/panels/TolerancePlot.h"

namespace fenestra::viewer {

class Document;

class RegionPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RegionPanel(Document& document, QWidget* parent = nullptr);

  QSlider* slider() const { return slider_; }  ///< counts segmentation's steps
  QDoubleSpinBox* tolerance() const { return tolerance_; }
  QToolButton* automatic() const { return automatic_; }
  TolerancePlot* plot() const { return plot_; }
  QLabel* size() const { return size_; }
  QLabel* facts() const { return facts_; }     ///< what the region is, in sentences
  QPushButton* open() const { return open_; }  ///< shown while Document::asksToOpen()
  QDoubleSpinBox* ball() const { return ball_; }
  QToolButton* noBall() const { return noBall_; }
  QLineEdit* name() const { return name_; }
  QPushButton* keep() const { return keep_; }

 Q_SIGNALS:
  /// The user wants the region as a label.
  void kept(const QString& name, glm::dvec3 colour);

 private:
  void showRegion();
  void showNumbers();
  void showFacts();
  /// The radius of the ball that bounds the region.
  void setUpTolerance();
  QWidget* makeBallRow();
  QLayout* makeKeepRow();
  void setStep(int step);

  Document& document_;
  QLabel *size_, *facts_;
  QPushButton* open_;
  TolerancePlot* plot_;
  QSlider* slider_;
  QDoubleSpinBox* tolerance_;
  QToolButton* automatic_;
  QDoubleSpinBox* ball_;
  QToolButton* noBall_;
  QWidget* ballRow_;  ///< shown while there is a ball
  QLineEdit* name_;
  ColourButton* colour_;
  QPushButton* keep_;
  glm::dvec3 chosenColour_{0.0};
  bool hasChosenColour_ = false;  ///< the user chose it since the last region was kept
};

}  // namespace fenestra::viewer
