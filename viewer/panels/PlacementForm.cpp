#include "viewer/panels/PlacementForm.h"

#include <QFormLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include "viewer/model/PlacementController.h"
#include "viewer/model/Translation.h"
#include "viewer/panels/SliderSpin.h"

namespace fenestra::viewer {
namespace {

/// The weights of a view of a picked point.
struct PickWeight {
  const char *name, *meaning;
  double placement::LiveSyncWeights::*member;
};
constexpr std::array<PickWeight, 4> pickWeights{{
    {QT_TRANSLATE_NOOP("Settings", "Usual side"),
     QT_TRANSLATE_NOOP("Settings",
                       "How usual the view is: from the front rather than from the side, from behind, from above or "
                       "below"),
     &placement::LiveSyncWeights::orientation},
    {QT_TRANSLATE_NOOP("Settings", "Last view"),
     QT_TRANSLATE_NOOP("Settings", "How near the view is to the present one, so that it does not jump"),
     &placement::LiveSyncWeights::history},
    {QT_TRANSLATE_NOOP("Settings", "Shape"),
     QT_TRANSLATE_NOOP("Settings",
                       "How well the view shows the structure's shape around the point: onto what is flat, across what "
                       "is long"),
     &placement::LiveSyncWeights::shape},
    {QT_TRANSLATE_NOOP("Settings", "Unhidden"),
     QT_TRANSLATE_NOOP("Settings", "How little hides the structure around the point, before anything is cut away"),
     &placement::LiveSyncWeights::visibility},
}};

}  // namespace

PlacementForm::PlacementForm(PlacementController& placement, QWidget* parent)
    : QWidget(parent),
      placement_(placement),
      automatic_(new QCheckBox(tr("Place the cameras when a focus is chosen"))),
      follow_(new QCheckBox(tr("Second view follows the first"))),
      joint_(new QCheckBox(tr("Find both views together"))),
      subject_(new QComboBox),
      sampling_(new QComboBox),
      region_(new QComboBox),
      pickRows_(nullptr),
      reach_(new SliderSpin(5.0, 150.0, 5.0)),
      streamHalfWidth_(new SliderSpin(1.0, 30.0, 1.0)),
      shareWeight_(new SliderSpin(0.0, 1.0, 0.05)) {
  makeChoices();
  makeRows();
  connectChoices();
  connect(&placement, &PlacementController::changed, this, &PlacementForm::show);
  show();
}

void PlacementForm::makeChoices() {
  subject_->addItem(tr("The focus"), false);
  subject_->addItem(tr("A point clicked on a slice"), true);
  subject_->setToolTip(tr(
      "What the cameras look at.\nThe focus: its best view and one that complements it.\nA point clicked on a slice: "
      "a click there turns both views to the structure at that point, which needs no label (LiveSync, Kohlmann et "
      "al. 2007)"));
  reach_->setSuffix(tr(" mm"));
  reach_->setToolTip(tr("How far from the point its structure counts"));
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
  form->addRow(tr("Cameras for"), subject_);
  pickRows_ = makePickRows();
  form->addRow(pickRows_);
  form->addRow(tr("Sides tried"), sampling_);
  form->addRow(tr("Second view"), region_);
  form->addRow(tr("Off right angle"), streamHalfWidth_);
  form->addRow(joint_);
  form->addRow(tr("Surface seen"), shareWeight_);
  addHabits(*form);
  addWeights(*form);
}

void PlacementForm::addHabits(QFormLayout& form) {
  for (std::size_t i = 0; i < placementHabits.size(); ++i) {
    habits_[i] = new QCheckBox(translated(placementHabits[i].name));
    habits_[i]->setToolTip(translated(placementHabits[i].meaning));
    form.addRow(habits_[i]);
    connect(habits_[i], &QCheckBox::clicked, this, [this, member = placementHabits[i].member](bool on) {
      edit([=](PlacementSettings& settings) { settings.options.habits.*member = on; });
    });
  }
}

void PlacementForm::addWeights(QFormLayout& form) {
  auto* further = new QWidget;
  auto* furtherForm = new QFormLayout(further);
  furtherForm->setContentsMargins(0, 0, 0, 0);
  for (std::size_t i = 0; i < placementWeights.size(); ++i) {
    const PlacementWeight& row = placementWeights[i];
    weights_[i] = new SliderSpin(row.low, row.high, row.step);
    weights_[i]->setToolTip(translated(row.meaning));
    (i < mainPlacementWeights ? &form : furtherForm)->addRow(translated(row.name), weights_[i]);
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

QWidget* PlacementForm::makePickRows() {
  auto* rows = new QWidget;
  auto* form = new QFormLayout(rows);
  form->setContentsMargins(0, 0, 0, 0);
  for (std::size_t i = 0; i < pickWeights.size(); ++i) {
    pickWeights_[i] = new SliderSpin(0.0, 4.0, 0.05);
    pickWeights_[i]->setToolTip(translated(pickWeights[i].meaning));
    form->addRow(translated(pickWeights[i].name), pickWeights_[i]);
    connect(pickWeights_[i], &SliderSpin::edited, this, [this, member = pickWeights[i].member](double value) {
      edit([=](PlacementSettings& settings) { settings.liveSync.weights.*member = value; });
    });
  }
  form->addRow(tr("Reach"), reach_);
  return rows;
}

void PlacementForm::connectChoices() {
  connect(subject_, &QComboBox::activated, this, [this] {
    edit([byPick = subject_->currentData().toBool()](PlacementSettings& settings) { settings.byPick = byPick; });
  });
  connect(reach_, &SliderSpin::edited, this,
          [this](double value) { edit([=](PlacementSettings& settings) { settings.liveSync.reach = value; }); });
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
  subject_->setCurrentIndex(settings.byPick ? 1 : 0);
  pickRows_->setVisible(settings.byPick);
  automatic_->setEnabled(!settings.byPick);
  for (std::size_t i = 0; i < pickWeights.size(); ++i)
    pickWeights_[i]->setValue(settings.liveSync.weights.*pickWeights[i].member);
  reach_->setValue(settings.liveSync.reach);
  automatic_->setChecked(settings.automatic);
  for (std::size_t i = 0; i < placementHabits.size(); ++i)
    habits_[i]->setChecked(settings.options.habits.*placementHabits[i].member);
  for (std::size_t i = 0; i < placementWeights.size(); ++i)
    weights_[i]->setValue(settings.options.weights.*placementWeights[i].member);
}

}  // namespace fenestra::viewer
