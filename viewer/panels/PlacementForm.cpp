#include "viewer/panels/PlacementForm.h"

#include <QFormLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include "viewer/model/PlacementController.h"
#include "viewer/panels/SliderSpin.h"

namespace fenestra::viewer {
namespace {

struct WeightRow {
  const char *name, *meaning;
  double low, high, step;
  double placement::Weights::*member;
};
constexpr std::size_t mainWeights = 3;
const std::array<WeightRow, PlacementForm::weightCount> weightRows{{
    {QT_TRANSLATE_NOOP("PlacementForm", "Depth"),
     QT_TRANSLATE_NOOP("PlacementForm", "How deep the focus lies; below 0 prefers views with little in front of it"),
     -2.0, 2.0, 0.05, &placement::Weights::visibility},
    {QT_TRANSLATE_NOOP("PlacementForm", "Size"),
     QT_TRANSLATE_NOOP("PlacementForm", "How much of the picture it covers"), 0.0, 16.0, 0.1,
     &placement::Weights::coverage},
    {QT_TRANSLATE_NOOP("PlacementForm", "Centring"), QT_TRANSLATE_NOOP("PlacementForm", "How near to the middle it is"),
     0.0, 2.0, 0.05, &placement::Weights::location},
    {QT_TRANSLATE_NOOP("PlacementForm", "Entropy"),
     QT_TRANSLATE_NOOP("PlacementForm", "How much of its surface is seen, evenly"), 0.0, 2.0, 0.05,
     &placement::Weights::entropy},
    {QT_TRANSLATE_NOOP("PlacementForm", "Typical"),
     QT_TRANSLATE_NOOP("PlacementForm", "Viewpoint mutual information: how typical the view is"), 0.0, 2.0, 0.05,
     &placement::Weights::mutualInformation},
    {QT_TRANSLATE_NOOP("PlacementForm", "Stable"),
     QT_TRANSLATE_NOOP("PlacementForm", "How little changes when the camera moves a bit"), 0.0, 2.0, 0.05,
     &placement::Weights::stability},
    {QT_TRANSLATE_NOOP("PlacementForm", "Standard"),
     QT_TRANSLATE_NOOP("PlacementForm", "How near the view is to anterior, left, superior …"), 0.0, 2.0, 0.05,
     &placement::Weights::orientation},
}};

}  // namespace

PlacementForm::PlacementForm(PlacementController& placement, QWidget* parent)
    : QWidget(parent),
      placement_(placement),
      automatic_(new QCheckBox(tr("Place when a focus is chosen"))),
      follow_(new QCheckBox(tr("C2 follows C1"))),
      joint_(new QCheckBox(tr("Both at once"))),
      sampling_(new QComboBox),
      region_(new QComboBox),
      streamHalfWidth_(new SliderSpin(1.0, 45.0, 1.0)),
      shareWeight_(new SliderSpin(0.0, 1.0, 0.05)) {
  makeChoices();
  makeRows();
  connectChoices();
  connect(&placement, &PlacementController::changed, this, &PlacementForm::show);
  show();
}

void PlacementForm::makeChoices() {
  for (const int count : {48, 108, 192, 300, 588, 1200}) sampling_->addItem(tr("%1 views").arg(count), count);
  sampling_->addItem(tr("refined"), 0);
  sampling_->setToolTip(
      tr("Number of viewpoints tried, evenly over the sphere; refined: ever finer around the best ones"));
  region_->addItem(tr("Semi-sphere"), static_cast<int>(placement::Region::SemiSphere));
  region_->addItem(tr("Stream"), static_cast<int>(placement::Region::Stream));
  region_->setToolTip(tr("Where C2 may be: beside C1 on one side, or in a band all around at right angles to it"));
  streamHalfWidth_->setSuffix(tr("°"));
  streamHalfWidth_->setToolTip(tr("δ: how far C2 may leave the right angle to C1"));
  joint_->setToolTip(tr("Choose the pair that together sees most of the focus's surface"));
  shareWeight_->setToolTip(tr("1: only the share of the surface counts; 0: only the quality of the two views"));
  follow_->setToolTip(tr("When C1 is turned, C2 goes to the best view of its region"));
}

void PlacementForm::makeRows() {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(automatic_);
  column->addWidget(follow_);
  auto* form = new QFormLayout;
  column->addLayout(form);
  form->addRow(tr("Tried"), sampling_);
  form->addRow(tr("C2 in"), region_);
  form->addRow(tr("δ"), streamHalfWidth_);
  form->addRow(joint_);
  form->addRow(tr("By share"), shareWeight_);
  addWeights(*form);
}

void PlacementForm::addWeights(QFormLayout& form) {
  auto* further = new QWidget;
  auto* furtherForm = new QFormLayout(further);
  furtherForm->setContentsMargins(0, 0, 0, 0);
  for (std::size_t i = 0; i < weightRows.size(); ++i) {
    const WeightRow& row = weightRows[i];
    weights_[i] = new SliderSpin(row.low, row.high, row.step);
    weights_[i]->setToolTip(tr(row.meaning));
    (i < mainWeights ? &form : furtherForm)->addRow(tr(row.name), weights_[i]);
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
  for (std::size_t i = 0; i < weightRows.size(); ++i)
    weights_[i]->setValue(settings.options.weights.*weightRows[i].member);
}

}  // namespace fenestra::viewer
