#include "viewer/dialogs/WindowLevelDialog.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QSignalBlocker>

#include "viewer/model/Document.h"
#include "viewer/model/NumberText.h"

namespace fenestra::viewer {

WindowLevelDialog::WindowLevelDialog(Document& document, QWidget* parent)
    : QDialog(parent), document_(document), width_(new QDoubleSpinBox), level_(new QDoubleSpinBox) {
  setWindowTitle(tr("Window and level"));
  width_->setObjectName(QStringLiteral("windowWidth"));
  level_->setObjectName(QStringLiteral("windowLevel"));
  auto* inverted = new QCheckBox(tr("&Invert: low values bright"));
  inverted->setChecked(document.isInverted());
  auto* form = new QFormLayout(this);
  form->addRow(tr("&Width"), width_);
  form->addRow(tr("&Level"), level_);
  form->addRow(inverted);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  for (QDoubleSpinBox* box : {width_, level_})
    connect(box, &QDoubleSpinBox::valueChanged, this, [this] {
      document_.setWindow({width_->value(), level_->value()});
    });
  connect(inverted, &QCheckBox::toggled, this, [this](bool on) { document_.setInverted(on); });
  connect(&document, &Document::windowChanged, this, [this, inverted] {
    follow();
    inverted->setChecked(document_.isInverted());
  });
  connect(&document, &Document::volumeChanged, this, &WindowLevelDialog::follow);
  follow();
  width_->selectAll();
}

void WindowLevelDialog::follow() {
  if (!document_.hasVolume()) return;
  const Volume& volume = *document_.scene().volume;
  const double span = std::max(volume.range.high - volume.range.low, 1e-9);
  const QString unit = unitSuffix(volume.unit);
  const int decimals = span < 20.0 ? 4 : 1;
  const WindowLevel window = document_.window();
  for (const auto& [box, value, low] :
       {std::tuple(width_, window.width, std::pow(10.0, -decimals)), std::tuple(level_, window.level, -1e9)}) {
    if (box->hasFocus() && box->value() == value) continue;  // being typed
    const QSignalBlocker quiet(box);
    box->setDecimals(decimals);
    box->setRange(low, 1e9);
    box->setSingleStep(span < 20.0 ? span / 100.0 : 10.0);
    box->setSuffix(unit);
    // The value that is shown is rounded: one that it stands for already stays.
    if (std::abs(box->value() - value) > 0.5 * std::pow(10.0, -decimals)) box->setValue(value);
  }
}

}  // namespace fenestra::viewer
