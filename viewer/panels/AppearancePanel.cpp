#include "viewer/panels/AppearancePanel.h"

#include <algorithm>
#include <cmath>

#include <QFormLayout>
#include <QVBoxLayout>

#include "viewer/model/Translation.h"

namespace fenestra::viewer {

AppearancePanel::AppearancePanel(Document& document, LookLibrary& library, QWidget* parent)
    : ScrollingPanel(parent),
      document_(document),
      light_(document, &Look::shading),
      presets_(new PresetPicker(document, library)),
      editor_(new TransferFunctionEditor(document, library)),
      shift_(new SliderSpin(-500.0, 500.0, 1.0)),
      background_(new ColourButton(translated(settingOf(&Look::background).description))),
      table_(new QCheckBox(translated(settingOf(&Look::hideTable).name))),
      reconstruction_(new QComboBox) {
  shift_->setToolTip(translated(settingOf(&ContextFunction::shift).description));

  auto* presets = new QFormLayout;
  presets->addRow(tr("Preset"), presets_);
  presets->addRow(translated(settingOf(&ContextFunction::shift).name), shift_);
  auto* form = new QFormLayout;
  light_.addRow(*form, &Shading::lightAzimuth);
  light_.addRow(*form, &Shading::lightElevation);
  light_.addRow(*form, &Shading::occlusion);
  light_.addRow(*form, &Shading::shadow);
  background_->setObjectName(QString::fromUtf8(settingOf(&Look::background).key));
  form->addRow(translated(settingOf(&Look::background).name), background_);
  table_->setObjectName(QString::fromUtf8(settingOf(&Look::hideTable).key));
  table_->setToolTip(translated(settingOf(&Look::hideTable).description));
  form->addRow(table_);
  const auto& reconstruction = settingOf(&Look::reconstruction);
  reconstruction_->setObjectName(QString::fromUtf8(reconstruction.key));
  reconstruction_->setToolTip(translated(reconstruction.description));
  for (const Word<Reconstruction>& word : wordsOf(Reconstruction{})) {
    reconstruction_->addItem(translated(word.name), static_cast<int>(word.value));
    reconstruction_->setItemData(reconstruction_->count() - 1, translated(word.description), Qt::ToolTipRole);
  }
  form->addRow(translated(reconstruction.name), reconstruction_);
  auto* body = new QWidget;
  auto* column = new QVBoxLayout(body);
  column->addLayout(presets);
  column->addWidget(editor_);
  column->addLayout(form);
  setBody(body);

  makeDragsSteps(*shift_, document.history());
  connect(shift_, &SliderSpin::edited, &document, &Document::setShift);
  connect(background_, &ColourButton::edited, &document, [this](glm::dvec3 colour) {
    Look look = document_.look();
    look.background = colour;
    document_.edit(translated(settingOf(&Look::background).name), std::move(look));
  });
  connect(table_, &QCheckBox::clicked, &document, [this](bool hide) {
    Look look = document_.look();
    look.hideTable = hide;
    document_.edit(table_->text(), std::move(look));
  });
  connect(reconstruction_, &QComboBox::activated, &document, [this](int row) {
    Look look = document_.look();
    look.reconstruction = static_cast<Reconstruction>(reconstruction_->itemData(row).toInt());
    document_.edit(translated(settingOf(&Look::reconstruction).name), std::move(look));
  });
  connect(&document, &Document::transferFunctionChanged, this, &AppearancePanel::show);
  connect(&document, &Document::sceneChanged, this, [this] {
    background_->setColour(document_.look().background);
    table_->setChecked(document_.look().hideTable);
    showReconstruction();
  });
  connect(&document, &Document::shadingChanged, this, [this] { light_.show(); });
  connect(&document, &Document::volumeChanged, this, [this] {
    const Volume& volume = *document_.scene().volume;
    // Only a volume with a table can be shown without.
    const Scene& scene = document_.scene();
    table_->setVisible(scene.table && scene.table->count > 0);
    // A quarter of the range either way; for CT ±500 HU, which separate lung, soft tissue and bone.
    const double span = volume.isInHounsfieldUnits() ? 500.0 : 0.25 * (volume.range.high - volume.range.low);
    const double step = std::pow(10.0, std::floor(std::log10(std::max(span, 1e-9) / 200.0)));
    shift_->setRange(-std::ceil(span / step) * step, std::ceil(span / step) * step, step);
    shift_->setSuffix(volume.unit.empty() ? QString() : QStringLiteral(" ") + QString::fromStdString(volume.unit));
  });
  show();
}

void AppearancePanel::show() {
  setEnabled(document_.hasVolume());
  if (!document_.hasVolume()) return;
  shift_->setValue(document_.shift());
  background_->setColour(document_.look().background);
  table_->setChecked(document_.look().hideTable);
  showReconstruction();
}

void AppearancePanel::showReconstruction() {
  reconstruction_->setCurrentIndex(reconstruction_->findData(static_cast<int>(document_.look().reconstruction)));
}

}  // namespace fenestra::viewer
