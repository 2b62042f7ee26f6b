#include "viewer/panels/ContextLayerPanel.h"

#include <QFormLayout>

#include "viewer/model/Document.h"
#include "viewer/panels/ColourButton.h"
#include "viewer/panels/SliderSpin.h"

namespace fenestra::viewer {

ContextLayerPanel::ContextLayerPanel(Document& document, QWidget* parent)
    : ScrollingPanel(parent), document_(document), colour_(new ColourButton(tr("Colour of the context's edges"))) {
  auto* body = new QWidget;
  auto* form = new QFormLayout(body);
  const auto add = [&](const QString& name, const QString& meaning, double most, double ContextLayer::*value) {
    auto* slider = new SliderSpin(0.0, most, 0.05);
    slider->setToolTip(meaning);
    form->addRow(name, slider);
    terms_.push_back({slider, value});
    makeDragsSteps(*slider, document.history());
    connect(slider, &SliderSpin::edited, this, [this, name, value](double edited) {
      ContextLayer layer = document_.scene().look.contextLayer;
      layer.*value = edited;
      document_.setContextLayer(layer, tr("Context edges: %1").arg(name.toLower()));
    });
  };
  add(tr("Strength"), tr("How strongly the edges of what was cut away are drawn over the focus; 0 is off"), 1.0,
      &ContextLayer::strength);
  add(tr("Curvature"), tr("How much bends of the surface count: eyes, nose, ears"), 2.0,
      &ContextLayer::curvatureWeight);
  add(tr("Silhouette"), tr("How much it counts that the surface is seen edge-on"), 2.0,
      &ContextLayer::silhouetteWeight);
  add(tr("Illumination"), tr("How much the edges are lit as their surface is; 0 draws them flat"), 1.0,
      &ContextLayer::illuminationWeight);
  add(tr("Value"), tr("How much of the context's own colour the edges take"), 1.0, &ContextLayer::valueWeight);
  add(tr("Illumination"), tr("How much the edges are lit as their surface is; 0 draws them flat"), 1.0,
      &ContextLayer::illuminationWeight);
  add(tr("Value"), tr("How much of the context's own colour the edges take"), 1.0, &ContextLayer::valueWeight);
  form->addRow(tr("Colour"), colour_);
  setBody(body);
  connect(colour_, &ColourButton::edited, this, [this](glm::dvec3 colour) {
    ContextLayer layer = document_.scene().look.contextLayer;
    layer.colour = colour;
    document_.setContextLayer(layer, tr("Context edges: colour"));
  });
  connect(&document, &Document::cutawayChanged, this, &ContextLayerPanel::show);
  connect(&document, &Document::volumeChanged, this, &ContextLayerPanel::show);
  show();
}

void ContextLayerPanel::show() {
  setEnabled(document_.hasVolume() && document_.scene().look.cutaway.enabled);
  const ContextLayer& layer = document_.scene().look.contextLayer;
  for (const Term& term : terms_) {
    term.slider->setValue(layer.*term.value);
    term.slider->setEnabled(term.slider == strength() || layer.strength > 0.0);
  }
  colour_->setColour(layer.colour);
}

}  // namespace fenestra::viewer
