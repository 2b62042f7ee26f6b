#pragma once
// How the volume looks: a preset, the editor of transfer functions, a shift that moves the context's along the values,
// light and background.

#include <QCheckBox>
#include <QComboBox>

#include "viewer/panels/LookControls.h"
#include "viewer/panels/ScrollingPanel.h"
#include "viewer/panels/TransferFunctionEditor.h"

namespace fenestra::viewer {

class AppearancePanel : public ScrollingPanel {
  Q_OBJECT
 public:
  explicit AppearancePanel(Document& document, QWidget* parent = nullptr);

  QComboBox* presets() const { return presets_; }
  TransferFunctionEditor& editor() const { return *editor_; }
  SliderSpin* shift() const { return shift_; }
  QCheckBox* hidesTable() const { return table_; }

 Q_SIGNALS:
  void failed(const QString& message);

 private:
  void show();
  void choose(int row);

  Document& document_;
  LookControls<Shading> light_;
  QComboBox* presets_;
  TransferFunctionEditor* editor_;
  SliderSpin* shift_;
  ColourButton* background_;
  QCheckBox* table_;
};

}  // namespace fenestra::viewer
