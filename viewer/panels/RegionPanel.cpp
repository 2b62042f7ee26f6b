#include "viewer/panels/RegionPanel.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "rendering/segmentation/LabelEdit.h"
#include "rendering/segmentation/RegionGrowing.h"
#include "viewer/model/Document.h"
#include "viewer/model/NumberText.h"
#include "viewer/model/RegionText.h"

namespace fenestra::viewer {
namespace {}  // namespace

RegionPanel::RegionPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      size_(new QLabel),
      facts_(new QLabel),
      open_(new QPushButton(tr("Open the 3-D views to it"))),
      plot_(new TolerancePlot(document)),
      slider_(new QSlider(Qt::Horizontal)),
      tolerance_(new QDoubleSpinBox),
      automatic_(new QToolButton),
      ball_(new QDoubleSpinBox),
      noBall_(new QToolButton),
      ballRow_(makeBallRow()),
      name_(new QLineEdit),
      colour_(new ColourButton(tr("Colour of the label"))),
      keep_(new QPushButton(tr("Keep"))) {
  setUpTolerance();
  auto* hint =
      new QLabel(tr("Shift+click adds to the region, Ctrl+click takes away. Shift+drag draws a ball around a "
                    "structure, which its region does not leave."));
  hint->setWordWrap(true);
  hint->setEnabled(false);

  facts_->setWordWrap(true);
  facts_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  connect(open_, &QPushButton::clicked, &document, &Document::openToRegion);

  auto* row = new QHBoxLayout;
  row->addWidget(slider_, 1);
  row->addWidget(tolerance_);
  row->addWidget(automatic_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(size_);
  column->addWidget(facts_);
  column->addWidget(open_);
  column->addWidget(plot_);
  column->addLayout(row);
  column->addWidget(ballRow_);
  column->addWidget(hint);
  column->addLayout(makeKeepRow());

  connect(ball_, &QDoubleSpinBox::valueChanged, &document, &Document::setBall);
  connect(noBall_, &QToolButton::clicked, this, [this] { document_.setBall(0.0); });
  connect(&document, &Document::focusChanged, this, &RegionPanel::showRegion);
  showRegion();
}

void RegionPanel::setUpTolerance() {
  slider_->setRange(1, segmentation::stepCount);
  slider_->setPageStep(8);
  slider_->setToolTip(tr("How far values may lie from those at the click (Alt+wheel over a picture, keys , and .)"));
  tolerance_->setKeyboardTracking(false);
  tolerance_->setAlignment(Qt::AlignRight);
  tolerance_->setToolTip(tr("Tolerance: how far values may lie below those at the click"));
  automatic_->setText(tr("Auto"));
  automatic_->setCheckable(true);
  automatic_->setObjectName(QStringLiteral("choice"));
  automatic_->setToolTip(tr("The tolerance is chosen from the plateaus"));
  History& history = document_.history();
  connect(slider_, &QSlider::sliderPressed, &history, &History::beginGesture);
  connect(slider_, &QSlider::sliderReleased, &history, &History::endGesture);
  connect(plot_, &TolerancePlot::dragBegun, &history, &History::beginGesture);
  connect(plot_, &TolerancePlot::dragEnded, &history, &History::endGesture);
  connect(slider_, &QSlider::valueChanged, this, &RegionPanel::setStep);
  connect(plot_, &TolerancePlot::edited, this, &RegionPanel::setStep);
  connect(tolerance_, &QDoubleSpinBox::valueChanged, this, [this](double value) { document_.setTolerance(value); });
  connect(automatic_, &QToolButton::clicked, this, [this](bool on) {
    document_.setTolerance(on || !document_.growth()
                               ? std::nullopt
                               : std::optional(document_.growth()->toleranceOf(document_.regionStep())));
  });
}

QWidget* RegionPanel::makeBallRow() {
  ball_->setRange(0.1, 10000.0);
  ball_->setDecimals(1);
  ball_->setSuffix(tr(" mm"));
  ball_->setKeyboardTracking(false);
  ball_->setAlignment(Qt::AlignRight);
  ball_->setToolTip(tr("Radius of the ball around the click, which the region does not leave"));
  noBall_->setText(tr("No ball"));
  noBall_->setToolTip(tr("Nothing bounds the region"));
  auto* ballRow = new QWidget;
  auto* row = new QHBoxLayout(ballRow);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new QLabel(tr("Within a ball of")), 1);
  row->addWidget(ball_);
  row->addWidget(noBall_);
  return ballRow;
}

QLayout* RegionPanel::makeKeepRow() {
  name_->setPlaceholderText(tr("Name of a label"));
  keep_->setToolTip(tr("Keep the region as a label of this study"));
  auto* row = new QHBoxLayout;
  row->addWidget(colour_);
  row->addWidget(name_, 1);
  row->addWidget(keep_);
  const auto keep = [this] {
    if (keep_->isEnabled()) Q_EMIT kept(name_->text(), chosenColour_);
  };
  connect(keep_, &QPushButton::clicked, this, keep);
  connect(name_, &QLineEdit::returnPressed, this, keep);
  connect(colour_, &ColourButton::edited, this, [this](glm::dvec3 colour) {
    chosenColour_ = colour;
    hasChosenColour_ = true;
    colour_->setColour(colour);
  });
  // Another label, another name and colour.
  connect(&document_, &Document::labelsChanged, this, [this] {
    name_->clear();
    hasChosenColour_ = false;
    showRegion();
  });
  return row;
}

void RegionPanel::setStep(int step) {
  if (const segmentation::Growth* growth = document_.growth()) document_.setTolerance(growth->toleranceOf(step));
}

void RegionPanel::showRegion() {
  setVisible(document_.region());
  keep_->setEnabled(document_.isWhole());
  if (!hasChosenColour_) chosenColour_ = defaultLabelColour(segmentation::freeLabel(document_.labels().get()));
  colour_->setColour(chosenColour_);
  const double radius = document_.region() ? document_.region()->ball : 0.0;
  ballRow_->setVisible(radius > 0.0);
  const QSignalBlocker quietBall(ball_);
  if (radius > 0.0) ball_->setValue(radius);
  showFacts();
  const bool grown = document_.growth();
  for (QWidget* each : std::initializer_list<QWidget*>{plot_, slider_, tolerance_, automatic_}) each->setEnabled(grown);
  if (grown)
    showNumbers();
  else
    size_->setText(tr("Region: growing…"));
}

void RegionPanel::showFacts() {
  const std::optional<segmentation::RegionFacts> facts = document_.regionFacts();
  facts_->setVisible(facts.has_value());
  open_->setVisible(document_.asksToOpen());
  if (!facts) return;
  QStringList sentences = regionSentences(*facts, document_.scene().volume->unit);
  const std::optional<Document::Doubt> doubt = document_.doubt();
  if (doubt == Document::Doubt::Share)
    sentences << tr("That is %1 % of the body: the 3-D views do not open to it by themselves.")
                     .arg(std::lround(100.0 * *document_.regionShareOfBody()));
  else if (doubt)
    sentences << tr("The 3-D views do not open to it by themselves.");
  facts_->setText(sentences.join(QLatin1Char(' ')));
}

void RegionPanel::showNumbers() {
  const segmentation::Growth& growth = *document_.growth();
  const int step = document_.regionStep();
  const double ml = document_.regionVolume() / mm3PerMl;
  size_->setText(document_.isWhole() ? tr("Region: %1").arg(volumeText(ml))
                                     : tr("Region: %1 so far…").arg(volumeText(ml)));
  const QSignalBlocker quietSlider(slider_), quietBox(tolerance_);
  slider_->setValue(step);
  const std::string& unit = document_.scene().volume->unit;
  // Two digits finer than the noise, so that a number typed is the number kept.
  tolerance_->setDecimals(std::clamp(static_cast<int>(std::ceil(2.0 - std::log10(growth.noise))), 0, 9));
  tolerance_->setSingleStep(growth.noise);
  tolerance_->setRange(
      0.0, std::max(growth.toleranceOf(segmentation::stepCount), document_.region()->tolerance.value_or(0.0)));
  tolerance_->setSuffix(unitSuffix(unit));
  tolerance_->setValue(document_.region()->tolerance.value_or(growth.toleranceOf(step)));
  automatic_->setChecked(!document_.region()->tolerance);
}

}  // namespace fenestra::viewer
