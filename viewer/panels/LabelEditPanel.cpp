#include "viewer/panels/LabelEditPanel.h"

#include <algorithm>

#include <QGridLayout>

#include "viewer/model/Document.h"
#include "viewer/model/Translation.h"

namespace fenestra::viewer {

LabelEditPanel::LabelEditPanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), distance_(new QDoubleSpinBox), island_(new QDoubleSpinBox) {
  distance_->setRange(0.1, 20.0);
  distance_->setSingleStep(0.5);
  distance_->setValue(1.0);
  distance_->setSuffix(unitSuffix("mm"));
  island_->setRange(0.0, 1e7);
  island_->setDecimals(0);
  island_->setSingleStep(100.0);
  island_->setValue(100.0);
  island_->setSuffix(unitSuffix("mm³"));

  auto* rows = new QGridLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](LabelOperation operation, const QString& text, const QString& description,
                       const QDoubleSpinBox* number, int row, int column) {
    auto* button = new QToolButton;
    button->setText(text);
    button->setToolTip(description);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    buttons_[static_cast<std::size_t>(operation)] = button;
    rows->addWidget(button, row, column);
    connect(button, &QToolButton::clicked, this, [this, operation, number] {
      if (const auto* focus = std::get_if<LabelFocus>(&document_.focus()))
        Q_EMIT edited(focus->labels.front(), operation, number ? number->value() : 0.0);
    });
  };
  rows->addWidget(distance_, 0, 0);
  add(LabelOperation::Grow, tr("Grow"), tr("Add what lies within this distance; other labels keep their voxels"),
      distance_, 0, 1);
  add(LabelOperation::Shrink, tr("Shrink"), tr("Remove what lies within this distance of the outside"), distance_, 0,
      2);
  rows->addWidget(island_, 1, 0);
  add(LabelOperation::RemoveIslands, tr("Remove islands"), tr("Remove separate parts smaller than this"), island_, 1,
      1);
  add(LabelOperation::FillHoles, tr("Fill holes"), tr("Add what the label encloses"), nullptr, 1, 2);

  connect(&document, &Document::focusChanged, this, &LabelEditPanel::showFocus);
  connect(&document, &Document::volumeChanged, this, [this] {
    if (!document_.hasVolume()) return;
    const glm::dvec3 spacing = document_.scene().volume->grid.spacing;
    distance_->setValue(std::max({spacing.x, spacing.y, spacing.z}));
  });
  showFocus();
}

void LabelEditPanel::showFocus() {
  const auto* focus = std::get_if<LabelFocus>(&document_.focus());
  setVisible(focus && focus->labels.size() == 1);
}

}  // namespace fenestra::viewer
