#include "viewer/dialogs/SpacingDialog.h"

#include <algorithm>

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

namespace fenestra::viewer {

SpacingDialog::SpacingDialog(const QString& why, QWidget* parent, const glm::dvec3& now) : QDialog(parent) {
  setWindowTitle(tr("Size of the voxels"));
  auto* text = new QLabel(why);
  text->setWordWrap(true);
  auto* form = new QFormLayout(this);
  form->addRow(text);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
  QPushButton* open = buttons->button(QDialogButtonBox::Open);
  open->setEnabled(false);
  const std::array names{tr("&Across a row"), tr("&Down a column"), tr("From &slice to slice")};
  for (std::size_t axis = 0; axis < fields_.size(); ++axis) {
    auto* field = new QDoubleSpinBox;
    // 1 nm to 1 m, the sizes that are plausible; 0 stands for what nobody has said yet.
    field->setDecimals(6);
    field->setRange(0.0, 1000.0);
    field->setSingleStep(0.01);
    field->setSuffix(tr(" mm"));
    field->setSpecialValueText(tr("not said"));
    fields_[axis] = field;
    form->addRow(names[axis], field);
    connect(field, &QDoubleSpinBox::valueChanged, this, [this, open] {
      open->setEnabled(
          std::all_of(fields_.begin(), fields_.end(), [](const auto* each) { return each->value() > 0.0; }));
    });
  }
  for (std::size_t axis = 0; axis < fields_.size(); ++axis) fields_[axis]->setValue(now[static_cast<int>(axis)]);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

glm::dvec3 SpacingDialog::spacing() const { return {fields_[0]->value(), fields_[1]->value(), fields_[2]->value()}; }

}  // namespace fenestra::viewer
