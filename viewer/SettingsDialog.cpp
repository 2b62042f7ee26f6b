#include "viewer/SettingsDialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSpinBox>

#include "viewer/model/Preferences.h"
#include "viewer/model/Translation.h"

namespace fenestra::viewer {

SettingsDialog::SettingsDialog(Preferences& preferences, QWidget* parent) : QDialog(parent), preferences_(preferences) {
  setWindowTitle(tr("Settings"));
  auto* form = new QFormLayout(this);
  for (const PreferenceEntry& entry : preferenceTable()) {
    QWidget* control = controlFor(entry);
    control->setObjectName(QLatin1String(entry.key));
    control->setToolTip(translated(entry.description));
    if (entry.isSwitch())
      form->addRow(control);
    else
      form->addRow(translated(entry.name), control);
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close | QDialogButtonBox::RestoreDefaults);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, &preferences_,
          &Preferences::restoreDefaults);
  form->addRow(buttons);
  connect(&preferences_, &Preferences::changed, this, [this] {
    for (const auto& show : shows_) show();
  });
}

QWidget* SettingsDialog::controlFor(const PreferenceEntry& entry) {
  const Preference which = entry.which;
  if (entry.isSwitch()) {
    auto* box = new QCheckBox(translated(entry.name));
    shows_.push_back([this, box, which] { box->setChecked(preferences_.isOn(which)); });
    shows_.back()();
    connect(box, &QCheckBox::toggled, &preferences_, [this, which](bool on) { preferences_.set(which, on); });
    return box;
  }
  auto* box = new QSpinBox;
  box->setRange(entry.low, entry.high);
  box->setSuffix(unitSuffix(entry.unit));
  shows_.push_back([this, box, which] { box->setValue(preferences_.value(which)); });
  shows_.back()();
  connect(box, &QSpinBox::valueChanged, &preferences_, [this, which](int value) { preferences_.set(which, value); });
  return box;
}

}  // namespace fenestra::viewer
