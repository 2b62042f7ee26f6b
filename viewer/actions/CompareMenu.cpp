// A second study beside the first: opening it, and the link between the two.

#include <memory>
#include <utility>

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QScreen>

#include "viewer/actions/Actions.h"
#include "viewer/files/FileOpener.h"
#include "viewer/model/StudyLink.h"

namespace fenestra::viewer {

void Actions::addOpenBeside(QMenu& menu) {
  QMenu* beside = menu.addMenu(tr("Open besi&de"));
  beside->setObjectName(QStringLiteral("openBeside"));
  beside->addAction(
      volumeAction(tr("&Folder…"), QKeySequence(tr("Ctrl+Shift+B")), [this] { targets_.files.chooseFolderBeside(); }));
  beside->addAction(
      volumeAction(tr("F&ile…"), QKeySequence(tr("Ctrl+B")), [this] { targets_.files.chooseFileBeside(); }));
}

void Actions::addSidePanels(QMenu& menu) {
  StudyLink& link = beside_.link;
  auto hidden = std::make_shared<QList<QDockWidget*>>();
  QAction* panels = toggle(tr("&Panels"), QKeySequence(tr("F9")), true, [this, hidden](bool on) {
    if (on) {
      for (QDockWidget* dock : std::as_const(*hidden)) dock->show();
      hidden->clear();
      return;
    }
    for (QDockWidget* dock : targets_.window.findChildren<QDockWidget*>())
      if (!dock->isHidden()) {
        *hidden << dock;
        dock->hide();
      }
  });
  menu.addAction(panels);
  connect(&link, &StudyLink::changed, panels, [this, &link, panels] {
    if (link.isCompared() == panels->isEnabled()) return;
    panels->setEnabled(link.isCompared());
    // Half of a usual screen has no room for panels beside five views.
    constexpr int leastWidth = 1200;  // device-independent pixels
    panels->setChecked(!link.isCompared() || targets_.window.screen()->availableSize().width() / 2 >= leastWidth);
  });
  panels->setEnabled(false);
}

void Actions::makeCompareMenu(QMenu& menu) {
  StudyLink& link = beside_.link;
  const int side = beside_.side;
  QMenu* both = menu.addMenu(tr("T&wo studies"));
  both->setObjectName(QStringLiteral("twoStudies"));
  QAction* linked = toggle(tr("&Link by patient position"), QKeySequence(tr("M")), false,
                           [&link, side](bool on) { link.setLinked(on, side); });
  linked->setObjectName(QStringLiteral("linkStudies"));
  QAction* match = action(tr("&Match points"), QKeySequence(tr("Shift+M")), [&link] { link.match(); });
  QAction* forget = action(tr("&Forget the pair of points"), {}, [&link, side] { link.forgetPair(side); });
  forget->setObjectName(QStringLiteral("forgetPair"));
  QAction* other = action(tr("&Other study"), QKeySequence(tr("F6")), [this] { beside_.showOther(); });
  both->addActions({linked, match, forget, other});
  addSidePanels(*both);
  const auto follow = [&link, linked, match, forget, other] {
    for (QAction* each : {linked, other}) each->setEnabled(link.isCompared());
    linked->setChecked(link.isLinked());
    match->setEnabled(link.isCompared() && !link.isLinked());
    forget->setEnabled(link.isMatched());
  };
  connect(&link, &StudyLink::changed, both, follow);
  follow();
}

}  // namespace fenestra::viewer
