#include "viewer/actions/Actions.h"

#include <QAction>
#include <QMainWindow>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include "viewer/dialogs/Dialogs.h"
#include "viewer/exports/PictureExports.h"
#include "viewer/exports/Verification.h"
#include "viewer/guide/Guide.h"
#include "viewer/guide/Tour.h"
#include "viewer/jobs/RegionGrower.h"
#include "viewer/model/Workspace.h"
#include "viewer/views/ViewArea.h"

namespace fenestra::viewer {

Actions::Actions(const Targets& targets, const Beside& beside)
    : QObject(&targets.window),
      targets_(targets),
      beside_(beside),
      viewCommands_(targets_.workspace, targets_.views),
      cine_(targets_.workspace.cursor) {
  makeFileMenu();
  makeEditMenu();
  makeViewMenu();
  makeWindowLevelMenu();
  makeMeasureMenu();
  makeFocusMenu();
  makeHelpMenu();
  keys_ = std::make_unique<KeyBindings>(*targets_.window.menuBar(), targets_.workspace.preferences);

  QToolBar* bar = targets_.window.addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("tools"));
  bar->setMovable(false);
  bar->setIconSize({18, 18});
  for (const QList<QAction*>& group : tools_) {
    if (!bar->actions().isEmpty()) bar->addSeparator();
    bar->addActions(group);
  }
  for (QToolButton* button : bar->findChildren<QToolButton*>()) button->setFocusPolicy(Qt::TabFocus);
  connect(&targets_.workspace.document, &Document::volumeChanged, this, [this] {
    for (QAction* each : needVolume_) each->setEnabled(targets_.workspace.document.hasVolume());
  });
}

QAction* Actions::action(const QString& text, const QKeySequence& keys, std::function<void()> does) {
  auto* made = new QAction(text, this);
  if (!keys.isEmpty()) {
    made->setShortcut(keys);
    made->setToolTip(QStringLiteral("%1 (%2)").arg(QString(text).remove(QLatin1Char('&')).remove(QStringLiteral("…")),
                                                   keys.toString(QKeySequence::NativeText)));
  }
  connect(made, &QAction::triggered, this, std::move(does));
  return made;
}

void Actions::addKey(QAction& action, const QKeySequence& keys) { action.setShortcuts(action.shortcuts() << keys); }

QAction* Actions::volumeAction(const QString& text, const QKeySequence& keys, std::function<void()> does) {
  QAction* made = action(text, keys, std::move(does));
  made->setEnabled(false);
  needVolume_ << made;
  return made;
}

QAction* Actions::toggle(const QString& text, const QKeySequence& keys, bool on, std::function<void(bool)> does) {
  auto* made = new QAction(text, this);
  made->setCheckable(true);
  made->setChecked(on);
  made->setShortcut(keys);
  if (!keys.isEmpty())
    made->setToolTip(
        QStringLiteral("%1 (%2)").arg(QString(text).remove(QLatin1Char('&')), keys.toString(QKeySequence::NativeText)));
  connect(made, &QAction::toggled, this, std::move(does));
  return made;
}

QAction* Actions::preferenceToggle(const QString& text, const QKeySequence& keys, Preference which) {
  Preferences& preferences = targets_.workspace.preferences;
  QAction* made =
      toggle(text, keys, preferences.isOn(which), [&preferences, which](bool on) { preferences.set(which, on); });
  connect(&preferences, &Preferences::changed, made,
          [&preferences, made, which] { made->setChecked(preferences.isOn(which)); });
  return made;
}

void Actions::makeHelpMenu() {
  QMenu* menu = targets_.window.menuBar()->addMenu(tr("&Help"));
  menu->addAction(
      action(tr("&User guide"), QKeySequence(QKeySequence::HelpContents), [this] { targets_.guide.open(); }));
  QAction* tour = action(tr("Guided &tour"), {}, [this] { targets_.tour.start(); });
  tour->setObjectName(QStringLiteral("tour"));
  tour->setEnabled(targets_.tour.canStart());
  connect(&targets_.tour, &Tour::canStartChanged, tour, &QAction::setEnabled);
  menu->addAction(tour);
  menu->addAction(action(tr("&Keys and mouse"), QKeySequence(tr("?")),
                         [this] { showKeys(*targets_.window.menuBar(), &targets_.window); }));
  menu->addAction(action(tr("&About Fenestra"), {},
                         [this] { showAbout(targets_.gl, targets_.views.schedule(), &targets_.window); }));
  menu->actions().constLast()->setObjectName(QStringLiteral("about"));
}

void Actions::stop() {
  if (targets_.loader.job().isRunning())
    targets_.loader.job().cancel();
  else if (targets_.pictures.isBusy())
    targets_.pictures.cancel();
  else if (targets_.verification.isBusy())
    targets_.verification.cancel();
  else if (targets_.grower.isGrowing() || targets_.workspace.document.asksToOpen())
    targets_.grower.cancel();
  else if (targets_.workspace.placement.isBusy())
    targets_.workspace.placement.cancel();
  else if (!targets_.workspace.tool.putDown() && !targets_.workspace.path.stop() &&
           !targets_.workspace.measuring.stop() && !cine_.stop())
    targets_.views.showAll();
}

}  // namespace fenestra::viewer
