#pragma once
// One number: a slider to drag and a box to type into.

#include <QDoubleSpinBox>
#include <QSlider>
#include <QWidget>

#include "rendering/scene/Settings.h"

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
    if (*setting.unit) setSuffix(QStringLiteral(" ") + QString::fromUtf8(setting.unit));
    setToolTip(QString::fromUtf8(setting.description));
  }

  void setRange(double low, double high, double step);
  /// Shows a value without telling anyone; one beyond the range widens it.
  void setValue(double value);
  double value() const { return box_->value(); }
  void setSuffix(const QString& suffix) { box_->setSuffix(suffix); }
  QSlider* slider() const { return slider_; }
  QDoubleSpinBox* box() const { return box_; }

 Q_SIGNALS:
  /// The user moved it.
  void edited(double value);
  /// The slider is being dragged from now on, and no longer.
  void dragBegun();
  void dragEnded();

 private:
  QSlider* slider_;
  QDoubleSpinBox* box_;
  double low_ = 0.0, step_ = 1.0;
};

/// A drag of the slider is one step of the history.
void makeDragsSteps(SliderSpin& slider, History& history);

}  // namespace fenestra::viewer
