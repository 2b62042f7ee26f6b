#pragma once
// The region in the focus: its tolerance by slider, by number and in a plot of its volume. Hidden without a region.

#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

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

 private:
  void showRegion();
  void showNumbers();
  void setStep(int step);

  Document& document_;
  QLabel* size_;
  TolerancePlot* plot_;
  QSlider* slider_;
  QDoubleSpinBox* tolerance_;
  QToolButton* automatic_;
};

}  // namespace fenestra::viewer
