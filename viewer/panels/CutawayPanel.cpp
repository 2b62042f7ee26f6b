#include "viewer/panels/CutawayPanel.h"

#include <QColorDialog>
#include <QFormLayout>
#include <QPixmap>

#include "viewer/model/Document.h"
#include "viewer/panels/SliderSpin.h"
#include "viewer/views/Overlay.h"

namespace fenestra::viewer {

CutawayPanel::CutawayPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      enabled_(new QCheckBox(tr("Open the context around the focus"))),
      openWidth_(new SliderSpin(0.0, 120.0, 1.0)),
      borderWidth_(new SliderSpin(0.0, 20.0, 0.5)),
      contextLayer_(new SliderSpin(0.0, 1.0, 0.05)),
      unit_(new QComboBox),
      colour_(new QToolButton) {
  unit_->addItem(tr("pixels"), static_cast<int>(WidthUnit::Pixel));
  unit_->addItem(tr("millimetres at the focus"), static_cast<int>(WidthUnit::Millimetre));
  unit_->setToolTip(tr("Millimetres keep the opening still while zooming"));
  openWidth_->setToolTip(tr("w_open: how far the opening reaches beyond the focus"));
  borderWidth_->setToolTip(tr("w_border: width of the line around the opening"));
  contextLayer_->setToolTip(tr("How strongly the edges of what was cut away are drawn over the focus; 0 is off"));
  colour_->setToolTip(tr("Colour of the border"));
  colour_->setIconSize({32, 14});

  auto* form = new QFormLayout(this);
  form->addRow(enabled_);
  form->addRow(tr("Opening"), openWidth_);
  form->addRow(tr("Border"), borderWidth_);
  form->addRow(tr("Unit"), unit_);
  form->addRow(tr("Border colour"), colour_);
  form->addRow(tr("Context edges"), contextLayer_);

  const auto edit = [this](auto change) {
    Cutaway cutaway = document_.scene().cutaway;
    change(cutaway);
    document_.setCutaway(cutaway);
  };
  connect(enabled_, &QCheckBox::clicked, this, [edit](bool on) { edit([on](Cutaway& cutaway) { cutaway.enabled = on; }); });
  connect(openWidth_, &SliderSpin::edited, this,
          [edit](double value) { edit([value](Cutaway& cutaway) { cutaway.openWidth = value; }); });
  connect(borderWidth_, &SliderSpin::edited, this,
          [edit](double value) { edit([value](Cutaway& cutaway) { cutaway.borderWidth = value; }); });
  connect(unit_, &QComboBox::activated, this, [this, edit] {
    edit([this](Cutaway& cutaway) { cutaway.unit = static_cast<WidthUnit>(unit_->currentData().toInt()); });
  });
  connect(colour_, &QToolButton::clicked, this, &CutawayPanel::chooseColour);
  connect(contextLayer_, &SliderSpin::edited, this, [this](double value) {
    ContextLayer layer = document_.scene().contextLayer;
    layer.strength = value;
    document_.setContextLayer(layer);
  });
  connect(&document, &Document::cutawayChanged, this, &CutawayPanel::show);
  connect(&document, &Document::volumeChanged, this, &CutawayPanel::show);
  show();
}

void CutawayPanel::show() {
  setEnabled(document_.hasVolume());
  const Cutaway& cutaway = document_.scene().cutaway;
  enabled_->setChecked(cutaway.enabled);
  openWidth_->setValue(cutaway.openWidth);
  borderWidth_->setValue(cutaway.borderWidth);
  const QString suffix = cutaway.unit == WidthUnit::Pixel ? tr(" px") : tr(" mm");
  openWidth_->setSuffix(suffix);
  borderWidth_->setSuffix(suffix);
  unit_->setCurrentIndex(unit_->findData(static_cast<int>(cutaway.unit)));
  QPixmap swatch(colour_->iconSize());
  swatch.fill(toColour(cutaway.borderColour));
  colour_->setIcon(swatch);
  contextLayer_->setValue(document_.scene().contextLayer.strength);
  for (QWidget* widget : {static_cast<QWidget*>(openWidth_), static_cast<QWidget*>(borderWidth_),
                          static_cast<QWidget*>(unit_), static_cast<QWidget*>(colour_),
                          static_cast<QWidget*>(contextLayer_)})
    widget->setEnabled(cutaway.enabled);
}

void CutawayPanel::chooseColour() {
  Cutaway cutaway = document_.scene().cutaway;
  const QColor colour = QColorDialog::getColor(toColour(cutaway.borderColour), this, tr("Border colour"));
  if (!colour.isValid()) return;
  cutaway.borderColour = fromColour(colour);
  document_.setCutaway(cutaway);
}

}  // namespace fenestra::viewer
