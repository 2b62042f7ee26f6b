#pragma once
// How the context looks: transfer-function preset, a shift that moves it along the values, and the light.

#include <QCheckBox>
#include <QComboBox>

#include "viewer/panels/LookControls.h"
#include "viewer/panels/ScrollingPanel.h"

namespace fenestra::viewer {

class AppearancePanel : public ScrollingPanel {
  Q_OBJECT
 public:
  explicit AppearancePanel(Document& document, QWidget* parent = nullptr);

  QComboBox* presets() const { return presets_; }
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
  SliderSpin* shift_;
  ColourButton* background_;
  QCheckBox* table_;
};

}  // namespace fenestra::viewer
