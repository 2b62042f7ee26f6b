#include "viewer/panels/CarvingRows.h"

#include <utility>

#include <QFormLayout>
#include <QHBoxLayout>

#include "viewer/model/Carving.h"
#include "viewer/model/Document.h"
#include "viewer/panels/SliderSpin.h"

namespace fenestra::viewer {

CarvingRows::CarvingRows(Document& document, Carving& carving, QWidget* parent)
    : QWidget(parent),
      document_(document),
      carving_(carving),
      method_(document.look().method.kind),
      carve_(new QToolButton),
      restore_(new QToolButton),
      shape_(new QComboBox),
      size_(new SliderSpin(settingOf(&CarvingSettings::size))),
      softness_(new SliderSpin(settingOf(&CarvingSettings::softness))),
      depth_(new SliderSpin(settingOf(&CarvingSettings::depth))) {
  layOut();
  connect(carve_, &QToolButton::clicked, &carving_, &Carving::setActive);
  connect(restore_, &QToolButton::clicked, this, [this] { document_.setRemovals({}, tr("Restore all")); });
  connect(shape_, &QComboBox::activated, this, [this](int which) {
    CarvingSettings settings = carving_.settings();
    settings.shape = wordsOf(RemovalShape{})[static_cast<std::size_t>(which)].value;
    carving_.setSettings(settings);
  });
  connect(&carving_, &Carving::changed, this, &CarvingRows::show);
  connect(&document_, &Document::removalsChanged, this, &CarvingRows::show);
  connect(&document_, &Document::cutawayChanged, this, &CarvingRows::followMethod);
  show();
}

void CarvingRows::layOut() {
  carve_->setText(tr("Carve"));
  carve_->setCheckable(true);
  carve_->setObjectName(QStringLiteral("choice"));
  carve_->setToolTip(tr("The left button carves in all views when it is let go; Ctrl+left drag still turns the view"));
  restore_->setText(tr("Restore all"));
  restore_->setToolTip(tr("Brings back all that was carved away"));
  for (const Word<RemovalShape>& each : wordsOf(RemovalShape{})) {
    shape_->addItem(translated(each.name));
    shape_->setItemData(shape_->count() - 1, translated(each.description), Qt::ToolTipRole);
  }
  shape_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  shape_->setMinimumContentsLength(5);
  auto* row = new QHBoxLayout;
  row->addWidget(carve_);
  row->addWidget(shape_, 1);
  row->addWidget(restore_);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow(row);
  const auto add = [&](SliderSpin* slider, double CarvingSettings::*member) {
    form->addRow(translated(settingOf(member).name), slider);
    slider->setObjectName(QLatin1String(settingOf(member).key));
    connect(slider, &SliderSpin::edited, this, [this, member](double value) {
      CarvingSettings settings = carving_.settings();
      settings.*member = value;
      carving_.setSettings(settings);
    });
  };
  add(size_, &CarvingSettings::size);
  add(softness_, &CarvingSettings::softness);
  add(depth_, &CarvingSettings::depth);
}

void CarvingRows::followMethod() {
  // The user most likely wants the method's own shape.
  const MethodKind kind = document_.look().method.kind;
  if (std::exchange(method_, kind) == kind) return;
  CarvingSettings settings = carving_.settings();
  const bool bends = settings.shape == RemovalShape::Plane;
  if (kind == kindOf<methods::Bend>) settings.shape = RemovalShape::Plane;
  if (kind == kindOf<methods::Sculpt> && bends) settings.shape = RemovalShape::Ball;
  carving_.setSettings(settings);
}

void CarvingRows::show() {
  const CarvingSettings& settings = carving_.settings();
  carve_->setChecked(carving_.isActive());
  shape_->setCurrentIndex(static_cast<int>(settings.shape));
  size_->setValue(settings.size);
  softness_->setValue(settings.softness);
  depth_->setValue(settings.depth);
  depth_->setEnabled(settings.shape == RemovalShape::Saw || settings.shape == RemovalShape::Plane);
  restore_->setEnabled(!document_.removals().empty());
}

}  // namespace fenestra::viewer
