#include "viewer/panels/SliderSpin.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QSignalBlocker>

#include "viewer/model/History.h"

namespace fenestra::viewer {

SliderSpin::SliderSpin(double low, double high, double step, QWidget* parent)
    : QWidget(parent), slider_(new QSlider(Qt::Horizontal)), box_(new QDoubleSpinBox) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  slider_->setMinimumWidth(40);  // beside long names, too, it can be dragged
  row->addWidget(slider_, 1);
  row->addWidget(box_);
  box_->setKeyboardTracking(false);
  box_->setAlignment(Qt::AlignRight);
  box_->setFixedWidth(84);
  setRange(low, high, step);
  connect(slider_, &QSlider::sliderPressed, this, &SliderSpin::dragBegun);
  connect(slider_, &QSlider::sliderReleased, this, &SliderSpin::dragEnded);
  connect(slider_, &QSlider::valueChanged, this, [this](int position) {
    const double value = low_ + position * step_;
    const QSignalBlocker quiet(box_);
    box_->setValue(value);
    Q_EMIT edited(value);
  });
  connect(box_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    setValue(value);
    Q_EMIT edited(value);
  });
}

void SliderSpin::setRange(double low, double high, double step) {
  const QSignalBlocker quietSlider(slider_), quietBox(box_);
  low_ = low;
  step_ = step;
  slider_->setRange(0, static_cast<int>(std::lround((high - low) / step)));
  slider_->setPageStep(std::max(1, slider_->maximum() / 10));
  box_->setDecimals(std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6));
  box_->setRange(low, high);
  box_->setSingleStep(step);
}

void SliderSpin::setValue(double value) {
  const QSignalBlocker quietSlider(slider_), quietBox(box_);
  if (value < box_->minimum()) box_->setMinimum(value);
  if (value > box_->maximum()) box_->setMaximum(value);
  box_->setValue(value);
  slider_->setValue(static_cast<int>(std::lround(std::clamp((value - low_) / step_, 0.0, slider_->maximum() + 0.0))));
}

void makeDragsSteps(SliderSpin& slider, History& history) {
  QObject::connect(&slider, &SliderSpin::dragBegun, &history, &History::beginGesture);
  QObject::connect(&slider, &SliderSpin::dragEnded, &history, &History::endGesture);
}

}  // namespace fenestra::viewer
