#pragma once
// How the volume looks: a preset, the editor of transfer functions, a shift that moves the context's along the values,
// light and background.

#include <functional>
#include <vector>

#include <QCheckBox>
#include <QFormLayout>

#include "viewer/panels/LookControls.h"
#include "viewer/panels/PresetPicker.h"
#include "viewer/panels/ScrollingPanel.h"
#include "viewer/panels/TransferFunctionEditor.h"

namespace fenestra::viewer {

class AppearancePanel : public ScrollingPanel {
  Q_OBJECT
 public:
  explicit AppearancePanel(Document& document, LookLibrary& library, QWidget* parent = nullptr);

  PresetPicker& presets() const { return *presets_; }
  TransferFunctionEditor& editor() const { return *editor_; }
  SliderSpin* shift() const { return shift_; }
  QCheckBox* hidesTable() const { return table_; }
  /// Down to the editor of the transfer function.
  int usefulHeight() const override { return heightThrough(*editor_); }

 private:
  void layOut();
  void fitToVolume();
  void show();

  // Controls for settings of the look itself; showSettings() updates them.
  template <class E>
  QComboBox* makeChoice(E Look::*member);
  ColourButton* makeColour(glm::dvec3 Look::*member);
  QComboBox* makeLightPresets();
  void showSettings() const;

  Document& document_;
  LookControls<Shading> light_;
  PresetPicker* presets_;
  TransferFunctionEditor* editor_;
  SliderSpin* shift_;
  QCheckBox* table_;
  std::vector<std::function<void(const Look&)>> settings_;
};

}  // namespace fenestra::viewer
