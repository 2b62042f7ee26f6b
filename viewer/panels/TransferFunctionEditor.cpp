#include "viewer/panels/TransferFunctionEditor.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <QAbstractItemView>
#include <QHBoxLayout>
#include <QMenu>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "io/TransferFunctionFile.h"
#include "viewer/model/Document.h"
#include "viewer/model/NumberText.h"
#include "viewer/model/Translation.h"
#include "viewer/model/WayOutText.h"
#include "viewer/panels/FileDialog.h"

namespace fenestra::viewer {

TransferFunctionEditor::TransferFunctionEditor(Document& document, const LookLibrary& library, QWidget* parent)
    : QWidget(parent),
      document_(document),
      library_(library),
      onlyContext_(new QLabel(tr("Point"))),
      targets_(new QComboBox),
      plot_(new TransferFunctionPlot(document)),
      value_(new QDoubleSpinBox),
      opacity_(new QDoubleSpinBox),
      colour_(new ColourButton(tr("Colour of the selected point"))),
      byValue_(new QCheckBox(tr("By value"))),
      presets_(new QToolButton),
      functionWhich_([this] {
        return askForFile(this, {tr("Open a transfer function"), tr("Transfer functions (*.json)")});
      }) {
  setUpControls();
  layOut();
  showTargets();
  showNode();
}

void TransferFunctionEditor::setUpControls() {
  targets_->setToolTip(tr("What the plot shows and edits"));
  targets_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  targets_->setMinimumContentsLength(5);
  targets_->view()->setTextElideMode(Qt::ElideNone);
  plot_->setToolTip(
      tr("Drag points, or the edges, top and inside of a trapezoid. Double-click adds a point; Delete removes it; the "
         "wheel enlarges. The key ? lists all."));
  value_->setToolTip(tr("Value of the selected point"));
  opacity_->setToolTip(tr("Opacity of 1 mm at the selected point"));
  opacity_->setRange(0.0, 100.0);
  opacity_->setDecimals(2);
  opacity_->setSuffix(tr(" %"));
  for (QDoubleSpinBox* box : {value_, opacity_}) {
    box->setKeyboardTracking(false);
    box->setAlignment(Qt::AlignRight);
    box->setMinimumWidth(60);
  }
  for (QWidget* control : std::initializer_list<QWidget*>{targets_, value_, opacity_, colour_})
    control->setAccessibleName(control->toolTip());
  byValue_->setToolTip(tr(
      "Shows this part of the focus by a function of the values, as the context is shown, in place of one colour and "
      "opacity"));
  presets_->setText(tr("From a preset"));
  presets_->setToolTip(tr("Takes the function of a preset for this part of the focus"));
  presets_->setPopupMode(QToolButton::InstantPopup);
  presets_->setFocusPolicy(Qt::StrongFocus);
  presets_->setMenu(new QMenu(this));
  connect(presets_->menu(), &QMenu::aboutToShow, this, &TransferFunctionEditor::fillPresets);
  connect(targets_, &QComboBox::activated, this,
          [this](int row) { plot_->setTarget(listed_.at(static_cast<std::size_t>(row))); });
  connect(byValue_, &QCheckBox::clicked, plot_, &TransferFunctionPlot::setByValue);
  connect(value_, &QDoubleSpinBox::valueChanged, plot_, &TransferFunctionPlot::setValue);
  connect(opacity_, &QDoubleSpinBox::valueChanged, plot_,
          [this](double percent) { plot_->setOpacity(0.01 * percent); });
  connect(colour_, &ColourButton::edited, plot_, &TransferFunctionPlot::setColour);
  connect(plot_, &TransferFunctionPlot::colourWanted, colour_, [this] {
    if (colour_->isEnabled()) colour_->click();
  });
  connect(&document_, &Document::volumeChanged, this, &TransferFunctionEditor::fitToVolume);
  connect(plot_, &TransferFunctionPlot::changed, this, [this] {
    showTargets();
    showNode();
  });
}

void TransferFunctionEditor::layOut() {
  auto* point = new QHBoxLayout;
  point->addWidget(onlyContext_);
  point->addWidget(targets_, 2);
  point->addWidget(value_, 3);
  point->addWidget(opacity_, 2);
  point->addWidget(colour_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(plot_);
  column->addLayout(point);
  auto* values = new QHBoxLayout;
  values->addWidget(byValue_, 1);
  values->addWidget(presets_);
  column->addLayout(values);
}

void TransferFunctionEditor::fillPresets() {
  QMenu* menu = presets_->menu();
  menu->clear();
  for (const io::TransferFunctionPreset& preset : io::transferFunctionPresets())
    menu->addAction(translated(preset.name), this, [this, id = preset.id] { takeFunction(id); });
  const auto& own = library_.entries();
  if (!own.empty()) menu->addSeparator();
  for (const LookLibrary::Entry& entry : own)
    menu->addAction(
        QString::fromStdString(entry.preset.name).replace(QLatin1Char('&'), QStringLiteral("&&")), this,
        [this, context = entry.preset.look.context] { showByValue(plot_->target(), document_, context.shifted()); });
  menu->addSeparator();
  menu->addAction(tr("From a file…"), this, [this] {
    if (const auto file = functionWhich_()) takeFunction(file->string());
  });
}

void TransferFunctionEditor::takeFunction(const std::string& presetOrPath) {
  try {
    showByValue(plot_->target(), document_, io::loadContextFunction(presetOrPath, *document_.scene().volume).function);
  } catch (const io::Error& error) {
    Q_EMIT failed(windowText(error));
  }
}

void TransferFunctionEditor::fitToVolume() {
  if (!document_.hasVolume()) return showNode();
  const Volume& volume = *document_.scene().volume;
  const double span = std::max(volume.range.high - volume.range.low, 1e-12);
  const QSignalBlocker quiet(value_);
  // Four significant digits of the range, and tenths of a Hounsfield unit.
  value_->setDecimals(std::clamp(static_cast<int>(std::ceil(4.0 - std::log10(span))), 0, 9));
  value_->setSingleStep(std::pow(10.0, std::floor(std::log10(span)) - 2.0));
  value_->setSuffix(unitSuffix(volume.unit));
  showNode();
}

void TransferFunctionEditor::showTargets() {
  const std::vector<FunctionTarget> targets = targetsOf(document_);
  const QSignalBlocker quiet(targets_);
  if (targets != listed_ || targets_->count() == 0) {
    listed_ = targets;
    targets_->clear();
    for (const FunctionTarget& target : listed_) targets_->addItem(nameOf(target, document_));
  }
  targets_->setVisible(listed_.size() > 1);
  onlyContext_->setVisible(listed_.size() == 1);
  const bool canBe = document_.hasVolume() && canBeByValue(plot_->target(), document_);
  byValue_->setVisible(canBe);
  presets_->setVisible(canBe);
  byValue_->setChecked(isByValue(plot_->target(), document_));
  for (std::size_t row = 0; row < listed_.size(); ++row) {
    targets_->setItemText(static_cast<int>(row), nameOf(listed_[row], document_));
    if (listed_[row] == plot_->target()) targets_->setCurrentIndex(static_cast<int>(row));
  }
}

void TransferFunctionEditor::showNode() {
  const std::optional<std::size_t> selected = plot_->selected();
  const FunctionTarget& target = plot_->target();
  const bool there = document_.hasVolume() && selected;
  value_->setEnabled(there && hasValues(target, document_));
  opacity_->setEnabled(there);
  colour_->setEnabled(there && hasColour(target, document_));
  if (!there) return;
  const TransferFunction function = plot_->function();
  const auto& nodes = function.nodes;
  const TransferFunction::Node& node = nodes[*selected];
  const QSignalBlocker quietValue(value_), quietOpacity(opacity_);
  // A node moves as far as its neighbours allow; a box's corner stays on its edge.
  const bool own = hasNodes(target, document_);
  const ValueRange all = own ? ValueRange{-1e9, 1e9} : document_.scene().volume->range;
  double low = all.low, high = all.high;
  if (own && *selected > 0) low = nodes[*selected - 1].value;
  if (own && *selected + 1 < nodes.size()) high = nodes[*selected + 1].value;
  if (!own && *selected >= 2) low = nodes.front().value;
  if (!own && *selected < 2) high = nodes.back().value;
  value_->setRange(std::min(low, node.value), std::max(high, node.value));
  value_->setValue(node.value);
  opacity_->setValue(100.0 * opacityFromExtinction(node.properties.extinction));
  colour_->setColour(node.properties.colour);
}

}  // namespace fenestra::viewer
