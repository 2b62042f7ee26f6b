#include "viewer/panels/PlacementForm.h"

#include <QFormLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include "viewer/model/PlacementController.h"
#include "viewer/panels/SliderSpin.h"

namespace fenestra::viewer {
PlacementForm::PlacementForm(PlacementController& placement, QWidget* parent)
    : QWidget(parent),
      placement_(placement),
      automatic_(new QCheckBox(tr("Place the cameras when a focus is chosen"))),
      follow_(new QCheckBox(tr("Second view follows the first"))),
      joint_(new QCheckBox(tr("Find both views together"))),
      sampling_(new QComboBox),
      region_(new QComboBox),
      streamHalfWidth_(new SliderSpin(1.0, 30.0, 1.0)),
      shareWeight_(new SliderSpin(0.0, 1.0, 0.05)) {
  makeChoices();
  makeRows();
  connectChoices();
  connect(&placement, &PlacementController::changed, this, &PlacementForm::show);
  show();
}

void PlacementForm::makeChoices() {
  for (const int count : {48, 108, 192, 300, 588, 1200}) sampling_->addItem(tr("%n views", nullptr, count), count);
  sampling_->addItem(tr("Finer near the best"), 0);
  sampling_->setToolTip(
      tr("From how many sides the focus is looked at, evenly all around (12·n² HEALPix directions), or ever finer "
         "around the best ones"));
  region_->addItem(tr("To its right"), static_cast<int>(placement::Region::SemiSphere));
  region_->addItem(tr("All around"), static_cast<int>(placement::Region::Stream));
  region_->setToolTip(
      tr("Where the second view may be, always 60° to 120° from the first.\nTo its right: the half sphere c2·a ≥ 0 "
         "around the first view's right axis a. All around: the band |c1·c2| ≤ sin δ"));
  streamHalfWidth_->setSuffix(tr("°"));
  streamHalfWidth_->setToolTip(tr("δ: how far the second view may leave the right angle to the first"));
  joint_->setToolTip(
      tr("Choose the two views that together see most of the focus's surface.\nOff: first the best view, then the best "
         "one beside it"));
  shareWeight_->setToolTip(
      tr("What two views are chosen by: w · share of the surface seen + (1 − w) · mean quality of the views"));
  follow_->setToolTip(tr("When the first view is turned, the second goes to the best view beside it"));
}

void PlacementForm::makeRows() {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(automatic_);
  column->addWidget(follow_);
  auto* form = new QFormLayout;
  column->addLayout(form);
  form->addRow(tr("Sides tried"), sampling_);
  form->addRow(tr("Second view"), region_);
  form->addRow(tr("Off right angle"), streamHalfWidth_);
  form->addRow(joint_);
  form->addRow(tr("Surface seen"), shareWeight_);
  addWeights(*form);
}

void PlacementForm::addWeights(QFormLayout& form) {
  auto* further = new QWidget;
  auto* furtherForm = new QFormLayout(further);
  furtherForm->setContentsMargins(0, 0, 0, 0);
  for (std::size_t i = 0; i < placementWeights.size(); ++i) {
    const PlacementWeight& row = placementWeights[i];
    weights_[i] = new SliderSpin(row.low, row.high, row.step);
    weights_[i]->setToolTip(tr(row.meaning));
    (i < mainPlacementWeights ? &form : furtherForm)->addRow(tr(row.name), weights_[i]);
    connect(weights_[i], &SliderSpin::edited, this, [this, member = row.member](double value) {
      edit([=](PlacementSettings& settings) { settings.options.weights.*member = value; });
    });
  }
  auto* more = new QToolButton;
  more->setText(tr("More weights"));
  more->setCheckable(true);
  more->setAutoRaise(true);
  more->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  more->setArrowType(Qt::RightArrow);
  connect(more, &QToolButton::toggled, this, [more, further](bool on) {
    more->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
    further->setVisible(on);
  });
  further->hide();
  form.addRow(more);
  form.addRow(further);
}

void PlacementForm::connectChoices() {
  connect(sampling_, &QComboBox::activated, this, [this] {
    edit([count = sampling_->currentData().toInt()](PlacementSettings& settings) {
      settings.sampling.refined = count == 0;
      if (count > 0) settings.sampling.count = count;
    });
  });
  connect(region_, &QComboBox::activated, this, [this] {
    edit([region = static_cast<placement::Region>(region_->currentData().toInt())](PlacementSettings& settings) {
      settings.options.region = region;
    });
  });
  const auto connectSlider = [this](SliderSpin* slider, double placement::Options::*member) {
    connect(slider, &SliderSpin::edited, this, [this, member](double value) {
      edit([=](PlacementSettings& settings) { settings.options.*member = value; });
    });
  };
  connectSlider(streamHalfWidth_, &placement::Options::streamHalfWidth);
  connectSlider(shareWeight_, &placement::Options::shareWeight);
  const auto connectBox = [this](QCheckBox* box, bool PlacementSettings::*member) {
    connect(box, &QCheckBox::clicked, this,
            [this, member](bool on) { edit([=](PlacementSettings& settings) { settings.*member = on; }); });
  };
  connectBox(joint_, &PlacementSettings::joint);
  connectBox(follow_, &PlacementSettings::follow);
  connectBox(automatic_, &PlacementSettings::automatic);
}

void PlacementForm::edit(const std::function<void(PlacementSettings&)>& change) {
  PlacementSettings settings = placement_.settings();
  change(settings);
  placement_.setSettings(settings);
  Q_EMIT edited(change);
}

void PlacementForm::show() {
  const PlacementSettings& settings = placement_.settings();
  sampling_->setCurrentIndex(sampling_->findData(settings.sampling.refined ? 0 : settings.sampling.count));
  region_->setCurrentIndex(region_->findData(static_cast<int>(settings.options.region)));
  streamHalfWidth_->setValue(settings.options.streamHalfWidth);
  streamHalfWidth_->setEnabled(settings.options.region == placement::Region::Stream);
  joint_->setChecked(settings.joint);
  shareWeight_->setValue(settings.options.shareWeight);
  shareWeight_->setEnabled(settings.joint);
  follow_->setChecked(settings.follow);
  automatic_->setChecked(settings.automatic);
  for (std::size_t i = 0; i < placementWeights.size(); ++i)
    weights_[i]->setValue(settings.options.weights.*placementWeights[i].member);
}

}  // namespace fenestra::viewer
