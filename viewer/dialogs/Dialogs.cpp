#include "viewer/dialogs/Dialogs.h"

#include <functional>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "viewer/dialogs/Gestures.h"

namespace fenestra::viewer {
namespace {

struct DialogsWords {
  Q_DECLARE_TR_FUNCTIONS(Dialogs)
};

}  // namespace

QList<MenuKey> menuKeys(const QMenuBar& menus) {
  QList<MenuKey> keys;
  const std::function<void(const QList<QAction*>&, const QString&)> add = [&](const QList<QAction*>& actions,
                                                                              const QString& menu) {
    for (const QAction* action : actions) {
      const QString text = QString(action->text()).remove(QLatin1Char('&')).remove(QStringLiteral("…"));
      if (action->menu())
        add(action->menu()->actions(), menu.isEmpty() ? text : menu);
      else
        for (const QKeySequence& shortcut : action->shortcuts())
          keys << MenuKey{menu, shortcut.toString(QKeySequence::NativeText), text};
    }
  };
  add(menus.actions(), {});
  return keys;
}

QString keysHtml(const QMenuBar& menus) {
  QString html = QStringLiteral("<table cellspacing='0' cellpadding='3'>"), group;
  const auto line = [&](const QString& where, const QString& keys, const QString& meaning) {
    if (where != group)
      html += QStringLiteral("<tr><td colspan='2'><br><b>%1</b></td></tr>").arg(where.toHtmlEscaped());
    group = where;
    html += QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
                .arg(keys.toHtmlEscaped(), meaning.toHtmlEscaped());
  };
  for (const Gesture& each : gestures)
    line(DialogsWords::tr(each.where), DialogsWords::tr(each.gesture), DialogsWords::tr(each.meaning));
  for (const MenuKey& each : menuKeys(menus)) line(DialogsWords::tr("Menu: %1").arg(each.menu), each.keys, each.text);
  return html + QStringLiteral("</table>");
}

QString keysPageHtml(const QMenuBar& menus) {
  return QStringLiteral("<h1>%1</h1><p>%2</p>")
             .arg(DialogsWords::tr("Keys and mouse"),
                  DialogsWords::tr("What the mouse does in each view, then the keys of the menus.")) +
         keysHtml(menus);
}

void showKeys(const QMenuBar& menus, QWidget* parent) {
  QDialog dialog(parent);
  dialog.setWindowTitle(DialogsWords::tr("Keys and mouse"));
  auto* text = new QTextBrowser;
  text->setHtml(keysHtml(menus));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  auto* column = new QVBoxLayout(&dialog);
  column->addWidget(text);
  column->addWidget(buttons);
  dialog.resize(620, 680);
  dialog.exec();
}

void showAbout(const GlSupport& gl, std::optional<Schedule> schedule, QWidget* parent) {
  QString views = gl.available ? gl.renderer.toHtmlEscaped() : DialogsWords::tr("not available");
  if (schedule)
    views += DialogsWords::tr(" (shader schedule: %1)").arg(QString::fromStdString(std::string(nameOf(*schedule))));
  QMessageBox::about(
      parent, DialogsWords::tr("About Fenestra"),
      DialogsWords::tr(
          "<h3>Fenestra %1</h3>"
          "<p>A medical volume viewer that opens an adaptive cutaway around the structure you want to see.</p>"
          "<p><b>Not for diagnostic use.</b></p>"
          "<p>Free software under the GNU General Public License, version 3 or later. It comes with no warranty.</p>"
          "<p>3-D views: %2</p>")
          .arg(QApplication::applicationVersion(), views));
}

}  // namespace fenestra::viewer
