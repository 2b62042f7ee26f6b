#pragma once
// A number, with a slider to drag and a box to type into.

#include <QDoubleSpinBox>
#include <QSlider>
#include <QWidget>

#include "rendering/settings/Settings.h"
#include "viewer/model/Translation.h"

namespace fenestra::viewer {

class History;

class SliderSpin : public QWidget {
  Q_OBJECT
 public:
  /// The slider spans low..high in `step`s.
  SliderSpin(double low, double high, double step, QWidget* parent = nullptr);
  /// For a declared setting: its slider's range, step and unit.
  template <class Owner>
  explicit SliderSpin(const Setting<Owner, double>& setting, QWidget* parent = nullptr)
      : SliderSpin(setting.slider.low, setting.slider.high, setting.step, parent) {
    setSuffix(unitSuffix(setting.unit));
    setToolTip(translated(setting.description));
  }

  void setRange(double low, double high, double step);
  /// Shows a value without emitting edited(). A value beyond the range widens it.
  void setValue(double value);
  double value() const { return box_->value(); }
  void setSuffix(const QString& suffix) { box_->setSuffix(suffix); }
  QSlider* slider() const { return slider_; }
  QDoubleSpinBox* box() const { return box_; }

 Q_SIGNALS:
  /// The user changed the value.
  void edited(double value);
  /// The user begins, or has ended, a drag of the slider.
  void dragBegun();
  void dragEnded();

 private:
  QSlider* slider_;
  QDoubleSpinBox* box_;
  double low_ = 0.0, step_ = 1.0;
};

/// Makes each drag of the slider one step of the history.
void makeDragsSteps(SliderSpin& slider, History& history);

}  // namespace fenestra::viewer
