#include "viewer/actions/MeasureMenu.h"

#include <memory>

#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QInputDialog>
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
  data->setText(measure
                    ? linesOf(document.measures().at(*measure), document.measured(*measure), *document.scene().volume)
                          .join(QLatin1Char('\n'))
                    : table);
  QGuiApplication::clipboard()->setMimeData(data.release());
}

void askForMarkText(Workspace& workspace, std::optional<std::size_t> measure, QWidget* parent) {
  MeasureMode& mode = workspace.measuring;
  auto* question = new QInputDialog(parent);
  question->setObjectName(QStringLiteral("markText"));
  question->setAttribute(Qt::WA_DeleteOnClose);
  question->setWindowTitle(MeasureMenuWords::tr("Text of the mark"));
  question->setLabelText(MeasureMenuWords::tr("Pictures and sessions hold it: name no patient."));
  if (measure) question->setTextValue(QString::fromStdString(workspace.document.measures().at(*measure).text));
  QObject::connect(question, &QInputDialog::textValueSelected, &mode, [&mode, measure](const QString& text) {
    measure ? mode.setText(*measure, text) : mode.finishMark(text);
  });
  if (!measure) QObject::connect(question, &QDialog::rejected, &mode, [&mode] { mode.setDraft({}); });
  // Another study has other measures.
  QObject::connect(&workspace.document, &Document::volumeChanged, question, &QDialog::reject);
  question->open();
}

void fillMeasureMenu(QMenu& menu, Workspace& workspace, std::size_t measure) {
  MeasureMode& mode = workspace.measuring;
  mode.select(measure);
  const auto add = [&menu](const QString& text, auto does) {
    QObject::connect(menu.addAction(text), &QAction::triggered, &menu, std::move(does));
  };
  if (isMark(workspace.document.measures().at(measure).kind))
    add(MeasureMenuWords::tr("Change the text…"),
        [&workspace, &menu, measure] { askForMarkText(workspace, measure, menu.parentWidget()); });
  add(MeasureMenuWords::tr("Copy this measure"), [&workspace, measure] { copyMeasures(workspace, measure); });
  add(MeasureMenuWords::tr("Copy all as a table (CSV)"), [&workspace] { copyMeasures(workspace); });
  menu.addSeparator();
  add(MeasureMenuWords::tr("Delete this measure"), [&mode] { mode.removeSelected(); });
  add(MeasureMenuWords::tr("Delete all measures"), [&mode] { mode.removeAll(); });
}

void showMeasureMenu(Workspace& workspace, std::size_t measure, QPoint at, QWidget* parent) {
  QMenu menu(parent);
  fillMeasureMenu(menu, workspace, measure);
  menu.exec(at);
}

}  // namespace fenestra::viewer
