#pragma once
// Edits the transfer function of the context, or how the focus or one of its labels looks: the plot, and below it the
// selected node's exact value, opacity and colour.

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QWidget>

#include "viewer/panels/ColourButton.h"
#include "viewer/panels/TransferFunctionPlot.h"

namespace fenestra::viewer {

class TransferFunctionEditor : public QWidget {
  Q_OBJECT
 public:
  explicit TransferFunctionEditor(Document& document, QWidget* parent = nullptr);

  TransferFunctionPlot& plot() const { return *plot_; }
  QComboBox* targets() const { return targets_; }
  QDoubleSpinBox* value() const { return value_; }
  QDoubleSpinBox* opacity() const { return opacity_; }
  ColourButton* colour() const { return colour_; }
  QCheckBox* byValue() const { return byValue_; }

 private:
  void fitToVolume();
  void showTargets();
  void showNode();

  Document& document_;
  QLabel* onlyContext_;  ///< in place of `targets_` where there is one
  QComboBox* targets_;
  TransferFunctionPlot* plot_;
  QDoubleSpinBox *value_, *opacity_;
  ColourButton* colour_;
  QCheckBox* byValue_;                  ///< of a part of the focus
  std::vector<FunctionTarget> listed_;  ///< what `targets_` shows
};

}  // namespace fenestra::viewer
