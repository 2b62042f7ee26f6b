#include "viewer/Dialogs.h"

#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QMessageBox>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace fenestra::viewer {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("Dialogs", text); }

}  // namespace

void showKeys(QWidget* parent) {
  struct Line {
    const char *keys, *meaning;
  };
  static constexpr Line lines[] = {
      {nullptr, QT_TRANSLATE_NOOP("Dialogs", "Slices")},
      {QT_TRANSLATE_NOOP("Dialogs", "Click"),
       QT_TRANSLATE_NOOP("Dialogs", "crosshair; the label there, or the region around the place, becomes the focus")},
      {QT_TRANSLATE_NOOP("Dialogs", "Ctrl+click"), QT_TRANSLATE_NOOP("Dialogs", "the label joins or leaves the focus")},
      {QT_TRANSLATE_NOOP("Dialogs", "Drag"),
       QT_TRANSLATE_NOOP("Dialogs", "window width (across) and level (up and down)")},
      {QT_TRANSLATE_NOOP("Dialogs", "Ctrl+double-click"), QT_TRANSLATE_NOOP("Dialogs", "window and level of the data")},
      {QT_TRANSLATE_NOOP("Dialogs", "Wheel, arrows, Page up/down"),
       QT_TRANSLATE_NOOP("Dialogs", "next and previous slices")},
      {nullptr, QT_TRANSLATE_NOOP("Dialogs", "3-D views")},
      {QT_TRANSLATE_NOOP("Dialogs", "Drag, arrows"), QT_TRANSLATE_NOOP("Dialogs", "rotate; the linked view follows")},
      {QT_TRANSLATE_NOOP("Dialogs", "Click"),
       QT_TRANSLATE_NOOP("Dialogs", "crosshair to what is seen there; its label or region becomes the focus")},
      {QT_TRANSLATE_NOOP("Dialogs", "Ctrl+click"), QT_TRANSLATE_NOOP("Dialogs", "its label joins or leaves the focus")},
      {QT_TRANSLATE_NOOP("Dialogs", "Wheel"), QT_TRANSLATE_NOOP("Dialogs", "zoom")},
      {QT_TRANSLATE_NOOP("Dialogs", "Shift+A P L R S I"),
       QT_TRANSLATE_NOOP("Dialogs", "look from anterior, posterior, left, right, superior, inferior")},
      {QT_TRANSLATE_NOOP("Dialogs", "F5"), QT_TRANSLATE_NOOP("Dialogs", "place both cameras for the focus")},
      {nullptr, QT_TRANSLATE_NOOP("Dialogs", "A grown region, in all views")},
      {QT_TRANSLATE_NOOP("Dialogs", "Shift+click, Ctrl+click"),
       QT_TRANSLATE_NOOP("Dialogs", "add what is there to the region; take it away")},
      {QT_TRANSLATE_NOOP("Dialogs", "Alt+wheel, , and ."), QT_TRANSLATE_NOOP("Dialogs", "tolerance")},
      {QT_TRANSLATE_NOOP("Dialogs", "Esc"), QT_TRANSLATE_NOOP("Dialogs", "give up a region that is being grown")},
      {QT_TRANSLATE_NOOP("Dialogs", "G"), QT_TRANSLATE_NOOP("Dialogs", "whether a click grows a region")},
      {nullptr, QT_TRANSLATE_NOOP("Dialogs", "Brush, in the 3-D views")},
      {QT_TRANSLATE_NOOP("Dialogs", "P"),
       QT_TRANSLATE_NOOP("Dialogs",
                         "activate the brush, which restores removed tissue; again (or Esc) deactivates it")},
      {QT_TRANSLATE_NOOP("Dialogs", "E"),
       QT_TRANSLATE_NOOP("Dialogs", "the opposite brush: open further, or strengthen the context's edges")},
      {QT_TRANSLATE_NOOP("Dialogs", "Drag"), QT_TRANSLATE_NOOP("Dialogs", "paint; Ctrl+drag still rotates")},
      {QT_TRANSLATE_NOOP("Dialogs", "[  ]"), QT_TRANSLATE_NOOP("Dialogs", "smaller, larger")},
      {QT_TRANSLATE_NOOP("Dialogs", "Shift+wheel, Shift+drag"),
       QT_TRANSLATE_NOOP("Dialogs", "depth, or by how much the context's edges change")},
      {nullptr, QT_TRANSLATE_NOOP("Dialogs", "All views")},
      {QT_TRANSLATE_NOOP("Dialogs", "Ctrl+Z, Ctrl+Shift+Z"), QT_TRANSLATE_NOOP("Dialogs", "undo, redo")},
      {QT_TRANSLATE_NOOP("Dialogs", "Middle drag"), QT_TRANSLATE_NOOP("Dialogs", "move the picture")},
      {QT_TRANSLATE_NOOP("Dialogs", "Right drag, Ctrl+wheel"), QT_TRANSLATE_NOOP("Dialogs", "zoom")},
      {QT_TRANSLATE_NOOP("Dialogs", "Right click"), QT_TRANSLATE_NOOP("Dialogs", "a menu for that place")},
      {QT_TRANSLATE_NOOP("Dialogs", "Shift+move"), QT_TRANSLATE_NOOP("Dialogs", "crosshair follows the mouse")},
      {QT_TRANSLATE_NOOP("Dialogs", "Double-click"),
       QT_TRANSLATE_NOOP("Dialogs", "show this view alone; Esc shows all")},
      {QT_TRANSLATE_NOOP("Dialogs", "R"), QT_TRANSLATE_NOOP("Dialogs", "reset the view; Ctrl+R all views")},
      {QT_TRANSLATE_NOOP("Dialogs", "Ctrl+S  Ctrl+Shift+S"),
       QT_TRANSLATE_NOOP("Dialogs", "save the session; save it as another file")},
      {QT_TRANSLATE_NOOP("Dialogs", "L"), QT_TRANSLATE_NOOP("Dialogs", "link the 3-D views")},
      {QT_TRANSLATE_NOOP("Dialogs", "C  O  T"), QT_TRANSLATE_NOOP("Dialogs", "crosshair, label overlay, corner text")},
      {QT_TRANSLATE_NOOP("Dialogs", "1"), QT_TRANSLATE_NOOP("Dialogs", "window and level of the data")},
      {QT_TRANSLATE_NOOP("Dialogs", "3 4 5 6 7"),
       QT_TRANSLATE_NOOP("Dialogs", "CT window: brain, abdomen, mediastinum, bone, lung")},
  };
  QString html = QStringLiteral("<table cellspacing='0' cellpadding='3'>");
  for (const Line& line : lines)
    html +=
        line.keys
            ? QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>").arg(tr(line.keys), tr(line.meaning))
            : QStringLiteral("<tr><td colspan='2'><br><b>%1</b></td></tr>").arg(tr(line.meaning));
  html += QStringLiteral("</table>");
  QDialog dialog(parent);
  dialog.setWindowTitle(tr("Keys and mouse"));
  auto* text = new QTextBrowser;
  text->setHtml(html);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  auto* column = new QVBoxLayout(&dialog);
  column->addWidget(text);
  column->addWidget(buttons);
  dialog.resize(620, 680);
  dialog.exec();
}

void showAbout(const GlSupport& gl, std::optional<Schedule> schedule, QWidget* parent) {
  QString views = gl.available ? gl.renderer.toHtmlEscaped() : tr("not available");
  if (schedule) views += tr(" (shader schedule: %1)").arg(QString::fromStdString(std::string(nameOf(*schedule))));
  QMessageBox::about(
      parent, tr("About Fenestra"),
      tr("<h3>Fenestra %1</h3>"
         "<p>A medical volume viewer that opens an adaptive cutaway around the structure you want to see.</p>"
         "<p><b>Not for diagnostic use.</b></p>"
         "<p>Free software under the GNU General Public License, version 3 or later. It comes with no warranty.</p>"
         "<p>3-D views: %2</p>")
          .arg(QApplication::applicationVersion(), views));
}

}  // namespace fenestra::viewer
