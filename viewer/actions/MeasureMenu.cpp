#include "viewer/actions/MeasureMenu.h"

#include <memory>

#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QMenu>
#include <QMimeData>

#include "viewer/model/MeasureText.h"
#include "viewer/model/Workspace.h"

namespace fenestra::viewer {
namespace {

struct MeasureMenuWords {
  Q_DECLARE_TR_FUNCTIONS(MeasureMenu)
};

}  // namespace

void copyMeasures(const Workspace& workspace, std::optional<std::size_t> measure) {
  const Document& document = workspace.document;
  const QString table = measuresCsv(document, measure);
  auto data = std::make_unique<QMimeData>();
  // A spreadsheet takes the table, a report the text.
  data->setData(QStringLiteral("text/csv"), table.toUtf8());
  data->setText(measure ? linesOf(document.measured(*measure), *document.scene().volume).join(QLatin1Char('\n'))
                        : table);
  QGuiApplication::clipboard()->setMimeData(data.release());
}

void fillMeasureMenu(QMenu& menu, Workspace& workspace, std::size_t measure) {
  MeasureMode& mode = workspace.measuring;
  mode.select(measure);
  const auto add = [&menu](const QString& text, auto does) {
    QObject::connect(menu.addAction(text), &QAction::triggered, &menu, std::move(does));
  };
  add(MeasureMenuWords::tr("Copy this measure"), [&workspace, measure] { copyMeasures(workspace, measure); });
  add(MeasureMenuWords::tr("Copy all as a table (CSV)"), [&workspace] { copyMeasures(workspace); });
  menu.addSeparator();
  add(MeasureMenuWords::tr("Delete this measure"), [&mode] { mode.removeSelected(); });
  add(MeasureMenuWords::tr("Delete all measures"), [&mode] { mode.removeAll(); });
}

void showMeasureMenu(Workspace& workspace, std::size_t measure, QPoint at) {
  QMenu menu;
  fillMeasureMenu(menu, workspace, measure);
  menu.exec(at);
}

}  // namespace fenestra::viewer
