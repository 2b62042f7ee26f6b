#pragma once
// Controls for the settings of one part of a document's look, made from their declarations in
// rendering/settings/Settings.h and rendering/methods: range, step, unit and tool tip. A change is a step of the
// history, as is a whole drag.

#include <concepts>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSignalBlocker>

#include "rendering/settings/Settings.h"
#include "viewer/model/Document.h"
#include "viewer/model/Translation.h"
#include "viewer/panels/ColourButton.h"
#include "viewer/panels/SliderSpin.h"

namespace fenestra::viewer {

template <class Part>
class LookControls {
 public:
  /// `partOf` is a member of Look, or gives a reference to the part of a look. `step` names the steps of the history,
  /// with %1 for the setting's name.
  LookControls(Document& document, auto partOf, QString step = QStringLiteral("%1"))
      : document_(document), part_(partOf), shownPart_(partOf), step_(std::move(step)) {}
  LookControls(const LookControls&) = delete;  // its controls refer to it
  LookControls& operator=(const LookControls&) = delete;

  SliderSpin* slider(double Part::*member) {
    const auto& setting = settingOf(member);
    auto* slider = new SliderSpin(setting);
    makeDragsSteps(*slider, document_.history());
    return bind(setting, slider, &SliderSpin::edited, [=](double value) { slider->setValue(value); });
  }
  /// A box to type into, without a slider.
  QDoubleSpinBox* spin(double Part::*member, double step) {
    const auto& setting = settingOf(member);
    auto* spin = new QDoubleSpinBox;
    spin->setRange(setting.range.low, setting.range.high);
    spin->setSingleStep(step);
    spin->setDecimals(0);
    spin->setKeyboardTracking(false);
    spin->setSuffix(unitSuffix(setting.unit));
    const auto show = [=](double value) {
      const QSignalBlocker silent(spin);
      spin->setValue(value);
    };
    return bind(setting, spin, &QDoubleSpinBox::valueChanged, show);
  }
  QCheckBox* box(bool Part::*member) {
    const auto& setting = settingOf(member);
    auto* box = new QCheckBox(translated(setting.name));
    return bind(setting, box, &QCheckBox::clicked, [=](bool on) { box->setChecked(on); });
  }
  ColourButton* colour(glm::dvec3 Part::*member) {
    const auto& setting = settingOf(member);
    auto* button = new ColourButton(translated(setting.description));
    return bind(setting, button, &ColourButton::edited, [=](glm::dvec3 colour) { button->setColour(colour); });
  }
  template <class E>
  QComboBox* choice(E Part::*member) {
    const auto& setting = settingOf(member);
    auto* choice = new QComboBox;
    for (const Word<E>& word : wordsOf(E{})) {
      choice->addItem(translated(word.name), static_cast<int>(word.value));
      if (*word.description) choice->setItemData(choice->count() - 1, translated(word.description), Qt::ToolTipRole);
    }
    const auto show = [=](E value) { choice->setCurrentIndex(choice->findData(static_cast<int>(value))); };
    QObject::connect(choice, &QComboBox::activated, &document_, [this, choice, &setting](int row) {
      set(setting, static_cast<E>(choice->itemData(row).toInt()));
    });
    return added(setting, choice, show);
  }
  /// The control that fits a setting: for a number with a step a slider.
  template <class Value>
  QWidget* control(const Setting<Part, Value>& setting) {
    if constexpr (std::same_as<Value, bool>)
      return box(setting.member);
    else if constexpr (std::same_as<Value, glm::dvec3>)
      return colour(setting.member);
    else if constexpr (std::is_enum_v<Value>)
      return choice(setting.member);
    else if (setting.step > 0.0)
      return slider(setting.member);
    else
      return spin(setting.member, 1.0);
  }
  /// A row of the setting's name and its slider.
  SliderSpin* addRow(QFormLayout& form, double Part::*member) {
    SliderSpin* control = slider(member);
    form.addRow(translated(settingOf(member).name), control);
    return control;
  }

  /// Shows the values of the document's look.
  void show() const {
    for (const auto& show : shows_) show(shownPart_(document_.look()));
  }
  void setEnabled(bool enabled) const {
    for (QWidget* control : controls_) control->setEnabled(enabled);
  }

 private:
  template <class Value>
  void set(const Setting<Part, Value>& setting, const Value& value) {
    Look look = document_.look();
    part_(look).*setting.member = value;
    document_.edit(step_.arg(translated(setting.name)), std::move(look));
  }

  template <class Value, class Control, class Signal, class Show>
  Control* bind(const Setting<Part, Value>& setting, Control* control, Signal edited, Show show) {
    QObject::connect(control, edited, &document_, [this, &setting](const Value& value) { set(setting, value); });
    return added(setting, control, show);
  }

  template <class Value, class Control, class Show>
  Control* added(const Setting<Part, Value>& setting, Control* control, Show show) {
    control->setObjectName(QString::fromUtf8(setting.key));
    control->setToolTip(translated(setting.description));
    controls_.push_back(control);
    shows_.push_back([show, member = setting.member](const Part& part) { show(part.*member); });
    return control;
  }

  Document& document_;
  std::function<Part&(Look&)> part_;
  std::function<const Part&(const Look&)> shownPart_;
  QString step_;
  std::vector<QWidget*> controls_;
  std::vector<std::function<void(const Part&)>> shows_;
};

}  // namespace fenestra::viewer
