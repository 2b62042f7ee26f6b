#include "viewer/panels/MethodRows.h"

#include <cstdlib>

#include <QHBoxLayout>

#include "viewer/panels/ImportanceList.h"
#include "viewer/panels/LookControls.h"

namespace fenestra::viewer {
namespace {

template <class M>
class GroupOf : public MethodRows::Group {
 public:
  using Shown = bool (*)(const M&);

  GroupOf(Document& document, QFormLayout& form);

  void show(const Method& method) override {
    const M& parameters = method.of<M>();
    controls.show();
    for (const auto& [setVisible, shown] : rows_) setVisible(method.is<M>() && (!shown || shown(parameters)));
  }
  void setEnabled(bool enabled) override {
    controls.setEnabled(enabled);
    for (QWidget* widget : others_) widget->setEnabled(enabled);
  }

  /// A row that shows where `shown`, if there is one, says so.
  template <class Label, class Row>
  void add(const Label& label, Row* row, Shown shown = nullptr) {
    form_.addRow(label, row);
    rows_.push_back({[this, row](bool visible) { form_.setRowVisible(row, visible); }, shown});
  }
  template <class Value>
  void add(Value M::*member, Shown shown = nullptr) {
    const auto& setting = settingOf(member);
    add(translated(setting.name), narrow(controls.control(setting)), shown);
  }
  /// A widget within a row, as add().
  void within(QWidget* widget, Shown shown) {
    rows_.push_back({[widget](bool visible) { widget->setVisible(visible); }, shown});
  }
  /// A widget that belongs to no setting.
  QWidget* other(QWidget* widget) {
    others_.push_back(widget);
    return widget;
  }
  /// A row that appears must not widen the panel and so push the views aside.
  template <class Control>
  static Control* narrow(Control* control) {
    if (auto* box = qobject_cast<QComboBox*>(control)) {
      box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
      box->setMinimumContentsLength(5);
    }
    return control;
  }

  LookControls<M> controls;

 private:
  struct Row {
    std::function<void(bool)> setVisible;
    Shown shown;
  };

  QFormLayout& form_;
  std::vector<Row> rows_;
  std::vector<QWidget*> others_;
};

/// Broken at the space next to its middle. A label that wraps by itself must not be in these rows: for hidden rows
/// whose height follows from their width, QFormLayout of Qt 6.4 writes behind the end of its memory.
QString inTwoLines(QString text) {
  qsizetype best = -1;
  for (qsizetype at = text.indexOf(QLatin1Char(' ')); at >= 0; at = text.indexOf(QLatin1Char(' '), at + 1))
    if (best < 0 || std::abs(2 * at - text.size()) < std::abs(2 * best - text.size())) best = at;
  if (best >= 0) text[best] = QLatin1Char('\n');
  return text;
}

template <class M>
void addRows(GroupOf<M>& group, Document&) {
  forEachSetting<M>([&](const auto& setting) { group.add(setting.member); });
}

void addRows(GroupOf<methods::Importance>& group, Document& document) {
  using methods::Importance;
  const GroupOf<Importance>::Shown removes = [](const Importance& method) {
    return method.mode == ImportanceMode::Maximum;
  };
  const GroupOf<Importance>::Shown keeps = [](const Importance& method) {
    return method.mode == ImportanceMode::Average;
  };
  auto* row = new QHBoxLayout;
  row->addWidget(group.narrow(group.controls.choice(&Importance::mode)), 1);
  QComboBox* sparseness = group.narrow(group.controls.choice(&Importance::sparseness));
  row->addWidget(sparseness, 1);
  group.add(inTwoLines(translated(settingOf(&Importance::mode).name)), row);
  group.within(sparseness, keeps);
  group.add(&Importance::angle, removes);
  group.add(&Importance::opacity, keeps);
  group.add(MethodRows::tr("Levels"), group.other(new ImportanceList(document)));
}

void addRows(GroupOf<methods::ClearView>& group, Document&) {
  using methods::ClearView;
  group.add(&ClearView::place);
  group.add(&ClearView::radius);
  group.add(&ClearView::bends);
  auto* row = new QHBoxLayout;
  row->addWidget(group.narrow(group.controls.choice(&ClearView::fade)), 1);
  QDoubleSpinBox* rim = group.controls.spin(&ClearView::rim, 5.0);
  //: before the number that says how thin the line around a lens is
  rim->setPrefix(MethodRows::tr("rim") + QLatin1Char(' '));
  row->addWidget(rim);
  group.add(translated(settingOf(&ClearView::fade).name), row);
}

void addRows(GroupOf<methods::Walls>& group, Document&) {
  using methods::Walls;
  group.add(&Walls::placement);
  // One letter a plane, as in the titles of other programs' views: three names are wider than the panel.
  QCheckBox* axial = group.controls.box(&Walls::axial);
  axial->setText(MethodRows::tr("A", "axial"));
  QCheckBox* sagittal = group.controls.box(&Walls::sagittal);
  sagittal->setText(MethodRows::tr("S", "sagittal"));
  QCheckBox* coronal = group.controls.box(&Walls::coronal);
  coronal->setText(MethodRows::tr("C", "coronal"));
  auto* row = new QHBoxLayout;
  for (QCheckBox* box : {axial, sagittal, coronal, group.controls.box(&Walls::outlines)}) row->addWidget(box);
  row->addStretch(1);
  group.add(MethodRows::tr("Slices"), row);
}

template <class M>
GroupOf<M>::GroupOf(Document& document, QFormLayout& form)
    : controls(
          document, [](auto& look) -> auto& { return look.method.template of<M>(); }),
      form_(form) {
  addRows(*this, document);
}

}  // namespace

MethodRows::MethodRows(Document& document, QFormLayout& form) : document_(document) {
  forEachMethod([&]<class M>() { groups_.push_back(std::make_unique<GroupOf<M>>(document, form)); });
}

void MethodRows::show() const {
  for (const auto& group : groups_) group->show(document_.look().method);
}

void MethodRows::setEnabled(bool enabled) const {
  for (const auto& group : groups_) group->setEnabled(enabled);
}

}  // namespace fenestra::viewer
