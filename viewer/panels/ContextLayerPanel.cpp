#include "viewer/panels/ContextLayerPanel.h"

#include "viewer/model/Translation.h"

namespace fenestra::viewer {

ContextLayerPanel::ContextLayerPanel(Document& document, QWidget* parent)
    : ScrollingPanel(parent),
      document_(document),
      controls_(document, &Look::contextLayer, tr("Context edges: %1")),
      strength_(controls_.slider(&ContextLayer::strength)) {
  auto* body = new QWidget;
  auto* form = new QFormLayout(body);
  form->addRow(translated(settingOf(&ContextLayer::strength).name), strength_);
  for (const auto member :
       {&ContextLayer::curvatureWeight, &ContextLayer::silhouetteWeight, &ContextLayer::illuminationWeight,
        &ContextLayer::valueWeight, &ContextLayer::saturation, &ContextLayer::share})
    rest_.push_back(controls_.addRow(*form, member));
  rest_.push_back(controls_.colour(&ContextLayer::colour));
  form->addRow(translated(settingOf(&ContextLayer::colour).name), rest_.back());
  setBody(body);
  connect(&document, &Document::cutawayChanged, this, &ContextLayerPanel::show);
  connect(&document, &Document::volumeChanged, this, &ContextLayerPanel::show);
  show();
}

void ContextLayerPanel::show() {
  const bool opens = stagesOf(document_.look().method).start != MethodStages::Start::Entry;
  setEnabled(document_.hasVolume() && document_.look().cutaway.enabled && opens);
  controls_.show();
  for (QWidget* control : rest_) control->setEnabled(document_.look().contextLayer.strength > 0.0);
}

}  // namespace fenestra::viewer
