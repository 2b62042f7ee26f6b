#include "viewer/dialogs/SettingsDialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSpinBox>

#include "viewer/model/Preferences.h"
#include "viewer/model/Translation.h"
#include "viewer/panels/ColourButton.h"
#include "viewer/style/Overlay.h"

namespace fenestra::viewer {

SettingsDialog::SettingsDialog(Preferences& preferences, QWidget* parent) : QDialog(parent), preferences_(preferences) {
  setWindowTitle(tr("Settings"));
  form_ = new QFormLayout(this);
  for (const PreferenceEntry& entry : preferenceTable()) {
    QWidget* control = controlFor(entry);
    control->setObjectName(QLatin1String(entry.key));
    control->setToolTip(translated(entry.description));
    if (entry.kind == PreferenceEntry::Kind::Switch)
      form_->addRow(control);
    else
      form_->addRow(translated(entry.name), control);
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close | QDialogButtonBox::RestoreDefaults);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, &preferences_,
          &Preferences::restoreDefaults);
  form_->addRow(buttons);
  connect(&preferences_, &Preferences::changed, this, [this] {
    for (const auto& show : shows_) show();
  });
}

void SettingsDialog::addRow(const QString& name, QWidget* control) {
  form_->insertRow(form_->rowCount() - 1, name, control);
}

QWidget* SettingsDialog::controlFor(const PreferenceEntry& entry) {
  const Preference which = entry.which;
  // Shows the value now and after each change.
  const auto keepShown = [this, which](auto show) {
    shows_.push_back([this, which, show] { show(preferences_.value(which)); });
    shows_.back()();
  };
  const auto store = [this, which](int value) { preferences_.set(which, value); };
  switch (entry.kind) {
    case PreferenceEntry::Kind::Switch: {
      auto* box = new QCheckBox(translated(entry.name));
      keepShown([box](int value) { box->setChecked(value != 0); });
      connect(box, &QCheckBox::toggled, &preferences_, store);
      return box;
    }
    case PreferenceEntry::Kind::Number: {
      auto* box = new QSpinBox;
      box->setRange(entry.low, entry.high);
      box->setSuffix(unitSuffix(entry.unit));
      keepShown([box](int value) { box->setValue(value); });
      connect(box, &QSpinBox::valueChanged, &preferences_, store);
      return box;
    }
    case PreferenceEntry::Kind::Colour: {
      auto* button = new ColourButton(translated(entry.name));
      keepShown([button](int rgb) { button->setColour(fromColour(QColor::fromRgb(static_cast<QRgb>(rgb)))); });
      connect(button, &ColourButton::edited, &preferences_, [store](glm::dvec3 colour) {
        constexpr QRgb withoutAlpha = 0xffffff;
        store(static_cast<int>(toColour(colour).rgb() & withoutAlpha));
      });
      return button;
    }
    case PreferenceEntry::Kind::Choice: {
      auto* box = new QComboBox;
      for (const char* word : entry.words()) box->addItem(translated(word));
      keepShown([box](int index) { box->setCurrentIndex(index); });
      connect(box, &QComboBox::currentIndexChanged, &preferences_, store);
      return box;
    }
  }
  return nullptr;
}

}  // namespace fenestra::viewer
