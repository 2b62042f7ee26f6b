#include "viewer/panels/CutawayPanel.h"

#include <algorithm>

#include <QFormLayout>
#include <QHBoxLayout>

#include "viewer/model/Document.h"
#include "viewer/panels/ColourButton.h"
#include "viewer/panels/SliderSpin.h"

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
    : ScrollingPanel(parent),
      document_(document),
      enabled_(new QCheckBox(tr("Open the context around the focus"))),
      openWidth_(new SliderSpin(0.0, 120.0, 1.0)),
      borderWidth_(new SliderSpin(0.0, 20.0, 0.5)),
      look_(new QComboBox),
      unit_(new QComboBox),
      colour_(new ColourButton(tr("Border colour"))) {
  for (const OpeningLook& look : openingLooks())
    look_->addItem(QString::fromUtf8(look.name.data(), static_cast<qsizetype>(look.name.size())));
  look_->setPlaceholderText(tr("own"));
  look_->setToolTip(tr("Ready-made border and context edges"));
  unit_->addItem(tr("pixels"), static_cast<int>(WidthUnit::Pixel));
  unit_->addItem(tr("millimetres at the focus"), static_cast<int>(WidthUnit::Millimetre));
  unit_->setToolTip(tr("Millimetres keep the opening still while zooming"));
  openWidth_->setToolTip(tr("w_open: how far the opening reaches beyond the focus"));
  borderWidth_->setToolTip(tr("w_border: width of the line around the opening"));

  auto* body = new QWidget;
  auto* form = new QFormLayout(body);
  form->addRow(enabled_);
  form->addRow(tr("Look"), look_);
  form->addRow(tr("Opening"), openWidth_);
  auto* border = new QHBoxLayout;
  border->addWidget(borderWidth_, 1);
  border->addWidget(colour_);
  form->addRow(tr("Border"), border);
  form->addRow(tr("Unit"), unit_);
  setBody(body);

  const auto edit = [this](const QString& step, auto change) {
    Cutaway cutaway = document_.scene().look.cutaway;
    change(cutaway);
    document_.setCutaway(cutaway, step);
  };
  connect(enabled_, &QCheckBox::clicked, this, [edit](bool on) {
    edit(on ? tr("Open the context") : tr("Close the context"), [on](Cutaway& cutaway) { cutaway.enabled = on; });
  });
  connect(look_, &QComboBox::activated, this, [this](int which) {
    Look look = document_.look();
    openingLooks()[static_cast<std::size_t>(which)].applyTo(look.cutaway, look.contextLayer);
    document_.edit(tr("Look"), std::move(look));
  });
  connect(openWidth_, &SliderSpin::edited, this,
          [edit](double value) { edit(tr("Opening"), [value](Cutaway& cutaway) { cutaway.openWidth = value; }); });
  connect(borderWidth_, &SliderSpin::edited, this,
          [edit](double value) { edit(tr("Border"), [value](Cutaway& cutaway) { cutaway.borderWidth = value; }); });
  connect(unit_, &QComboBox::activated, this, [this, edit] {
    edit(tr("Unit of the opening"),
         [this](Cutaway& cutaway) { cutaway.unit = static_cast<WidthUnit>(unit_->currentData().toInt()); });
  });
  connect(colour_, &ColourButton::edited, this, [edit](glm::dvec3 colour) {
    edit(tr("Border colour"), [colour](Cutaway& cutaway) { cutaway.borderColour = colour; });
  });
  for (SliderSpin* slider : {openWidth_, borderWidth_}) makeDragsSteps(*slider, document.history());
  connect(&document, &Document::cutawayChanged, this, &CutawayPanel::show);
  connect(&document, &Document::volumeChanged, this, &CutawayPanel::show);
  show();
}

void CutawayPanel::show() {
  setEnabled(document_.hasVolume());
  const Cutaway& cutaway = document_.scene().look.cutaway;
  enabled_->setChecked(cutaway.enabled);
  look_->setCurrentIndex(lookOf(document_.look()));
  openWidth_->setValue(cutaway.openWidth);
  borderWidth_->setValue(cutaway.borderWidth);
  const QString suffix = cutaway.unit == WidthUnit::Pixel ? tr(" px") : tr(" mm");
  openWidth_->setSuffix(suffix);
  borderWidth_->setSuffix(suffix);
  unit_->setCurrentIndex(unit_->findData(static_cast<int>(cutaway.unit)));
  colour_->setColour(cutaway.borderColour);
  for (QWidget* widget : std::initializer_list<QWidget*>{look_, openWidth_, borderWidth_, unit_, colour_})
    widget->setEnabled(cutaway.enabled);
}

}  // namespace fenestra::viewer
