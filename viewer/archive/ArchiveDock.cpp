#include "viewer/archive/ArchiveDock.h"

#include <QDropEvent>
#include <QMainWindow>
#include <QMimeData>
#include <QTimer>

#include "viewer/archive/ArchiveModel.h"
#include "viewer/archive/ArchivePanel.h"
#include "viewer/archive/ArrivalView.h"
#include "viewer/archive/Retrievals.h"
#include "viewer/archive/SendDialog.h"
#include "viewer/archive/ServerDialog.h"
#include "viewer/bars/StudyDialogs.h"
#include "viewer/model/Workspace.h"
#include "viewer/panels/ScrollingPanel.h"

namespace fenestra::viewer {

ArchiveDock::ArchiveDock(QMainWindow& window, Workspace& workspace, LoadJob& opening, Open open)
    : QDockWidget(tr("Archive")), window_(window), workspace_(workspace), opening_(opening), open_(std::move(open)) {
  setObjectName(QStringLiteral("archiveDock"));
  setAllowedAreas(Qt::LeftDockWidgetArea | Qt::RightDockWidgetArea | Qt::BottomDockWidgetArea);
  window_.addDockWidget(Qt::LeftDockWidgetArea, this);
  hide();
  connect(this, &QDockWidget::visibilityChanged, this, [this](bool visible) {
    if (!visible || panel_) return;
    panel();
    // Unless a restored layout has given it more. From the event loop: the dock is being shown.
    constexpr int wanted = 370;  // a name with its date, type and number of images
    QTimer::singleShot(0, this, [this] {
      if (width() < wanted && !isFloating()) window_.resizeDocks({this}, {wanted}, Qt::Horizontal);
    });
  });
}

ArchiveDock::~ArchiveDock() {
  // Their workers use the servers.
  delete send_;
  delete arrivals_;
  delete panel_;
}

Archives& ArchiveDock::archives() {
  if (!archives_) {
    archives_ = std::make_unique<Archives>(workspace_.preferences);
    archives_->setWindow(&window_);
    archives_->setAskSecret([this](const ServerEntry& entry) { return askForSecret(entry, &window_); });
  }
  return *archives_;
}

Retrievals& ArchiveDock::retrievals() {
  if (!retrievals_) {
    retrievals_ = std::make_unique<Retrievals>(archives());
    connect(retrievals_.get(), &Retrievals::ready, this, [this](const auto& folder) { open_(folder); });
    arrivals_ = new ArrivalView(*retrievals_, opening_, *window_.centralWidget());
  }
  return *retrievals_;
}

ArchivePanel& ArchiveDock::panel() {
  if (panel_) return *panel_;
  panel_ = new ArchivePanel(archives(), retrievals());
  connect(panel_, &ArchivePanel::openRequested, this, &ArchiveDock::openRetrieved);
  const auto follow = [this] { panel_->setHidesPatient(workspace_.options.hidesPatient()); };
  connect(&workspace_.options, &ViewOptions::changed, panel_, follow);
  follow();
  auto* scroller = new ScrollingPanel;  // beside all other panels a low window leaves it little height
  scroller->setBody(panel_);
  setWidget(scroller);
  window_.installEventFilter(this);
  return *panel_;
}

ArrivalView* ArchiveDock::arrivals() const { return arrivals_; }

void ArchiveDock::openRetrieved(int retrieval) {
  const Retrievals::Item* item = retrievals().find(retrieval);
  if (!item) return;
  std::error_code unknown;
  if (std::filesystem::exists(item->folder, unknown)) return open_(item->folder);
  // The cache was cleared meanwhile.
  RetrievalOrder order = item->order;
  order.opens = true;
  retrievals().add(order);
}

void ArchiveDock::showSendDialog() {
  if (archives().servers().empty()) {
    show();
    raise();
    return;
  }
  if (!send_) {
    send_ = new SendDialog(archives(), workspace_.document, &window_);
    send_->setAttribute(Qt::WA_DeleteOnClose);
    markAsStudyDialog(*send_);
  }
  send_->QDialog::show();
  send_->raise();
  send_->activateWindow();
}

bool ArchiveDock::eventFilter(QObject* watched, QEvent* event) {
  const QEvent::Type type = event->type();
  if (watched != &window_ || (type != QEvent::DragEnter && type != QEvent::DragMove && type != QEvent::Drop))
    return QDockWidget::eventFilter(watched, event);
  auto* drop = static_cast<QDropEvent*>(event);
  if (!drop->mimeData()->hasFormat(QLatin1String(ArchiveModel::dragType)))
    return QDockWidget::eventFilter(watched, event);
  const bool isOnViews = window_.centralWidget()->geometry().contains(drop->position().toPoint());
  if (type == QEvent::DragEnter || isOnViews)
    drop->acceptProposedAction();
  else
    drop->ignore();
  // From the event loop: opening may ask a question, and the drag has to end first.
  if (type == QEvent::Drop && isOnViews) QTimer::singleShot(0, panel_, [this] { panel_->retrieveSelected(true); });
  return true;
}

}  // namespace fenestra::viewer
