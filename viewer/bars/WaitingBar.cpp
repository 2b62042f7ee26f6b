#include "viewer/bars/WaitingBar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "viewer/views/ViewArea.h"

namespace fenestra::viewer {

WaitingBar::WaitingBar(ViewArea& views, QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("waitingBar"));
  auto* text = new QLabel;
  auto* progress = new QProgressBar;
  progress->setRange(0, 0);  // compiling does not tell how far it is
  progress->setTextVisible(false);
  progress->setFixedWidth(90);
  auto* cancel = new QPushButton(tr("Cancel"));
  cancel->setToolTip(tr("Take back what the pictures do not show yet"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(text);
  row->addWidget(progress);
  row->addWidget(cancel);
  hide();
  const auto tell = [this, text] { text->setText(tr("Preparing the picture, %1 s").arg(since_.elapsed() / 1000)); };
  second_.setInterval(1000);
  connect(&second_, &QTimer::timeout, this, tell);
  connect(cancel, &QPushButton::clicked, &views, &ViewArea::takeBackWhatIsAwaited);
  connect(&views, &ViewArea::lateChanged, this, [this, tell, &views] {
    const bool waits = views.isPreparing();
    if (waits == second_.isActive()) return;
    if (waits) {
      since_.start();
      second_.start();
      tell();
    } else {
      second_.stop();
    }
    setVisible(waits);
  });
}

}  // namespace fenestra::viewer
