#include "viewer/panels/FocusPanel.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QTimer>
#include <QVBoxLayout>

#include "viewer/model/Document.h"
#include "viewer/model/NumberText.h"
#include "viewer/model/PlacementController.h"
#include "viewer/model/SelectionBrush.h"
#include "viewer/model/ViewLink.h"
#include "viewer/panels/LabelEditPanel.h"
#include "viewer/panels/LabelList.h"
#include "viewer/panels/LabelModel.h"
#include "viewer/panels/RegionPanel.h"
#include "viewer/panels/SliderSpin.h"
#include "viewer/style/Style.h"

namespace fenestra::viewer {

FocusPanel::FocusPanel(Document& document, const PlacementController& placement, const ViewLink& cameras,
                       SelectionBrush& selection, QWidget* parent)
    : ScrollingPanel(parent),
      document_(document),
      selection_(selection),
      study_(new QLabel),
      filter_(new QLineEdit),
      list_(new LabelList(document, placement)),
      noLabels_(new QLabel(tr(
          "No labels. Click a structure in a picture, open a label map (Ctrl+L), or choose a range of values below."))),
      byValue_(new QCheckBox(tr("Focus on values"))),
      low_(new QDoubleSpinBox),
      high_(new QDoubleSpinBox),
      islands_(new SliderSpin(settingOf(&ValueFocus::minimumComponent))),
      region_(new RegionPanel(document)),
      labelEdits_(new LabelEditPanel(document)),
      paint_(new QToolButton),
      painting_(new QWidget),
      paintRadius_(new SliderSpin(settingOf(&SelectionBrushSettings::radius))),
      paintSoftness_(new SliderSpin(settingOf(&SelectionBrushSettings::softness))) {
  study_->setWordWrap(true);
  study_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  noLabels_->setWordWrap(true);
  noLabels_->setEnabled(false);
  filter_->setPlaceholderText(tr("Find a structure"));
  filter_->setClearButtonEnabled(true);

  makeIslandsRow();
  makePainting();
  layOut();
  connect(filter_, &QLineEdit::textChanged, list_, &LabelList::filter);
  connect(list_, &LabelList::doubleClicked, this, [this](const QModelIndex& index) {
    const std::uint16_t label = list_->labelAt(index);
    if (label == 0 || index.column() != LabelModel::Name) return;
    document_.focusOn(label);
    Q_EMIT structureChosen();
  });
  connect(&cameras, &ViewLink::changed, this, [this] {
    if (list_->isVisible()) list_->labels().refreshSeen();
  });
  connect(&document, &Document::volumeChanged, filter_, &QLineEdit::clear);
  connect(&document, &Document::volumeChanged, this, &FocusPanel::showStudy);
  connect(&document, &Document::labelsChanged, this, &FocusPanel::showStudy);
  connect(&document, &Document::focusChanged, this, &FocusPanel::showFocus);
  connect(&document, &Document::focusChanged, this, &FocusPanel::showRegionsRows);
  showStudy();
}

void FocusPanel::layOut() {
  auto* body = new QWidget;
  auto* column = new QVBoxLayout(body);
  column->addWidget(study_);
  column->addWidget(filter_);
  column->addWidget(list_);
  column->addWidget(noLabels_);
  column->addWidget(byValue_);
  column->addLayout(makeRange());
  column->addWidget(islandsRow_);
  column->addWidget(labelEdits_);
  column->addWidget(paint_);
  column->addWidget(painting_);
  column->addWidget(region_);
  column->addStretch(1);
  setBody(body);
}

int FocusPanel::usefulHeight() const {
  const QLayout& column = *widget()->layout();
  const QMargins margins = column.contentsMargins();
  // The study's text has one line; the list and the field above it count while there are no labels, too, so that the
  // other panels stay as they are when a study with labels opens.
  return margins.top() + study_->fontMetrics().height() + column.spacing() + filter_->sizeHint().height() +
         column.spacing() + list_->leastHeight() + margins.bottom();
}

void FocusPanel::resizeEvent(QResizeEvent* event) {
  ScrollingPanel::resizeEvent(event);
  fitList();
}

void FocusPanel::fitList() {
  const QLayout& column = *widget()->layout();
  int others = heightThrough(*paint_);
  for (QWidget* row : std::initializer_list<QWidget*>{list_, labelEdits_})
    if (!row->isHidden()) others -= column.itemAt(column.indexOf(row))->minimumSize().height() + column.spacing();
  list_->setFixedHeight(std::max(list_->leastHeight(), viewport()->height() - others - column.spacing()));
}

void FocusPanel::showRegionsRows() {
  const int state = !document_.region() ? 0 : document_.growth() ? 2 : 1;
  if (state <= regionState_) {
    if (state == 0) regionState_ = 0;
    return;
  }
  regionState_ = state;
  // From the event loop: the rows have their places then. The last one that is asked for is in sight for certain.
  QTimer::singleShot(0, this, [this] {
    for (QWidget* row : std::initializer_list<QWidget*>{region_->keep(), region_->plot(), region_->slider()})
      ensureWidgetVisible(row, 0, 0);
  });
}

QLayout* FocusPanel::makeRange() {
  byValue_->setToolTip(tr("The focus is everything whose value lies in this range"));
  auto* range = new QHBoxLayout;
  range->addWidget(low_, 1);
  range->addWidget(new QLabel(tr("to")));
  range->addWidget(high_, 1);
  for (QDoubleSpinBox* box : {low_, high_}) {
    box->setKeyboardTracking(false);
    box->setAlignment(Qt::AlignRight);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this] {
      if (byValue_->isChecked()) applyRange();
    });
  }
  connect(byValue_, &QCheckBox::clicked, this, [this](bool on) {
    if (on)
      applyRange();
    else
      document_.setFocus(std::monostate{});
  });
  return range;
}

void FocusPanel::makeIslandsRow() {
  islandsRow_ = new QWidget;
  auto* row = new QHBoxLayout(islandsRow_);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new QLabel(tr("Without islands below")));
  row->addWidget(islands_, 1);
  islandsRow_->setToolTip(islands_->toolTip());
  islands_->setValue(ValueFocus{}.minimumComponent);
  makeDragsSteps(*islands_, document_.history());
  connect(islands_, &SliderSpin::edited, this, &FocusPanel::applyRange);
}

void FocusPanel::makePainting() {
  paint_->setText(tr("Paint the region"));
  paint_->setIcon(icon("brush"));
  paint_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  paint_->setCheckable(true);
  paint_->setObjectName(QStringLiteral("choice"));
  paint_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  paint_->setToolTip(tr("The left button paints the region in focus in all views; with Shift it erases"));
  auto* form = new QFormLayout(painting_);
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow(tr("Radius"), paintRadius_);
  form->addRow(tr("Softness"), paintSoftness_);
  connect(paint_, &QToolButton::clicked, &selection_, &SelectionBrush::setActive);
  const auto follow = [this](SliderSpin* slider, double SelectionBrushSettings::*member) {
    connect(slider, &SliderSpin::edited, this, [this, member](double value) {
      SelectionBrushSettings settings = selection_.settings();
      settings.*member = value;
      selection_.setSettings(settings);
    });
  };
  follow(paintRadius_, &SelectionBrushSettings::radius);
  follow(paintSoftness_, &SelectionBrushSettings::softness);
  const auto show = [this] {
    paint_->setChecked(selection_.isActive());
    painting_->setVisible(selection_.isActive());
    paintRadius_->setValue(selection_.settings().radius);
    paintSoftness_->setValue(selection_.settings().softness);
  };
  connect(&selection_, &SelectionBrush::changed, this, show);
  show();
}

void FocusPanel::showStudy() {
  setEnabled(document_.hasVolume());
  study_->setText(document_.hasVolume() ? document_.description() : tr("Nothing open"));
  const bool labelled = !list_->isEmpty();
  list_->setVisible(labelled);
  filter_->setVisible(labelled);
  noLabels_->setVisible(!labelled && document_.hasVolume());
  fitList();
  if (!document_.hasVolume()) return;

  const Volume& volume = *document_.scene().volume;
  const double span = std::max(volume.range.high - volume.range.low, 1e-12);
  // Whole numbers for CT and other wide ranges, three significant digits for a narrow one.
  const int decimals = std::clamp(static_cast<int>(std::ceil(3.0 - std::log10(span))), 0, 9);
  const QString suffix = unitSuffix(volume.unit);
  for (QDoubleSpinBox* box : {low_, high_}) {
    const QSignalBlocker quiet(box);
    box->setDecimals(decimals);
    box->setSingleStep(std::pow(10.0, std::floor(std::log10(span)) - 2.0));
    box->setRange(volume.range.low, volume.range.high);
    box->setSuffix(suffix);
  }
  const QSignalBlocker quietLow(low_), quietHigh(high_);
  // A range to start from: bone where the data has some, otherwise the upper quarter of the values.
  constexpr double bone = 300.0;  // HU
  const bool holdsBone = volume.isInHounsfieldUnits() && volume.range.high > 2.0 * bone;
  low_->setValue(holdsBone ? bone : volume.range.high - 0.25 * span);
  high_->setValue(volume.range.high);
  showFocus();
}

void FocusPanel::showFocus() {
  const auto* values = std::get_if<ValueFocus>(&document_.focus());
  byValue_->setChecked(values != nullptr);
  low_->setEnabled(values != nullptr);
  high_->setEnabled(values != nullptr);
  islandsRow_->setEnabled(values != nullptr);
  if (const auto* labels = std::get_if<LabelFocus>(&document_.focus())) {
    list_->scrollToLabel(labels->labels.front());
  }
  if (!values) return;
  const QSignalBlocker quietLow(low_), quietHigh(high_);
  low_->setValue(values->values.low);
  high_->setValue(values->values.high);
  islands_->setValue(values->minimumComponent);
}

void FocusPanel::applyRange() {
  const double a = low_->value(), b = high_->value();
  document_.setFocus(ValueFocus{{std::min(a, b), std::max(a, b)}, islands_->value()});
}

}  // namespace fenestra::viewer
