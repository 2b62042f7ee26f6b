#include "viewer/panels/CamerasPanel.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "viewer/model/Document.h"
#include "viewer/model/PlacementController.h"
#include "viewer/panels/SphereMap.h"

namespace fenestra::viewer {

CamerasPanel::CamerasPanel(Document& document, ViewLink& cameras, PlacementController& placement, QWidget* parent)
    : ScrollingPanel(parent),
      placement_(placement),
      place_(new QPushButton(tr("Place cameras"))),
      cancel_(new QPushButton(tr("Cancel"))),
      progress_(new QProgressBar),
      share_(new QLabel),
      note_(new QLabel),
      best_(new BestViews(document, cameras, placement)),
      map_(new SphereMap(cameras, placement)),
      form_(new PlacementForm(placement)) {
  setBody(makeBody());
  connect(place_, &QPushButton::clicked, &placement, &PlacementController::place);
  connect(cancel_, &QPushButton::clicked, &placement, &PlacementController::cancel);
  connect(map_, &SphereMap::clicked, &placement, &PlacementController::goTo);
  connect(&placement, &PlacementController::progressed, this,
          [this](double fraction) { progress_->setValue(static_cast<int>(100.0 * fraction)); });
  connect(&placement, &PlacementController::changed, this, &CamerasPanel::show);
  connect(&cameras, &ViewLink::changed, this, &CamerasPanel::showShare);
  connect(&document, &Document::volumeChanged, this, &CamerasPanel::show);
  show();
}

QWidget* CamerasPanel::makeBody() {
  place_->setToolTip(tr("Look for the best view of the focus and the one that complements it (F5)"));
  progress_->setRange(0, 100);
  progress_->setTextVisible(false);
  share_->setObjectName(QStringLiteral("share"));
  note_->setWordWrap(true);
  auto* top = new QHBoxLayout;
  top->addWidget(place_, 1);
  top->addWidget(progress_, 1);
  top->addWidget(cancel_);
  auto* body = new QWidget;
  auto* column = new QVBoxLayout(body);
  column->addLayout(top);
  column->addWidget(share_);
  column->addWidget(note_);
  column->addWidget(best_);
  column->addWidget(map_);
  column->addWidget(form_);
  column->addStretch();
  return body;
}

int CamerasPanel::usefulHeight() const { return heightThrough(*map_); }

void CamerasPanel::show() {
  const bool measuring = placement_.isMeasuring();
  place_->setEnabled(placement_.canPlace());
  place_->setVisible(!measuring);
  progress_->setVisible(measuring);
  cancel_->setVisible(measuring);
  if (measuring) progress_->setValue(static_cast<int>(100.0 * placement_.progress()));
  note_->setText(placement_.note());
  note_->setVisible(!placement_.note().isEmpty());
  showShare();
}

void CamerasPanel::showShare() {
  if (const std::optional<double> share = placement_.share())
    share_->setText(tr("The two views see <b>%1 %</b> of the focus's surface").arg(100.0 * *share, 0, 'f', 0));
  else if (!placement_.hasBackend())
    share_->setText(tr("Needs the 3-D views"));
  else if (placement_.isBusy())
    share_->setText(tr("Looking at the focus from all sides…"));
  else if (placement_.settings().byPick)
    share_->setText(tr("Click a structure on a slice"));
  else
    share_->setText(placement_.canPlace() ? tr("Not placed yet for this focus") : tr("Choose a focus first"));
}

}  // namespace fenestra::viewer
