#include "viewer/SaveDialog.h"

#include <algorithm>

#include <QFileDialog>

#include "viewer/model/Paths.h"

namespace fenestra::viewer {

std::filesystem::path askForSaveFile(QWidget& window, const QString& title, const QList<FileKind>& kinds,
                                     qsizetype& chosen) {
  QStringList filters;
  for (const FileKind& kind : kinds) filters << QStringLiteral("%1 (*%2)").arg(kind.name, kind.ending);
  QString filter = filters.front();
  QString file = QFileDialog::getSaveFileName(&window, title, {}, filters.join(QStringLiteral(";;")), &filter);
  if (file.isEmpty()) return {};
  chosen = std::max<qsizetype>(0, filters.indexOf(filter));
  if (!file.endsWith(kinds[chosen].ending, Qt::CaseInsensitive) && QFileInfo(file).suffix().isEmpty())
    file += kinds[chosen].ending;
  return toPath(file);
}

}  // namespace fenestra::viewer
