#include "viewer/panels/BestViews.h"

#include <exception>

#include <QHBoxLayout>

#include "viewer/model/Document.h"
#include "viewer/model/PlacementController.h"

namespace fenestra::viewer {
namespace {

constexpr QSize pictureSize(62, 54);    ///< device-independent pixels
constexpr int firstMilliseconds = 300;  ///< before the first picture: the views come first
constexpr int nextMilliseconds = 30;

}  // namespace

BestViews::BestViews(Document& document, ViewLink& cameras, PlacementController& placement, QWidget* parent)
    : QWidget(parent), cameras_(cameras), placement_(placement) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  for (std::size_t rank = 0; rank < count; ++rank) {
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("thumbnail"));
    button->setIconSize(pictureSize);
    button->setFixedSize(pictureSize + QSize(6, 6));
    button->setToolTip(tr("One of the best viewpoints; click to look from there with C1"));
    connect(button, &QToolButton::clicked, this, [this, rank] {
      if (const auto* measured = placement_.measured(); measured && rank < best_.size())
        placement_.goTo(measured->candidates[best_[rank]].direction);
    });
    row->addWidget(button);
    buttons_[rank] = button;
  }
  row->addStretch();
  connect(&placement, &PlacementController::measuredFocus, this, [this] { best_.clear(); });
  connect(&placement, &PlacementController::changed, this, &BestViews::list);
  connect(&document, &Document::volumeChanged, this, &BestViews::list);
  connect(&document, &Document::transferFunctionChanged, this, &BestViews::redraw);
  connect(&document, &Document::cutawayChanged, this, &BestViews::redraw);
  connect(&drawing_, &QTimer::timeout, this, &BestViews::drawNext);
  list();
}

void BestViews::list() {
  const std::vector<std::size_t> best = placement_.best(count);
  if (best == best_ && !best.empty()) return;
  best_ = best;
  for (std::size_t rank = 0; rank < count; ++rank) {
    buttons_[rank]->setIcon({});
    buttons_[rank]->setEnabled(rank < best_.size());
  }
  redraw();
}

void BestViews::redraw() {
  drawn_ = 0;
  if (isVisible() && !best_.empty())
    drawing_.start(firstMilliseconds);
  else
    drawing_.stop();
}

void BestViews::drawNext() {
  if (cameras_.isFlying() || placement_.isBusy()) return;
  drawing_.setInterval(nextMilliseconds);
  if (!placement_.measured() || drawn_ >= best_.size()) {
    drawing_.stop();
    return;
  }
  const double ratio = devicePixelRatioF();
  try {
    QImage picture = placement_.picture(best_[drawn_], pictureSize * ratio);
    picture.setDevicePixelRatio(ratio);
    buttons_[drawn_]->setIcon(QPixmap::fromImage(picture));
    ++drawn_;
  } catch (const std::exception&) {
    // The 3-D views say what is wrong with OpenGL; a viewpoint without a picture still takes a click.
    drawn_ = best_.size();
  }
}

void BestViews::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (drawn_ < best_.size()) redraw();
}

}  // namespace fenestra::viewer
