#include "viewer/panels/BrushPanel.h"

#include <QButtonGroup>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "viewer/model/Brush.h"
#include "viewer/model/Document.h"
#include "viewer/model/Translation.h"
#include "viewer/panels/SliderSpin.h"
#include "viewer/panels/StrokeList.h"
#include "viewer/style/Style.h"

namespace fenestra::viewer {
namespace {

/// A button that stays pressed and takes the width that it gets.
void makeChoice(QToolButton& button) {
  button.setCheckable(true);
  button.setObjectName(QStringLiteral("choice"));
  button.setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

}  // namespace

BrushPanel::BrushPanel(Document& document, Brush& brush, QWidget* parent)
    : ScrollingPanel(parent),
      brush_(brush),
      paint_(new QToolButton),
      radius_(new SliderSpin(settingOf(&BrushSettings::radius))),
      softness_(new SliderSpin(settingOf(&BrushSettings::softness))),
      depth_(new SliderSpin(settingOf(&BrushSettings::depth))),
      amount_(new SliderSpin(settingOf(&BrushSettings::amount))),
      toSurface_(new QCheckBox(tr("Restore to the surface"))),
      coversFocus_(new QCheckBox(tr("May cover the focus"))),
      thisViewOnly_(new QCheckBox(tr("In the painted view only"))),
      strokes_(new StrokeList(document)) {
  setBody(makeBody());
  connectSettings();
  connect(&document, &Document::volumeChanged, this, [this, &document] { setEnabled(document.hasVolume()); });
  setEnabled(false);
  showBrush();
}

QLayout* BrushPanel::makeModes() {
  auto* row = new QHBoxLayout;
  row->setSpacing(2);
  auto* group = new QButtonGroup(this);
  for (const Word<BrushMode>& each : wordsOf(BrushMode{})) {
    auto* button = new QToolButton;
    makeChoice(*button);
    button->setText(translated(each.name));
    button->setToolTip(translated(each.description));
    group->addButton(button);
    row->addWidget(button);
    modes_[static_cast<std::size_t>(each.value)] = button;
    connect(button, &QToolButton::clicked, this,
            [this, mode = each.value] { edit([mode](BrushSettings& settings) { settings.mode = mode; }); });
  }
  return row;
}

QWidget* BrushPanel::makeBody() {
  makeChoice(*paint_);
  paint_->setText(tr("Paint in the 3-D views"));
  paint_->setIcon(icon("brush"));
  paint_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  paint_->setToolTip(tr("The left button paints; Ctrl+left drag still turns the view (P; E for the opposite brush)"));
  toSurface_->setToolTip(
      tr("Restore brings back all that was removed under the brush; otherwise no more than the depth"));
  coversFocus_->setToolTip(tr("Otherwise restored tissue never hides the focus"));
  thisViewOnly_->setToolTip(tr("Otherwise a stroke shows in both views"));

  auto* form = new QFormLayout;
  form->addRow(tr("Radius"), radius_);
  form->addRow(tr("Softness"), softness_);
  form->addRow(tr("Depth"), depth_);
  form->addRow(tr("Amount"), amount_);
  auto* body = new QWidget;
  auto* column = new QVBoxLayout(body);
  column->addWidget(paint_);
  column->addLayout(makeModes());
  column->addLayout(form);
  column->addWidget(toSurface_);
  column->addWidget(coversFocus_);
  column->addWidget(thisViewOnly_);
  column->addWidget(strokes_, 1);
  return body;
}

void BrushPanel::connectSettings() {
  connect(paint_, &QToolButton::clicked, &brush_, &Brush::setActive);
  const auto connectSlider = [this](SliderSpin* slider, double BrushSettings::*member) {
    connect(slider, &SliderSpin::edited, this,
            [this, member](double value) { edit([=](BrushSettings& settings) { settings.*member = value; }); });
  };
  connectSlider(radius_, &BrushSettings::radius);
  connectSlider(softness_, &BrushSettings::softness);
  connectSlider(depth_, &BrushSettings::depth);
  connectSlider(amount_, &BrushSettings::amount);
  const auto connectBox = [this](QCheckBox* box, bool BrushSettings::*member) {
    connect(box, &QCheckBox::clicked, this,
            [this, member](bool on) { edit([=](BrushSettings& settings) { settings.*member = on; }); });
  };
  connectBox(toSurface_, &BrushSettings::toSurface);
  connectBox(coversFocus_, &BrushSettings::coversFocus);
  connectBox(thisViewOnly_, &BrushSettings::thisViewOnly);
  connect(&brush_, &Brush::changed, this, &BrushPanel::showBrush);
}

void BrushPanel::edit(const std::function<void(BrushSettings&)>& change) {
  BrushSettings settings = brush_.settings();
  change(settings);
  brush_.setSettings(settings);
}

void BrushPanel::showBrush() {
  const BrushSettings& settings = brush_.settings();
  paint_->setChecked(brush_.isActive());
  modeButton(settings.mode)->setChecked(true);
  radius_->setValue(settings.radius);
  softness_->setValue(settings.softness);
  depth_->setValue(settings.depth);
  amount_->setValue(settings.amount);
  const bool deep = movesRayStart(settings.mode);
  depth_->setEnabled(usesDepth(settings));
  amount_->setEnabled(!deep);
  toSurface_->setEnabled(settings.mode == BrushMode::Restore);
  toSurface_->setChecked(settings.toSurface);
  coversFocus_->setEnabled(settings.mode == BrushMode::Restore);
  coversFocus_->setChecked(settings.coversFocus);
  thisViewOnly_->setChecked(settings.thisViewOnly);
}

}  // namespace fenestra::viewer
