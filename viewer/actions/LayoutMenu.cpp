// The View menu's layouts: the ready ones with a small picture each, and the user's own.

#include <algorithm>
#include <cstddef>

#include <QAction>
#include <QActionGroup>
#include <QInputDialog>
#include <QMainWindow>
#include <QPainter>

#include "viewer/actions/Actions.h"
#include "viewer/model/Workspace.h"
#include "viewer/views/ViewArea.h"

namespace fenestra::viewer {
namespace {

constexpr int layoutIconSide = 16;  ///< device-independent pixels, as the style's small icons

/// The views as boxes, the 3-D ones filled; an arrangement of null is one view alone. One colour that shows on both
/// themes, because a pixmap does not follow a change of theme.
QIcon layoutIcon(const Arrangement* arrangement) {
  constexpr int density = 4;  // sharp on every screen, and small enough not to matter
  QPixmap picture(layoutIconSide * density, layoutIconSide * density);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.scale(density, density);
  const QColor colour(110, 150, 190);
  painter.setPen(QPen(colour, 1.0));
  const auto box = [&](const QRectF& area, bool filled) {
    const QRectF inner = area.adjusted(0.75, 0.75, -0.75, -0.75);
    if (filled) painter.fillRect(inner, colour);
    painter.drawRect(inner);
  };
  QRectF rest(0.0, 1.0, layoutIconSide, layoutIconSide - 2.0);
  if (!arrangement) {
    box(rest, false);
    return picture;
  }
  const bool rows = arrangement->groupsLie == Qt::Vertical;
  for (std::size_t group = 0; group < arrangement->groups.size(); ++group) {
    QRectF area = rest;
    const double share = 0.01 * arrangement->shares[group];
    if (rows)
      area.setHeight(share * (layoutIconSide - 2.0));
    else
      area.setWidth(share * layoutIconSide);
    if (rows)
      rest.setTop(area.bottom());
    else
      rest.setLeft(area.right());
    const auto& views = arrangement->groups[group];
    const auto count = std::count_if(views.begin(), views.end(), [](const char* each) { return each != nullptr; });
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      const double from = static_cast<double>(i) / static_cast<double>(count), size = 1.0 / static_cast<double>(count);
      const QRectF part =
          rows ? QRectF(area.left() + from * area.width(), area.top(), size * area.width(), area.height())
               : QRectF(area.left(), area.top() + from * area.height(), area.width(), size * area.height());
      box(part, views[static_cast<std::size_t>(i)][0] == 'C');
    }
  }
  return picture;
}

}  // namespace

void Actions::makeLayoutMenu(QMenu& menu) {
  ViewArea& views = targets_.views;
  QMenu* layouts = menu.addMenu(tr("Layo&ut of the views"));
  auto* group = new QActionGroup(layouts);
  int key = 1;
  const auto add = [&](const QString& text, const Arrangement* arrangement, std::function<void()> does) {
    QAction* entry = action(text, QKeySequence(QStringLiteral("Ctrl+%1").arg(key++)), std::move(does));
    entry->setIcon(layoutIcon(arrangement));
    entry->setIconVisibleInMenu(true);
    entry->setCheckable(true);
    group->addAction(entry);
    layouts->addAction(entry);
    const auto show = [entry, arrangement, &views] {
      entry->setChecked(arrangement ? !views.isMaximised() && &views.arrangement() == arrangement
                                    : views.isMaximised());
    };
    connect(&views, &ViewArea::arranged, entry, show);
    connect(entry, &QAction::triggered, entry, show);
    show();
  };
  const auto addReady = [&](const Arrangement& each) {
    add(QCoreApplication::translate("ViewArea", each.name), &each, [&views, &each] { views.arrange(each); });
  };
  addReady(arrangements().front());
  add(tr("&One view, the active one"), nullptr, [&views] {
    if (!views.isMaximised()) views.toggleMaximised(views.activeView());
  });
  for (const Arrangement& each : arrangements().subspan(1)) addReady(each);

  layouts->addSeparator();
  addOwnLayouts(*layouts);
  menu.addAction(action(tr("&Next view"), QKeySequence(tr("N")), [&views] { views.showNeighbour(1); }));
  menu.addAction(action(tr("Previous view"), QKeySequence(tr("Shift+N")), [&views] { views.showNeighbour(-1); }));
}

void Actions::addOwnLayouts(QMenu& layouts) {
  QAction* save = layouts.addAction(tr("&Keep this layout…"));
  save->setObjectName(QStringLiteral("keepLayout"));
  QMenu* forget = layouts.addMenu(tr("Forget"));
  layouts.addSeparator();
  ViewArea& views = targets_.views;
  Preferences& preferences = targets_.workspace.preferences;
  auto* shown = new QActionGroup(&layouts);
  shown->setExclusive(false);
  // Made anew whenever the list changes; what was triggered lives until its event has ended.
  const auto fill = [this, &layouts, &views, &preferences, forget, shown] {
    for (QAction* old : shown->actions() + forget->actions()) old->deleteLater();
    forget->clear();
    const QVariantMap own = preferences.ownLayouts();
    for (auto each = own.begin(); each != own.end(); ++each) {
      QAction* entry = shown->addAction(QString(each.key()).replace(QLatin1Char('&'), QStringLiteral("&&")));
      layouts.addAction(entry);
      connect(entry, &QAction::triggered, this, [&views, layout = each->toByteArray()] {
        views.showAll();
        views.restoreLayout(layout);
      });
      QAction* drop = forget->addAction(entry->text());
      connect(drop, &QAction::triggered, this, [&preferences, name = each.key()] {
        QVariantMap others = preferences.ownLayouts();
        others.remove(name);
        preferences.setOwnLayouts(others);
      });
    }
    forget->setEnabled(!own.isEmpty());
  };
  connect(&preferences, &Preferences::ownChanged, this, fill);
  connect(save, &QAction::triggered, this, [this, &views, &preferences] {
    const QString name = QInputDialog::getText(&targets_.window, tr("Keep this layout"), tr("Name")).trimmed();
    if (name.isEmpty()) return;
    QVariantMap own = preferences.ownLayouts();
    own.insert(name, views.saveLayout());
    preferences.setOwnLayouts(own);
  });
  fill();
}

}  // namespace fenestra::viewer
