#pragma once
// Edits the transfer function of the context, or how the focus or one of its labels looks: the plot, and below it the
// selected node's exact value, opacity and colour.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include "viewer/model/LookLibrary.h"
#include "viewer/panels/ColourButton.h"
#include "viewer/panels/TransferFunctionPlot.h"

namespace fenestra::viewer {

class TransferFunctionEditor : public QWidget {
  Q_OBJECT
 public:
  TransferFunctionEditor(Document& document, const LookLibrary& library, QWidget* parent = nullptr);

  TransferFunctionPlot& plot() const { return *plot_; }
  QComboBox* targets() const { return targets_; }
  QDoubleSpinBox* value() const { return value_; }
  QDoubleSpinBox* opacity() const { return opacity_; }
  ColourButton* colour() const { return colour_; }
  QCheckBox* byValue() const { return byValue_; }
  /// Offers functions for a part of the focus: built-in ones, the user's, and files.
  QToolButton* presets() const { return presets_; }
  /// Asks for a transfer function's file; a dialog, unless a test replaces it.
  std::function<std::optional<std::filesystem::path>()>& functionWhich() { return functionWhich_; }

 Q_SIGNALS:
  void failed(const QString& message);

 private:
  void setUpControls();
  void layOut();
  void fillPresets();
  /// A built-in preset's id or a file.
  void takeFunction(const std::string& presetOrPath);
  void fitToVolume();
  void showTargets();
  void showNode();

  Document& document_;
  const LookLibrary& library_;
  QLabel* onlyContext_;  ///< in place of `targets_` where the context is the only one
  QComboBox* targets_;
  TransferFunctionPlot* plot_;
  QDoubleSpinBox *value_, *opacity_;
  ColourButton* colour_;
  QCheckBox* byValue_;    ///< gives a part of the focus its own function
  QToolButton* presets_;  ///< functions for a part of the focus
  std::function<std::optional<std::filesystem::path>()> functionWhich_;
  std::vector<FunctionTarget> listed_;  ///< what `targets_` shows
};

}  // namespace fenestra::viewer
