#include "viewer/panels/CutawayPanel.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QToolButton>

#include "viewer/model/Translation.h"

namespace fenestra::viewer {
namespace {

/// Which ready-made look it is; -1 for none.
int lookOf(const Look& shown) {
  const auto looks = openingLooks();
  const auto at = std::find_if(looks.begin(), looks.end(), [&](const OpeningLook& look) {
    Cutaway cutaway = shown.cutaway;
    ContextLayer layer = shown.contextLayer;
    look.applyTo(cutaway, layer);
    return cutaway == shown.cutaway && layer == shown.contextLayer;
  });
  return at == looks.end() ? -1 : static_cast<int>(at - looks.begin());
}

}  // namespace

CutawayPanel::CutawayPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      controls_(document, &Look::cutaway),
      enabled_(controls_.box(&Cutaway::enabled)),
      openWidth_(controls_.slider(&Cutaway::openWidth)),
      borderWidth_(controls_.slider(&Cutaway::borderWidth)),
      axisOffset_(controls_.slider(&Cutaway::axisOffset)),
      axisDirection_(controls_.spin(&Cutaway::axisDirection, 15.0)),
      axis_(new QHBoxLayout),
      look_(new QComboBox),
      unit_(controls_.choice(&Cutaway::unit)),
      colour_(controls_.colour(&Cutaway::borderColour)) {
  for (const OpeningLook& look : openingLooks()) look_->addItem(translated(look.name));
  look_->setPlaceholderText(tr("own"));
  look_->setToolTip(tr("Ready-made border and context edges"));

  auto* form = new QFormLayout(this);
  const auto name = [](const auto& setting) { return translated(setting.name); };
  form->addRow(enabled_);
  form->addRow(name(settingOf(&Cutaway::openWidth)), openWidth_);
  auto* border = new QHBoxLayout;
  border->addWidget(borderWidth_, 1);
  border->addWidget(colour_);
  form->addRow(name(settingOf(&Cutaway::borderWidth)), border);
  axis_->addWidget(axisOffset_, 1);
  axis_->addWidget(axisDirection_);
  form->addRow(name(settingOf(&Cutaway::axisOffset)), axis_);
  form->addRow(tr("Look"), look_);
  form->addRow(name(settingOf(&Cutaway::unit)), unit_);

  connect(look_, &QComboBox::activated, this, [this](int which) {
    Look look = document_.look();
    openingLooks()[static_cast<std::size_t>(which)].applyTo(look.cutaway, look.contextLayer);
    document_.edit(tr("Look"), std::move(look));
  });
  connect(&document, &Document::cutawayChanged, this, &CutawayPanel::show);
  connect(&document, &Document::volumeChanged, this, &CutawayPanel::show);
  show();
}

void CutawayPanel::addFreeze(QAction* freeze) {
  auto* button = new QToolButton;
  button->setDefaultAction(freeze);
  axis_->addWidget(button);
}

void CutawayPanel::show() {
  setEnabled(document_.hasVolume());
  const Cutaway& cutaway = document_.look().cutaway;
  controls_.show();
  look_->setCurrentIndex(lookOf(document_.look()));
  const QString suffix = unitSuffix(wordOf(cutaway.unit).word);
  openWidth_->setSuffix(suffix);
  borderWidth_->setSuffix(suffix);
  for (QWidget* widget : std::initializer_list<QWidget*>{look_, openWidth_, borderWidth_, axisOffset_, unit_, colour_})
    widget->setEnabled(cutaway.enabled);
  axisDirection_->setEnabled(cutaway.enabled && cutaway.axisOffset > 0.0);
}

}  // namespace fenestra::viewer
