#include "viewer/panels/AppearancePanel.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "rendering/scene/Lighting.h"
#include "viewer/model/NumberText.h"
#include "viewer/model/Translation.h"

namespace fenestra::viewer {

AppearancePanel::AppearancePanel(Document& document, LookLibrary& library, QWidget* parent)
    : ScrollingPanel(parent),
      document_(document),
      light_(document, &Look::shading),
      presets_(new PresetPicker(document, library)),
      editor_(new TransferFunctionEditor(document, library)),
      shift_(new SliderSpin(-500.0, 500.0, 1.0)),
      table_(new QCheckBox(translated(settingOf(&Look::hideTable).name))) {
  shift_->setToolTip(translated(settingOf(&ContextFunction::shift).description));

  layOut();
  makeDragsSteps(*shift_, document.history());
  connect(shift_, &SliderSpin::edited, &document, &Document::setShift);
  connect(table_, &QCheckBox::clicked, &document, [this](bool hide) {
    Look look = document_.look();
    look.hideTable = hide;
    document_.edit(table_->text(), std::move(look));
  });
  connect(&document, &Document::transferFunctionChanged, this, &AppearancePanel::show);
  connect(&document, &Document::sceneChanged, this, &AppearancePanel::showSettings);
  connect(&document, &Document::shadingChanged, this, [this] { light_.show(); });
  connect(&document, &Document::volumeChanged, this, &AppearancePanel::fitToVolume);
  show();
}

void AppearancePanel::layOut() {
  auto* presets = new QFormLayout;
  presets->addRow(tr("Preset"), presets_);
  presets->addRow(translated(settingOf(&ContextFunction::shift).name), shift_);
  auto* form = new QFormLayout;
  form->addRow(tr("Light"), makeLightPresets());
  light_.addRow(*form, &Shading::lightAzimuth);
  light_.addRow(*form, &Shading::lightElevation);
  light_.addRow(*form, &Shading::occlusion);
  light_.addRow(*form, &Shading::shadow);
  auto* background = new QHBoxLayout;
  background->addWidget(makeColour(&Look::background));
  background->addWidget(makeChoice(&Look::backdrop), 1);
  ColourButton* top = makeColour(&Look::backgroundTop);
  background->addWidget(top);
  settings_.push_back([top](const Look& look) { top->setEnabled(look.backdrop == Backdrop::Gradient); });
  form->addRow(translated(settingOf(&Look::background).name), background);
  table_->setObjectName(QString::fromUtf8(settingOf(&Look::hideTable).key));
  table_->setToolTip(translated(settingOf(&Look::hideTable).description));
  settings_.push_back([this](const Look& look) { table_->setChecked(look.hideTable); });
  form->addRow(table_);
  form->addRow(translated(settingOf(&Look::reconstruction).name), makeChoice(&Look::reconstruction));
  form->addRow(translated(settingOf(&Look::labelSmoothing).name), makeChoice(&Look::labelSmoothing));
  form->addRow(translated(settingOf(&Look::edges).name), makeChoice(&Look::edges));
  auto* body = new QWidget;
  auto* column = new QVBoxLayout(body);
  column->addLayout(presets);
  column->addWidget(editor_);
  column->addLayout(form);
  setBody(body);
}

void AppearancePanel::fitToVolume() {
  if (!document_.hasVolume()) return show();
  const Volume& volume = *document_.scene().volume;
  // Only a volume with a table can be shown without.
  const Scene& scene = document_.scene();
  table_->setVisible(scene.table && scene.table->count > 0);
  // A quarter of the range either way; for CT ±500 HU, which separate lung, soft tissue and bone.
  const double span = volume.isInHounsfieldUnits() ? 500.0 : 0.25 * (volume.range.high - volume.range.low);
  const double step = std::pow(10.0, std::floor(std::log10(std::max(span, 1e-9) / 200.0)));
  shift_->setRange(-std::ceil(span / step) * step, std::ceil(span / step) * step, step);
  shift_->setSuffix(unitSuffix(volume.unit));
}

void AppearancePanel::show() {
  setEnabled(document_.hasVolume());
  if (!document_.hasVolume()) return;
  shift_->setValue(document_.shift());
  showSettings();
}

void AppearancePanel::showSettings() const {
  for (const auto& setting : settings_) setting(document_.look());
}

template <class E>
QComboBox* AppearancePanel::makeChoice(E Look::*member) {
  const auto& setting = settingOf(member);
  auto* choice = new QComboBox;
  choice->setObjectName(QString::fromUtf8(setting.key));
  choice->setToolTip(translated(setting.description));
  for (const Word<E>& word : wordsOf(E{})) {
    choice->addItem(translated(word.name), static_cast<int>(word.value));
    choice->setItemData(choice->count() - 1, translated(word.description), Qt::ToolTipRole);
  }
  connect(choice, &QComboBox::activated, &document_, [this, choice, member](int row) {
    Look look = document_.look();
    look.*member = static_cast<E>(choice->itemData(row).toInt());
    document_.edit(translated(settingOf(member).name), std::move(look));
  });
  settings_.push_back([choice, member](const Look& look) {
    choice->setCurrentIndex(choice->findData(static_cast<int>(look.*member)));
  });
  return choice;
}

ColourButton* AppearancePanel::makeColour(glm::dvec3 Look::*member) {
  const auto& setting = settingOf(member);
  auto* button = new ColourButton(translated(setting.description));
  button->setObjectName(QString::fromUtf8(setting.key));
  connect(button, &ColourButton::edited, &document_, [this, member](glm::dvec3 colour) {
    Look look = document_.look();
    look.*member = colour;
    document_.edit(translated(settingOf(member).name), std::move(look));
  });
  settings_.push_back([button, member](const Look& look) { button->setColour(look.*member); });
  return button;
}

QComboBox* AppearancePanel::makeLightPresets() {
  auto* presets = new QComboBox;
  presets->setObjectName(QStringLiteral("light_preset"));
  presets->setToolTip(tr("Ready-made light: how surfaces give it back, from wherever it comes"));
  presets->setPlaceholderText(tr("own"));
  for (const LightPreset& preset : lightPresets()) {
    presets->addItem(translated(preset.name));
    presets->setItemData(presets->count() - 1, translated(preset.description), Qt::ToolTipRole);
  }
  connect(presets, &QComboBox::activated, &document_, [this](int row) {
    Look look = document_.look();
    lightPresets()[static_cast<std::size_t>(row)].applyTo(look.shading);
    document_.edit(tr("Light"), std::move(look));
  });
  settings_.push_back([presets](const Look& look) {
    const auto all = lightPresets();
    const auto shown = std::find_if(all.begin(), all.end(), [&](const LightPreset& preset) {
      Shading shading = look.shading;
      preset.applyTo(shading);
      return shading == look.shading;
    });
    presets->setCurrentIndex(shown == all.end() ? -1 : static_cast<int>(shown - all.begin()));
  });
  return presets;
}

}  // namespace fenestra::viewer
