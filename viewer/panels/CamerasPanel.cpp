#include "viewer/panels/CamerasPanel.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "viewer/model/Document.h"
#include "viewer/model/PlacementController.h"
#include "viewer/panels/SliderSpin.h"
#include "viewer/panels/SphereMap.h"

namespace fenestra::viewer {
namespace {

constexpr QSize thumbnailSize(62, 54);  ///< device-independent pixels
constexpr int firstMilliseconds = 300;  ///< before the first thumbnail: the views come first
constexpr int nextMilliseconds = 30;

struct WeightRow {
  const char *name, *meaning;
  double low, high, step;
  double placement::Weights::*member;
};
constexpr std::size_t mainWeights = 3;
const std::array<WeightRow, CamerasPanel::weightCount> weightRows{{
    {QT_TRANSLATE_NOOP("CamerasPanel", "Depth"),
     QT_TRANSLATE_NOOP("CamerasPanel", "How deep the focus lies; below 0 prefers views with little before it"), -2.0,
     2.0, 0.05, &placement::Weights::visibility},
    {QT_TRANSLATE_NOOP("CamerasPanel", "Size"), QT_TRANSLATE_NOOP("CamerasPanel", "How much of the picture it covers"),
     0.0, 16.0, 0.1, &placement::Weights::coverage},
    {QT_TRANSLATE_NOOP("CamerasPanel", "Centring"), QT_TRANSLATE_NOOP("CamerasPanel", "How near to the middle it is"),
     0.0, 2.0, 0.05, &placement::Weights::location},
    {QT_TRANSLATE_NOOP("CamerasPanel", "Entropy"),
     QT_TRANSLATE_NOOP("CamerasPanel", "How much of its surface is seen, evenly"), 0.0, 2.0, 0.05,
     &placement::Weights::entropy},
    {QT_TRANSLATE_NOOP("CamerasPanel", "Typical"),
     QT_TRANSLATE_NOOP("CamerasPanel", "Viewpoint mutual information: how typical the view is"), 0.0, 2.0, 0.05,
     &placement::Weights::mutualInformation},
    {QT_TRANSLATE_NOOP("CamerasPanel", "Stable"),
     QT_TRANSLATE_NOOP("CamerasPanel", "How little changes when the camera moves a bit"), 0.0, 2.0, 0.05,
     &placement::Weights::stability},
    {QT_TRANSLATE_NOOP("CamerasPanel", "Standard"),
     QT_TRANSLATE_NOOP("CamerasPanel", "How near the view is to anterior, left, superior …"), 0.0, 2.0, 0.05,
     &placement::Weights::orientation},
}};

}  // namespace

CamerasPanel::CamerasPanel(Document& document, ViewLink& cameras, PlacementController& placement, QWidget* parent)
    : ScrollingPanel(parent),
      cameras_(cameras),
      placement_(placement),
      place_(new QPushButton(tr("Place cameras"))),
      cancel_(new QPushButton(tr("Cancel"))),
      progress_(new QProgressBar),
      share_(new QLabel),
      note_(new QLabel),
      sampling_(new QComboBox),
      region_(new QComboBox),
      streamHalfWidth_(new SliderSpin(1.0, 45.0, 1.0)),
      shareWeight_(new SliderSpin(0.0, 1.0, 0.05)),
      joint_(new QCheckBox(tr("Both at once"))),
      follow_(new QCheckBox(tr("C2 follows C1"))),
      automatic_(new QCheckBox(tr("Place when a focus is chosen"))),
      map_(new SphereMap(cameras, placement)) {
  place_->setToolTip(tr("Look for the best view of the focus and the one that complements it (F5)"));
  progress_->setRange(0, 100);
  progress_->setTextVisible(false);
  share_->setObjectName(QStringLiteral("share"));
  note_->setWordWrap(true);
  for (const int count : {48, 108, 192, 300, 588, 1200}) sampling_->addItem(tr("%1 views").arg(count), count);
  sampling_->addItem(tr("refined"), 0);
  sampling_->setToolTip(tr("Viewpoints tried, evenly over the sphere; refined: more and more finely where it counts"));
  region_->addItem(tr("Semi-sphere"), static_cast<int>(placement::Region::SemiSphere));
  region_->addItem(tr("Stream"), static_cast<int>(placement::Region::Stream));
  region_->setToolTip(tr("Where C2 may be: beside C1 on one side, or in a band all around at right angles to it"));
  streamHalfWidth_->setSuffix(tr("°"));
  streamHalfWidth_->setToolTip(tr("δ: how far C2 may leave the right angle to C1"));
  joint_->setToolTip(tr("Choose the pair that together sees most of the focus's surface"));
  shareWeight_->setToolTip(tr("1: only the share of the surface counts; 0: only the quality of the two views"));
  follow_->setToolTip(tr("When C1 is turned, C2 goes to the best view of its region"));

  auto* body = new QWidget;
  auto* column = new QVBoxLayout(body);
  auto* top = new QHBoxLayout;
  top->addWidget(place_, 1);
  top->addWidget(progress_, 1);
  top->addWidget(cancel_);
  column->addLayout(top);
  column->addWidget(share_);
  column->addWidget(note_);
  auto* best = new QHBoxLayout;
  best->setSpacing(4);
  for (QToolButton*& button : thumbnails_) {
    button = new QToolButton;
    button->setObjectName(QStringLiteral("thumbnail"));
    button->setIconSize(thumbnailSize);
    button->setFixedSize(thumbnailSize + QSize(6, 6));
    button->setToolTip(tr("One of the best viewpoints; click to look from there with C1"));
    best->addWidget(button);
  }
  best->addStretch();
  column->addLayout(best);
  column->addWidget(map_);
  column->addWidget(automatic_);
  column->addWidget(follow_);

  auto* form = new QFormLayout;
  form->addRow(tr("Tried"), sampling_);
  form->addRow(tr("C2 in"), region_);
  form->addRow(tr("δ"), streamHalfWidth_);
  form->addRow(joint_);
  form->addRow(tr("By share"), shareWeight_);
  auto* more = new QToolButton;
  more->setText(tr("More weights"));
  more->setCheckable(true);
  more->setAutoRaise(true);
  more->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  more->setArrowType(Qt::RightArrow);
  auto* further = new QWidget;
  auto* furtherForm = new QFormLayout(further);
  furtherForm->setContentsMargins(0, 0, 0, 0);
  for (std::size_t i = 0; i < weightRows.size(); ++i) {
    const WeightRow& row = weightRows[i];
    weights_[i] = new SliderSpin(row.low, row.high, row.step);
    weights_[i]->setToolTip(tr(row.meaning));
    (i < mainWeights ? form : furtherForm)->addRow(tr(row.name), weights_[i]);
  }
  form->addRow(more);
  column->addLayout(form);
  column->addWidget(further);
  column->addStretch();
  further->hide();
  setBody(body);

  const auto edit = [this](auto change) {
    PlacementSettings settings = placement_.settings();
    change(settings);
    placement_.setSettings(settings);
    Q_EMIT edited(change);
  };
  connect(place_, &QPushButton::clicked, &placement, &PlacementController::place);
  connect(cancel_, &QPushButton::clicked, &placement, &PlacementController::cancel);
  connect(more, &QToolButton::toggled, this, [more, further](bool on) {
    more->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
    further->setVisible(on);
  });
  connect(sampling_, &QComboBox::activated, this, [this, edit] {
    edit([count = sampling_->currentData().toInt()](PlacementSettings& settings) {
      settings.sampling.refined = count == 0;
      if (count > 0) settings.sampling.count = count;
    });
  });
  connect(region_, &QComboBox::activated, this, [this, edit] {
    edit([region = static_cast<placement::Region>(region_->currentData().toInt())](PlacementSettings& settings) {
      settings.options.region = region;
    });
  });
  connect(streamHalfWidth_, &SliderSpin::edited, this, [edit](double degrees) {
    edit([degrees](PlacementSettings& settings) { settings.options.streamHalfWidth = degrees; });
  });
  connect(shareWeight_, &SliderSpin::edited, this, [edit](double weight) {
    edit([weight](PlacementSettings& settings) { settings.options.shareWeight = weight; });
  });
  const auto connectBox = [this, edit](QCheckBox* box, bool PlacementSettings::*member) {
    connect(box, &QCheckBox::clicked, this,
            [edit, member](bool on) { edit([=](PlacementSettings& settings) { settings.*member = on; }); });
  };
  connectBox(joint_, &PlacementSettings::joint);
  connectBox(follow_, &PlacementSettings::follow);
  connectBox(automatic_, &PlacementSettings::automatic);
  for (std::size_t i = 0; i < weightRows.size(); ++i)
    connect(weights_[i], &SliderSpin::edited, this, [edit, member = weightRows[i].member](double value) {
      edit([=](PlacementSettings& settings) { settings.options.weights.*member = value; });
    });
  for (std::size_t rank = 0; rank < thumbnailCount; ++rank)
    connect(thumbnails_[rank], &QToolButton::clicked, this, [this, rank] {
      if (const auto* measured = placement_.measured(); measured && rank < best_.size())
        placement_.goTo(measured->candidates[best_[rank]].direction);
    });
  connect(map_, &SphereMap::clicked, &placement, &PlacementController::goTo);
  connect(&placement, &PlacementController::progressed, this,
          [this](double fraction) { progress_->setValue(static_cast<int>(100.0 * fraction)); });
  connect(&placement, &PlacementController::measuredFocus, this, [this] { best_.clear(); });
  connect(&placement, &PlacementController::changed, this, &CamerasPanel::show);
  connect(&cameras, &ViewLink::changed, this, &CamerasPanel::showShare);
  connect(&document, &Document::volumeChanged, this, &CamerasPanel::show);
  connect(&document, &Document::transferFunctionChanged, this, &CamerasPanel::drawBest);
  connect(&document, &Document::cutawayChanged, this, &CamerasPanel::drawBest);
  connect(&drawing_, &QTimer::timeout, this, &CamerasPanel::drawNext);
  show();
}

void CamerasPanel::show() {
  const PlacementSettings& settings = placement_.settings();
  const bool measuring = placement_.isMeasuring();
  place_->setEnabled(placement_.canPlace());
  place_->setVisible(!measuring);
  progress_->setVisible(measuring);
  cancel_->setVisible(measuring);
  if (measuring) progress_->setValue(static_cast<int>(100.0 * placement_.progress()));
  note_->setText(placement_.note());
  note_->setVisible(!placement_.note().isEmpty());
  sampling_->setCurrentIndex(sampling_->findData(settings.sampling.refined ? 0 : settings.sampling.count));
  region_->setCurrentIndex(region_->findData(static_cast<int>(settings.options.region)));
  streamHalfWidth_->setValue(settings.options.streamHalfWidth);
  streamHalfWidth_->setEnabled(settings.options.region == placement::Region::Stream);
  joint_->setChecked(settings.joint);
  shareWeight_->setValue(settings.options.shareWeight);
  shareWeight_->setEnabled(settings.joint);
  follow_->setChecked(settings.follow);
  automatic_->setChecked(settings.automatic);
  for (std::size_t i = 0; i < weightRows.size(); ++i)
    weights_[i]->setValue(settings.options.weights.*weightRows[i].member);
  showShare();
  listBest();
}

void CamerasPanel::showShare() {
  if (const std::optional<double> share = placement_.share())
    share_->setText(tr("The two views see <b>%1 %</b> of the focus's surface").arg(100.0 * *share, 0, 'f', 0));
  else if (!placement_.hasBackend())
    share_->setText(tr("Needs the 3-D views"));
  else if (placement_.isBusy())
    share_->setText(tr("Looking at the focus from all sides…"));
  else
    share_->setText(placement_.canPlace() ? tr("Not placed yet for this focus") : tr("Choose a focus first"));
}

void CamerasPanel::listBest() {
  const std::vector<std::size_t> best = placement_.best(thumbnailCount);
  if (best == best_ && !best.empty()) return;
  best_ = best;
  for (std::size_t rank = 0; rank < thumbnailCount; ++rank) {
    thumbnails_[rank]->setIcon({});
    thumbnails_[rank]->setEnabled(rank < best_.size());
  }
  drawBest();
}

void CamerasPanel::drawBest() {
  drawn_ = 0;
  if (isVisible() && !best_.empty())
    drawing_.start(firstMilliseconds);
  else
    drawing_.stop();
}

void CamerasPanel::drawNext() {
  if (cameras_.isFlying() || placement_.isBusy()) return;
  drawing_.setInterval(nextMilliseconds);
  if (!placement_.measured() || drawn_ >= best_.size()) {
    drawing_.stop();
    return;
  }
  const double ratio = devicePixelRatioF();
  try {
    QImage picture = placement_.picture(best_[drawn_], thumbnailSize * ratio);
    picture.setDevicePixelRatio(ratio);
    thumbnails_[drawn_]->setIcon(QPixmap::fromImage(picture));
  } catch (const std::exception&) {
    // The views say what is wrong with OpenGL; a viewpoint without a picture still takes a click.
    drawn_ = best_.size();
    return;
  }
  ++drawn_;
}

void CamerasPanel::showEvent(QShowEvent* event) {
  ScrollingPanel::showEvent(event);
  if (drawn_ < best_.size()) drawBest();
}

}  // namespace fenestra::viewer
