#include "viewer/panels/CutawayPanel.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "viewer/model/Translation.h"
#include "viewer/panels/CarvingRows.h"

namespace fenestra::viewer {
namespace {

/// Which ready-made look it is; -1 for none.
int lookOf(const Look& shown) {
  const auto looks = openingLooks();
  const auto at = std::find_if(looks.begin(), looks.end(), [&](const OpeningLook& look) {
    Cutaway cutaway = shown.cutaway;
    ContextLayer layer = shown.contextLayer;
    look.applyTo(cutaway, layer);
    return cutaway == shown.cutaway && layer == shown.contextLayer;
  });
  return at == looks.end() ? -1 : static_cast<int>(at - looks.begin());
}

}  // namespace

CutawayPanel::CutawayPanel(Document& document, Carving& carving, QWidget* parent)
    : QWidget(parent),
      document_(document),
      controls_(document, &Look::cutaway),
      methodControls_(document, &Look::method),
      enabled_(controls_.box(&Cutaway::enabled)),
      openWidth_(controls_.slider(&Cutaway::openWidth)),
      borderWidth_(controls_.slider(&Cutaway::borderWidth)),
      axisOffset_(controls_.slider(&Cutaway::axisOffset)),
      axisDirection_(controls_.spin(&Cutaway::axisDirection, 15.0)),
      axis_(new QHBoxLayout),
      form_(new QFormLayout(this)),
      method_(methodControls_.choice(&Method::kind)),
      carving_(new CarvingRows(document, carving)),
      look_(new QComboBox),
      unit_(controls_.choice(&Cutaway::unit)),
      colour_(controls_.colour(&Cutaway::borderColour)) {
  layOut();
  // While all rows are there. The column of labels, too, is as wide as the widest.
  int widest = 0;
  for (int row = 0; row < form_->rowCount(); ++row)
    if (const QLayoutItem* label = form_->itemAt(row, QFormLayout::LabelRole))
      widest = std::max(widest, label->widget()->sizeHint().width());
  form_->labelForField(method_)->setMinimumWidth(widest);
  width_ = QWidget::minimumSizeHint().width();
  connect(look_, &QComboBox::activated, this, &CutawayPanel::apply);
  connect(&document, &Document::cutawayChanged, this, &CutawayPanel::show);
  connect(&document, &Document::volumeChanged, this, &CutawayPanel::show);
  show();
}

void CutawayPanel::layOut() {
  for (const OpeningLook& look : openingLooks()) look_->addItem(translated(look.name));
  look_->setPlaceholderText(tr("own"));
  look_->setToolTip(tr("Ready-made border and context edges"));

  const auto name = [](const auto& setting) { return translated(setting.name); };
  form_->addRow(enabled_);
  form_->addRow(name(settingOf(&Method::kind)), method_);
  form_->addRow(name(settingOf(&Cutaway::openWidth)), openWidth_);
  auto* border = new QHBoxLayout;
  border->addWidget(borderWidth_, 1);
  border->addWidget(colour_);
  form_->addRow(name(settingOf(&Cutaway::borderWidth)), border);
  methodRows_.emplace(document_, *form_);
  form_->addRow(carving_);
  axisOffset_->box()->setFixedWidth(64);  // two digits: the row holds four controls
  axis_->addWidget(axisOffset_, 1);
  axis_->addWidget(axisDirection_);
  form_->addRow(name(settingOf(&Cutaway::axisOffset)), axis_);
  // In one row: a column of all panels leaves few rows on a small screen.
  for (QComboBox* box : {look_, unit_}) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(5);
  }
  auto* looks = new QHBoxLayout;
  looks->addWidget(look_, 1);
  looks->addWidget(unit_);
  form_->addRow(tr("Look"), looks);
}

void CutawayPanel::apply(int openingLook) {
  Look look = document_.look();
  openingLooks()[static_cast<std::size_t>(openingLook)].applyTo(look.cutaway, look.contextLayer);
  document_.edit(tr("Look"), std::move(look));
}

QSize CutawayPanel::sizeHint() const {
  const QSize now = QWidget::sizeHint();
  if (height_ == 0 || document_.look().method.kind == kindOf<methods::Adaptive>) height_ = now.height();
  return {now.width(), height_};
}

QSize CutawayPanel::minimumSizeHint() const { return QWidget::minimumSizeHint().expandedTo({width_, 0}); }

void CutawayPanel::addFreeze(QAction* freeze) {
  auto* button = new QToolButton;
  button->setDefaultAction(freeze);
  axis_->addWidget(button);
}

void CutawayPanel::show() {
  setEnabled(document_.hasVolume());
  const Cutaway& cutaway = document_.look().cutaway;
  controls_.show();
  look_->setCurrentIndex(lookOf(document_.look()));
  const QString suffix = unitSuffix(wordOf(cutaway.unit).word);
  openWidth_->setSuffix(suffix);
  borderWidth_->setSuffix(suffix);
  for (QWidget* widget : std::initializer_list<QWidget*>{look_, openWidth_, borderWidth_, axisOffset_, unit_, colour_})
    widget->setEnabled(cutaway.enabled);
  axisDirection_->setEnabled(cutaway.enabled && cutaway.axisOffset > 0.0);
  showMethod();
}

void CutawayPanel::showMethod() {
  methodControls_.show();
  methodRows_->show();
  const MethodKind kind = document_.look().method.kind;
  const MethodStages stages = stagesOf(document_.look().method);
  const bool open = document_.look().cutaway.enabled, byLens = stages.lens.has_value();
  const bool opens = stages.start != MethodStages::Start::Entry;
  form_->setRowVisible(carving_, carves(kind));
  QString tip = translated(wordOf(kind).description);
  if (opens && !stages.opensBetweenPixels())
    tip += QStringLiteral("\n") + tr("Smooth edges, by several rays a pixel, are the adaptive cutaway's alone");
  method_->setToolTip(tip);
  methodControls_.setEnabled(open);
  methodRows_->setEnabled(open);
  carving_->setEnabled(open);
  for (QWidget* widget : std::initializer_list<QWidget*>{look_, axisOffset_, unit_}) widget->setEnabled(open && opens);
  axisDirection_->setEnabled(axisDirection_->isEnabled() && opens);
  // A width that the method does not have stays in sight, and says why it cannot be moved.
  const QString decides = !opens   ? tr("This method has no width: it cuts nothing away")
                          : byLens ? tr("This method has no width of its own: the focus and the lens decide on it")
                                   : tr("This method has no width of its own: the focus and the angle decide on it");
  openWidth_->setEnabled(open && stages.hasWidth);
  openWidth_->setToolTip(stages.hasWidth ? translated(settingOf(&Cutaway::openWidth).description) : decides);
  borderWidth_->setEnabled(open && stages.hasBorder);
  colour_->setEnabled(open && stages.hasBorder);
  borderWidth_->setToolTip(stages.hasBorder ? translated(settingOf(&Cutaway::borderWidth).description)
                           : byLens         ? tr("The line of this method is the rim of its lens")
                                            : tr("This method has no line: it cuts nothing away"));
}

}  // namespace fenestra::viewer
